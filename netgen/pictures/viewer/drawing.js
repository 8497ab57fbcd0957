'use strict';
// What draws an unfolded net (unfolding.js), with its layers, colours and legend: on a canvas, or as the text of an SVG file.

// ---- Colours ----

// The picture on paper that is light or dark. Colours of the net and of its layers are those of light paper.
const schemes = {
  light: {page: '#f4f6f9', paper: '#ffffff', ink: '#1d2b3a', rim: '#8a94a0', stops: [[255, 252, 224], [199, 227, 201], [111, 178, 205], [44, 99, 164]], chart: '45%,85%'},
  dark: {page: '#0f141a', paper: '#171d24', ink: '#e6ebf1', rim: '#66727f', stops: [[28, 34, 42], [26, 62, 84], [38, 112, 140], [112, 196, 190]], chart: '40%,26%'}};
let scheme = 'light';

const channels = colour => [1, 3, 5].map(i => parseInt(colour.slice(i, i + 2), 16));
// Contrast as the Web Content Accessibility Guidelines (WCAG 2) define it, from 1 to 21.
function luminance(rgb) {
  const [r, g, b] = rgb.map(x => x / 255 <= 0.04045 ? x / 255 / 12.92 : ((x / 255 + 0.055) / 1.055) ** 2.4);
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}
function contrast(p, q) {
  const [a, b] = [luminance(p), luminance(q)];
  return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
}
// A colour as it is on the present paper: on dark paper mixed with white until it stands out about as much as on white.
function onPaper(colour) {
  if (scheme === 'light') return colour;
  let rgb = channels(colour);
  const enough = Math.min(12, Math.max(4.5, 0.75 * contrast(rgb, [255, 255, 255])));
  for (let k = 0; k < 40 && contrast(rgb, channels(schemes.dark.paper)) < enough; ++k) rgb = rgb.map(x => Math.round(x + 0.1 * (255 - x)));
  return '#' + rgb.map(x => x.toString(16).padStart(2, '0')).join('');
}

const kShades = 24;
// From pale yellow to blue, or from dark to bright.
function shade(share) {
  const s = Math.min(1, Math.max(0, share)), stops = schemes[scheme].stops;
  const p = Math.min(2, Math.floor(3 * s)), f = 3 * s - p;
  return '#' + stops[p].map((c, i) => Math.round(c + f * (stops[p + 1][i] - c)).toString(16).padStart(2, '0')).join('');
}
const chartColour = k => `hsl(${Math.round((k * 137.508) % 360)},${schemes[scheme].chart})`;
const kSelectedColour = '#ffb000';
const kPinColour = '#b5197f';

// ---- Ink: a canvas, or the text of an SVG file ----

const kLegendFont = '12px sans-serif';
const kWide = 1.5;  // Narrower strokes need no round ends, which take their time.
class CanvasInk {
  constructor(pen, width, height) { Object.assign(this, {pen, width, height}); }
  path() { return new Path2D(); }
  // As a rectangle, of which a browser knows that nothing that was drawn before is left to be seen.
  background(colour) {
    this.pen.fillStyle = colour;
    this.pen.fillRect(0, 0, this.width, this.height);
  }
  fill(path, colour, opacity = 1) {
    this.pen.globalAlpha = opacity;
    this.pen.fillStyle = colour;
    this.pen.fill(path, 'nonzero');
    this.pen.globalAlpha = 1;
  }
  stroke(path, colour, lineWidth) {
    this.pen.strokeStyle = colour;
    this.pen.lineWidth = lineWidth;
    this.pen.lineCap = lineWidth < kWide ? 'butt' : 'round';
    this.pen.lineJoin = lineWidth < kWide ? 'bevel' : 'round';
    this.pen.stroke(path);
  }
  text(text, x, y, colour) {
    this.pen.font = kLegendFont;
    this.pen.fillStyle = colour;
    this.pen.fillText(text, x, y);
  }
  // From here to endClip only what is inside of the path is drawn.
  clip(path) {
    this.pen.save();
    this.pen.clip(path);
  }
  endClip() { this.pen.restore(); }
}

