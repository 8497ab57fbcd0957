'use strict';
// A net, and its triangulation unfolded in the Poincaré disk around a point of view that can move without end. Nothing here knows of a screen.
//
// Nothing here lives far from the origin: a vertex is a point |z| < 0.7 of its chart, and a corner of a triangle that is unfolded has a frame, the isometry from the
// chart of its vertex to the disk. Neighbours share the frames of common corners; along an edge frames change by the edge's label. The point of view is the frame of
// one corner near the centre, so that products only ever grow outwards, and precision never degrades however far one travels.

// ---- Isometries ----
//
// An isometry z -> (a z + b)/(conj(b) z + conj(a)), |a|^2 - |b|^2 = 1, is four numbers (Re a, Im a, Re b, Im b).

const compose = (f, g) => [
  f[0] * g[0] - f[1] * g[1] + f[2] * g[2] + f[3] * g[3], f[0] * g[1] + f[1] * g[0] + f[3] * g[2] - f[2] * g[3],
  f[0] * g[2] - f[1] * g[3] + f[2] * g[0] + f[3] * g[1], f[0] * g[3] + f[1] * g[2] + f[3] * g[0] - f[2] * g[1]];
const inverse = f => [f[0], -f[1], -f[2], -f[3]];
function apply(f, x, y) {
  const nx = f[0] * x - f[1] * y + f[2], ny = f[0] * y + f[1] * x + f[3];
  const dx = f[2] * x + f[3] * y + f[0], dy = f[2] * y - f[3] * x - f[1];
  const q = 1 / (dx * dx + dy * dy);
  return [(nx * dx + ny * dy) * q, (ny * dx - nx * dy) * q];
}
// Back to |a|^2 - |b|^2 = 1 with the directions kept, also where that difference is lost among the digits.
function normalized(f) {
  const a2 = f[0] * f[0] + f[1] * f[1], b2 = f[2] * f[2] + f[3] * f[3];
  if (a2 < 1e8) {
    const s = 1 / Math.sqrt(a2 - b2);
    return f.map(x => s * x);
  }
  const s = Math.sqrt((a2 - 1) / b2);
  return [f[0], f[1], s * f[2], s * f[3]];
}
function translation(x, y) {
  const s = 1 / Math.sqrt(1 - x * x - y * y);
  return [s, 0, s * x, s * y];
}
const turn = angle => [Math.cos(angle / 2), Math.sin(angle / 2), 0, 0];
// The half turn about a point; two of them make the translation along the line through p and q that takes p to q.
function halfTurn(x, y) { return compose(compose(translation(x, y), [0, 1, 0, 0]), translation(-x, -y)); }
function translationTo(p, q) {
  const m = halfWay(p, q);
  return compose(halfTurn(m[0], m[1]), halfTurn(p[0], p[1]));
}
// The point half-way between two points of the disk: tanh(d/2) = 2m/(1 + m^2) for m = tanh(d/4).
function halfWay(p, q) {
  const [x, y] = apply(translation(-p[0], -p[1]), q[0], q[1]), s = 1 / (1 + Math.sqrt(Math.max(0, 1 - x * x - y * y)));
  return apply(translation(p[0], p[1]), s * x, s * y);
}
// Positive if the point w is on the left of the line from u to v: a determinant on the hyperboloid, where lines are planes.
function side(ux, uy, vx, vy, wx, wy) {
  const U = 1 + ux * ux + uy * uy, V = 1 + vx * vx + vy * vy, W = 1 + wx * wx + wy * wy;
  return ux * (vy * W - wy * V) - uy * (vx * W - wx * V) + U * (vx * wy - wx * vy);
}

// ---- The net ----

function decode(text, Type) {
  const raw = atob(text);
  const bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; ++i) bytes[i] = raw.charCodeAt(i);
  return new Type(bytes.buffer);
}

// Darts are numbered 3t + i, from corner i of triangle t to corner i + 1.
const next = d => d % 3 === 2 ? d - 2 : d + 1;
const previous = d => d % 3 === 0 ? d + 2 : d - 1;

