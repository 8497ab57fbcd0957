'use strict';
// A drawing (drawing.js) to travel in (travel.js), with a legend and buttons, and the panel that controls it.

const $ = id => document.getElementById(id);

const kPictureParts = `
  <canvas id="view" tabindex="0" role="application" aria-label="The triangulation in the Poincaré disk, a picture to travel in" aria-describedby="keys"></canvas>
  <details id="legend" class="card"><summary>Legend</summary><ul aria-label="Legend"></ul></details>
  <div id="hover" class="card"></div>
  <p id="status" class="card" role="status"></p>
  <div id="tools" role="group" aria-label="Point of view">
    <button type="button" id="zoom-in" aria-label="Zoom in" title="Zoom in"><svg class="icon" viewBox="0 0 24 24" aria-hidden="true"><path d="M12 5v14M5 12h14"/></svg></button>
    <button type="button" id="zoom-out" aria-label="Zoom out" title="Zoom out"><svg class="icon" viewBox="0 0 24 24" aria-hidden="true"><path d="M5 12h14"/></svg></button>
    <button type="button" id="turn-left" aria-label="Turn left" title="Turn left"><svg class="icon" viewBox="0 0 24 24" aria-hidden="true"><path d="M5 4v5h5M5.5 9A8 8 0 1 1 4 13"/></svg></button>
    <button type="button" id="turn-right" aria-label="Turn right" title="Turn right"><svg class="icon" viewBox="0 0 24 24" aria-hidden="true"><path d="M19 4v5h-5M18.5 9A8 8 0 1 0 20 13"/></svg></button>
    <button type="button" id="home" aria-label="Back to the start" title="Back to the start"><svg class="icon" viewBox="0 0 24 24" aria-hidden="true"><path d="M4 11l8-7 8 7M6 10v9h12v-9"/></svg></button>
  </div>`;

const kPanelParts = `
  <section aria-labelledby="net-heading">
    <h2 id="net-heading">Net</h2>
    <table id="facts"></table>
    <p id="message"></p>
  </section>
  <fieldset id="layers"><legend><h2>Show</h2></legend></fieldset>
  <fieldset id="colours"><legend><h2>Colour of triangles</h2></legend></fieldset>
  <section id="geodesics-section" aria-labelledby="geodesics-heading" hidden>
    <h2 id="geodesics-heading">Closed geodesics</h2>
    <select id="geodesics" size="6" aria-labelledby="geodesics-heading"></select>
    <div class="buttons">
      <button type="button" id="go-to" disabled>Go to it</button>
      <button type="button" id="travel" disabled>Travel once around</button>
      <button type="button" id="unselect" disabled>Unselect</button>
    </div>
  </section>
  <section aria-labelledby="lengths-heading">
    <h2 id="lengths-heading">Lengths against ε</h2>
    <canvas id="histogram" role="img"></canvas>
  </section>
  <section aria-labelledby="picture-heading">
    <h2 id="picture-heading">Picture</h2>
    <label class="row">Scheme <select id="scheme"><option value="">as the system</option><option value="light">light</option><option value="dark">dark</option></select></label>
    <div class="buttons">
      <button type="button" id="save-svg">Save as SVG</button>
      <button type="button" id="save-png">Save as PNG</button>
    </div>
  </section>
  <section aria-labelledby="help-heading">
    <h2 id="help-heading">How to travel</h2>
    <ul class="help">
      <li>Drag to move, click to ask what is there, click twice to have it in the centre.</li>
      <li>Wheel or two fingers: zoom; two fingers also turn and move.</li>
    </ul>
    <p id="keys" class="help">Keys in the picture: <kbd>arrows</kbd> move, <kbd>Shift</kbd> with <kbd>←</kbd> or <kbd>→</kbd> turns, <kbd>+</kbd> and
      <kbd>−</kbd> zoom, <kbd>Enter</kbd> says what is in the centre, <kbd>Home</kbd> leads back to the start.</p>
  </section>`;