// The data of an SVG path, from place to place in hundredths of a pixel.
class SvgPath {
  constructor() {
    this.data = '';
    this.x = this.y = 0;
  }
  add(command, x, y) {
    const toX = Math.round(100 * x), toY = Math.round(100 * y);
    this.data += `${command}${(toX - this.x) / 100} ${(toY - this.y) / 100}`;
    this.x = toX;
    this.y = toY;
  }
  moveTo(x, y) { this.add('m', x, y); }
  lineTo(x, y) { this.add('l', x, y); }
  // As of a canvas, from where the pen is: less than half of a circle, or all of it.
  arc(cx, cy, r, from, to, anticlockwise = false) {
    const ends = Math.abs(to - from) > 6.28 ? [from + Math.PI, to] : [to], size = Math.round(10 * r) / 10 || 0.05;
    for (const angle of ends) this.add(`a${size} ${size} 0 0 ${anticlockwise ? 0 : 1} `, cx + r * Math.cos(angle), cy + r * Math.sin(angle));
  }
  rect(x, y, w, h) {
    this.moveTo(x, y);
    this.lineTo(x + w, y);
    this.lineTo(x + w, y + h);
    this.lineTo(x, y + h);
    this.lineTo(x, y);
  }
}
class SvgInk {
  constructor(width, height, title) {
    Object.assign(this, {width, height});
    this.page = document.createElement('div');
    this.page.innerHTML = '<svg></svg>';  // A parser knows the name space of SVG.
    this.svg = this.group = this.page.firstChild;
    this.add('title', {}).textContent = title;
    this.svg.setAttribute('width', width);
    this.svg.setAttribute('height', height);
    this.svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
  }
  add(name, attributes, parent = this.group) {
    const element = document.createElementNS(this.svg.namespaceURI, name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    return parent.appendChild(element);
  }
  path() { return new SvgPath(); }
  background(colour) { this.add('rect', {width: this.width, height: this.height, fill: colour}); }
  fill(path, colour, opacity = 1) {
    if (path.data !== '') this.add('path', {fill: colour, ...(opacity < 1 ? {'fill-opacity': opacity} : {}), d: path.data});
  }
  stroke(path, colour, lineWidth) {
    const round = lineWidth < kWide ? {} : {'stroke-linecap': 'round', 'stroke-linejoin': 'round'};
    if (path.data !== '') this.add('path', {fill: 'none', stroke: colour, 'stroke-width': lineWidth, ...round, d: path.data});
  }
  text(text, x, y, colour) { this.add('text', {x, y, fill: colour, 'font-family': 'sans-serif', 'font-size': 12}).textContent = text; }
  clip(path) {
    this.add('path', {d: path.data}, this.add('clipPath', {id: 'inside'}));
    this.group = this.add('g', {'clip-path': 'url(#inside)'});
  }
  endClip() { this.group = this.svg; }
  toString() { return new XMLSerializer().serializeToString(this.svg) + '\n'; }
}
// ---- Drawing ----

// Data of a layer of the file, by triangle: arcs are pieces of geodesics within triangles, each in the chart of the corner where its dart starts; darts are edges;
// triangles are areas.
function decodedLayer(id, layer) {
  const result = {id, ...layer};
  if (layer.arcs !== undefined) {
    result.arcs = decode(layer.arcs, Uint32Array);
    result.ends = decode(layer.ends, Float64Array);
    result.byTriangle = arcsByTriangle(result, 0, result.arcs.length);
  }
  if (layer.darts !== undefined) result.isDart = new Set(decode(layer.darts, Uint32Array));
  if (layer.triangles !== undefined) result.isTriangle = new Set(decode(layer.triangles, Uint32Array));
  return result;
}
function arcsByTriangle(layer, first, end) {
  const result = new Map();
  for (let i = first; i < end; ++i) {
    const t = Math.floor(layer.arcs[i] / 3);
    if (result.has(t)) result.get(t).push(i);
    else result.set(t, [i]);
  }
  return result;
}

const geodesicName = g => `${g.name}: length ${g.length.toPrecision(6)}`;

// A circle on the screen, in pixels.
function ring(path, x, y, r) {
  path.moveTo(x + r, y);
  path.arc(x, y, r, 0, 2 * Math.PI);
}

function distanceToSegment(px, py, ux, uy, vx, vy) {
  const dx = vx - ux, dy = vy - uy, s = Math.min(1, Math.max(0, ((px - ux) * dx + (py - uy) * dy) / (dx * dx + dy * dy)));
  return Math.hypot(px - ux - s * dx, py - uy - s * dy);
}

class Drawing {
  constructor(canvas, net) {
    this.canvas = canvas;
    this.pen = canvas.getContext('2d');
    this.net = net;
    this.palette = net.data.palette;
    this.unfolding = new Unfolding(net);
    this.lift = this.unfolding.lift;
    this.layers = [
      {id: 'edges', name: 'triangles', colour: this.palette.edges, on: true},
      {id: 'vertices', name: 'vertices', colour: this.palette.vertices, on: true},
      {id: 'covering', name: 'disks of radius ε', colour: this.palette.covering, on: false},
      {id: 'packing', name: 'disks of radius ε/2', colour: this.palette.packing, on: false},
      ...net.data.layers.map((layer, k) => decodedLayer('layer' + k, layer))];
    this.colourings = [{id: 'none', name: 'plain'}, {id: 'circumradius', name: 'by circumradius'}, {id: 'chart', name: 'by chart'}];
    if (net.farthest > 0) this.colourings.push({id: 'distance', name: 'by distance from vertex 0'});
    this.colouring = 'circumradius';
    // The closed geodesics, each a run of arcs of its layer.
    this.geodesics = [];
    for (const layer of this.layers)
      (layer.parts || []).forEach(([name, length, first], k) => {
        const end = k + 1 < layer.parts.length ? layer.parts[k + 1][2] : layer.arcs.length;
        this.geodesics.push({layer, name, length, first, end, byTriangle: arcsByTriangle(layer, first, end)});
      });
    this.selected = null;  // One of the geodesics.
    this.hovered = null;   // What `find` returned.
    this.pins = [];        // Points that somebody marked, as `pinAt` returned them, with names.
    this.width = this.height = this.ox = this.oy = 0;
    this.scale = 1;
    this.lastDraw = 0;  // milliseconds
    this.goHome();
  }

