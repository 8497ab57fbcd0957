// The page: what is chosen, what is asked of the module, and what is said of the answers. The pictures are those of the viewer (Net, Viewer, save, scheme are its).
import * as epsnet from './epsnet.mjs';
import {commandsOf, estimatedVertices, fromHash, kMostVertices, kMostVerticesOfProgram, pointOf, toHash} from './choice.mjs';
import {grouped, number, rough, subscript} from './numbers.mjs';

const form = $('make');
let current = null;      // The net that is shown: {net, surface, choice, title}.
let viewer = null;
let opened = null;       // The surface of a file: {surface, title, genus}.
const dropped = [];      // The files that were opened, for the way back to them.
let running = null;      // The controller of the work that is going on.

// ---- What is chosen ----

// One row of sliders for each cuff: lengths and twists; the number beside a slider is what counts, and may be beyond its ends.
function cuffRow(k) {
  const row = document.createElement('details'), summary = element('summary', '');
  const tell = () => { summary.textContent = `cuff ${k + 1}: length ${$(`length-${k}`)?.value ?? 2}, twist ${$(`twist-${k}`)?.value ?? 0}`; };
  row.className = 'cuff';
  row.open = k === 0;
  row.append(summary);
  tell();
  for (const [what, least, most, value] of [['length', 0.2, 6, 2], ['twist', -3, 3, 0]]) {
    const label = document.createElement('label'), slider = document.createElement('input'), box = document.createElement('input');
    label.textContent = what;
    label.htmlFor = box.id = `${what}-${k}`;
    Object.assign(slider, {type: 'range', min: least, max: most, step: 0.05, value, ariaLabel: `${what} of cuff ${k + 1}, roughly`});
    Object.assign(box, {value, inputMode: 'decimal', autocomplete: 'off', ariaLabel: `${what} of cuff ${k + 1}`});
    slider.oninput = () => { box.value = slider.value; tell(); };
    box.oninput = () => { slider.value = box.value; tell(); };
    row.append(label, slider, box);
  }
  return row;
}
function fillCuffs() {
  const count = 3 * Number($('genus').value) - 3, cuffs = $('cuffs');
  while (cuffs.children.length > count) cuffs.lastChild.remove();
  while (cuffs.children.length < count) cuffs.append(cuffRow(cuffs.children.length));
}
const cuffValues = what => [...document.querySelectorAll(`#cuffs input[id^=${what}-]`)].map(input => input.value.trim());

function choice() {
  const value = id => $(id).value.trim(), surface = value('surface');
  return {surface, epsilon: value('epsilon'), kind: value('kind'),
          ...{octagon: () => ({seed: value('seed')}), named: () => ({name: value('name')}), file: () => ({title: opened.title, genus: opened.genus}),
              'fenchel-nielsen': () => ({genus: value('genus'), graph: value('graph'), lengths: cuffValues('length'), twists: cuffValues('twist')})}[surface]()};
}
function choose(chosen) {
  // A name that the list does not have.
  if (chosen.name !== undefined && ![...$('name').options].some(option => option.value === chosen.name)) $('name').append(new Option(chosen.name, chosen.name));
  for (const id of ['surface', 'seed', 'name', 'genus', 'graph', 'epsilon', 'kind']) if (chosen[id] !== undefined) $(id).value = chosen[id];
  fillCuffs();
  for (const what of ['length', 'twist'])
    (chosen[what + 's'] || []).forEach((value, k) => {
      const box = $(`${what}-${k}`);
      if (box === null) return;
      box.value = value;
      box.oninput();
    });
  tellChoice();
}
function tellChoice() {
  for (const part of document.querySelectorAll('[data-kind]')) part.hidden = part.dataset.kind !== $('surface').value;
  const chosen = choice();
  $('commands').textContent = commandsOf(chosen);
  tellDifference(chosen);
}
// Picture, certificate and answers are of `current`, which the form may not say any more.
const isSame = (a, b) => a.surface === b.surface && (a.surface === 'file' ? a.title === b.title : toHash(a) === toHash(b));
function tellDifference(chosen) {
  const differs = current !== null && !$('certificate').hidden && !isSame(chosen, current.chosen);
  $('of-before').textContent = differs ? `Picture, certificate and answers are of ${current.title}, not of what the form says now.` : '';
  $('verdict').classList.toggle('past', differs);
}
function surfaceOf(chosen) {
  switch (chosen.surface) {
    case 'octagon': return epsnet.octagon(Number(chosen.seed));
    case 'named': return epsnet.named(chosen.name);
    case 'fenchel-nielsen': return epsnet.fenchelNielsen({graph: chosen.graph, genus: Number(chosen.genus), lengths: chosen.lengths, twists: chosen.twists});
    default: return opened.surface;
  }
}

