// What is chosen on the page, as the part of its address after #, and as commands of the program. Nothing here knows of the page.

const kFields = {octagon: ['seed'], named: ['name'], 'fenchel-nielsen': ['genus', 'graph', 'lengths', 'twists']};
const kNumber = /^-?[0-9.eE/+-]{1,40}$/;
const kForms = {
  seed: /^[0-9]{1,10}$/, name: /^[A-Za-z0-9.-]{1,40}$/, genus: /^[2-4]$/, graph: /^(chain|ring|tree|theta|[0-5]-[0-5]( [0-5]-[0-5]){2,8})$/, epsilon: kNumber, kind: /^(net|sparse|pseudo)$/,
  lengths: kNumber, twists: kNumber};
const kExpected = {
  seed: 'an integer', name: 'a name, such as bolza, wiman-7 or R2.1', genus: '2, 3 or 4', graph: 'chain, ring, tree, theta or edges such as 0-1 0-1 0-1', epsilon: 'a number, such as 0.1 or 1/10',
  kind: 'net, sparse or pseudo', lengths: 'numbers', twists: 'numbers'};

// Steps from a surface to another one, in the order of the parts of their texts: cover:2:1, twist:0.3.5:1/2, dehn-twist:0.3.5:-1.
const kWord = '[0-9]{1,6}(?:[.][0-9]{1,6}){0,199}';
const kSteps = {
  cover: {form: /^cover:([0-9]{1,2}):([0-9]{1,10})$/, tell: (degree, seed) => `its cover of degree ${degree} of the seed ${seed}`,
          options: (degree, seed) => `--degree ${degree} --seed ${seed}`},
  twist: {form: new RegExp(`^twist:(${kWord}):([0-9./-]{1,40})$`), tell: (word, by) => `a twist by ${by} along ${word}`,
          options: (word, by) => `${word.replaceAll('.', ',')} --by=${by}`},
  'dehn-twist': {form: new RegExp(`^dehn-twist:(${kWord}):(-?[0-9]{1,4})$`), tell: (word, power) => `${power} Dehn twists along ${word}`,
                 options: (word, power) => `${word.replaceAll('.', ',')} ${power}`}};
const stepForm = text => Object.entries(kSteps).find(([, {form}]) => form.test(text));

// The parts of a step: {kind, degree, seed} of a cover, {kind, word, by} of a twist by a length or as often as `by`. Throws an Error for other texts.
export function stepOf(text) {
  const found = stepForm(text);
  if (found === undefined) throw new Error(`${text.slice(0, 40)}: expected a cover or a twist, such as cover:2:1, twist:0.3:1/2 or dehn-twist:0.3:1`);
  const [kind, {form}] = found, [, first, second] = form.exec(text);
  return kind === 'cover' ? {kind, degree: Number(first), seed: Number(second)} : {kind, word: first.split('.').map(Number), by: second};
}
export function tellStep(text) {
  const [, {form, tell}] = stepForm(text);
  return tell(...form.exec(text).slice(1));
}

export function toHash(chosen) {
  const fields = ['surface', ...kFields[chosen.surface], ...(chosen.steps ? ['steps'] : []), 'epsilon', 'kind'];
  return fields.map(field => `${field}=${[].concat(chosen[field]).map(encodeURIComponent).join(',')}`).join('&');
}

// The genus of a map of Conder's census, as R2.1 or C7.1, or of the member of a family, as wiman-7; else undefined.
export const genusOfMap = name => /^[RC]([0-9]+)[.]/.exec(name)?.[1];
const genusOfMember = name => /-([0-9]+)$/.exec(name)?.[1];

const kDefaults = {seed: '123', genus: '2', graph: 'chain', epsilon: '0.1', kind: 'net'};

// The choice that an address describes, with `missing`, the fields that it does not have and that are those of kDefaults, lengths 2 and twists 0,
// and `unknown`, those that mean nothing for this surface; null if it describes none. Throws an Error that says which value is wrong.
// Other people make addresses: each value must have its form.
export function fromHash(hash) {
  const values = new URLSearchParams(hash);
  if (hash === '' || values.has('file')) return null;
  const wrong = (field, value, expected) => new Error(`This link does not work: ${field}=${String(value).slice(0, 40)}, expected ${expected}`);
  const surface = values.get('surface') ?? Object.keys(kFields).find(kind => kFields[kind].some(field => values.has(field)));
  if (!Object.hasOwn(kFields, surface)) throw wrong('surface', surface ?? '', Object.keys(kFields).join(', '));
  const fields = [...kFields[surface], 'epsilon', 'kind'];
  const unknown = [...new Set(values.keys())].filter(name => !['surface', 'steps', ...fields].includes(name)).map(name => name.slice(0, 40));
  const chosen = {surface, missing: [], unknown};
  for (const field of fields) {
    const isList = field === 'lengths' || field === 'twists', count = 3 * chosen.genus - 3, text = values.get(field);
    if (text === null && field === 'name') throw wrong('name', '', 'the name of a surface, such as bolza');
    if (text === null) chosen.missing.push(field);
    const usual = isList ? Array(count).fill(field === 'lengths' ? '2' : '0').join(',') : kDefaults[field];
    const words = isList ? (text ?? usual).split(',') : [text ?? usual];
    const bad = words.find(word => !kForms[field].test(word));
    if (bad !== undefined) throw wrong(field, bad, kExpected[field]);
    if (isList && words.length !== count) throw wrong(field, text, `${count} numbers for genus ${chosen.genus}`);
    chosen[field] = isList ? words : words[0];
  }
  const edges = /-/.test(chosen.graph) ? chosen.graph.split(' ').length : 3 * chosen.genus - 3;
  if (surface === 'fenchel-nielsen' && (edges !== 3 * chosen.genus - 3 || (chosen.graph === 'theta' && chosen.genus !== '2')))
    throw wrong('graph', chosen.graph, `a graph of genus ${chosen.genus}`);
  if (values.has('steps')) chosen.steps = values.get('steps').split(',');
  const step = chosen.steps?.find(text => stepForm(text) === undefined);
  if (step !== undefined) throw wrong('steps', step, 'steps such as cover:2:1, twist:0.3:1/2 or dehn-twist:0.3:1');
  return chosen;
}

