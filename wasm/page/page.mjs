// The page: what is chosen, what is asked of the module, and what is said of the answers. The pictures are those of the viewer (Net, Viewer, save, scheme are its).
import * as epsnet from './epsnet.mjs';
import {commandsOf, costOf, estimatedVertices, fromHash, genusOfMap, kMostVertices, kMostVerticesOfProgram, pointOf, stepOf, surfaceCommands, tellStep, toHash} from './choice.mjs';
import {decimal, grouped, number, rough, subscript} from './numbers.mjs';
import * as pantsGraph from './pants_graph.mjs';

const form = $('make');
let current = null;      // The net that is shown: {net, surface, choice, title}.
let viewer = null;
let opened = null;       // The surface of a file: {surface, title, genus}.
const dropped = [];      // The files that were opened, for the way back to them.
let running = null;      // The controller of the work that is going on.
let isExample = false;   // Nobody asked for that work: whatever else is asked for comes first.
let steps = [];          // From the surface that is chosen to the one that is meant (choice.mjs).

// ---- What is chosen ----

// One row of sliders for each cuff: lengths and twists; the number beside a slider is what counts, and may be beyond its ends.
function cuffRow(k) {
  const row = document.createElement('details'), summary = element('summary', ''), fields = document.createElement('div');
  const short = (id, usual) => {
    const text = $(id)?.value ?? usual;
    return Number.isFinite(Number(text)) ? String(Number(Number(text).toPrecision(6))) : text;
  };
  const tell = () => { summary.textContent = `cuff ${k}: length ${short(`length-${k}`, '2')}, twist ${short(`twist-${k}`, '0')}`; };
  row.className = 'cuff';
  row.open = k === 0;
  row.addEventListener('focusin', () => tellCuff(k));
  row.append(summary, fields);
  tell();
  for (const [what, least, most, value] of [['length', 0.2, 6, 2], ['twist', -3, 3, 0]]) {
    const label = document.createElement('label'), slider = document.createElement('input'), box = document.createElement('input');
    label.textContent = what;
    label.htmlFor = box.id = `${what}-${k}`;
    Object.assign(slider, {type: 'range', min: least, max: most, step: 0.05, value, ariaLabel: `${what} of cuff ${k}, roughly`});
    Object.assign(box, {value, inputMode: 'decimal', autocomplete: 'off', ariaLabel: `${what} of cuff ${k}`});
    slider.oninput = () => { box.value = slider.value; tell(); };
    box.oninput = () => { slider.value = box.value; tell(); };
    fields.append(label, slider, box);
  }
  return row;
}
function fillCuffs() {
  const count = 3 * Number($('genus').value) - 3, cuffs = $('cuffs');
  while (cuffs.children.length > count) cuffs.lastChild.remove();
  while (cuffs.children.length < count) cuffs.append(cuffRow(cuffs.children.length));
}
const cuffValues = what => [...document.querySelectorAll(`#cuffs input[id^=${what}-]`)].map(input => input.value.trim());

// The graph of the cuffs, as the module makes it: asked for when another one is chosen.
let graphShown = '';
async function showGraph() {
  const graph = $('graph').value, genus = Number($('genus').value), name = `${genus} ${graph}`;
  if ($('surface').value !== 'fenchel-nielsen' || name === graphShown) return;
  graphShown = name;
  try {
    const {edges} = await epsnet.coordinates({graph, genus, lengths: ['2'], twists: ['0']});
    if (name === graphShown) $('pants-graph').replaceChildren(pantsGraph.picture(edges, openCuff));
    tellCuff([...$('cuffs').children].findIndex(row => row.open));
  } catch {
    graphShown = '';  // The page does without.
  }
}
function openCuff(k) {
  const row = $('cuffs').children[k];
  row.open = true;
  row.querySelector('summary').focus();
  tellCuff(k);
}
function tellCuff(k) {
  [...$('pants-graph').querySelectorAll('g')].forEach((group, number) => group.classList.toggle('chosen', number === k));
}
// The graph theta has genus 2; edges that a link or pairs of pants brought have a genus, too.
function fitGraph() {
  const genus = Number($('genus').value), fits = graph => graph === 'theta' ? genus === 2 : !graph.includes('-') || graph.split(' ').length === 3 * genus - 3;
  for (const option of $('graph').options) option.disabled = !fits(option.value);
  if (!fits($('graph').value)) $('graph').value = 'chain';
}