// Offers bytes as a file with a name that is made of a title.
function save(blob, title, extension) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = (title.replace(/\.json$/, '').replace(/[^\p{L}\p{N}._-]+/gu, '-') || 'net') + extension;
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  return link.download;
}

// The mark of a layer or of an entry of the legend.
function markOf(entry) {
  const box = document.createElement('span');
  box.className = 'mark';
  if (entry.mark === 'ramp') {
    box.className = 'ramp';
    box.style.background = `linear-gradient(to right, ${[0, 1, 2, 3].map(k => shade(k / 3)).join(', ')})`;
  } else if (entry.mark === 'line') {
    box.style.background = `linear-gradient(${entry.colour}, ${entry.colour}) center / 100% 3px no-repeat`;
  } else if (entry.mark === 'dot') {
    box.style.background = `radial-gradient(circle, ${entry.colour} 4px, transparent 4.8px)`;
  } else if (entry.mark === 'area') {
    box.style.background = entry.colour;
  }
  return box;
}

const systemIsDark = matchMedia('(prefers-color-scheme: dark)');
const isNarrow = matchMedia('(max-width: 860px)');  // Then the legend would hide the picture, so it folds (viewer.css).

class Viewer {
  // Fills the elements `picture` and `panel` of the page; one viewer at a time, as they have ids. `onTap(x, y)` hears of points of the disk
  // that are tapped, and says whether it takes them; if it does not, a closed geodesic there is selected. It hears of the centre if Enter is
  // pressed, too, which selects nothing: for keys there is the list. `onSelect(g)` hears of geodesics that are selected.
  // The new viewer shows the part that `before`, one of the same triangulation, showed.
  constructor(picture, panel, net, {onTap = () => false, onSelect = () => {}, before = null} = {}) {
    const kept = before && before.state(), schemeOfBefore = $('scheme') ? $('scheme').value : '';
    const isLegendOpen = $('legend') ? $('legend').open : !isNarrow.matches;
    picture.innerHTML = kPictureParts;
    panel.innerHTML = kPanelParts;
    this.net = net;
    this.drawing = new Drawing($('view'), net);
    this.travel = new Travel(this.drawing, {
      rest: () => this.tellView(), hover: (found, x, y) => this.showHovered(found, x, y), say: text => this.say(text),
      tap: (x, y) => {
        const g = onTap(x, y) ? null : this.drawing.geodesicAt(x, y);
        if (g !== null) this.choose(g);
      },
      enter: onTap});
    this.onSelect = onSelect;
    $('legend').open = isLegendOpen;
    if (kept) this.restore(kept);
    this.fillPanel();
    this.listen();
    $('scheme').value = schemeOfBefore;
    this.setScheme();
    this.resize();
  }
  // Leaves the elements to another viewer.
  end() {
    this.travel.end();
    this.observer.disconnect();
  }
  state() {
    const {unfolding: {here}, zoom, layers, colouring, pins} = this.drawing;
    return {here, zoom, colouring, pins, isOn: new Map(layers.map(layer => [layer.name, layer.on]))};
  }
  restore({here, zoom, colouring, pins, isOn}) {
    const drawing = this.drawing;
    Object.assign(drawing, {zoom, pins});
    drawing.unfolding.here = here;
    if (drawing.colourings.some(({id}) => id === colouring)) drawing.colouring = colouring;
    for (const layer of drawing.layers) if (isOn.has(layer.name)) layer.on = isOn.get(layer.name);
  }

  // ---- Over the picture ----

  say(text) {
    if ($('status').textContent !== text) $('status').textContent = text;
  }
  tellView() {
    const {lift, zoom, unfolding} = this.drawing;
    this.say(`${lift.count} triangles in view, zoom ${zoom.toPrecision(3)}, near vertex ${this.net.vertex[unfolding.here.dart]}`);
    this.fillLegend();
  }
  showHovered(found, x, y) {
    const box = $('hover');
    box.style.display = found === null ? 'none' : 'block';
    if (found === null) return;
    box.textContent = this.drawing.describe(found);
    box.style.left = Math.max(0, Math.min(x + 14, this.drawing.width - box.offsetWidth - 4)) + 'px';
    box.style.top = Math.max(0, Math.min(y + 14, this.drawing.height - box.offsetHeight - 4)) + 'px';
  }
  fillLegend() {
    const entries = this.drawing.legendEntries();
    $('legend').hidden = entries.length === 0;
    $('legend').querySelector('ul').replaceChildren(...entries.map(entry => {
      const row = document.createElement('li');
      row.append(markOf(entry), entry.name);
      return row;
    }));
  }