// The triangulation of a net, from the data that `viewer_data` (netgen/pictures/pictures.h) makes of its file.
class Net {
  constructor(data) {
    this.data = data;
    this.epsilon = data.epsilon;
    this.opposite = decode(data.opposite, Uint32Array);       // by dart
    this.point = decode(data.points, Float64Array);           // by vertex: x, y in its chart
    this.isometry = decode(data.isometries, Float64Array);    // four numbers each; 0 is the identity
    this.chart = decode(data.charts, Uint32Array);            // by vertex
    this.dartCount = this.opposite.length;
    this.triangleCount = this.dartCount / 3;
    // By dart: the label number of the isometry from the chart of its end to that of its start.
    this.edgeLabel = new Uint32Array(this.dartCount);
    const pairs = decode(data.edge_labels, Uint32Array);
    for (let i = 0; i < pairs.length; i += 2) this.edgeLabel[pairs[i]] = pairs[i + 1];
    // By dart: the vertex where it starts. The darts around a vertex are an orbit.
    this.vertex = new Uint32Array(this.dartCount);
    this.vertexDart = decode(data.vertex_darts, Uint32Array);  // by vertex: a dart that starts there
    this.vertexDart.forEach((first, v) => {
      let d = first;
      do {
        this.vertex[d] = v;
        d = this.opposite[previous(d)];
      } while (d !== first);
    });
    this.radius = new Float32Array(this.triangleCount);  // the circumradii
    for (let t = 0; t < this.triangleCount; ++t) this.radius[t] = this.circumradius(t);
    // By vertex, from vertex 0; may be empty.
    this.distance = decode(data.distances, Float32Array);
    this.farthest = this.distance.reduce((a, b) => Math.max(a, b), 0);
  }

  // sinh^2 of half the length of a dart's edge, from numerators and denominators: nothing cancels however long the edge is.
  sinh2HalfLength(d) {
    const {point, isometry} = this, u = 2 * this.vertex[d], v = 2 * this.vertex[next(d)], m = 4 * this.edgeLabel[d];
    const ar = isometry[m], ai = isometry[m + 1], br = isometry[m + 2], bi = isometry[m + 3];
    const ux = point[u], uy = point[u + 1], x = point[v], y = point[v + 1];
    const nx = ar * x - ai * y + br, ny = ar * y + ai * x + bi;
    const dx = br * x + bi * y + ar, dy = br * y - bi * x - ai;
    const ex = ux * dx - uy * dy - nx, ey = ux * dy + uy * dx - ny;
    return (ex * ex + ey * ey) / ((1 - ux * ux - uy * uy) * (1 - x * x - y * y));
  }
  edgeLength(d) { return 2 * Math.asinh(Math.sqrt(this.sinh2HalfLength(d))); }

  // sinh of the circumradius is twice the radius of the Euclidean circle through a triangle with sides sinh(length/2); Heron's formula in Kahan's order.
  circumradius(t) {
    const [a, b, c] = [0, 1, 2].map(i => Math.sqrt(this.sinh2HalfLength(3 * t + i))).sort((p, q) => q - p);
    const area16 = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
    return area16 > 0 ? Math.asinh(2 * a * b * c / Math.sqrt(area16)) : Infinity;
  }

  // The mean distance of a triangle's corners from vertex 0, as a share of the greatest.
  distanceShare(t) {
    const {distance, vertex} = this;
    return (distance[vertex[3 * t]] + distance[vertex[3 * t + 1]] + distance[vertex[3 * t + 2]]) / (3 * this.farthest);
  }

  label(d) { return this.isometry.subarray(4 * this.edgeLabel[d], 4 * this.edgeLabel[d] + 4); }
  // The frame of a dart's end from that of its start, and the other way round.
  alongEdge(frame, d) { return this.edgeLabel[d] === 0 ? frame : normalized(compose(frame, this.label(d))); }
  againstEdge(frame, d) { return this.edgeLabel[d] === 0 ? frame : normalized(compose(frame, inverse(this.label(d)))); }
  // Where a dart starts.
  place(frame, d) { return apply(frame, this.point[2 * this.vertex[d]], this.point[2 * this.vertex[d] + 1]); }
}

// ---- Unfolding ----

const kMost = 40000;  // triangles that are unfolded at most

