// What is chosen on the page, as the part of its address after #, and as commands of the program. Nothing here knows of the page.

const kFields = {octagon: ['seed'], named: ['name'], 'fenchel-nielsen': ['genus', 'graph', 'lengths', 'twists']};
const kNumber = /^-?[0-9.eE/+-]{1,40}$/;
const kForms = {
  seed: /^[0-9]{1,10}$/, name: /^[a-z0-9-]{1,40}$/, genus: /^[2-4]$/, graph: /^(chain|ring|tree)$/, epsilon: kNumber, kind: /^(net|sparse|pseudo)$/,
  lengths: kNumber, twists: kNumber};
const kExpected = {
  seed: 'an integer', name: 'a name, such as bolza or wiman-7', genus: '2, 3 or 4', graph: 'chain, ring or tree', epsilon: 'a number, such as 0.1 or 1/10',
  kind: 'net, sparse or pseudo', lengths: 'numbers', twists: 'numbers'};

export function toHash(chosen) {
  const fields = ['surface', ...kFields[chosen.surface], 'epsilon', 'kind'];
  return fields.map(field => `${field}=${[].concat(chosen[field]).map(encodeURIComponent).join(',')}`).join('&');
}

const kDefaults = {seed: '123', genus: '2', graph: 'chain', epsilon: '0.1', kind: 'net'};

// The choice that an address describes, with `missing`, the fields that it does not have and that are those of kDefaults, lengths 2 and twists 0;
// null if it describes none. Throws an Error that says which value is wrong. Other people make addresses: each value must have its form.
export function fromHash(hash) {
  const values = new URLSearchParams(hash);
  if (hash === '' || values.has('file')) return null;
  const wrong = (field, value, expected) => new Error(`This link does not work: ${field}=${String(value).slice(0, 40)}, expected ${expected}`);
  const surface = values.get('surface') ?? Object.keys(kFields).find(kind => kFields[kind].some(field => values.has(field)));
  if (!Object.hasOwn(kFields, surface)) throw wrong('surface', surface ?? '', Object.keys(kFields).join(', '));
  const chosen = {surface, missing: []};
  for (const field of [...kFields[surface], 'epsilon', 'kind']) {
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
  return chosen;
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

// The commands that do the same: the first makes the surface.
export function commandsOf(chosen) {
  const quoted = text => /^[\w.,/+-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`;
  const option = (name, list) => `${name}=${quoted(list.join(','))}`;
  const surface = {
    octagon: () => `octagon --seed ${quoted(chosen.seed)} -o s.json`,
    named: () => `named ${quoted(chosen.name)} -o s.json`,
    'fenchel-nielsen': () => `fenchel-nielsen --genus ${chosen.genus} --pants-graph ${chosen.graph} ${option('--lengths', chosen.lengths)} ` +
                             `${option('--twists', chosen.twists)} -o s.json`};
  const first = chosen.surface === 'file' ? `epsnet convert ${quoted(chosen.title + '.json')} s.json --surface` : `epsnet surface ${surface[chosen.surface]()}`;
  const kind = chosen.kind === 'sparse' ? ' --sparse' : chosen.kind === 'pseudo' ? ' --pseudo' : '';
  return `${first}\nepsnet net s.json --epsilon ${quoted(chosen.epsilon ?? '0.1')}${kind} -o net.json\ncertify net.json`;
}

// Beyond the first a net takes a browser minutes, and gigabytes; beyond the second the program refuses it (docs/using-epsnet.md, "Limits").
export const kMostVertices = 400000;
export const kMostVerticesOfProgram = 26e6;
const kGenus = {bolza: 2, klein: 3, 'fermat-quartic': 3, bring: 4, 'fricke-macbeath': 7};
// How many vertices a net has, roughly: 2.15 times the lower bound (docs/design.md), its area over that of a disk of radius ε. Thin parts are not counted.
export function estimatedVertices(chosen) {
  const [numerator, denominator] = chosen.epsilon.split('/'), epsilon = Number(numerator) / Number(denominator ?? 1);
  const genus = Number(chosen.genus ?? kGenus[chosen.name] ?? /-([0-9]+)$/.exec(chosen.name)?.[1] ?? 2);
  if (!(epsilon > 0) || !Number.isFinite(genus)) return 0;  // The module says what is wrong.
  return 2.15 * (genus - 1) / Math.sinh(epsilon / 2) ** 2;
}
