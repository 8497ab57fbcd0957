'use strict';
// What moves the point of view of a drawing (drawing.js): fingers, wheel and keys on its canvas, and ways along geodesics; what asks what is at a point.

// Those who ask for less motion are there at once.
const calmMotion = matchMedia('(prefers-reduced-motion: reduce)');

// A point of the open disk, not too close to the circle to be moved.
function inside(p) {
  const r = Math.hypot(...p);
  return r < 0.98 ? p : [p[0] * 0.98 / r, p[1] * 0.98 / r];
}

class Travel {
  // Calls `on.rest()` once everything is drawn, `on.hover(found, x, y)` with what `find` found at a point of the screen, null for nothing,
  // `on.say(text)` when a key asks, `on.tap(x, y)` for a point of the disk that is tapped or clicked, and `on.enter(x, y)` for the centre when Enter is pressed.
  constructor(drawing, on) {
    Object.assign(this, {drawing, on});
    this.pending = false;   // The next frame is asked for,
    this.frame = 0;         // by this number.
    this.resting = 0;       // A timer.
    this.budget = 6000;     // triangles while something moves
    this.glideTimer = 0;
    this.fingers = new Map();  // By pointer: where it is, in pixels; a mouse with its button down is one.
    this.tapped = null;        // Where a finger came down that has not moved since.
    this.listen(drawing.canvas);
  }

  // Draws nothing any more.
  end() {
    this.stopGliding();
    clearTimeout(this.resting);
    cancelAnimationFrame(this.frame);
    this.pending = true;
  }

  // ---- Frames ----

  // Draws all and says so: in words only once nothing moves, for those who have the page read to them.
  drawAtRest() {
    this.drawing.draw(kMost);
    this.on.rest();
  }
  // While something moves, as many triangles are drawn, from the centre outwards, as 60 frames a second allow; at rest all of more than a pixel.
  redraw() {
    if (this.pending) return;
    this.pending = true;
    const asked = performance.now();
    this.frame = requestAnimationFrame(() => {
      this.pending = false;
      const waited = performance.now() - asked;  // More than a frame: the last picture is still on its way to the screen.
      this.drawing.draw(this.budget);
      if (this.drawing.lastDraw > 12 || waited > 20) this.budget = Math.max(1500, Math.round(0.8 * this.budget));
      else if (this.drawing.lastDraw < 9) this.budget = Math.min(kMost, Math.round(1.1 * this.budget));
      clearTimeout(this.resting);
      this.resting = setTimeout(() => this.drawAtRest(), 150);
    });
  }

  // ---- Moving ----

  move(f) { this.drawing.unfolding.move(f); }
  setZoom(value) { this.drawing.zoom = Math.min(1e6, Math.max(0.2, value)); }
  // What two fingers do: zooms by a factor and turns by an angle, counterclockwise; what was at `from` is then at `to`, in pixels.
  pinch(from, to, factor, angle) {
    const drawing = this.drawing;
    this.stopGliding();
    drawing.frameView();
    const p = drawing.toDisk(...from);
    this.setZoom(drawing.zoom * factor);
    drawing.frameView();
    if (Math.hypot(...p) >= 0.98) {
      this.move(turn(angle));
    } else {
      const q = inside(drawing.toDisk(...to));
      this.move(compose(compose(translation(...q), turn(angle)), compose(translation(-q[0], -q[1]), translationTo(p, q))));
    }
    this.redraw();
  }
  stepLength() { return 0.06 / Math.max(1, this.drawing.zoom); }
  step(x, y) {
    this.stopGliding();
    this.move(translation(this.stepLength() * x, this.stepLength() * y));
    this.redraw();
  }
  rotate(angle) {
    this.stopGliding();
    this.move(turn(angle));
    this.redraw();
  }
  zoomBy(factor) {
    this.setZoom(this.drawing.zoom * factor);
    this.redraw();
  }
  goHome() {
    this.stopGliding();
    this.drawing.goHome();
    this.redraw();
  }

  // Glides along the line through the centre at an angle, so far, in some seconds; 0: at once.
  glide(angle, length, seconds) {
    this.stopGliding();
    const forward = d => {
      const steps = Math.max(1, Math.ceil(d)), t = -Math.tanh(d / steps / 2);  // Short steps keep all their digits.
      for (let k = 0; k < steps; ++k) this.move(translation(t * Math.cos(angle), t * Math.sin(angle)));
    };
    if (seconds === 0) {
      forward(length);
      this.redraw();
      return;
    }
    const started = performance.now();
    let done = 0;
    const frame = () => {
      const s = Math.min(1, (performance.now() - started) / (1000 * seconds)), goal = length * s * s * (3 - 2 * s);
      if (goal > done) forward(goal - done);
      done = Math.max(done, goal);
      this.redraw();
      this.glideTimer = s < 1 ? requestAnimationFrame(frame) : 0;
    };
    frame();
  }
  stopGliding() {
    cancelAnimationFrame(this.glideTimer);
    this.glideTimer = 0;
  }

