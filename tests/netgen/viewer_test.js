// Appended to a page of `epsnet view`: clicks, drags and turns, and checks what is drawn. Leaves the result in the page's text.
{
  const failures = [];
  const expect = (holds, what) => { if (!holds) failures.push(what); };
  const near = (x, y, tolerance, what) => expect(Math.abs(x - y) <= tolerance, `${what}: ${x} is not ${y}`);
  const distance = (p, q) => 2 * Math.asinh(Math.hypot(p[0] - q[0], p[1] - q[1]) / Math.sqrt((1 - p[0] ** 2 - p[1] ** 2) * (1 - q[0] ** 2 - q[1] ** 2)));
  const corner = (slot, c) => [lift.x[3 * slot + c], lift.y[3 * slot + c]];
  const pixels = () => {
    const data = pen.getImageData(0, 0, canvas.width, canvas.height).data;
    let sum = 0;
    for (let i = 0; i < data.length; i += 4) sum = (sum * 31 + data[i] + 7 * data[i + 1] + 49 * data[i + 2]) >>> 0;
    return sum;
  };
  // offsetX and offsetY of a made event follow from its client coordinates.
  const at = (type, x, y) => {
    const box = canvas.getBoundingClientRect();
    canvas.dispatchEvent(new PointerEvent(type, {bubbles: true, pointerId: 1, clientX: box.left + x, clientY: box.top + y}));
  };

  // What is unfolded is a part of the universal cover: edges have the lengths of the net, triangles are counterclockwise, no lift comes twice.
  function checkUnfolding(where) {
    draw(kMost);
    const seen = new Set();
    expect(lift.count > 10, `${where}: only ${lift.count} triangles`);
    for (let slot = 0; slot < lift.count; ++slot) {
      const t = lift.triangle[slot], corners = [0, 1, 2].map(c => corner(slot, c));
      const key = t + ' ' + corners[0].map(x => Math.round(1e6 * x)).join(' ');
      expect(!seen.has(key), `${where}: triangle ${t} is unfolded twice at ${key}`);
      seen.add(key);
      if (Math.max(...corners.map(p => Math.hypot(...p))) > 0.999) continue;
      expect(side(...corners[0], ...corners[1], ...corners[2]) > 0, `${where}: triangle ${t} is not counterclockwise`);
      for (let c = 0; c < 3; ++c)
        near(distance(corners[c], corners[(c + 1) % 3]), edgeLength(3 * t + c), 1e-6 * (1 + edgeLength(3 * t + c)), `${where}: length of an edge of triangle ${t}`);
      if (failures.length > 5) return;
    }
    const c = [0, 1, 2].map(i => corner(0, i));
    for (let i = 0; i < 3; ++i) expect(side(...c[i], ...c[(i + 1) % 3], 0, 0) > -1e-9, `${where}: the centre is not in the first triangle`);
    near(here.frame[0] ** 2 + here.frame[1] ** 2 - here.frame[2] ** 2 - here.frame[3] ** 2, 1, 1e-9, `${where}: the frame's determinant`);
    // Around the centre there are no holes: points near it are in a triangle.
    for (let k = 0; k < 40; ++k) expect(find(0.7 * Math.cos(2.4 * k) * k / 40, 0.7 * Math.sin(2.4 * k) * k / 40) !== null, `${where}: a hole`);
  }

  checkUnfolding('start');
  near(vertex[here.dart], 0, 0, 'the vertex in the centre at the start');

  // A drag takes the point that was grabbed along.
  const grabbedPoint = toDisk(ox + 60, oy - 40), where = find(...grabbedPoint);
  at('pointerdown', ox + 60, oy - 40);
  at('pointermove', ox + 20, oy + 30);
  at('pointerup', ox + 20, oy + 30);
  checkUnfolding('after a drag');
  expect(find(...toDisk(ox + 20, oy + 30)).triangle === where.triangle, 'the triangle grabbed is not under the pointer');

  // There and back is where one was (directions that differ by 2^-53 are e^15 as far apart after a way of 15).
  home();
  const dart = here.dart;
  for (let k = 0; k < 75; ++k) move(translation(0.1, 0.02));
  checkUnfolding('far away');
  for (let k = 0; k < 75; ++k) move(translation(-0.1, -0.02));
  near(Math.hypot(...place(here.frame, here.dart)), 0, 1e-6, 'the way back');
  expect(vertex[here.dart] === vertex[dart], 'the way back ends at another vertex');
  let seed = 1;
  for (let k = 0; k < 1000; ++k) {
    seed = (seed * 16807) % 2147483647;
    move(translation(0.3 * Math.cos(seed), 0.3 * Math.sin(seed)));
  }
  checkUnfolding('after a random walk');

  // Keys, wheel, double click.
  const frame = Array.from(here.frame);
  dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowLeft'}));
  expect(frame.some((x, i) => Math.abs(x - here.frame[i]) > 1e-3), 'an arrow key does not turn');
  dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowRight'}));
  expect(frame.every((x, i) => Math.abs(x - here.frame[i]) < 1e-9), 'the other arrow key does not turn back');
  const zoomBefore = zoom;
  canvas.dispatchEvent(new WheelEvent('wheel', {deltaY: -500, cancelable: true}));
  expect(zoom > 1.5 * zoomBefore, 'the wheel does not zoom');
  checkUnfolding('zoomed');
  dispatchEvent(new KeyboardEvent('keydown', {key: 'Home'}));
  expect(zoom === zoomBefore, 'Home does not lead home');

  // Every switch and every colouring changes the picture and changes it back.
  draw(kMost);
  hovered = null;
  for (const box of document.querySelectorAll('#layers input')) {
    draw(kMost);
    const one = pixels();
    box.click();
    draw(kMost);
    expect(pixels() !== one, `switch ${box.id} changes nothing`);
    box.click();
    draw(kMost);
    expect(pixels() === one, `switch ${box.id} does not change back`);
  }
  const shown = new Set();
  for (const choice of document.querySelectorAll('#colours input')) {
    choice.click();
    draw(kMost);
    shown.add(pixels());
  }
  expect(shown.size >= 2, 'the colourings look the same');

  // Hovering says what is there.
  at('pointermove', ox, oy);
  expect($('hover').textContent.includes('vertex 0'), `hovering over vertex 0 says ${$('hover').textContent}`);
  expect(/circumradius [0-9.]+$/.test($('hover').textContent), `no circumradius in ${$('hover').textContent}`);
  const [u, v] = [corner(0, 0), corner(0, 1)], seenFromU = apply(translation(-u[0], -u[1]), ...v);
  const half = 1 / (1 + Math.sqrt(1 - seenFromU[0] ** 2 - seenFromU[1] ** 2));
  const middle = apply(translation(...u), half * seenFromU[0], half * seenFromU[1]);
  at('pointermove', ox + scale * middle[0], oy - scale * middle[1]);
  expect($('hover').textContent.includes('length'), `hovering over an edge says ${$('hover').textContent}`);
  for (let t = 0; t < triangleCount; ++t) expect(radius[t] <= 1.000001 * epsilon || net.verdict !== 'VERIFIED', `circumradius ${radius[t]}`);

  document.body.textContent = failures.length === 0 ? 'viewer-test: passed' : 'viewer-test: ' + failures.slice(0, 8).join('; ');
}