// Families have a member for each genus, wiman-7; a census has maps, R2.1.
const kFamily = /^(wiman|accola-maclachlan)(?:-([0-9]+))?$/;
function nameChosen() {
  const name = $('name').value;
  return name === 'map' ? $('map').value.trim() : kFamily.test(name) ? `${name}-${$('name-genus').value.trim()}` : name;
}

function choice() {
  const value = id => $(id).value.trim(), surface = value('surface');
  return {surface, epsilon: value('epsilon'), kind: value('kind'), ...(steps.length > 0 && {steps}),
          ...{octagon: () => ({seed: value('seed')}), named: () => ({name: nameChosen()}), file: () => ({title: opened.title, genus: opened.genus}),
              'fenchel-nielsen': () => ({genus: value('genus'), graph: value('graph'), lengths: cuffValues('length'), twists: cuffValues('twist')})}[surface]()};
}
function choose({name, ...chosen}) {
  const [, family, familyGenus] = kFamily.exec(name) ?? [];
  const isMap = genusOfMap(name) !== undefined;
  const values = {...chosen, ...(name !== undefined && {name: isMap ? 'map' : family ?? name}), ...(isMap && {map: name}),
                  ...(familyGenus !== undefined && {'name-genus': familyGenus})};
  // A name or a graph that the list does not have.
  for (const id of ['name', 'graph'])
    if (values[id] !== undefined && ![...$(id).options].some(option => option.value === values[id])) $(id).append(new Option(values[id], values[id]));
  for (const id of ['surface', 'seed', 'name', 'name-genus', 'map', 'genus', 'graph', 'epsilon', 'kind']) if (values[id] !== undefined) $(id).value = values[id];
  steps = chosen.steps ?? [];
  fitGraph();
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
  $('of-genus').hidden = !kFamily.test($('name').value);
  $('of-map').hidden = $('name').value !== 'map';
  $('steps').replaceChildren(...steps.map(stepRow));
  showGraph();
  const chosen = choice();
  $('commands').textContent = commandsOf(chosen);
  tellDifference(chosen);
}
function stepRow(text, k) {
  const row = element('li', tellStep(text) + ' '), button = element('button', 'Remove');
  button.type = 'button';
  button.ariaLabel = `Remove ${tellStep(text)}`;
  button.onclick = () => {
    steps = steps.filter((_, number) => number !== k);
    tellChoice();
  };
  row.append(button);
  return row;
}
// Picture, certificate and answers are of `current`, which the form may not say any more.
const isSame = (a, b) => a.surface === b.surface && (a.surface === 'file' ? a.title === b.title && String(a.steps) === String(b.steps) : toHash(a) === toHash(b));
function tellDifference(chosen) {
  const differs = current !== null && !$('certificate').hidden && !isSame(chosen, current.chosen);
  $('of-before').textContent = differs ? `Picture, certificate and answers are of ${current.title}, not of what the form says now.` : '';
  $('verdict').classList.toggle('past', differs);
}
function surfaceOf(chosen) {
  const first = {
    octagon: () => epsnet.octagon(Number(chosen.seed)),
    named: () => epsnet.named(chosen.name),
    'fenchel-nielsen': () => epsnet.fenchelNielsen({graph: chosen.graph, genus: Number(chosen.genus), lengths: chosen.lengths, twists: chosen.twists}),
    file: () => opened.surface};
  const next = {
    cover: (surface, {degree, seed}) => surface.cover({degree, seed}),
    twist: (surface, {word, by}) => surface.twist(word, by),
    'dehn-twist': (surface, {word, by}) => surface.dehnTwist(word, Number(by))};
  return (chosen.steps ?? []).map(stepOf).reduce((surface, step) => next[step.kind](surface, step), first[chosen.surface]());
}

// ---- Work ----