  goHome() {
    this.unfolding.goHome();
    this.zoom = Math.max(1, 0.025 / this.net.epsilon);  // Edges in the centre of a fine net are then about eight pixels long.
  }
  layerOf(id) { return this.layers.find(layer => layer.id === id); }

  // ---- The screen ----

  frameView() {
    this.ox = this.width / 2;
    this.oy = this.height / 2;
    this.scale = 0.48 * Math.min(this.width, this.height) * this.zoom;
  }
  resize() {
    const canvas = this.canvas, ratio = window.devicePixelRatio || 1;
    this.width = canvas.clientWidth;
    this.height = canvas.clientHeight;
    canvas.width = Math.round(this.width * ratio);
    canvas.height = Math.round(this.height * ratio);
    this.pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.frameView();
  }
  toDisk(x, y) { return [(x - this.ox) / this.scale, (this.oy - y) / this.scale]; }

  // ---- Colours of triangles ----

  shadeOf(t) {
    const net = this.net;
    if (this.colouring === 'circumradius') return Math.floor(kShades * Math.min(0.9999, Math.max(0, 2 * net.radius[t] / net.epsilon - 1)));
    if (this.colouring === 'distance') return Math.floor(kShades * Math.min(0.9999, net.distanceShare(t)));
    return net.chart[net.vertex[3 * t]];
  }
  shadeColour(k) { return this.colouring === 'chart' ? chartColour(k) : shade((k + 0.5) / kShades); }

  // ---- Curves ----