class Unfolding {
  constructor(net) {
    this.net = net;
    this.here = null;  // The point of view: the corner where dart `here.dart` starts has the frame `here.frame`.
    this.lift = {
      count: 0,
      triangle: new Uint32Array(kMost),
      entry: new Uint8Array(kMost),            // the corner that is new, opposite to the edge crossed; 3: all are
      x: new Float64Array(3 * kMost), y: new Float64Array(3 * kMost), frame: new Int32Array(3 * kMost)};
    this.frames = new Float64Array(4 * 1024);
    this.frameCount = 0;
    this.goHome();
  }

  goHome() { this.goTo(this.net.vertexDart[0], this.net.point[0], this.net.point[1]); }
  // To a point in the chart of the corner where a dart starts.
  goTo(dart, x, y) {
    this.here = {dart, frame: translation(-x, -y)};
    this.settle();
  }
  move(f) {
    this.here.frame = normalized(compose(f, this.here.frame));
    this.settle();
  }

  // Moves on to the triangle that contains the centre, and to its corner nearest to the centre.
  settle() {
    const net = this.net;
    for (let steps = 0; steps < 10000; ++steps) {
      const here = this.here, d = here.dart, e = next(d), f = next(e);
      const frames = [here.frame, net.alongEdge(here.frame, d), net.againstEdge(here.frame, f)];
      const corners = [net.place(frames[0], d), net.place(frames[1], e), net.place(frames[2], f)];
      let best = 0;
      for (const i of [1, 2]) if (Math.hypot(...corners[i]) < Math.hypot(...corners[best]) - 1e-9) best = i;
      if (best !== 0) {
        this.here = {dart: [d, e, f][best], frame: frames[best]};
        continue;
      }
      // Turn around the nearest corner, or leave across the edge opposite to it.
      const outside = i => side(...corners[i], ...corners[(i + 1) % 3], 0, 0) < -1e-13;
      if (outside(0)) this.here = {dart: next(net.opposite[d]), frame: here.frame};
      else if (outside(2)) this.here = {dart: net.opposite[f], frame: here.frame};
      else if (outside(1)) this.here = {dart: next(net.opposite[e]), frame: frames[1]};
      else return;
    }
  }

  addFrame(f) {
    if (4 * this.frameCount === this.frames.length) {
      const larger = new Float64Array(2 * this.frames.length);
      larger.set(this.frames);
      this.frames = larger;
    }
    this.frames.set(f, 4 * this.frameCount);
    return this.frameCount++;
  }
  frameOf(k) { return this.frames.subarray(4 * k, 4 * k + 4); }
  // The frame of a corner of a lifted triangle.
  cornerFrame(slot, c) { return this.frameOf(this.lift.frame[3 * slot + c]); }

  putCorner(slot, i, d, frame) {
    const {lift, frames} = this, point = this.net.point;
    const k = 3 * slot + i, v = 2 * this.net.vertex[d], x = point[v], y = point[v + 1], f = 4 * frame;
    const ar = frames[f], ai = frames[f + 1], br = frames[f + 2], bi = frames[f + 3];
    const nx = ar * x - ai * y + br, ny = ar * y + ai * x + bi, dx = br * x + bi * y + ar, dy = br * y - bi * x - ai;
    const q = 1 / (dx * dx + dy * dy);
    lift.x[k] = (nx * dx + ny * dy) * q;
    lift.y[k] = (ny * dx - nx * dy) * q;
    lift.frame[k] = frame;
  }