// ---- Work ----

// Runs a job that can be cancelled, says how far it is, and what went wrong. One at a time.
// What is said of it, and Cancel, stand after the element `place`, where it was asked for.
async function work(name, command, job, place = $('buttons')) {
  if (running !== null) return;
  running = new AbortController();
  reached = 0;
  place.after($('work'));
  const focused = document.activeElement;
  setBusy(true);
  $('problem').textContent = '';
  $('work-text').textContent = `${name} …`;
  const started = performance.now();
  try {
    await job({signal: running.signal, progress: tellProgress.bind(null, name)});
    const seconds = ((performance.now() - started) / 1000).toFixed(1);
    $('work-text').textContent = `${name}: ${seconds} seconds${links.length > 0 ? `; ${links.splice(0).join('; ')}` : ''}`;
  } catch (error) {
    $('work-text').textContent = '';
    if (running.signal.aborted) $('work-text').textContent = `${name}: cancelled`;
    else $('problem').textContent = isTooMuch(error) ? tooMuch('This needs more memory than a browser has.', command) : `${name}: ${error.message}`;
  } finally {
    running = null;
    setBusy(false);
    if ([$('cancel'), document.body].includes(document.activeElement)) focused.focus({preventScroll: true});  // Keys go on from where they were.
  }
}
// The bar never goes back: when something begins anew, it only says that there is work.
let reached = 0;
function tellProgress(name, what, share) {
  $('work-text').textContent = `${name}: ${what}`;
  const isKnown = share >= reached && share <= 1;
  if (isKnown) $('progress').value = reached = share;
  else $('progress').removeAttribute('value');
}
const isTooMuch = error => error.kind === 'MemoryError' || error instanceof RangeError;
const tooMuch = (why, command) => `${why} The program does it:\n${command}`;
function setBusy(isBusy) {
  $('cancel').disabled = !isBusy;
  $('cancel').hidden = !isBusy;
  $('verdict').hidden = isBusy;  // Nothing says VERIFIED of what is not done.
  $('progress').hidden = !isBusy;
  $('progress').removeAttribute('value');
  for (const id of ['start', 'systole', 'diameter', 'eigenvalues', 'spectrum', 'distance', 'file']) $(id).disabled = isBusy;
  if (isBusy) $('cancel').focus({preventScroll: true});
}

// `isFollowed`: the address says it already.
function make({isFollowed = false} = {}) {
  const chosen = choice(), command = commandsOf(chosen), vertices = estimatedVertices(chosen);
  if (running !== null) return;
  forget();
  $('problem').textContent = '';
  if (vertices > kMostVertices) {
    const some = `Some ${rough(vertices)} vertices need more`;
    $('problem').textContent = vertices > kMostVerticesOfProgram ? `${some} memory than the program has room for, too: choose a larger ε.`
                                                                 : tooMuch(`${some} time and memory than a browser has.`, command);
    return;
  }
  if (chosen.surface !== 'file' && !isFollowed) goTo(toHash(chosen));
  work('A net', command, async options => {
    const surface = surfaceOf(chosen), net = await surface.net(chosen.epsilon, {sparse: chosen.kind === 'sparse', pseudo: chosen.kind === 'pseudo', ...options});
    showCertificate(net, titleOf(chosen), [['Save the net', () => net.bytes, '.json']]);
    await show({net, surface, chosen, title: titleOf(chosen)}, options);
  });
}
// The address, a new one for the way back unless it is the same.
function goTo(hash) {
  if (location.hash.slice(1) !== hash) history.pushState(null, '', '#' + hash);
}
function titleOf(chosen) {
  const surface = {octagon: `octagon ${chosen.seed}`, named: chosen.name, file: chosen.title,
                   'fenchel-nielsen': `genus ${chosen.genus}, lengths ${(chosen.lengths || []).join(', ')}`}[chosen.surface];
  return `${surface}, ε = ${chosen.epsilon}${chosen.kind === 'net' ? '' : ', ' + chosen.kind}`;
}

