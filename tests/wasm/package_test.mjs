// node package_test.mjs: what the npm package refuses before it asks the module, which is not needed.
import assert from "node:assert/strict";

import epsnet from "../../wasm/js/epsnet.mjs";

const refused = (promise, message) => assert.rejects(promise, { kind: "ArgumentError", message });
const surface = epsnet.octagon(1);

// Options that there are not are named, with those that there are.
await refused(surface.net("0.1", { sparce: true }), 'unknown option "sparce", expected pseudo, sparse, base, signal, progress');
await refused(surface.systole({ width: 1 }), 'unknown option "width", expected signal, progress');
await refused(surface.diameter({ digits: 3 }), 'unknown option "digits", expected width, signal, progress');
await refused(surface.eigenvalues({ upTo: 3 }), 'unknown option "upTo", expected count, below, digits, epsilon, phases, signal, progress');
await refused(surface.svg({ colour: "none" }), 'unknown option "colour", expected size, signal, progress');
await refused(epsnet.certify("{}", { fast: true }), 'unknown option "fast", expected name, exact, signal, progress');
await refused(epsnet.svg("{}", { color: "none" }), 'unknown option "color", expected size, centre, colour, legend, show, eigenfunction, signal, progress');
await refused(epsnet.about({ x: 1 }), 'unknown option "x", expected signal, progress');
await refused(surface.pants({ curve: [] }), 'unknown option "curve", expected curves, find, signal, progress');
await refused(surface.isometries({ proof: true }), 'unknown option "proof", expected signal, progress');
await refused(surface.dirichletDomain({ point: {} }), 'unknown option "point", expected base, signal, progress');
assert.throws(() => surface.cover({ sheets: 3 }), { kind: "ArgumentError", message: 'unknown option "sheets", expected permutations, degree, seed, signal, progress' });

// A number that is none is named as it was given.
await refused(surface.net(NaN), "epsilon: expected a number, not NaN");
await refused(surface.spectrum(-Infinity), "up_to: expected a number, not -Infinity");
await refused(surface.distance({ tile: 0, z: [0, Infinity] }, { tile: 0 }), "z: expected a number, not Infinity");
await refused(epsnet.octagon(NaN).info(), "octagon: expected a number, not NaN");
await refused(surface.twist([0], NaN).info(), "by: expected a number, not NaN");
await refused(epsnet.coordinates({ genus: NaN }), "genus: expected a number, not NaN");