  // Unfolds the triangles around the point of view, the nearest ones first. A lifted triangle is reached from its neighbour across its first edge that separates it
  // from a fixed interior point of the first one: so each is reached once, and nothing has to be looked up.
  // `limits`: the greatest number of triangles, the least size of one, and the box of what is seen, in units of the disk.
  unfold(limits) {
    const {net, lift, here} = this;
    this.frameCount = 0;
    lift.count = 1;
    const d = here.dart, t = (d - d % 3) / 3, i = d % 3, j = (i + 1) % 3, k = (i + 2) % 3;
    lift.triangle[0] = t;
    lift.entry[0] = 3;
    const own = this.addFrame(here.frame);
    this.putCorner(0, i, d, own);
    this.putCorner(0, j, 3 * t + j, net.edgeLabel[d] === 0 ? own : this.addFrame(net.alongEdge(here.frame, d)));
    this.putCorner(0, k, 3 * t + k, net.edgeLabel[3 * t + k] === 0 ? own : this.addFrame(net.againstEdge(here.frame, 3 * t + k)));
    // Nothing special about these weights: no line of a symmetric surface should pass through the point.
    let rx = 0, ry = 0, rw = 0;
    [0.3141, 0.3337, 0.3522].forEach((w, c) => {
      const s = w / (1 + lift.x[c] ** 2 + lift.y[c] ** 2);
      rx += 2 * s * lift.x[c]; ry += 2 * s * lift.y[c]; rw += w;
    });
    // From the Klein disk to the Poincaré disk.
    rx /= rw; ry /= rw;
    const shrink = 1 / (1 + Math.sqrt(1 - rx * rx - ry * ry));
    rx *= shrink; ry *= shrink;
    for (let slot = 0; slot < lift.count && lift.count < limits.count; ++slot)
      for (let c = 0; c < 3 && lift.count < limits.count; ++c) this.tryNeighbour(slot, c, rx, ry, limits);
  }

  tryNeighbour(slot, c, rx, ry, limits) {
    const {net, lift} = this;
    const u = 3 * slot + c, v = 3 * slot + (c + 1) % 3;
    const ux = lift.x[u], uy = lift.y[u], vx = lift.x[v], vy = lift.y[v];
    if (!(side(ux, uy, vx, vy, rx, ry) > 0)) return;
    const other = net.opposite[3 * lift.triangle[slot] + c], t = (other - other % 3) / 3;
    const j = other % 3, w = (j + 2) % 3, slot2 = lift.count;
    const put = (corner, from) => {
      lift.x[3 * slot2 + corner] = lift.x[from];
      lift.y[3 * slot2 + corner] = lift.y[from];
      lift.frame[3 * slot2 + corner] = lift.frame[from];
    };
    put(j, v);
    put((j + 1) % 3, u);
    // The third corner from the nearer one of the two.
    const near = ux * ux + uy * uy < vx * vx + vy * vy;
    const along = 3 * t + (near ? (j + 1) % 3 : w), from = near ? lift.frame[u] : lift.frame[v], before = this.frameCount;
    this.putCorner(slot2, w, 3 * t + w, net.edgeLabel[along] === 0 ? from :
        this.addFrame(near ? net.alongEdge(this.frameOf(from), along) : net.againstEdge(this.frameOf(from), along)));
    const x = lift.x[3 * slot2 + w], y = lift.y[3 * slot2 + w];
    // The sides of the new triangle: the one from corner i separates it from the reference point if that is on its right.
    const separates = i => {
      const p = 3 * slot2 + i, q = 3 * slot2 + (i + 1) % 3;
      return side(lift.x[p], lift.y[p], lift.x[q], lift.y[q], rx, ry) < 0;
    };
    let first = true;
    for (let i = 0; i < j; ++i) if (separates(i)) first = false;
    const reach = Math.max(Math.abs(ux - vx), Math.abs(uy - vy), Math.abs(ux - x), Math.abs(uy - y), Math.abs(vx - x), Math.abs(vy - y));
    const pad = 0.5 * reach + 0.25 * limits.width;
    const seen = Math.min(ux, vx, x) < limits.right + pad && Math.max(ux, vx, x) > limits.left - pad &&
                 Math.min(uy, vy, y) < limits.top + pad && Math.max(uy, vy, y) > limits.bottom - pad;
    if (!first || !seen || reach < limits.size) {
      this.frameCount = before;
      return;
    }
    lift.triangle[slot2] = t;
    lift.entry[slot2] = w;
    ++lift.count;
  }

  // The lifted triangle that contains a point of the disk; -1 if none that is unfolded does.
  slotAt(x, y) {
    const {count, x: X, y: Y} = this.lift;
    for (let slot = 0; slot < count; ++slot) {
      const k = 3 * slot;
      if (!(side(X[k], Y[k], X[k + 1], Y[k + 1], x, y) < 0 || side(X[k + 1], Y[k + 1], X[k + 2], Y[k + 2], x, y) < 0 ||
            side(X[k + 2], Y[k + 2], X[k], Y[k], x, y) < 0)) return slot;
    }
    return -1;
  }
}