// ---- What the checkers say ----

const element = (name, text, className) => Object.assign(document.createElement(name), {textContent: text, className: className || ''});
const verdictMark = text => element('span', text, 'verdict ' + text.toLowerCase());

// A file's certificate, the report of `certify --json`: each checker by its own verdict.
function certificateParts({bytes, certificate}) {
  const list = document.createElement('dl'), parts = [list];
  const row = (name, ...what) => {
    const cell = document.createElement('dd');
    cell.append(...what);
    list.append(element('dt', name), cell);
    return cell;
  };
  const says = ({verdict, rule, message}) => [verdictMark(verdict), message ? ` ${rule ? rule + ': ' : ''}${message}` : ''];
  const second = certificate.second_checker;
  if (certificate.error) row('error', certificate.error);
  else if (certificate.no_claim) row('claim', 'none: this is a file of a surface. “Make and prove it” makes a net of it.');
  else row('certify', ...says(certificate));
  if (second) row('certify-exact', ...says(second));
  else if (certificate.verdict !== 'MALFORMED' && certificate.verdict) row('certify-exact', ...secondChecker(bytes, certificate, parts));
  if (certificate.claim) row('claim', certificate.claim);
  for (const [name, ends] of Object.entries(certificate.enclosures || {})) row(name.replaceAll('_', ' '), number(ends)).title = `in [${ends.join(', ')}]`;
  if (certificate.sha256) row('SHA-256', certificate.sha256).className = 'hash';
  const details = document.createElement('details'), text = element('pre', certificate.text);
  text.tabIndex = 0;
  details.append(element('summary', 'All that certify says'), text);
  parts.push(details);
  return parts;
}
// The second checker is not asked about large files, unless somebody wants it.
function secondChecker(bytes, certificate, parts) {
  const why = /^second checker: (.*)$/m.exec(certificate.text), button = element('button', 'Ask it');
  if (!/more than/.test(why)) return [why === null ? 'not asked' : why[1]];
  button.type = 'button';
  button.onclick = () => work('The second checker', 'certify --exact FILE', async options => {
    const asked = await epsnet.certify(bytes, {exact: true, ...options});
    button.closest('dl').parentElement.replaceChildren(...certificateParts({bytes, certificate: asked}));
  });
  return [why[1] + ' ', button];
}
function showCertificate(file, title, files) {
  const verdict = file.certificate.no_claim ? 'NO CLAIM' : file.certificate.verdict || 'ERROR';
  $('certificate').hidden = false;
  $('certificate-heading').textContent = `Certificate: ${title}`;
  $('certificate-text').replaceChildren(...certificateParts(file));
  $('verdict').textContent = verdict;
  $('verdict').className = verdict.toLowerCase().replace(' ', '-');
  const all = [...files, ['Save the certificate', () => file.certificate.text, '.certificate.txt']];
  $('files').replaceChildren(...all.map(([name, make, extension]) => fileButton(name, make, title, extension)));
}
function fileButton(name, make, title, extension) {
  const button = element('button', name);
  button.type = 'button';
  button.onclick = () => { $('work-text').textContent = `saved as ${save(new Blob([make()]), title, extension)}`; };
  return button;
}

// ---- The net that is shown ----

// Whatever happens next, a verdict of before must not stand beside it.
function forget() {
  current = null;
  $('of-before').textContent = $('work-text').textContent = '';
  for (const id of ['certificate', 'questions', 'panel']) $(id).hidden = true;
  $('verdict').textContent = $('verdict').className = '';
  $('picture').classList.add('past');
}

// `net` is one; `shown` are files of closed geodesics and distances to be drawn on it.
async function show({net, surface, chosen, title}, options) {
  const data = await net.viewerData({title, ...options});
  $('answered').replaceChildren();
  current = {net, surface, chosen, title, shown: []};
  $('questions').hidden = net.certificate.verdict !== 'VERIFIED';
  draw(data);
  tellChoice();
}
// Shows data of the viewer; of the same net as before from the same point of view.
function draw(data, before = null) {
  if (viewer !== null) viewer.end();
  $('panel').hidden = false;
  $('picture').classList.remove('past');
  viewer = new Viewer($('picture'), $('panel'), new Net(data), {onTap: take, before});
}

// ---- Questions ----