  resize() {
    this.drawing.resize();
    this.travel.drawAtRest();
    this.drawHistogram();
  }
  setScheme() {
    scheme = $('scheme').value || (systemIsDark.matches ? 'dark' : 'light');
    document.documentElement.dataset.scheme = scheme;
    for (const layer of this.drawing.layers)
      $(layer.id).parentElement.querySelector('.mark').replaceWith(markOf({mark: 'area', colour: onPaper(layer.colour)}));
    if (this.drawing.width === 0) return;
    this.travel.drawAtRest();
    this.drawHistogram();
  }
  listen() {
    const {drawing, travel} = this;
    $('zoom-in').onclick = () => travel.zoomBy(1.3);
    $('zoom-out').onclick = () => travel.zoomBy(1 / 1.3);
    $('turn-left').onclick = () => travel.rotate(Math.PI / 12);
    $('turn-right').onclick = () => travel.rotate(-Math.PI / 12);
    $('home').onclick = () => travel.goHome();
    $('scheme').onchange = () => this.setScheme();
    systemIsDark.onchange = () => this.setScheme();
    isNarrow.onchange = () => { $('legend').open = !isNarrow.matches; };
    const savePicture = (make, extension) => {
      travel.endHover();
      this.say(`saved as ${save(make(), this.net.data.title, extension)}`);
    };
    $('save-svg').onclick = () => savePicture(() => drawing.svgPicture(), '.svg');
    $('save-png').onclick = () => savePicture(() => drawing.pngPicture(), '.png');
    this.observer = new ResizeObserver(() => {
      if (drawing.canvas.clientWidth !== drawing.width || drawing.canvas.clientHeight !== drawing.height) this.resize();
      else this.drawHistogram();
    });
    for (const canvas of [drawing.canvas, $('histogram')]) this.observer.observe(canvas);
  }

  // ---- The panel ----

  choiceRow(type, id, name, checked, onchange) {
    const row = document.createElement('label'), input = document.createElement('input');
    row.className = 'row';
    Object.assign(input, {type, id, checked, onchange: () => {
      onchange(input.checked);
      this.travel.drawAtRest();
    }});
    row.append(input, name);
    return row;
  }
  fillPanel() {
    const {drawing, net} = this;
    $('message').textContent = net.data.message;
    for (const [name, value] of net.data.facts) {
      const row = $('facts').insertRow(), head = document.createElement('th');
      head.scope = 'row';
      head.textContent = name;
      row.append(head);
      row.insertCell().textContent = value;
    }
    for (const layer of drawing.layers) {
      const row = this.choiceRow('checkbox', layer.id, layer.name, layer.on, on => { layer.on = on; });
      row.firstChild.after(markOf({mark: 'area', colour: layer.colour}));
      $('layers').append(row);
    }
    for (const {id, name} of drawing.colourings) {
      const row = this.choiceRow('radio', 'colour-' + id, name, id === drawing.colouring, () => { drawing.colouring = id; });
      row.firstChild.name = 'colouring';
      $('colours').append(row);
    }
    this.fillGeodesics();
  }
  fillGeodesics() {
    const {geodesics} = this.drawing;
    if (geodesics.length === 0) return;
    $('geodesics-section').hidden = false;
    $('geodesics-heading').textContent = `Closed geodesics: ${geodesics.length}`;
    for (const g of geodesics) $('geodesics').append(new Option(geodesicName(g)));
    $('geodesics').size = Math.max(2, Math.min(6, geodesics.length));
    $('geodesics').selectedIndex = -1;
    $('geodesics').onchange = () => {
      this.choose(geodesics[$('geodesics').selectedIndex]);
      this.travel.goToSelected();
    };
    $('go-to').onclick = () => this.travel.goToSelected();
    $('travel').onclick = () => this.travel.aroundSelected(2 + this.drawing.selected.length);
    $('unselect').onclick = () => {
      $('geodesics').focus();  // The button cannot keep the focus.
      this.select(null);
    };
  }
  // Selects one of the geodesics for somebody.
  choose(g) {
    this.select(g);
    this.say(geodesicName(g));
    this.onSelect(g);
  }
  // One of the geodesics, or null.
  select(g) {
    this.drawing.selected = g;
    if (g !== null && !g.layer.on) $(g.layer.id).click();
    $('geodesics').selectedIndex = this.drawing.geodesics.indexOf(g);
    for (const id of ['go-to', 'travel', 'unselect']) $(id).disabled = g === null;
    this.fillLegend();
    this.travel.redraw();
  }