// Runs a job that can be cancelled, says how far it is, and what went wrong. One at a time.
// What is said of it, and Cancel, stand after the element `place`, where it was asked for.
async function work(name, command, job, place = $('buttons')) {
  if (running !== null) return;
  const isQuiet = isExample;
  running = new AbortController();
  reached = 0;
  place.after($('work'));
  const focused = document.activeElement;
  setBusy(true, isQuiet);
  $('problem').textContent = '';
  $('work-text').textContent = `${name} …`;
  const started = performance.now();
  try {
    await job({signal: running.signal, progress: tellProgress.bind(null, name)});
    const seconds = ((performance.now() - started) / 1000).toFixed(1);
    $('work-text').textContent = `${name}: ${seconds} seconds`;
  } catch (error) {
    $('work-text').textContent = '';
    if (running.signal.aborted) $('work-text').textContent = `${name}: cancelled`;
    else $('problem').textContent = isTooMuch(error) ? tooMuch('This needs more memory than a browser has.', command) : `${name}: ${error.message}`;
  } finally {
    running = null;
    isExample = false;
    setBusy(false);
    if ([$('cancel'), document.body].includes(document.activeElement)) focused.focus({preventScroll: true});  // Keys go on from where they were.
  }
}
// Says something where it was asked for; what is going on keeps its place.
function say(text, place) {
  if (running === null) place.after($('work'));
  $('work-text').textContent = text;
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
// What nobody asked for keeps nobody from asking for something else.
function setBusy(isBusy, isQuiet = false) {
  $('cancel').disabled = !isBusy;
  $('cancel').hidden = !isBusy;
  $('verdict').hidden = isBusy;  // Nothing says VERIFIED of what is not done.
  $('progress').hidden = !isBusy;
  $('progress').removeAttribute('value');
  for (const button of document.querySelectorAll('#start, #file, #questions button:not(#cancel)')) button.disabled = isBusy && !isQuiet;
  if (!isBusy) tellCurves();
  if (isBusy && !isQuiet) $('cancel').focus({preventScroll: true});
}

// Whether something else is going on, which is said; an example makes room for `next`.
function isBusyFor(next) {
  if (running === null) return false;
  if (isExample) {
    running.abort();
    afterWork(next);
  } else {
    $('problem').textContent = 'One thing at a time: cancel what is going on first.';
  }
  return true;
}
// `isFollowed`: the address says it already.
function make({isFollowed = false} = {}) {
  const chosen = choice(), command = commandsOf(chosen), vertices = estimatedVertices(chosen);
  if (isBusyFor(() => make({isFollowed}))) return;
  forget();
  $('problem').textContent = '';
  if (vertices > kMostVertices) {
    const some = `Some ${rough(vertices)} vertices need more`;
    $('problem').textContent = vertices > kMostVerticesOfProgram ? `${some} memory than the program has room for, too: choose a larger ε.`
                                                                 : tooMuch(`${some} time and memory than a browser has.`, command);
    return;
  }
  if (chosen.surface !== 'file' && !isFollowed) goTo(toHash(chosen));
  work(isExample ? `An example, ${titleOf(chosen)}` : 'A net', command, async options => {
    const surface = surfaceOf(chosen), net = await surface.net(chosen.epsilon, {sparse: chosen.kind === 'sparse', pseudo: chosen.kind === 'pseudo', ...options});
    showCertificate(net, titleOf(chosen), [['Save the net', () => net.bytes, '.json']]);
    // What steps lead to would be made anew for each question: the net has it.
    await show({net, surface: chosen.steps ? net.surface : surface, chosen, title: titleOf(chosen)}, options);
  });
}
// The address, a new one for the way back unless it is the same.
function goTo(hash) {
  if (location.hash.slice(1) !== hash) history.pushState(null, '', '#' + hash);
}
function titleOf(chosen) {
  const surface = {octagon: `octagon ${chosen.seed}`, named: chosen.name, file: chosen.title,
                   'fenchel-nielsen': `genus ${chosen.genus}, lengths ${(chosen.lengths || []).join(', ')}`}[chosen.surface];
  return `${[surface, ...(chosen.steps ?? []).map(tellStep)].join(', ')}, ε = ${chosen.epsilon}${chosen.kind === 'net' ? '' : ', ' + chosen.kind}`;
}

// ---- What the checkers say ----

const element = (name, text, className) => Object.assign(document.createElement(name), {textContent: text, className: className || ''});
const verdictMark = text => element('span', text, 'verdict ' + text.toLowerCase());

// A file's certificate, the report of `certify --json`: each checker by its own verdict.
function certificateParts({bytes, certificate, info}) {
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
  else if (certificate.no_claim) row('claim', `none: ${certificate.no_claim}`);
  else row('certify', ...says(certificate));
  if (second) row('certify-exact', ...says(second));
  else if (certificate.verdict !== 'MALFORMED' && certificate.verdict) row('certify-exact', ...secondChecker({bytes, certificate, info}, parts));
  if (certificate.claim) row('claim', certificate.claim);
  if (info?.epsilon) row('epsilon', info.epsilon);  // As it was given.
  for (const [name, ends] of Object.entries(certificate.enclosures || {}).filter(([name]) => name !== 'epsilon' || !info?.epsilon)) row(name.replaceAll('_', ' '), number(ends)).title = `in [${ends.join(', ')}]`;
  if (certificate.sha256) row('SHA-256', certificate.sha256).className = 'hash';
  const details = document.createElement('details'), text = element('pre', certificate.text);
  text.tabIndex = 0;
  details.append(element('summary', 'All that certify says'), text);
  parts.push(details);
  return parts;
}
// The second checker is not asked about large files, unless somebody wants it.
function secondChecker({bytes, certificate, info}, parts) {
  const why = /^second checker: (.*)$/m.exec(certificate.text), button = element('button', 'Ask it');
  if (!/more than/.test(why)) return [why === null ? 'not asked' : why[1]];
  button.type = 'button';
  button.onclick = () => {
    const place = button.closest('dl').parentElement;
    work('The second checker', 'certify --exact FILE', async options => {
      const asked = await epsnet.certify(bytes, {exact: true, ...options});
      place.replaceChildren(...certificateParts({bytes, certificate: asked, info}));
    }, place);
  };
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
  button.onclick = () => say(`saved as ${save(new Blob([make()]), title, extension)}`, button.closest('.buttons') ?? button);
  return button;
}

// ---- The net that is shown ----

// Whatever happens next, a verdict of before must not stand beside it.
function forget() {
  current = null;
  $('of-before').textContent = $('of-link').textContent = $('work-text').textContent = '';
  for (const id of ['certificate', 'questions', 'panel']) $(id).hidden = true;
  $('verdict').textContent = $('verdict').className = '';
  $('picture').classList.add('past');
}

// `net` is one; `shown` are files of closed geodesics and distances to be drawn on it.
async function show({net, surface, chosen, title}, options) {
  const data = await net.viewerData({title, ...options});
  $('answered').replaceChildren();
  $('curve').replaceChildren();
  current = {net, surface, chosen, title, shown: []};
  $('questions').hidden = net.certificate.verdict !== 'VERIFIED';
  tellCosts();
  draw(data);
  tellChoice();
}
// Shows data of the viewer; of the same net as before from the same point of view.
function draw(data, before = null) {
  if (viewer !== null) viewer.end();
  $('panel').hidden = false;
  $('picture').classList.remove('past');
  viewer = new Viewer($('picture'), $('panel'), new Net(data), {onTap: take, onSelect: askAbout, before});
}

// ---- Questions ----

// What was clicked among the questions, while it is answered to: Safari gives a button that is clicked no focus.
let clicked = null;
$('questions').addEventListener('click', event => { clicked = event.target; }, true);
$('questions').addEventListener('click', () => { clicked = null; });

// Beside each question: how long it takes.
function tellCosts() {
  const about = {genus: current.net.certificate.counts?.genus, upTo: typed('up-to'), count: typed('count'), digits: $('digits').value};
  for (const place of document.querySelectorAll('#questions button small')) place.textContent = costOf(place.parentElement.id, about);
}
$('questions').addEventListener('input', tellCosts);

// Asks for something about the surface; shows the lines that `tell` makes of the answer, and its certificate, if it has one. A file of curves is drawn
// in the picture of the net, or with `isPicture` the answer in a picture of its own.
function ask(name, command, question, tell, {isDrawn = false, isPicture = false} = {}) {
  const asked = current, place = clicked?.closest('#questions .line, #questions .buttons') ?? $('questions-heading');
  work(name, command, async options => {
    const file = await question(asked, options), parts = tell(file);
    if (isDrawn && file.geodesics?.length !== 0) {
      draw(await asked.net.viewerData({title: asked.title, layers: [...asked.shown, file], ...options}), viewer);
      asked.shown.push(file);
    }
    if (isPicture) parts.push(...pictureOf(await file.svg(options), `${asked.title} ${name}`));
    parts.push(...(file.certificate ? certificateOf(file) : []), fileButton('Save the file', () => file.bytes, `${asked.title} ${name}`, '.json'));
    const article = document.createElement('article');
    article.append(element('h3', name), ...parts.map(part => typeof part === 'string' ? element('p', part) : part));
    $('answered').prepend(article);
  }, place);
}
function certificateOf(file) {
  const details = document.createElement('details'), certificate = document.createElement('div');
  certificate.append(...certificateParts(file));
  details.append(element('summary', 'Certificate'), certificate);
  return [verdictMark(file.certificate.verdict), element('span', ` by ${file.certificate.verified_by.join(' and ')}`), details];
}
function pictureOf(svg, title) {
  return [Object.assign(new Image(), {alt: title, src: `data:image/svg+xml,${encodeURIComponent(svg)}`}), fileButton('Save the picture', () => svg, title, '.svg')];
}
// Curves along which the surface can be cut: those of the answers, each once.
function addCurves(curves) {
  for (const {name, word} of curves) {
    const value = word.join('.');
    if (![...$('curve').options].some(option => option.value === value)) $('curve').append(new Option(`${name}: ${word.join(' ')}`, value));
  }
}
function tellCurves() {
  for (const id of ['twist', 'dehn-twist']) $(id).disabled = $('curve').options.length === 0;
}
// The numbers of the sides of a path that somebody typed.
function wordOf(text) {
  if (!/^[0-9]+( +[0-9]+)*$/.test(text)) throw new Error(`${text.slice(0, 40)}: expected the numbers of the sides that a closed curve crosses, such as 1 2`);
  return text.split(/ +/).map(Number);
}
// Commands about the surface, FILE in their text.
function surfaceCommand(rest) {
  const {text, file} = surfaceCommands(current.chosen);
  return `${text}\n${rest.replace('FILE', file)}`;
}
const lengthName = length => `length ${number(length)}`;
const simpleCurves = ({geodesics}) => geodesics.filter(({simple}) => simple).map(({length, word}) => ({name: lengthName(length), word}));
const lengthsOf = file => file.geodesics.map(({length}) => length);
const times = n => n === 0 ? 'never' : n === 1 ? 'once' : `${n} times`;
const counted = n => `${n === 0 ? 'no' : n} closed geodesic${n === 1 ? '' : 's'}`;
$('systole').onclick = () => ask('Systole', surfaceCommand('epsnet systole FILE'), ({surface}, options) => surface.systole(options),
    file => {
      addCurves(simpleCurves(file));
      return [`the systole, the length of a shortest closed geodesic, is ${number(lengthsOf(file)[0])}`];
    }, {isDrawn: true});
$('spectrum').onclick = () => {
  const upTo = $('up-to').value.trim(), kMostLines = 12;
  ask(`Closed geodesics up to ${upTo}`, surfaceCommand(`epsnet spectrum FILE --up-to ${upTo}`), ({surface}, options) => surface.spectrum(upTo, options), file => {
    const lengths = lengthsOf(file), lines = grouped(lengths);
    addCurves(simpleCurves(file));
    return [`${counted(lengths.length)} up to length ${upTo}${lengths.length > 0 ? ', and no others; their lengths:' : ''}`, ...lines.slice(0, kMostLines),
            ...(lines.length > kMostLines ? [`and ${lines.length - kMostLines} more lengths in the file`] : [])];
  }, {isDrawn: true});
};
const tellCurve = ({length, power, self_intersections: crossings, homology}, k) =>
  `curve ${k}: length ${number(length)}, ${power > 1 ? `a power, ${power}` : crossings === 0 ? 'simple' : `crosses itself ${times(crossings)}`}, class (${homology.join(', ')})`;
// How closed curves meet: all pairs of them, or the first one with each of the others.
function askCurves(name, words, {isOfFirst = false} = {}) {
  ask(name, surfaceCommand(`epsnet curves FILE ${words.map(word => word.join(',')).join(' ')}`),
      ({surface}, options) => surface.closedCurves(words, options), ({curves, pairs, fill}) => {
        const given = curves.slice(0, words.length), told = isOfFirst ? given.slice(0, 1) : given;
        const meetings = pairs.filter(({first, second}) => second < words.length && (!isOfFirst || first === 0));
        addCurves(given.flatMap(({length, power, self_intersections, word}) => power === 1 && self_intersections === 0 ? [{name: lengthName(length), word}] : []));
        return [...told.map(tellCurve),
                ...meetings.map(({first, second, intersections, algebraic}) => `curves ${first} and ${second} meet ${times(intersections)}, algebraically ${algebraic}`),
                ...(fill ? ['together they fill the surface'] : [])];
      }, {isPicture: true});
}
$('curves').onclick = () => {
  try {
    askCurves('Closed curves', typed('words').split(',').map(text => wordOf(text.trim())));
  } catch (error) {
    $('problem').textContent = error.message;
  }
};
// The word of a geodesic that is drawn: the layers of a list, as that of the shortest ones, have its geodesics by their numbers.
function wordInLists(lists, layer, name) {
  const layers = viewer.drawing.layers.filter(({parts}) => parts?.[0]?.[0].startsWith('geodesic '));
  for (const {geodesics} of lists) {
    for (let left = geodesics.length; left > 0 && layers.length > 0;) {
      const first = layers.shift();
      if (first === layer) return geodesics[Number(/^geodesic ([0-9]+)/.exec(name)[1])]?.word;
      left -= first.parts.length;
    }
  }
  return undefined;
}
// A closed geodesic that was chosen in the picture: it and some others there become the curves in question.
function askAbout({layer, name}) {
  const kMostOthers = 7;
  const lists = current.shown.filter(file => file.geodesics?.length > 0);
  const word = wordInLists(lists, layer, name);
  if (word === undefined) return;
  const text = word.join(' ');
  const others = new Set(lists.flatMap(file => file.geodesics.map(g => g.word.join(' '))));
  others.delete(text);
  const texts = [text, ...[...others].slice(0, kMostOthers)];
  $('words').value = texts.join(', ');
  if (running === null) askCurves('What a closed geodesic meets', texts.map(wordOf), {isOfFirst: true});
}
// The point of a bound: rounded, and exactly, as the fields of points take it.
function tellPoint({tile, z}) {
  const details = document.createElement('details'), exact = element('p', `${tile},${z.join(',')}`);
  details.append(element('summary', `attained, within these bounds, at p: tile ${tile}, (${z.map(decimal).join(', ')})`), exact);
  return details;
}
$('diameter').onclick = () => ask('Diameter', surfaceCommand('epsnet diameter FILE --width 1e-3'), ({surface}, options) => surface.diameter({width: 1e-3, ...options}),
    file => [`the diameter is ${number(file.value)}`, tellPoint(file.p)]);
$('radius').onclick = () => ask('Radius', surfaceCommand('epsnet radius FILE --width 1e-2'), ({surface}, options) => surface.radius({width: 1e-2, ...options}),
    file => [`the radius is ${number(file.value)}`, tellPoint(file.p)]);
const tellEigenvalues = ({first, count, ...row}) =>
  count === 1 ? `λ${subscript(first)} is ${number(row.in)}` : `λ${subscript(first)} to λ${subscript(first + count - 1)} are ${number(row.in)}`;
$('eigenvalues').onclick = () => {
  const [count, digits] = ['count', 'digits'].map(id => Number($(id).value));
  const command = surfaceCommand(`epsnet eigenvalues FILE --count ${count} --digits ${digits}`), {title} = current;
  ask(`Eigenvalues of the Laplacian: ${count === 1 ? 'the first' : `the first ${count}`}, ${digits} digits`, command,
      ({surface}, options) => surface.eigenvalues({count, digits, ...options}), file => {
        const simple = file.eigenvalues.filter(row => row.count === 1);
        const drawn = digits < kDigitsOfFunctions ? [`eigenfunctions can be drawn from ${kDigitsOfFunctions} digits on`]
                                                  : simple.map(({first}) => eigenfunctionRow(file, first, command, title));
        return [...file.eigenvalues.map(tellEigenvalues), `all others are at least ${file.next}`, ...drawn];
      });
};
// A multiple eigenvalue has no function of its own; a file has functions of those that it encloses by them, and the module says of which.
const kDigitsOfFunctions = 3, kSizeOfFunctions = 400;
function eigenfunctionRow(file, index, command, title) {
  const name = `eigenfunction of λ${subscript(index)}`, button = element('button', `Draw the ${name}`), row = element('p', '');
  button.type = 'button';
  row.append(button);
  button.onclick = () => work(`The ${name}`, `${command} -o e.json\nepsnet draw e.json --eigenfunction ${index} --size ${kSizeOfFunctions} -o e.svg`, async options => {
    const svg = await file.eigenfunctionSvg(index, {size: kSizeOfFunctions, ...options});
    row.replaceWith(element('p', `the ${name}: blue where it is negative, red where it is positive, the lines where it is 0`), ...pictureOf(svg, `${title} ${name}`));
  }, row);
  return row;
}
$('distance').onclick = () => {
  try {
    const [p, q] = ['p', 'q'].map(id => pointOf($(id).value.trim(), id));
    ask('Distance of p and q', `epsnet distance net.json ${$('p').value.trim()} ${$('q').value.trim()}`, ({net}, options) => net.distance(p, q, options),
        file => [`the distance is ${number(file.value)}`], {isDrawn: true});
  } catch (error) {
    $('problem').textContent = error.message;
  }
};

const ofOrder = ([order, count]) => `${count} of order ${order}`;
$('isometries').onclick = () => ask('Isometries', surfaceCommand('epsnet isometries FILE'), ({surface}, options) => surface.isometries(options), group => {
  const orders = new Map(), rest = group.order - group.orientation_preserving;
  for (const {preserves_orientation: isKept, order} of group.isometries) if (isKept) orders.set(order, (orders.get(order) ?? 0) + 1);
  return [`${group.order} isometries${group.name ? `, the group ${group.name}` : ''}`,
          `${group.orientation_preserving} preserve the orientation: ${[...orders].sort(([a], [b]) => a - b).map(ofOrder).join(', ')}`,
          rest === 0 ? 'none reverses it' : `${rest} reverse it`];
});
$('pants').onclick = () => ask('Pairs of pants', surfaceCommand('epsnet pants FILE'), ({surface}, options) => surface.pants(options), pants => {
  const use = element('button', 'Take these coordinates into the form');
  use.type = 'button';
  use.onclick = () => takeCoordinates(pants);
  addCurves(pants.cuffs.map(({length, word}, k) => ({name: `cuff ${k}, ${lengthName(length)}`, word})));
  return [...pants.cuffs.map(({length, twist, ends: [[p], [q]]}, k) => `cuff ${k}, of pants ${p} and ${q}: ${lengthName(length)}, twist ${number(twist)}`),
          ...(pants.cuffs.length <= 9 ? [use] : [])];
}, {isPicture: true});
$('dirichlet').onclick = () => ask('Dirichlet domain', surfaceCommand('epsnet dirichlet FILE -o domain.json'), ({surface}, options) => surface.dirichletDomain(options),
    domain => [`${domain.sides.length} sides, read off a triangulation that is verified; the corners are rounded`], {isPicture: true});
const middle = ([lower, upper]) => lower <= 0 && upper >= 0 ? '0' : String((lower + upper) / 2);
function takeCoordinates({edges, cuffs}) {
  choose({surface: 'fenchel-nielsen', genus: String(cuffs.length / 3 + 1), graph: edges.map(edge => edge.join('-')).join(' '),
          lengths: cuffs.map(({length}) => middle(length)), twists: cuffs.map(({twist}) => middle(twist))});
  $('surface').focus();
}

// ---- Surfaces made of the one that is shown ----

function goOn(step) {
  try {
    stepOf(step);
    choose({...current.chosen, steps: [...current.chosen.steps ?? [], step]});
    make();
  } catch (error) {
    $('problem').textContent = error.message;
  }
}
const typed = id => $(id).value.trim();
$('cover').onclick = () => goOn(`cover:${typed('degree')}:${typed('sheets')}`);
$('twist').onclick = () => goOn(`twist:${$('curve').value}:${typed('by')}`);
$('dehn-twist').onclick = () => goOn(`dehn-twist:${$('curve').value}:${typed('power')}`);

// A point of the picture as p, then as q, then as p again, if points are to be taken.
function take(x, y) {
  if (!$('take').checked || x * x + y * y >= 1) return false;
  const pin = viewer.drawing.pinAt(x, y), pins = viewer.drawing.pins;
  if (pin === null) return false;
  if (pins.length === 2) pins.length = 0;
  pin.name = pins.length === 0 ? 'p' : 'q';
  pins.push(pin);
  $(pin.name).value = pin.text;
  viewer.travel.drawAtRest();
  viewer.say(`${pin.name} is a point of triangle ${pin.triangle}`);
  if (pin.name === 'q' && running === null) $('distance').click();
  return true;
}

// ---- Files ----

const kMostBytes = 64e6;
// `isFollowed`: the address says it already.
function open(file, {isFollowed = false} = {}) {
  const command = `certify ${file.name}`;
  if (isBusyFor(() => open(file, {isFollowed}))) return;
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
    const unless = error => { if (options.signal.aborted) throw error; };
    const info = certificate.claim ? await epsnet.ask({do: 'info', net: 0}, [bytes], options).catch(unless) : undefined;
    showCertificate({bytes, certificate, info}, file.name, []);
    $('certificate-heading').focus();
    // Those that are no files of a surface, or of a net that can be drawn, have said so.
    const surface = epsnet.surfaceFromFile(bytes, file.name);
    const facts = await surface.info(options).catch(unless);
    if (facts === undefined) return;
    opened = {surface, title, genus: facts.genus};
    const entry = $('surface').querySelector('[value=file]');
    entry.disabled = false;
    entry.textContent = $('file-name').textContent = `the file ${file.name}`;
    choose({surface: 'file'});
    if (certificate.no_claim) $('certificate-text').append(element('p', 'Its surface is in the form: “Make and prove it” makes a net of it.'));
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
  fitGraph();
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
    say('the link is copied', $('buttons'));
  } catch (error) {
    say(`the link is the address of this page now: ${location.href}`, $('buttons'));
  }
};