// Asks for a file about the surface, which comes with its certificate; shows its answer, and draws what of it can be drawn.
function ask(name, command, question, lines, isDrawn = true) {
  const asked = current, place = document.activeElement?.closest('#questions .line, #questions .buttons') ?? $('questions-heading');
  work(name, command, async options => {
    const file = await question(asked, options);
    if (isDrawn && file.geodesics?.length !== 0) {
      draw(await asked.net.viewerData({title: asked.title, layers: [...asked.shown, file], ...options}), viewer);
      asked.shown.push(file);
    }
    const article = document.createElement('article'), details = document.createElement('details'), certificate = document.createElement('div');
    certificate.append(...certificateParts(file));
    details.append(element('summary', 'Certificate'), certificate);
    article.append(element('h3', name), ...lines(file).map(line => element('p', line)), verdictMark(file.certificate.verdict),
                   ` by ${file.certificate.verified_by.join(' and ')}`, details, fileButton('Save the file', () => file.bytes, `${asked.title} ${name}`, '.json'));
    $('answered').prepend(article);
  }, place);
}
const surfaceCommand = rest => commandsOf(current.chosen).split('\n')[0] + '\n' + rest;
const lengthsOf = file => file.geodesics.map(({length}) => length);
const counted = n => `${n === 0 ? 'no' : n} closed geodesic${n === 1 ? '' : 's'}`;
$('systole').onclick = () => ask('Systole', surfaceCommand('epsnet systole s.json'), ({surface}, options) => surface.systole(options),
    file => [`the systole, the length of a shortest closed geodesic, is ${number(lengthsOf(file)[0])}`]);
$('spectrum').onclick = () => {
  const upTo = $('up-to').value.trim(), kMostLines = 12;
  ask(`Closed geodesics up to ${upTo}`, surfaceCommand(`epsnet spectrum s.json --up-to ${upTo}`), ({surface}, options) => surface.spectrum(upTo, options), file => {
    const lengths = lengthsOf(file), lines = grouped(lengths);
    return [`${counted(lengths.length)} up to length ${upTo}${lengths.length > 0 ? ', and no others; their lengths:' : ''}`, ...lines.slice(0, kMostLines),
            ...(lines.length > kMostLines ? [`and ${lines.length - kMostLines} more lengths in the file`] : [])];
  });
};
$('diameter').onclick = () => ask('Diameter', surfaceCommand('epsnet diameter s.json --width 1e-3'),
    ({surface}, options) => surface.diameter({width: 1e-3, ...options}), file => [`the diameter is ${number(file.value)}`], false);
const tellEigenvalues = ({first, count, ...row}) =>
  count === 1 ? `λ${subscript(first)} is ${number(row.in)}` : `λ${subscript(first)} to λ${subscript(first + count - 1)} are ${number(row.in)}`;
$('eigenvalues').onclick = () => {
  const [count, digits] = ['count', 'digits'].map(id => Number($(id).value));
  ask(`Eigenvalues of the Laplacian: ${count === 1 ? 'the first' : `the first ${count}`}, ${digits} digits`,
      surfaceCommand(`epsnet eigenvalues s.json --count ${count} --digits ${digits}`),
      ({surface}, options) => surface.eigenvalues({count, digits, ...options}),
      file => [...file.eigenvalues.map(tellEigenvalues), `all others are at least ${file.next}`], false);
};
$('distance').onclick = () => {
  try {
    const [p, q] = ['p', 'q'].map(id => pointOf($(id).value.trim(), id));
    ask('Distance of p and q', `epsnet distance net.json ${$('p').value.trim()} ${$('q').value.trim()}`, ({net}, options) => net.distance(p, q, options),
        file => [`the distance is ${number(file.value)}`]);
  } catch (error) {
    $('problem').textContent = error.message;
  }
};

// A point of the picture as p, then as q, then as p again.
function take(x, y) {
  if (!$('take').checked || x * x + y * y >= 1) return;
  const pin = viewer.drawing.pinAt(x, y), pins = viewer.drawing.pins;
  if (pin === null) return;
  if (pins.length === 2) pins.length = 0;
  pin.name = pins.length === 0 ? 'p' : 'q';
  pins.push(pin);
  $(pin.name).value = pin.text;
  viewer.travel.drawAtRest();
  viewer.say(`${pin.name} is a point of triangle ${pin.triangle}`);
  if (pin.name === 'q' && running === null) $('distance').click();
}

// ---- Files ----