  // Continues a path along the geodesic from u, where the pen is, to v. What a chord follows to a quarter of a pixel is a chord.
  geodesicTo(path, ux, uy, vx, vy) {
    const {ox, oy, scale} = this, chord2 = (ux - vx) ** 2 + (uy - vy) ** 2;
    if (chord2 * scale * scale < 9) {
      path.lineTo(ox + scale * vx, oy - scale * vy);
      return;
    }
    const twice = 2 * (ux * vy - uy * vx), a = 1 + ux * ux + uy * uy, b = 1 + vx * vx + vy * vy;
    const wx = a * vx - b * ux, wy = a * vy - b * uy, rest = wx * wx + wy * wy - twice * twice;
    const r = rest > 0 ? Math.sqrt(rest) / Math.abs(twice) : Infinity;
    if (!(chord2 * scale > 2 * r)) {
      path.lineTo(ox + scale * vx, oy - scale * vy);
      return;
    }
    const cx = wy / twice, cy = -wx / twice;
    const from = Math.atan2(cy - uy, ux - cx), to = Math.atan2(cy - vy, vx - cx);
    const angle = Math.atan2(Math.sin(to - from), Math.cos(to - from));
    path.arc(ox + scale * cx, oy - scale * cy, scale * r, from, to, angle < 0);
  }
  geodesic(path, ux, uy, vx, vy) {
    path.moveTo(this.ox + this.scale * ux, this.oy - this.scale * uy);
    this.geodesicTo(path, ux, uy, vx, vy);
  }
  edgeOf(path, slot, c) {
    const {x, y} = this.lift, u = 3 * slot + c, v = 3 * slot + (c + 1) % 3;
    this.geodesic(path, x[u], y[u], x[v], y[v]);
  }
  outline(path, slot) {
    const {x, y} = this.lift, k = 3 * slot;
    path.moveTo(this.ox + this.scale * x[k], this.oy - this.scale * y[k]);
    for (let c = 0; c < 3; ++c) this.geodesicTo(path, x[k + c], y[k + c], x[k + (c + 1) % 3], y[k + (c + 1) % 3]);
  }
  // The Euclidean circle that is the hyperbolic circle of radius r about a point.
  circle(path, x, y, r) {
    const {ox, oy, scale} = this, t = Math.tanh(r / 2), n = x * x + y * y, q = 1 / (1 - t * t * n);
    const size = scale * t * (1 - n) * q;
    if (size >= 0.4) ring(path, ox + scale * x * (1 - t * t) * q, oy - scale * y * (1 - t * t) * q, size);
  }

  // ---- Painting ----

  eachNewCorner(action) {
    const lift = this.lift;
    for (let slot = 0; slot < lift.count; ++slot)
      for (let c = 0; c < 3; ++c) {
        if (lift.entry[slot] !== 3 && lift.entry[slot] !== c) continue;
        const k = 3 * slot + c;
        action(lift.x[k], lift.y[k], this.net.vertex[3 * lift.triangle[slot] + c]);
      }
  }

  drawFills(ink) {
    if (this.colouring === 'none') return;
    const paths = new Map();
    for (let slot = 0; slot < this.lift.count; ++slot) {
      const k = this.shadeOf(this.lift.triangle[slot]);
      if (!paths.has(k)) paths.set(k, ink.path());
      this.outline(paths.get(k), slot);
    }
    for (const [k, path] of paths) {
      ink.fill(path, this.shadeColour(k));
      if (!this.layerOf('edges').on) ink.stroke(path, this.shadeColour(k), 0.7);  // Covers the seams that smoothing leaves, as edges do.
    }
  }

  // Far edges are thin: three widths by the scale at the place.
  drawEdges(ink) {
    const lift = this.lift, paths = [ink.path(), ink.path(), ink.path()];
    for (let slot = 0; slot < lift.count; ++slot)
      for (let c = 0; c < 3; ++c) {
        const d = 3 * lift.triangle[slot] + c;
        if (d > this.net.opposite[d]) continue;
        const k = 3 * slot + c, n = lift.x[k] ** 2 + lift.y[k] ** 2, local = this.zoom * (1 - n);
        this.edgeOf(paths[local > 0.4 ? 0 : local > 0.1 ? 1 : 2], slot, c);
      }
    [0.9, 0.5, 0.22].forEach((w, i) => ink.stroke(paths[i], onPaper(this.layerOf('edges').colour), w));
  }

  drawVertices(ink) {
    const {ox, oy, scale} = this, epsilon = this.net.epsilon, dots = ink.path(), base = ink.path(), rim = ink.path();
    const most = Math.min(3.5, 0.12 * epsilon * scale);
    this.eachNewCorner((x, y, v) => {
      const r = Math.min(most, 0.09 * epsilon * scale * (1 - x * x - y * y)) * (v === 0 ? 1.6 : 1);
      if (r < 0.3) return;
      ring(v === 0 ? base : dots, ox + scale * x, oy - scale * y, r);
      if (v === 0) ring(rim, ox + scale * x, oy - scale * y, 1.4 * r);
    });
    ink.fill(dots, onPaper(this.layerOf('vertices').colour));
    ink.fill(rim, schemes[scheme].paper);
    ink.fill(base, onPaper(this.palette.centre));
  }