// A link makes its net; the way back leads to surfaces and files of before.
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
    if (chosen === null) return showExample();
    choose(chosen);
    afterWork(() => {
      make({isFollowed: true});
      $('of-link').textContent = tellLink(chosen);
    });
  } catch (error) {
    forget();
    $('problem').textContent = error.message;
  }
}
function tellLink({missing, unknown}) {
  const tell = (what, fields) => fields.length > 0 ? [`${what}: ${fields.join(', ')}`] : [];
  return [...tell('not in the link, so as usual', missing), ...tell('in the link without meaning for this surface', unknown)].join('; ');
}
// On arrival something is there to be looked at.
function showExample() {
  choose({surface: 'octagon', seed: '123', epsilon: '0.1', kind: 'net'});
  afterWork(() => {
    isExample = true;
    make({isFollowed: true});
  });
}
// What was cancelled ends first.
const afterWork = next => running === null ? next() : setTimeout(afterWork, 20, next);
scheme = systemIsDark.matches ? 'dark' : 'light';
document.documentElement.dataset.scheme = scheme;
fitGraph();
fillCuffs();
tellChoice();
addEventListener('hashchange', follow);
if (location.protocol === 'file:') $('problem').textContent = 'A browser does not load the module from a file: python3 -m http.server in this folder serves it.';
else {
  follow();
  // Where there is a service worker the page works without a network from now on.
  afterWork(() => navigator.serviceWorker?.register('service.js').catch(() => {}));
}
