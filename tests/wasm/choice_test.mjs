// node choice_test.mjs: what a link means, and numbers as the page writes them. Needs no module.
import assert from 'node:assert/strict';
import {commandsOf, costOf, estimatedVertices, fromHash, kMostVertices, kMostVerticesOfProgram, stepOf, surfaceCommands, tellStep, toHash} from '../../wasm/page/choice.mjs';
import {decimal, grouped, number, rough, subscript} from '../../wasm/page/numbers.mjs';
import {curves, layout} from '../../wasm/page/pants_graph.mjs';

// A link of the page comes back as it is.
for (const hash of ['surface=octagon&seed=7&epsilon=0.1&kind=net', 'surface=named&name=wiman-17&epsilon=1/10&kind=sparse',
                    'surface=named&name=R2.1&epsilon=0.5&kind=net', 'surface=named&name=R3.5-6a&epsilon=0.5&kind=net', 'surface=named&name=C7.1&epsilon=0.5&kind=net',
                    'surface=fenchel-nielsen&genus=3&graph=ring&lengths=1,2,3,4,5,6&twists=0,0,0,0,0,-1&epsilon=0.3&kind=pseudo',
                    'surface=fenchel-nielsen&genus=2&graph=theta&lengths=1,2,3&twists=0,0,0&epsilon=0.3&kind=net',
                    'surface=fenchel-nielsen&genus=2&graph=0-0 0-1 1-1&lengths=1,2,3&twists=0,0,0&epsilon=0.3&kind=net',
                    'surface=octagon&seed=7&steps=cover:2:1,dehn-twist:0.3:-1,twist:0.3.5:1/2&epsilon=0.1&kind=net']) {
  const chosen = fromHash(hash);
  assert.deepEqual([chosen.missing, chosen.unknown], [[], []]);
  assert.equal(decodeURIComponent(toHash(chosen)), hash);
}
assert.equal(fromHash(''), null);
assert.equal(fromHash('file=2'), null);

// What is missing is as usual, and is said.
assert.deepEqual(fromHash('name=klein'), {surface: 'named', name: 'klein', epsilon: '0.1', kind: 'net', missing: ['epsilon', 'kind'], unknown: []});
assert.deepEqual(fromHash('surface=octagon').missing, ['seed', 'epsilon', 'kind']);
assert.deepEqual(fromHash('genus=3').lengths, Array(6).fill('2'));
assert.deepEqual(fromHash('genus=2&lengths=1,1,1').twists, ['0', '0', '0']);

// What means nothing for the surface is named: fields of nothing, and those of another surface.
assert.deepEqual(fromHash('seed=7&epsilom=0.2&genus=3&genus=4').unknown, ['epsilom', 'genus']);
assert.deepEqual(fromHash(`name=R2.1&${'x'.repeat(100)}=1`).unknown, ['x'.repeat(40)]);

// What is wrong is named.
const refused = (hash, text) => assert.throws(() => fromHash(hash), {message: `This link does not work: ${text}`});
refused('surface=octagn&seed=1', 'surface=octagn, expected octagon, named, fenchel-nielsen');
refused('seed=<img>', 'seed=<img>, expected an integer');
refused('surface=named', 'name=, expected the name of a surface, such as bolza');
refused('name=Klein!', 'name=Klein!, expected a name, such as bolza, wiman-7 or R2.1');
refused('genus=2&lengths=1,2', 'lengths=1,2, expected 3 numbers for genus 2');
refused('genus=3&graph=theta', 'graph=theta, expected a graph of genus 3');
refused('genus=3&graph=0-1 0-1 0-1', 'graph=0-1 0-1 0-1, expected a graph of genus 3');
refused('seed=1&steps=cover:2:1,fold:3', 'steps=fold:3, expected steps such as cover:2:1, twist:0.3:1/2 or dehn-twist:0.3:1');
refused('genus=9', 'genus=9, expected 2, 3 or 4');
refused('seed=1&epsilon=a', 'epsilon=a, expected a number, such as 0.1 or 1/10');
refused('nonsense', 'surface=, expected octagon, named, fenchel-nielsen');

// Estimates stay numbers for the smallest ε, and grow with the genus in a name.
const vertices = (epsilon, more = {}) => estimatedVertices({surface: 'octagon', epsilon, ...more});
assert.equal(rough(vertices('1e-9')), '8.6 · 10¹⁸');
assert.ok(vertices('1e-9') > kMostVerticesOfProgram && vertices('0.1') < kMostVertices);
assert.ok(Math.abs(vertices('0.1', {name: 'wiman-7'}) / vertices('0.1') - 6) < 1e-9);
for (const [name, genus] of [['R2.1', 2], ['R3.5-6a', 3], ['C7.1', 7], ['R10.13-15c', 10]])
  assert.ok(Math.abs(vertices('0.1', {name}) / vertices('0.1') - (genus - 1)) < 1e-9, name);
