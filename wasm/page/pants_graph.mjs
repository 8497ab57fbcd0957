// A small picture of a graph of pants, to say which cuff is which. An edge is a pair of pants, and its number that of the cuff.

const mean = numbers => numbers.reduce((a, b) => a + b, 0) / numbers.length;
const otherEnds = (node, edges) => edges.flatMap(([a, b]) => a === b ? [] : a === node ? [b] : b === node ? [a] : []);

// By node how many edges it is away from another one.
function distancesFrom(start, edges, count) {
  const result = Array(count).fill(Infinity), reached = [start];
  result[start] = 0;
  for (const node of reached)
    for (const next of otherEnds(node, edges))
      if (result[next] === Infinity) {
        result[next] = result[node] + 1;
        reached.push(next);
      }
  return result;
}

// By node its place: distances are about those along the graph (their stress is majorized, from a circle), the longest way lies across.
export function layout(edges) {
  const count = 1 + Math.max(...edges.flat()), nodes = [...Array(count).keys()];
  const far = nodes.map(node => distancesFrom(node, edges, count));
  let places = nodes.map(k => [Math.cos(2 * Math.PI * k / count), Math.sin(2 * Math.PI * k / count)]);
  const push = (i, j, axis) => i === j ? 0 : far[i][j] * (places[i][axis] - places[j][axis]) / Math.hypot(places[i][0] - places[j][0], places[i][1] - places[j][1]);
  for (let step = 0; step < 200; ++step) places = nodes.map(i => [0, 1].map(axis => mean(nodes.map(j => push(i, j, axis)))));
  return across(places);
}
function across(places) {
  const middle = [0, 1].map(axis => mean(places.map(place => place[axis])));
  const centred = places.map(([x, y]) => [x - middle[0], y - middle[1]]);
  const angle = Math.atan2(2 * mean(centred.map(([x, y]) => x * y)), mean(centred.map(([x, y]) => x * x - y * y))) / 2;
  const c = Math.cos(angle), s = Math.sin(angle);
  return centred.map(([x, y]) => [c * x + s * y, c * y - s * x]);
}

// By edge the points of a Bézier curve, and the place of its number. Edges between the same nodes are bent; loops lead away from the other nodes.
export function curves(edges, places) {
  const name = edge => [...edge].sort().join('-'), count = {}, labels = [];
  return edges.map(edge => {
    const [a, b] = edge, among = edges.filter(other => name(other) === name(edge)).length, number = count[name(edge)] = (count[name(edge)] ?? -1) + 1;
    const points = a === b ? loop(places[a], otherEnds(a, edges).map(node => places[node])) : bent(places[a], places[b], (number - (among - 1) / 2) * (a < b ? 1 : -1));
    // In the middle, unless another number is there: edges may cross.
    const isFree = ([x, y]) => labels.every(([u, v]) => Math.hypot(x - u, y - v) > 0.28);
    const label = [0.5, 0.25, 0.75].map(share => pointOf(points, share)).find(isFree) ?? pointOf(points, 0.5);
    labels.push(label);
    return {points, label};
  });
}
function bent(p, q, by) {
  return [p, [(p[0] + q[0]) / 2 - 0.9 * by * (q[1] - p[1]), (p[1] + q[1]) / 2 + 0.9 * by * (q[0] - p[0])], q];
}
function loop(p, others) {
  const away = Math.atan2(p[1] - mean(others.map(q => q[1])), p[0] - mean(others.map(q => q[0])));
  const at = turn => [p[0] + Math.cos(away + turn), p[1] + Math.sin(away + turn)];
  return [p, at(0.8), at(-0.8), p];
}
// De Casteljau's algorithm.
function pointOf(points, share) {
  const between = points.slice(1).map((q, k) => [0, 1].map(axis => (1 - share) * points[k][axis] + share * q[axis]));
  return between.length === 1 ? between[0] : pointOf(between, share);
}

// The picture, as an SVG element. `onCuff(k)` hears of the cuff that was pointed at; its group has the class cuff-k.
export function picture(edges, onCuff) {
  const kScale = 64, kMargin = 12, places = layout(edges), drawn = curves(edges, places);
  const all = drawn.flatMap(({points}) => [0, 0.2, 0.35, 0.5, 0.65, 0.8, 1].map(share => pointOf(points, share)));
  const least = [0, 1].map(axis => Math.min(...all.map(p => p[axis])));
  const [width, height] = [0, 1].map(axis => Math.round(kScale * (Math.max(...all.map(p => p[axis])) - least[axis]) + 2 * kMargin));
  const on = p => [0, 1].map(axis => (kMargin + kScale * (p[axis] - least[axis])).toFixed(1));
  const make = (name, attributes, ...children) => {
    const made = document.createElementNS('http://www.w3.org/2000/svg', name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    made.append(...children);
    return made;
  };
  const words = edges.map(([a, b], k) => `cuff ${k} joins pants ${a} and ${b}`).join(', ');
  const svg = make('svg', {viewBox: `0 0 ${width} ${height}`, width, height, role: 'img', 'aria-label': `Graph of pants: ${words}`});
  drawn.forEach(({points: [start, ...rest], label}, k) => {
    const d = `M${on(start)} ${rest.length === 2 ? 'Q' : 'C'}${rest.map(on).join(' ')}`, [x, y] = on(label);
    const group = make('g', {class: `cuff-${k}`}, make('path', {d}), make('circle', {cx: x, cy: y, r: 8}), make('text', {x, y}, String(k)));
    group.addEventListener('click', () => onCuff(k));
    svg.append(group);
  });
  for (const place of places) {
    const [cx, cy] = on(place);
    svg.append(make('circle', {class: 'pants', cx, cy, r: 4}));
  }
  return svg;
}