  // Edges between different vertices above the axis of the same scale as circumradii: the first are at least ε, the second at most.
  drawHistogram() {
    const chartCanvas = $('histogram'), ratio = window.devicePixelRatio || 1, {net} = this, epsilon = net.epsilon;
    const w = chartCanvas.clientWidth, h = chartCanvas.clientHeight, g = chartCanvas.getContext('2d');
    if (w === 0) return;  // The panel is closed.
    if (this.edgeLengths === undefined) {
      this.edgeLengths = [];
      for (let d = 0; d < net.dartCount; ++d)
        if (d < net.opposite[d] && net.vertex[d] !== net.vertex[next(d)]) this.edgeLengths.push(net.edgeLength(d));
    }
    chartCanvas.width = w * ratio;
    chartCanvas.height = h * ratio;
    g.scale(ratio, ratio);
    const extent = values => values.reduce(([a, b], x) => [Math.min(a, x), Math.max(b, x)], [Infinity, 0]);
    const words = (name, [least, most]) => most === 0 ? `no ${name}` : `${name} from ${least.toPrecision(4)} to ${most.toPrecision(4)}`;
    chartCanvas.setAttribute('aria-label', `Histogram: ${words('circumradii', extent(net.radius))}; ` +
        `${words('edges between different vertices', extent(this.edgeLengths))}; ε is ${epsilon}`);
    const most = Math.min(Math.max(2 * epsilon, extent(this.edgeLengths)[1]), 3 * epsilon);
    const kBins = 60, base = h - 18;
    const counted = values => {
      const bins = new Array(kBins).fill(0);
      for (const x of values) ++bins[Math.min(kBins - 1, Math.floor(kBins * x / most))];
      const highest = Math.max(1, ...bins);
      return bins.map(n => n / highest);
    };
    const bars = (bins, colour) => {
      g.fillStyle = colour;
      bins.forEach((share, k) => g.fillRect(k * w / kBins, base - share * (base - 16), w / kBins - 0.5, share * (base - 16)));
    };
    const blue = onPaper('#2c63a4'), red = onPaper('#b03a25');
    bars(counted(net.radius), blue + 'bb');
    bars(counted(this.edgeLengths), red + 'bb');
    g.strokeStyle = g.fillStyle = schemes[scheme].ink;
    g.font = '11px system-ui, sans-serif';
    g.beginPath();
    g.moveTo(0, base);
    g.lineTo(w, base);
    const x = w * epsilon / most;
    g.moveTo(x, 12);
    g.lineTo(x, base);
    g.stroke();
    g.textAlign = 'center';
    g.fillText('ε', x, h - 5);
    g.textAlign = 'left';
    g.fillText('0', 0, h - 5);
    g.textAlign = 'right';
    g.fillText((most / epsilon).toPrecision(3) + ' ε', w, h - 5);
    g.fillStyle = red;
    g.fillText('edges', w, 10);
    g.textAlign = 'left';
    g.fillStyle = blue;
    g.fillText('circumradii', 0, 10);
  }
}