assert.equal(rough(1234.4), '1,234');
assert.equal(rough(3214321), '3.2 million');
assert.match(commandsOf({surface: 'octagon', seed: '5', epsilon: '0.1', kind: 'net'}), /^epsnet surface octagon --seed 5 -o s.json\nepsnet net s.json --epsilon 0.1 -o net.json/);

// Times are those of some questions, for small genera; of others nothing is said.
assert.match(costOf('systole', {genus: 2}), /^[0-9]+ s$/);
assert.match(costOf('eigenvalues', {genus: 3, count: '1', digits: '3'}), /^[0-9]+ s$/);
assert.match(costOf('spectrum', {genus: 2, upTo: '5'}), /^[0-9]+ s$/);
for (const [question, about] of [['systole', {genus: 7}], ['systole', {}], ['eigenvalues', {genus: 2, count: '5', digits: '3'}], ['eigenvalues', {genus: 2, count: '1', digits: 'x'}], ['eigenvalues', {genus: 3, count: '1', digits: '9'}],
                                 ['spectrum', {genus: 2, upTo: '9'}], ['spectrum', {genus: 2, upTo: 'x'}], ['dehn-twist', {genus: 2}]])
  assert.equal(costOf(question, about), '');

// Steps lead from one surface to another one, on the page and in the commands.
assert.deepEqual(stepOf('cover:12:7'), {kind: 'cover', degree: 12, seed: 7});
assert.deepEqual(stepOf('twist:0.3.5:-1/2'), {kind: 'twist', word: [0, 3, 5], by: '-1/2'});
assert.throws(() => stepOf('cover:x'), {message: 'cover:x: expected a cover or a twist, such as cover:2:1, twist:0.3:1/2 or dehn-twist:0.3:1'});
assert.equal(tellStep('dehn-twist:0.3:-2'), '-2 Dehn twists along 0.3');
const steps = ['cover:3:1', 'twist:0.3:-1/2'];
assert.deepEqual(surfaceCommands({surface: 'octagon', seed: '5', steps}), {
  text: 'epsnet surface octagon --seed 5 -o s.json\nepsnet surface cover s.json --degree 3 --seed 1 -o s1.json\n' +
        'epsnet surface twist s1.json 0,3 --by=-1/2 -o s2.json', file: 's2.json'});
assert.ok(Math.abs(vertices('0.1', {steps}) / vertices('0.1') - 3) < 1e-9);

// The picture of a graph of pants: neighbours are about 1 away from each other, and no two things in one place.
for (const edges of [[[0, 1], [0, 1], [0, 1]], [[0, 0], [0, 1], [1, 1]], [[0, 0], [0, 1], [1, 2], [1, 2], [2, 3], [3, 3]],
                     [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]], [[0, 0], [0, 1], [1, 2], [1, 3], [2, 2], [3, 4], [3, 5], [4, 4], [5, 5]]]) {
  const places = layout(edges), all = [...places, ...curves(edges, places).map(({label}) => label)];
  for (const [a, b] of edges) assert.ok(a === b || Math.abs(Math.hypot(places[a][0] - places[b][0], places[a][1] - places[b][1]) - 1) < 0.35, `${edges}: ${places}`);
  all.forEach((p, i) => all.slice(0, i).forEach(q => assert.ok(Math.hypot(p[0] - q[0], p[1] - q[1]) > 0.27, `${edges}: ${all}`)));
}

// As many digits as the enclosure determines.
assert.equal(number([0.09999999999999999, 0.1]), '0.1');
assert.equal(number([3.9359462488299, 3.9359462488301]), '3.93594624883');
assert.equal(number([2.4578, 2.4583]), '2.458');
assert.equal(number([2.41, 2.49]), 'in [2.41, 2.49]');
assert.equal(number([1, null]), 'in [1, ∞]');
assert.equal(number([2, 2]), '2');
assert.equal(number([-2.4084e-70, 2.408e-70]), '0 ± 3e-70');
assert.equal(number([-9.8e-70, 0]), '0 ± 1e-69');
assert.equal(number([0, 0]), '0');
assert.equal(decimal('19499/32768'), '0.595062255859');
assert.equal(decimal('-2/3'), '-0.666666666667');
assert.equal(decimal(`${2n ** 2000n}/${3n * 2n ** 2000n}`), '0.333333333333');
assert.equal(decimal('0'), '0');
assert.equal(decimal('1/30000000'), '3.3333e-8');
assert.deepEqual(grouped([...Array(21).fill([3.9359462488299, 3.9359462488301]), [5, 5.0000000001]]), ['21 × 3.93594624883', '5']);
assert.equal(`λ${subscript(12)}`, 'λ₁₂');