  // Brings the selected geodesic to the centre.
  goToSelected(seconds = calmMotion.matches ? 0 : 0.6) {
    const {layer, first} = this.drawing.selected, arc = this.drawing.nearestArc(this.drawing.selected);
    if (arc !== null) {
      const [x, y] = arc[0];
      this.glide(Math.atan2(y, x), 2 * Math.atanh(Math.hypot(x, y)), seconds);
      return;
    }
    this.stopGliding();
    const [ux, uy, vx, vy] = layer.ends.subarray(4 * first, 4 * first + 4);
    this.drawing.unfolding.goTo(layer.arcs[first], ...halfWay([ux, uy], [vx, vy]));
    this.redraw();
  }
  // Once around the selected geodesic: the end is the beginning.
  aroundSelected(seconds) {
    this.goToSelected(0);
    const [middle, end] = this.drawing.nearestArc(this.drawing.selected), [x, y] = apply(translation(-middle[0], -middle[1]), ...end);
    this.glide(Math.atan2(y, x), this.drawing.selected.length, seconds);
  }

  // ---- Pointing ----

  // Asks what is at a point of the screen.
  hover(x, y) {
    const at = this.drawing.toDisk(x, y);
    this.drawing.hovered = at[0] ** 2 + at[1] ** 2 < 1 ? this.drawing.find(...at) : null;
    this.on.hover(this.drawing.hovered, x, y);
    this.redraw();
  }
  endHover() {
    this.drawing.hovered = null;
    this.on.hover(null, 0, 0);
  }

  listen(canvas) {
    const {drawing, fingers} = this;
    canvas.addEventListener('pointerdown', event => {
      this.stopGliding();
      this.endHover();
      fingers.set(event.pointerId, [event.offsetX, event.offsetY]);
      this.tapped = fingers.size === 1 ? [event.offsetX, event.offsetY] : null;
      canvas.classList.add('dragging');
      try { canvas.setPointerCapture(event.pointerId); } catch (error) { /* a pointer that is gone already */ }
    });
    for (const type of ['pointerup', 'pointercancel'])
      canvas.addEventListener(type, event => {
        if (!fingers.delete(event.pointerId) || fingers.size > 0) return;
        canvas.classList.remove('dragging');
        const tapped = this.tapped;
        this.tapped = null;
        if (type !== 'pointerup' || tapped === null) return;
        this.hover(...tapped);
        this.on.tap(...drawing.toDisk(...tapped));
      });
    canvas.addEventListener('pointerleave', event => { if (event.pointerType !== 'touch') this.endHover(); });
    canvas.addEventListener('pointermove', event => {
      const at = [event.offsetX, event.offsetY];
      if (!fingers.has(event.pointerId)) {
        if (fingers.size === 0) this.hover(...at);
        return;
      }
      if (this.tapped !== null && Math.hypot(at[0] - this.tapped[0], at[1] - this.tapped[1]) < 4) return;
      this.tapped = null;
      const before = fingers.get(event.pointerId);
      fingers.set(event.pointerId, at);
      if (fingers.size === 1) {
        this.move(translationTo(inside(drawing.toDisk(...before)), inside(drawing.toDisk(...at))));
        this.redraw();
      } else if (fingers.size === 2) {
        const [other] = [...fingers].filter(([id]) => id !== event.pointerId).map(([, place]) => place);
        const middle = p => [(p[0] + other[0]) / 2, (p[1] + other[1]) / 2];
        const spread = p => Math.max(1, Math.hypot(p[0] - other[0], p[1] - other[1]));
        const direction = p => Math.atan2(other[1] - p[1], p[0] - other[0]);  // y of the screen points down
        this.pinch(middle(before), middle(at), spread(at) / spread(before), direction(at) - direction(before));
      }
    });
    canvas.addEventListener('dblclick', event => {
      this.move(translationTo(inside(drawing.toDisk(event.offsetX, event.offsetY)), [0, 0]));
      this.endHover();
      this.redraw();
    });
    canvas.addEventListener('wheel', event => {
      event.preventDefault();
      const pixels = event.deltaY * (event.deltaMode === 1 ? 16 : 1), at = [event.offsetX, event.offsetY];
      this.pinch(at, at, Math.exp(-(event.ctrlKey ? 0.01 : 0.0015) * pixels), 0);  // With Ctrl: two fingers on a touch pad.
    }, {passive: false});

    // Keys belong to the control that has the focus, and with Ctrl, Alt or Meta to the browser.
    canvas.addEventListener('keydown', event => {
      if (event.ctrlKey || event.altKey || event.metaKey) return;
      const act = {
        ArrowLeft: () => event.shiftKey ? this.rotate(0.05) : this.step(1, 0), ArrowRight: () => event.shiftKey ? this.rotate(-0.05) : this.step(-1, 0),
        ArrowUp: () => this.step(0, -1), ArrowDown: () => this.step(0, 1),
        '+': () => this.zoomBy(1.2), '=': () => this.zoomBy(1.2), '-': () => this.zoomBy(1 / 1.2), Home: () => this.goHome(),
        Enter: () => {
          drawing.draw(kMost);
          this.on.say(drawing.describe(drawing.find(0, 0)).replaceAll('\n', ', '));
          this.on.enter(0, 0);
        }
      }[event.key];
      if (act === undefined) return;
      event.preventDefault();
      act();
    });
  }
}