  drawDisks(ink, layer, r) {
    const path = ink.path();
    this.eachNewCorner((x, y) => this.circle(path, x, y, r));
    ink.fill(path, onPaper(layer.colour), 0.13);
    ink.stroke(path, onPaper(layer.colour), 0.6);
  }

  // Calls the action with the ends of the arcs on the screen, and their numbers.
  eachArc(layer, byTriangle, action) {
    for (let slot = 0; slot < this.lift.count; ++slot) {
      const arcs = byTriangle.get(this.lift.triangle[slot]);
      if (arcs === undefined) continue;
      for (const i of arcs) {
        const frame = this.unfolding.cornerFrame(slot, layer.arcs[i] % 3);
        action(apply(frame, layer.ends[4 * i], layer.ends[4 * i + 1]), apply(frame, layer.ends[4 * i + 2], layer.ends[4 * i + 3]), i);
      }
    }
  }

  drawFileLayer(ink, layer) {
    const path = ink.path();
    for (let slot = 0; slot < this.lift.count; ++slot) {
      const t = this.lift.triangle[slot];
      if (layer.isTriangle && layer.isTriangle.has(t)) this.outline(path, slot);
      if (layer.isDart) for (let c = 0; c < 3; ++c) if (layer.isDart.has(3 * t + c)) this.edgeOf(path, slot, c);
    }
    if (layer.byTriangle) this.eachArc(layer, layer.byTriangle, (u, v) => this.geodesic(path, ...u, ...v));
    if (layer.isTriangle) ink.fill(path, onPaper(layer.colour), 0.6);
    else ink.stroke(path, onPaper(layer.colour), 2);
  }

  drawSelected(ink) {
    const path = ink.path();
    this.eachArc(this.selected.layer, this.selected.byTriangle, (u, v) => this.geodesic(path, ...u, ...v));
    ink.stroke(path, '#1d2b3a', 6);
    ink.stroke(path, kSelectedColour, 3.5);
  }

  drawHovered(ink) {
    const {slot, triangle, edge} = this.hovered, path = ink.path();
    if (slot >= this.lift.count || this.lift.triangle[slot] !== triangle) return;
    this.outline(path, slot);
    ink.fill(path, kSelectedColour, 0.27);
    if (edge >= 0) {
      const line = ink.path();
      this.edgeOf(line, slot, edge);
      ink.stroke(line, onPaper(this.palette.dirichlet), 2.5);
    }
  }

  drawPins(ink) {
    const {ox, oy, scale} = this, rims = ink.path(), dots = ink.path(), names = [];
    for (const pin of this.pins)
      for (let slot = 0; slot < this.lift.count; ++slot) {
        if (this.lift.triangle[slot] !== pin.triangle) continue;
        const [x, y] = apply(this.unfolding.cornerFrame(slot, 0), pin.x, pin.y), r = Math.min(8, 10 * this.zoom * (1 - x * x - y * y));
        if (r < 1) continue;
        ring(rims, ox + scale * x, oy - scale * y, r + 1.5);
        ring(dots, ox + scale * x, oy - scale * y, r);
        if (r === 8) names.push([pin.name, ox + scale * x - 3.5, oy - scale * y + 3.5]);
      }
    ink.fill(rims, schemes[scheme].paper);
    ink.fill(dots, onPaper(kPinColour));
    for (const name of names) ink.text(...name, schemes[scheme].paper);
  }

  paint(ink) {
    const disk = ink.path(), colours = schemes[scheme], epsilon = this.net.epsilon;
    ink.background(colours.page);
    ring(disk, this.ox, this.oy, this.scale);
    ink.fill(disk, colours.paper);
    ink.stroke(disk, colours.rim, 1);
    ink.clip(disk);
    this.drawFills(ink);
    for (const layer of this.layers) if (layer.on && layer.isTriangle) this.drawFileLayer(ink, layer);
    if (this.layerOf('covering').on) this.drawDisks(ink, this.layerOf('covering'), epsilon);
    if (this.layerOf('packing').on) this.drawDisks(ink, this.layerOf('packing'), epsilon / 2);
    if (this.layerOf('edges').on) this.drawEdges(ink);
    for (const layer of this.layers) if (layer.on && (layer.isDart || layer.byTriangle)) this.drawFileLayer(ink, layer);
    if (this.selected !== null) this.drawSelected(ink);
    if (this.layerOf('vertices').on) this.drawVertices(ink);
    this.drawPins(ink);
    if (this.hovered !== null) this.drawHovered(ink);
    ink.endClip();
  }