// Seconds that questions take at most on surfaces of genus 2 and 3 without short closed geodesics, rounded up from what docs/wasm.md says.
const kSeconds = {
  systole: [2, 3], diameter: [2, 4], radius: [2, 4], isometries: [2, 6], pants: [1, 2], dirichlet: [1, 1], curves: [1, 1], distance: [2, 2], 'spectrum up to 5': [2, 3],
  '1 eigenvalue, 2 digits': [5, 10], '1 eigenvalue, 3 digits': [30, 60], '1 eigenvalue, 6 digits': [30], '1 eigenvalue, 9 digits': [30]};
// How long a question of the page takes, roughly: "2 s", or empty if nobody has measured it. `upTo` is of the spectrum, `count` and `digits` of eigenvalues.
export function costOf(question, {genus, upTo, count, digits}) {
  const name = {spectrum: Number(upTo) <= 5 ? 'spectrum up to 5' : '', eigenvalues: Number(count) === 1 ? `1 eigenvalue, ${digits} digits` : ''}[question] ?? question;
  const seconds = kSeconds[name]?.[genus - 2];
  return seconds === undefined ? '' : `${seconds} s`;
}

// A point as epsnet writes it (docs/using-epsnet.md): v17; t12:1,2,1; 0,1/3,-0.25; 0.
export function pointOf(text, name) {
  const number = '[-+0-9.eE/]+', forms = [
    [/^v([0-9]{1,9})$/, ([, v]) => ({vertex: Number(v)})],
    [new RegExp(`^t([0-9]{1,9}):(${number}),(${number}),(${number})$`), ([, t, ...weights]) => ({triangle: Number(t), weights})],
    [new RegExp(`^([0-9]{1,9}),(${number}),(${number})$`), ([, t, ...z]) => ({tile: Number(t), z})],
    [/^([0-9]{1,9})$/, ([, t]) => ({tile: Number(t)})]];
  for (const [form, make] of forms) {
    const found = form.exec(text);
    if (found !== null) return make(found);
  }
  throw new Error(`${name}: "${text}" is not a point; it is written as in v17, 0,1/3,-0.25 or t12:1,2,1`);
}

const quoted = text => /^[\w.,/+-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`;

// The commands that make the surface, and the file that has it then.
export function surfaceCommands(chosen) {
  const option = (name, list) => `${name}=${quoted(list.join(','))}`;
  const first = {
    file: () => `convert ${quoted(chosen.title + '.json')} s.json --surface`,
    octagon: () => `surface octagon --seed ${quoted(chosen.seed)} -o s.json`,
    named: () => `surface named ${quoted(chosen.name)} -o s.json`,
    'fenchel-nielsen': () => `surface fenchel-nielsen --genus ${chosen.genus} --pants-graph ${quoted(chosen.graph)} ${option('--lengths', chosen.lengths)} ` +
                             `${option('--twists', chosen.twists)} -o s.json`};
  const lines = [first[chosen.surface]()];
  let file = 's.json';
  for (const text of chosen.steps ?? []) {
    const [kind, {form, options}] = stepForm(text), before = file;
    file = `s${lines.length}.json`;
    lines.push(`surface ${kind} ${before} ${options(...form.exec(text).slice(1))} -o ${file}`);
  }
  return {text: lines.map(line => `epsnet ${line}`).join('\n'), file};
}
// The commands that do the same as the page.
export function commandsOf(chosen) {
  const {text, file} = surfaceCommands(chosen), kind = chosen.kind === 'sparse' ? ' --sparse' : chosen.kind === 'pseudo' ? ' --pseudo' : '';
  return `${text}\nepsnet net ${file} --epsilon ${quoted(chosen.epsilon ?? '0.1')}${kind} -o net.json\ncertify net.json`;
}

// Beyond the first a net takes a browser minutes, and gigabytes; beyond the second the program refuses it (docs/using-epsnet.md, "Limits").
export const kMostVertices = 400000;
export const kMostVerticesOfProgram = 26e6;
const kGenus = {bolza: 2, klein: 3, 'fermat-quartic': 3, bring: 4, 'fricke-macbeath': 7};
// How many vertices a net has, roughly: 2.15 times the lower bound (docs/design.md), its area over that of a disk of radius ε. Thin parts are not counted.
export function estimatedVertices(chosen) {
  const [numerator, denominator] = chosen.epsilon.split('/'), epsilon = Number(numerator) / Number(denominator ?? 1);
  const genus = Number(chosen.genus ?? kGenus[chosen.name] ?? genusOfMap(chosen.name) ?? genusOfMember(chosen.name) ?? 2);
  const sheets = (chosen.steps ?? []).reduce((product, text) => product * (stepOf(text).degree ?? 1), 1);
  if (!(epsilon > 0) || !Number.isFinite(genus)) return 0;  // The module says what is wrong.
  return 2.15 * sheets * (genus - 1) / Math.sinh(epsilon / 2) ** 2;
}
