// Appended to a page of `epsnet view`: clicks, drags and turns, and checks what is drawn. Leaves the result in the page's text.
{
  const failures = [];
  const {drawing, travel} = viewer, {unfolding, lift, canvas, pen, layers, geodesics} = drawing, {vertex, epsilon, radius} = net;
  const home = () => drawing.goHome(), draw = count => drawing.draw(count);
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
  const at = (type, x, y, pointerId = 1) => {
    const box = canvas.getBoundingClientRect();
    canvas.dispatchEvent(new PointerEvent(type, {bubbles: true, pointerId, clientX: box.left + x, clientY: box.top + y}));
  };
  // What goes wrong in one part is no excuse for the others.
  const test = (name, body) => {
    try { body(); } catch (error) { failures.push(`${name}: ${error}`); }
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
        near(distance(corners[c], corners[(c + 1) % 3]), net.edgeLength(3 * t + c), 1e-6 * (1 + net.edgeLength(3 * t + c)), `${where}: length of an edge of triangle ${t}`);
      if (failures.length > 5) return;
    }
    const c = [0, 1, 2].map(i => corner(0, i));
    for (let i = 0; i < 3; ++i) expect(side(...c[i], ...c[(i + 1) % 3], 0, 0) > -1e-9, `${where}: the centre is not in the first triangle`);
    near(unfolding.here.frame[0] ** 2 + unfolding.here.frame[1] ** 2 - unfolding.here.frame[2] ** 2 - unfolding.here.frame[3] ** 2, 1, 1e-9, `${where}: the frame's determinant`);
    // Around the centre there are no holes: points near it are in a triangle.
    for (let k = 0; k < 40; ++k) expect(drawing.find(0.7 * Math.cos(2.4 * k) * k / 40, 0.7 * Math.sin(2.4 * k) * k / 40) !== null, `${where}: a hole`);
  }

  const isOn = new Map(layers.map(layer => [layer.id, layer.on]));
  test('the start', () => {
    checkUnfolding('start');
    near(vertex[unfolding.here.dart], 0, 0, 'the vertex in the centre at the start');
  });

  test('a drag', () => {
    // A drag takes the point that was grabbed along.
    const grabbedPoint = drawing.toDisk(drawing.ox + 60, drawing.oy - 40), where = drawing.find(...grabbedPoint);
    at('pointerdown', drawing.ox + 60, drawing.oy - 40);
    at('pointermove', drawing.ox + 20, drawing.oy + 30);
    at('pointerup', drawing.ox + 20, drawing.oy + 30);
    checkUnfolding('after a drag');
    expect(drawing.find(...drawing.toDisk(drawing.ox + 20, drawing.oy + 30)).triangle === where.triangle, 'the triangle grabbed is not under the pointer');
  });

  test('there and back', () => {
    // There and back is where one was (directions that differ by 2^-53 are e^15 as far apart after a way of 15).
    home();
    const dart = unfolding.here.dart;
    for (let k = 0; k < 75; ++k) travel.move(translation(0.1, 0.02));
    checkUnfolding('far away');
    for (let k = 0; k < 75; ++k) travel.move(translation(-0.1, -0.02));
    near(Math.hypot(...net.place(unfolding.here.frame, unfolding.here.dart)), 0, 1e-6, 'the way back');
    expect(vertex[unfolding.here.dart] === vertex[dart], 'the way back ends at another vertex');
    let seed = 1;
    for (let k = 0; k < 1000; ++k) {
      seed = (seed * 16807) % 2147483647;
      travel.move(translation(0.3 * Math.cos(seed), 0.3 * Math.sin(seed)));
    }
    checkUnfolding('after a random walk');
  });

  test('keys in the picture', () => {
    home();
    const press = (key, more) => {
      const event = new KeyboardEvent('keydown', {key, bubbles: true, cancelable: true, ...more});
      canvas.dispatchEvent(event);
      return event.defaultPrevented;
    };
    const frame = Array.from(unfolding.here.frame), isAsBefore = () => frame.every((x, i) => Math.abs(x - unfolding.here.frame[i]) < 1e-9);
    for (const [there, back, shiftKey] of [['ArrowLeft', 'ArrowRight', true], ['ArrowLeft', 'ArrowRight', false], ['ArrowUp', 'ArrowDown', false]]) {
      expect(press(there, {shiftKey}), `${there} is not taken`);
      expect(!isAsBefore(), `${there} does not move`);
      press(back, {shiftKey});
      expect(isAsBefore(), `${back} does not move back`);
    }
    // To look to the left moves the surface to the right; in thin parts another vertex may then be the nearest.
    home();
    press('ArrowLeft', {});
    const pressed = unfolding.here.dart, pressedFrame = Array.from(unfolding.here.frame);
    home();
    expect(travel.stepLength() > 0.01, 'a step is too short to be seen');
    travel.move(translation(travel.stepLength(), 0));
    expect(unfolding.here.dart === pressed && pressedFrame.every((x, i) => Math.abs(x - unfolding.here.frame[i]) < 1e-9), 'ArrowLeft does not look to the left');
    home();
    travel.move(translation(1e-6, 0));
    near(net.place(unfolding.here.frame, net.vertexDart[0])[0], 1e-6, 1e-9, 'a translation to the right');
    home();
    const zoomBefore = drawing.zoom;
    press('+', {shiftKey: true});
    expect(drawing.zoom > zoomBefore, '+ does not zoom');
    press('-', {});
    near(drawing.zoom, zoomBefore, 1e-9, 'zoom after + and -');
    press('Enter', {});
    expect($('status').textContent.includes('vertex 0'), `Enter says ${$('status').textContent}`);
    press('+', {});
    press('Home', {});
    expect(drawing.zoom === zoomBefore && isAsBefore(), 'Home does not lead home');
  });

  test('keys that belong to others', () => {
    home();
    const frame = unfolding.here.frame, zoomBefore = drawing.zoom;
    const untouched = (target, key, more) => {
      const event = new KeyboardEvent('keydown', {key, bubbles: true, cancelable: true, ...more});
      target.dispatchEvent(event);
      expect(!event.defaultPrevented && unfolding.here.frame === frame && drawing.zoom === zoomBefore, `${JSON.stringify(more)} ${key} is swallowed on ${target.id || target.tagName}`);
    };
    for (const key of ['ArrowLeft', 'ArrowUp', 'ArrowDown', 'Home', '+', '-'])
      for (const target of [document.querySelector('#colours input'), document.querySelector('#layers input'), document.body]) untouched(target, key, {});
    for (const more of [{ctrlKey: true}, {metaKey: true}, {altKey: true}]) for (const key of ['+', '-', 'ArrowLeft', 'Home']) untouched(canvas, key, more);
  });

  test('wheel', () => {
    home();
    draw(kMost);
    const zoomBefore = drawing.zoom, x = drawing.ox + 50, y = drawing.oy - 30, box = canvas.getBoundingClientRect(), under = drawing.find(...drawing.toDisk(x, y));
    canvas.dispatchEvent(new WheelEvent('wheel', {deltaY: -500, cancelable: true, clientX: box.left + x, clientY: box.top + y}));
    expect(drawing.zoom > 1.5 * zoomBefore, 'the wheel does not zoom');
    checkUnfolding('zoomed');
    expect(drawing.find(...drawing.toDisk(x, y)).triangle === under.triangle, 'what is under the pointer does not stay there');
    home();
  });

  // ---- Fingers ----

  // Puts two fingers down, moves them along their ways in turns, and takes them up.
  const fingersMove = (first, second, steps) => {
    at('pointerdown', ...first(0), 1);
    at('pointerdown', ...second(0), 2);
    for (let k = 1; k <= steps; ++k) {
      at('pointermove', ...first(k / steps), 1);
      at('pointermove', ...second(k / steps), 2);
    }
    at('pointerup', ...first(1), 1);
    at('pointerup', ...second(1), 2);
    draw(kMost);
  };
  test('two fingers apart', () => {
    home();
    draw(kMost);
    const zoomBefore = drawing.zoom, middle = [drawing.ox - 20, drawing.oy + 30], under = drawing.find(...drawing.toDisk(...middle));
    const finger = sign => s => [middle[0] + sign * (40 + 40 * s), middle[1]];
    fingersMove(finger(-1), finger(1), 10);
    near(drawing.zoom, 2 * zoomBefore, 1e-6, 'zoom by two fingers twice as far apart');
    expect(drawing.find(...drawing.toDisk(...middle)).triangle === under.triangle, 'what is between the fingers does not stay there');
    checkUnfolding('after two fingers');
    home();
  });
  test('two fingers turn', () => {
    home();
    draw(kMost);
    // A triangle at the vertex in the centre, and the direction of another corner.
    const t = lift.triangle[0], c = [0, 1, 2].find(i => vertex[3 * t + i] === 0 && Math.hypot(...corner(0, i)) < 1e-9), other = (c + 1) % 3;
    const angleOf = slot => Math.atan2(corner(slot, other)[1], corner(slot, other)[0]);
    const before = angleOf(0), zoomBefore = drawing.zoom;
    const finger = sign => s => [drawing.ox + sign * 80 * Math.cos(s * Math.PI / 2), drawing.oy - sign * 80 * Math.sin(s * Math.PI / 2)];
    fingersMove(finger(1), finger(-1), 90);
    const slot = [...Array(lift.count).keys()].find(k => lift.triangle[k] === t && Math.hypot(...corner(k, c)) < 0.02);
    expect(slot !== undefined, 'the centre moved');
    near(Math.cos(angleOf(slot) - before - Math.PI / 2), 1, 1e-3, 'a quarter of a turn');
    near(drawing.zoom, zoomBefore, 1e-2, 'zoom after a turn');
    home();
  });
  test('two fingers move', () => {
    home();
    draw(kMost);
    const under = drawing.find(...drawing.toDisk(drawing.ox + 23, drawing.oy - 11)), zoomBefore = drawing.zoom;
    fingersMove(s => [drawing.ox - 17 + 60 * s, drawing.oy - 11 + 40 * s], s => [drawing.ox + 63 + 60 * s, drawing.oy - 11 + 40 * s], 20);
    expect(drawing.find(...drawing.toDisk(drawing.ox + 83, drawing.oy + 29)).triangle === under.triangle, 'what is between the fingers does not come along');
    near(drawing.zoom, zoomBefore, 1e-6, 'zoom after a move');
    home();
  });
  test('a tap asks what is there', () => {
    home();
    draw(kMost);
    at('pointerdown', drawing.ox, drawing.oy, 3);
    at('pointerup', drawing.ox, drawing.oy, 3);
    expect($('hover').style.display === 'block' && $('hover').textContent.includes('vertex 0'), 'a tap says nothing');
    at('pointerdown', drawing.ox, drawing.oy, 3);
    at('pointermove', drawing.ox + 50, drawing.oy, 3);
    at('pointerup', drawing.ox + 50, drawing.oy, 3);
    expect($('hover').style.display === 'none', 'a drag says what is there');
    home();
  });

  test('switches and colourings', () => {
    // Every switch and every colouring changes the picture and changes it back.
    draw(kMost);
    drawing.hovered = null;
    home();
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
    const looks = new Set();
    expect((net.distance.length > 0) === (net.data.verdict === 'VERIFIED'), 'distances of a net that is not verified, or none of one that is');
    for (const choice of document.querySelectorAll('#colours input')) {
      choice.click();
      draw(kMost);
      looks.add(pixels());
    }
    expect(looks.size >= 2, 'the colourings look the same');
  });

  test('hovering', () => {
    home();
    draw(kMost);
    // Hovering says what is there.
    at('pointermove', drawing.ox, drawing.oy);
    expect($('hover').textContent.includes('vertex 0'), `hovering over vertex 0 says ${$('hover').textContent}`);
    expect(/circumradius [0-9.]+$/.test($('hover').textContent), `no circumradius in ${$('hover').textContent}`);
    const [u, v] = [corner(0, 0), corner(0, 1)], seenFromU = apply(translation(-u[0], -u[1]), ...v);
    const half = 1 / (1 + Math.sqrt(1 - seenFromU[0] ** 2 - seenFromU[1] ** 2));
    const middle = apply(translation(...u), half * seenFromU[0], half * seenFromU[1]);
    at('pointermove', drawing.ox + drawing.scale * middle[0], drawing.oy - drawing.scale * middle[1]);
    expect($('hover').textContent.includes('length'), `hovering over an edge says ${$('hover').textContent}`);
    const inCollar = t => layers.some(layer => layer.name === 'triangles of collars' && layer.isTriangle.has(t));
    for (let t = 0; t < net.triangleCount; ++t)
      expect(radius[t] <= 1.000001 * epsilon || inCollar(t) || net.data.verdict !== 'VERIFIED', `circumradius ${radius[t]}`);
  });

  // ---- The panel, the legend, the geodesics ----

  const legendText = () => [...document.querySelectorAll('#legend li')].map(row => row.textContent);
  test('the legend follows the picture', () => {
    for (const layer of layers) {
      if (layer.on) $(layer.id).click();
    }
    $('colour-none').click();
    if (!$('unselect').disabled) $('unselect').click();  // A closed geodesic that was clicked.
    expect(legendText().length === 0, `a legend of nothing: ${legendText()}`);
    for (const layer of layers) {
      $(layer.id).click();
      expect(legendText().some(text => text.startsWith(layer.name)), `${layer.name} is not in the legend`);
      $(layer.id).click();
      expect(!legendText().some(text => text.startsWith(layer.name)), `${layer.name} stays in the legend`);
    }
    $('colour-circumradius').click();
    expect(legendText().some(text => text.includes('circumradius')), 'no circumradii in the legend');
    $('colour-chart').click();
    expect(!legendText().some(text => text.includes('circumradius')), 'circumradii in a legend of charts');
    const shown = new Set([...Array(lift.count).keys()].map(slot => net.chart[vertex[3 * lift.triangle[slot]]]));
    for (const k of [...shown].slice(0, 8)) expect(legendText().includes(`chart ${k}`), `chart ${k} is not in the legend`);
    $('colour-circumradius').click();
    for (const layer of layers) if (layer.on !== isOn.get(layer.id)) $(layer.id).click();
  });

  test('what can be used has a name, and shows the focus', () => {
    const nameOf = control => control.getAttribute('aria-label') || control.textContent.trim() || (control.labels || [])[0]?.textContent.trim() ||
        (control.getAttribute('aria-labelledby') || '').split(' ').map(id => $(id)?.textContent).join(' ').trim();
    const controls = document.querySelectorAll('button, input, select, canvas[tabindex]');
    expect(controls.length > 12, `only ${controls.length} controls`);
    for (const control of controls) {
      const what = control.id || control.tagName;
      expect(nameOf(control), `${what} has no name`);
      expect(control.tabIndex === 0, `${what} is out of the order of the page`);
      if (control.disabled || control.getClientRects().length === 0) continue;
      control.focus();
      expect(document.activeElement === control, `${what} does not take the focus`);
      expect(parseFloat(getComputedStyle(control).outlineWidth) >= 2, `${what} does not show the focus`);
    }
    document.activeElement.blur();
    expect($('status').getAttribute('role') === 'status', 'the status is not said aloud');
    expect(canvas.getAttribute('role') !== null && $(canvas.getAttribute('aria-describedby')).textContent.includes('Home'), 'the picture has no role, or keys that nobody is told');
    const ids = [...document.querySelectorAll('[id]')].map(element => element.id);
    expect(new Set(ids).size === ids.length, 'an id comes twice');
    expect($('histogram').getAttribute('aria-label').includes('circumradii from'), 'the histogram says nothing');
    for (const select of ['header', 'main', 'aside', 'h1']) expect(document.querySelector(select) !== null, `no ${select}`);
    const choices = [...document.querySelectorAll('#colours input')];
    expect(choices.every(choice => choice.closest('fieldset')?.querySelector('legend')), 'choices without a heading');
  });

  test('the buttons beside the picture', () => {
    home();
    const zoomBefore = drawing.zoom, frame = unfolding.here.frame;
    $('zoom-in').click();
    expect(drawing.zoom > zoomBefore, 'zoom in');
    $('zoom-out').click();
    near(drawing.zoom, zoomBefore, 1e-9, 'zoom out');
    $('turn-left').click();
    expect(unfolding.here.frame !== frame, 'turn left');
    $('turn-right').click();
    expect(unfolding.here.frame.every((x, i) => Math.abs(x - frame[i]) < 1e-9), 'turn right');
    $('zoom-in').click();
    $('home').click();
    expect(drawing.zoom === zoomBefore, 'home');
    $('toggle').click();
    expect($('panel').hidden && $('toggle').getAttribute('aria-expanded') === 'false', 'the panel does not close');
    $('toggle').click();
    expect(!$('panel').hidden && $('toggle').getAttribute('aria-expanded') === 'true', 'the panel does not open');
  });

  test('closed geodesics', () => {
    const expected = net.data.layers.flatMap(layer => layer.parts || []);
    expect($('geodesics').options.length === expected.length, `${$('geodesics').options.length} of ${expected.length} geodesics are listed`);
    expect($('geodesics-section').hidden === (expected.length === 0), 'the list of geodesics is not there, or empty');
    for (const g of geodesics) {
      home();
      drawing.hovered = null;
      draw(kMost);
      viewer.select(g);
      draw(kMost);
      expect($('geodesics').selectedIndex === geodesics.indexOf(g) && !$('travel').disabled, `${g.name} is not selected`);
      expect(legendText().some(text => text.includes(g.name)), `${g.name} is not in the legend`);
      travel.goToSelected(0);
      near(Math.hypot(...drawing.nearestArc(g)[0]), 0, 1e-6, `${g.name}: the distance from the centre`);
      // It, or another one through the same point, is there.
      expect(drawing.geodesicAt(0, 0) !== null, `${g.name} is not found in the centre`);
      g.layer.on = false;
      expect(drawing.geodesicAt(0, 0)?.layer !== g.layer, `${g.name} is found where it is not shown`);
      g.layer.on = true;
      const lit = pixels();
      viewer.select(null);
      draw(kMost);
      expect(pixels() !== lit, `${g.name} is not lit up`);
      viewer.select(g);
      // Once around a closed geodesic is the identity: the same corner, with the same frame.
      const dart = unfolding.here.dart, frame = Array.from(unfolding.here.frame);
      travel.aroundSelected(0);
      draw(kMost);
      const slots = [...Array(lift.count).keys()].filter(slot => lift.triangle[slot] === (dart - dart % 3) / 3);
      const there = net.place(frame, dart);
      expect(slots.some(slot => Math.hypot(corner(slot, dart % 3)[0] - there[0], corner(slot, dart % 3)[1] - there[1]) < 1e-5), `${g.name}: once around is somewhere else`);
      checkUnfolding(`after ${g.name}`);
    }
    viewer.select(null);
    home();
  });

  test('the status', () => {
    travel.drawAtRest();
    expect(/^[0-9]+ triangles in view, zoom [0-9.]+, near vertex [0-9]+$/.test($('status').textContent), `the status is ${$('status').textContent}`);
    const before = $('status').textContent;
    travel.move(translation(0.1, 0));
    draw(100);
    expect($('status').textContent === before, 'the status is said while something moves');
    home();
  });

  // ---- Schemes, saved pictures ----

  test('a dark scheme', () => {
    const paper = () => pen.getImageData(2, canvas.height - 3, 1, 1).data;
    for (const [value, isDark] of [['dark', true], ['light', false]]) {
      $('scheme').value = value;
      $('scheme').dispatchEvent(new Event('change'));
      expect((paper()[0] < 60) === isDark, `the picture is not ${value}`);
      expect((luminance(getComputedStyle(document.body).backgroundColor.match(/[0-9]+/g).map(Number)) < 0.05) === isDark, `the page is not ${value}`);
      for (const layer of layers)
        expect(contrast(channels(onPaper(layer.colour)), channels(schemes[scheme].paper)) >= (isDark ? 4.4 : 1.5), `${layer.name} cannot be seen on ${value} paper`);
    }
  });

  // The page is not loaded, and its text not looked at, before its images are: so there is time for this.
  const bitmap = file => new Promise((resolve, reject) => {
    const image = new Image();
    image.onload = () => resolve(pixelsOf(image));
    image.onerror = () => reject(new Error(`a saved ${file.type} is none`));
    image.src = URL.createObjectURL(file);
  });
  const pixelsOf = source => {
    const copy = document.createElement('canvas'), g = copy.getContext('2d');
    copy.width = drawing.width;
    copy.height = drawing.height;
    g.drawImage(source, 0, 0, drawing.width, drawing.height);
    return g.getImageData(0, 0, drawing.width, drawing.height).data;
  };
  // The share of points, below a height, where two pictures differ visibly.
  const difference = (p, q, top) => {
    let count = 0;
    for (let i = 4 * top * drawing.width; i < p.length; i += 4)
      if (Math.abs(p[i] - q[i]) + Math.abs(p[i + 1] - q[i + 1]) + Math.abs(p[i + 2] - q[i + 2]) > 150) ++count;
    return count / (p.length / 4 - top * drawing.width);
  };
  const fromScreen = async file => difference(await bitmap(file), pixelsOf(canvas), Math.min(drawing.height, 40 + 18 * drawing.legendEntries().length));
  // A few long arcs, circles and fills in both inks: a wrong bend would show.
  const testInks = async () => {
    drawing.zoom = 1;
    drawing.frameView();
    const sheet = document.createElement('canvas');
    sheet.width = drawing.width;
    sheet.height = drawing.height;
    const inks = [new CanvasInk(sheet.getContext('2d'), drawing.width, drawing.height), new SvgInk(drawing.width, drawing.height, net.data.title)];
    for (const ink of inks) {
      const arcs = ink.path(), disks = ink.path(), inner = ink.path();
      ink.background('#ffffff');
      ring(inner, drawing.ox, drawing.oy, 0.9 * drawing.scale);
      ink.clip(inner);
      for (let k = 0; k < 8; ++k) {
        const u = [0.95 * Math.cos(k), 0.95 * Math.sin(k)], v = [0.9 * Math.cos(k + 1 + 0.2 * k), 0.9 * Math.sin(k + 1 + 0.2 * k)];
        if (k % 2 === 0) drawing.geodesic(arcs, ...u, ...v);
        else drawing.geodesic(arcs, ...v, ...u);
        drawing.circle(disks, 0.5 * Math.sin(3 * k), 0.5 * Math.cos(5 * k), 0.1 + 0.05 * k);
      }
      ink.fill(disks, '#2f9468', 0.5);
      ink.stroke(arcs, '#b5197f', 4);
      ink.endClip();
    }
    const different = difference(await bitmap(new Blob([inks[1].toString()], {type: 'image/svg+xml'})), pixelsOf(sheet), 0);
    expect(different < 0.002, `arcs in SVG differ from those on the screen in ${different} of the points`);
    home();
  };
  const testSaving = async () => {
    for (const value of ['dark', 'light']) {
      // Once with everything on.
      if (value === 'light') for (const layer of layers) layer.on = true;
      $('scheme').value = value;
      $('scheme').dispatchEvent(new Event('change'));
      travel.endHover();
      const file = drawing.svgPicture(), ink = new SvgInk(drawing.width, drawing.height, net.data.title);
      drawing.paint(ink);
      drawing.drawLegend(ink);
      const text = ink.toString(), svg = new DOMParser().parseFromString(text, 'image/svg+xml');
      expect(file.type === 'image/svg+xml' && file.size === new Blob([text]).size, 'the SVG file is something else');
      expect(svg.documentElement.localName === 'svg' && svg.querySelector('parsererror') === null, 'the SVG picture is no XML');
      expect(!/NaN|Infinity|undefined/.test(text), 'the SVG picture has numbers that are none');
      expect(svg.querySelector('title').textContent === net.data.title, 'the SVG picture has no title');
      for (const entry of drawing.legendEntries()) expect([...svg.querySelectorAll('text')].some(row => row.textContent === entry.name), `${entry.name} is not in the saved legend`);
      for (const picture of [file, drawing.pngPicture()]) {
        const different = await fromScreen(picture);
        expect(different < 0.04, `${value}: the picture in ${picture.type} differs from the screen in ${different} of its points`);
      }
    }
    // The buttons offer files with names.
    const names = [], click = HTMLAnchorElement.prototype.click;
    HTMLAnchorElement.prototype.click = function() { names.push(this.download); };
    $('save-svg').click();
    $('save-png').click();
    HTMLAnchorElement.prototype.click = click;
    expect(names.length === 2 && names[0].endsWith('.svg') && names[1].endsWith('.png'), `files are called ${names}`);
  };

  (async () => {
    for (const part of [testInks, testSaving]) try { await part(); } catch (error) { failures.push(`saving: ${error}`); }
    document.body.textContent = failures.length === 0 ? 'viewer-' + 'test: passed' : 'viewer-' + 'test: ' + failures.slice(0, 12).join('; ');
  })();
}