  // Draws at most `count` triangles.
  draw(count) {
    const started = performance.now();
    this.frameView();
    const [left, top] = this.toDisk(0, 0), [right, bottom] = this.toDisk(this.width, this.height);
    this.unfolding.unfold({count, size: 1.2 / this.scale, left, right, top, bottom, width: right - left});
    this.paint(new CanvasInk(this.pen, this.width, this.height));
    this.lastDraw = performance.now() - started;
  }

  // ---- What is where ----

  // The lifted triangle at a point of the disk, and the corner or edge that is meant: one within a few pixels.
  find(x, y) {
    const slot = this.unfolding.slotAt(x, y);
    if (slot < 0) return null;
    const found = {slot, triangle: this.lift.triangle[slot], corner: -1, edge: -1}, X = this.lift.x, Y = this.lift.y, k = 3 * slot;
    for (let c = 0; c < 3; ++c) if (this.scale * Math.hypot(X[k + c] - x, Y[k + c] - y) < 7) found.corner = c;
    // Seen from the point itself the sides are nearly straight.
    const toPoint = translation(-x, -y), pixels = this.scale * (1 - x * x - y * y);
    const corners = [0, 1, 2].map(c => apply(toPoint, X[k + c], Y[k + c]));
    for (let c = 0; c < 3; ++c)
      if (found.edge < 0 && pixels * distanceToSegment(0, 0, ...corners[c], ...corners[(c + 1) % 3]) < 4) found.edge = c;
    return found;
  }
  describe(found) {
    const net = this.net, t = found.triangle, lines = [`triangle ${t}: circumradius ${net.radius[t].toPrecision(6)}`];
    if (found.edge >= 0) {
      const d = 3 * t + found.edge;
      lines.unshift(`edge ${net.vertex[d]} – ${net.vertex[next(d)]}: length ${net.edgeLength(d).toPrecision(6)}`);
    }
    if (found.corner >= 0) lines.unshift(`vertex ${net.vertex[3 * t + found.corner]}`);
    return lines.join('\n');
  }

  // Of the geodesics that are shown, the one nearest to a point of the disk, if it is within some pixels; else null.
  geodesicAt(x, y) {
    const toPoint = translation(-x, -y), pixels = this.scale * (1 - x * x - y * y);
    let best = null, least = 8;
    for (const g of this.geodesics) {
      if (!g.layer.on) continue;
      this.eachArc(g.layer, g.byTriangle, (u, v) => {
        const far = pixels * distanceToSegment(0, 0, ...apply(toPoint, ...u), ...apply(toPoint, ...v));
        if (far < least) [best, least] = [g, far];
      });
    }
    return best;
  }

  // A point of the disk as a point of the surface: with weights on the corners of its triangle, as epsnet writes it, and in the chart of the triangle's first corner.
  pinAt(x, y) {
    const slot = this.unfolding.slotAt(x, y);
    if (slot < 0) return null;
    const X = this.lift.x, Y = this.lift.y, k = 3 * slot, triangle = this.lift.triangle[slot];
    const [cx, cy] = apply(inverse(this.unfolding.cornerFrame(slot, 0)), x, y);
    // Cramer's rule for Lorentz vectors: `side` is their determinant but for the factors 1 - |z|^2.
    const weights = [0, 1, 2].map(c => {
      const i = k + c, u = k + (c + 1) % 3, v = k + (c + 2) % 3;
      return Math.max(0, side(X[u], Y[u], X[v], Y[v], x, y) * (1 - X[i] ** 2 - Y[i] ** 2));
    });
    const most = Math.max(...weights);
    return {triangle, x: cx, y: cy, text: `t${triangle}:` + weights.map(w => (w / most).toFixed(9)).join(',')};
  }

  // The lifted arc of a geodesic whose middle is nearest to the centre, if one is in view: [middle, end].
  nearestArc(g) {
    let best = null;
    this.draw(kMost);
    this.eachArc(g.layer, g.byTriangle, (u, v) => {
      const middle = halfWay(u, v);
      if (Math.hypot(...middle) < (best === null ? 0.95 : Math.hypot(...best[0]))) best = [middle, v];
    });
    return best;
  }