const kMostBytes = 64e6;
// `isFollowed`: the address says it already.
function open(file, {isFollowed = false} = {}) {
  const command = `certify ${file.name}`;
  if (running !== null) return;
  forget();
  $('problem').textContent = '';
  if (!isFollowed) goTo(`file=${dropped.push(file)}`);
  if (file.size > kMostBytes) {
    $('problem').textContent = tooMuch(`${file.name} has more than ${kMostBytes / 1e6} MB, too much for a browser.`, command);
    return;
  }
  work(file.name, command, async options => {
    const bytes = new Uint8Array(await file.arrayBuffer()), title = file.name.replace(/\.[^.]*$/, ''), chosen = {surface: 'file', title};
    const certificate = await epsnet.certify(bytes, {name: file.name, exact: true, ...options});
    showCertificate({bytes, certificate}, file.name, []);
    $('certificate-heading').focus();
    // Those that are no files of a surface, or of a net that can be drawn, have said so.
    const surface = epsnet.surfaceFromFile(bytes, file.name), unless = error => { if (options.signal.aborted) throw error; };
    const facts = await surface.info(options).catch(unless);
    if (facts === undefined) return;
    opened = {surface, title, genus: facts.genus};
    const entry = $('surface').querySelector('[value=file]');
    entry.disabled = false;
    entry.textContent = $('file-name').textContent = `the file ${file.name}`;
    choose({surface: 'file'});
    const net = new epsnet.Net({files: [bytes, new Uint8Array()], certificate});
    if (certificate.claim) await show({net, surface, chosen, title}, options).catch(unless);
  }, $('drop'));
}
$('file').onchange = () => {
  if ($('file').files.length > 0) open($('file').files[0]);
  $('file').value = '';
};
addEventListener('dragover', event => {
  event.preventDefault();
  document.body.classList.add('dropping');
});
addEventListener('dragleave', event => { if (event.relatedTarget === null) document.body.classList.remove('dropping'); });
addEventListener('drop', event => {
  event.preventDefault();
  document.body.classList.remove('dropping');
  if (event.dataTransfer.files.length > 0) open(event.dataTransfer.files[0]);
});

// ---- The form ----

form.onsubmit = event => {
  event.preventDefault();
  make();
};
form.addEventListener('input', tellChoice);
$('genus').onchange = () => {
  fillCuffs();
  tellChoice();
};
$('another').onclick = () => {
  $('seed').value = crypto.getRandomValues(new Uint32Array(1))[0] >>> 1;
  tellChoice();
};
$('cancel').onclick = () => running && running.abort();
$('copy-link').onclick = async () => {
  const chosen = choice();
  if (chosen.surface === 'file') {
    $('problem').textContent = 'A link cannot contain a file: send the file, too.';
    return;
  }
  history.replaceState(null, '', '#' + toHash(chosen));
  try {
    await navigator.clipboard.writeText(location.href);
    $('work-text').textContent = 'the link is copied';
  } catch (error) {
    $('work-text').textContent = `the link is the address of this page now: ${location.href}`;
  }
};

// A link makes its net; the way back leads to surfaces and files of before.
const links = [];  // What is to be said of a link when its net is there.
function follow() {
  const hash = location.hash.slice(1), file = /^file=([0-9]+)$/.exec(hash);
  if (running !== null) running.abort();
  $('problem').textContent = '';
  if (file !== null) {
    forget();
    if (dropped[file[1] - 1] === undefined) $('problem').textContent = 'This address was of a file, which a link cannot contain: open the file again.';
    else afterWork(() => open(dropped[file[1] - 1], {isFollowed: true}));
    return;
  }
  try {
    const chosen = fromHash(hash);
    if (chosen === null) return;
    if (chosen.missing.length > 0) links.push(`not in the link, so as usual: ${chosen.missing.join(', ')}`);
    choose(chosen);
    afterWork(() => make({isFollowed: true}));
  } catch (error) {
    forget();
    $('problem').textContent = error.message;
  }
}
// What was cancelled ends first.
const afterWork = next => running === null ? next() : setTimeout(afterWork, 20, next);
scheme = systemIsDark.matches ? 'dark' : 'light';
document.documentElement.dataset.scheme = scheme;
fillCuffs();
tellChoice();
addEventListener('hashchange', follow);
if (location.protocol === 'file:') $('problem').textContent = 'A browser does not load the module from a file: python3 -m http.server in this folder serves it.';
else follow();
