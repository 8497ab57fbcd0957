// node choice_test.mjs: what a link means, and numbers as the page writes them. Needs no module.
import assert from 'node:assert/strict';
import {commandsOf, estimatedVertices, fromHash, kMostVertices, kMostVerticesOfProgram, toHash} from '../../wasm/page/choice.mjs';
import {grouped, number, rough, subscript} from '../../wasm/page/numbers.mjs';

// A link of the page comes back as it is.
for (const hash of ['surface=octagon&seed=7&epsilon=0.1&kind=net', 'surface=named&name=wiman-17&epsilon=1/10&kind=sparse',
                    'surface=fenchel-nielsen&genus=3&graph=ring&lengths=1,2,3,4,5,6&twists=0,0,0,0,0,-1&epsilon=0.3&kind=pseudo']) {
  const chosen = fromHash(hash);
  assert.deepEqual(chosen.missing, []);
  assert.equal(decodeURIComponent(toHash(chosen)), hash);
}
assert.equal(fromHash(''), null);
assert.equal(fromHash('file=2'), null);

// What is missing is as usual, and is said.
assert.deepEqual(fromHash('name=klein'), {surface: 'named', name: 'klein', epsilon: '0.1', kind: 'net', missing: ['epsilon', 'kind']});
assert.deepEqual(fromHash('surface=octagon').missing, ['seed', 'epsilon', 'kind']);
assert.deepEqual(fromHash('genus=3').lengths, Array(6).fill('2'));
assert.deepEqual(fromHash('genus=2&lengths=1,1,1').twists, ['0', '0', '0']);

// What is wrong is named.
const refused = (hash, text) => assert.throws(() => fromHash(hash), {message: `This link does not work: ${text}`});
refused('surface=octagn&seed=1', 'surface=octagn, expected octagon, named, fenchel-nielsen');
refused('seed=<img>', 'seed=<img>, expected an integer');
refused('surface=named', 'name=, expected the name of a surface, such as bolza');
refused('name=Klein!', 'name=Klein!, expected a name, such as bolza or wiman-7');
refused('genus=2&lengths=1,2', 'lengths=1,2, expected 3 numbers for genus 2');
refused('genus=9', 'genus=9, expected 2, 3 or 4');
refused('seed=1&epsilon=a', 'epsilon=a, expected a number, such as 0.1 or 1/10');
refused('nonsense', 'surface=, expected octagon, named, fenchel-nielsen');

// Estimates stay numbers for the smallest ε, and grow with the genus in a name.
const vertices = (epsilon, more = {}) => estimatedVertices({surface: 'octagon', epsilon, ...more});
assert.equal(rough(vertices('1e-9')), '8.6 · 10¹⁸');
assert.ok(vertices('1e-9') > kMostVerticesOfProgram && vertices('0.1') < kMostVertices);
assert.ok(Math.abs(vertices('0.1', {name: 'wiman-7'}) / vertices('0.1') - 6) < 1e-9);
assert.equal(rough(1234.4), '1,234');
assert.equal(rough(3214321), '3.2 million');
assert.match(commandsOf({surface: 'octagon', seed: '5', epsilon: '0.1', kind: 'net'}), /^epsnet surface octagon --seed 5 -o s.json\nepsnet net s.json --epsilon 0.1 -o net.json/);

// As many digits as the enclosure determines.
assert.equal(number([0.09999999999999999, 0.1]), '0.1');
assert.equal(number([3.9359462488299, 3.9359462488301]), '3.93594624883');
assert.equal(number([2.4578, 2.4583]), '2.458');
assert.equal(number([2.41, 2.49]), 'in [2.41, 2.49]');
assert.equal(number([1, null]), 'in [1, ∞]');
assert.equal(number([2, 2]), '2');
assert.deepEqual(grouped([...Array(21).fill([3.9359462488299, 3.9359462488301]), [5, 5.0000000001]]), ['21 × 3.93594624883', '5']);
assert.equal(`λ${subscript(12)}`, 'λ₁₂');