  // ---- Legend and files ----

  // What a legend says of the picture as it is: marks (area, line, dot, ramp) and names.
  legendEntries() {
    const entries = [];
    for (const layer of this.layers) {
      if (!layer.on) continue;
      const isArea = layer.isTriangle !== undefined || layer.id === 'covering' || layer.id === 'packing';
      entries.push({mark: layer.id === 'vertices' ? 'dot' : isArea ? 'area' : 'line', colour: onPaper(layer.colour),
                    name: layer.parts === undefined ? layer.name : `${layer.name}: ${layer.parts.length}`});
      if (layer.id === 'vertices') entries.push({mark: 'dot', colour: onPaper(this.palette.centre), name: 'vertex 0'});
    }
    if (this.pins.length > 0) entries.push({mark: 'dot', colour: onPaper(kPinColour), name: this.pins.map(pin => pin.name).join(', ')});
    if (this.selected !== null) entries.push({mark: 'line', colour: kSelectedColour, name: geodesicName(this.selected)});
    if (this.colouring === 'circumradius') entries.push({mark: 'ramp', name: 'circumradius, ≤ ε/2 to ε'});
    if (this.colouring === 'distance') entries.push({mark: 'ramp', name: `distance from vertex 0, 0 to ${this.net.farthest.toPrecision(4)}`});
    if (this.colouring === 'chart') {
      const kMostCharts = 8, seen = new Set();
      for (let slot = 0; slot < this.lift.count; ++slot) seen.add(this.shadeOf(this.lift.triangle[slot]));
      const charts = [...seen];  // The nearest to the centre first.
      for (const k of charts.slice(0, kMostCharts)) entries.push({mark: 'area', colour: chartColour(k), name: `chart ${k}`});
      if (charts.length > kMostCharts) entries.push({mark: 'none', name: `and ${charts.length - kMostCharts} more charts`});
    }
    return entries;
  }
  drawLegend(ink) {
    const colours = schemes[scheme], entries = this.legendEntries();
    if (entries.length === 0) return;
    const box = ink.path();
    const textAt = entry => entry.mark === 'ramp' ? 70 : 36;
    this.pen.font = kLegendFont;
    box.rect(8, 8, Math.max(0, ...entries.map(entry => textAt(entry) + this.pen.measureText(entry.name).width)), 10 + 18 * entries.length);
    ink.fill(box, colours.page, 0.9);
    entries.forEach((entry, k) => {
      const y = 18 + 18 * k + 4, path = ink.path();
      if (entry.mark === 'ramp') {
        for (let i = 0; i < kShades; ++i) {
          const cell = ink.path();
          cell.rect(16 + 2 * i, y - 5, 2, 10);
          ink.fill(cell, shade((i + 0.5) / kShades));
        }
      } else if (entry.mark === 'line') {
        path.moveTo(16, y);
        path.lineTo(30, y);
        ink.stroke(path, entry.colour, 2.5);
      } else if (entry.mark === 'dot') {
        ring(path, 23, y, 4);
        ink.fill(path, entry.colour);
      } else if (entry.mark === 'area') {
        path.rect(17, y - 6, 12, 12);
        ink.fill(path, entry.colour);
      }
      ink.text(entry.name, textAt(entry), y + 4, colours.ink);
    });
  }

  // The picture as it is, with its legend, as a file.
  svgPicture() {
    this.draw(kMost);
    const ink = new SvgInk(this.width, this.height, this.net.data.title);
    this.paint(ink);
    this.drawLegend(ink);
    return new Blob([ink.toString()], {type: 'image/svg+xml'});
  }
  pngPicture() {
    this.draw(kMost);
    const copy = document.createElement('canvas'), ratio = Math.max(2, window.devicePixelRatio || 1), pen = copy.getContext('2d');
    copy.width = Math.round(this.width * ratio);
    copy.height = Math.round(this.height * ratio);
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    const ink = new CanvasInk(pen, this.width, this.height);
    this.paint(ink);
    this.drawLegend(ink);
    const address = copy.toDataURL('image/png');
    return new Blob([decode(address.slice(address.indexOf(',') + 1), Uint8Array)], {type: 'image/png'});
  }
}
