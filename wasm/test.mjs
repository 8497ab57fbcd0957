// What wasm/test runs in a folder with the npm package: the interface as users see it.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import test, { after } from "node:test";

import epsnet, { EpsnetError, octagon } from "epsnet";

const data = process.argv[2];
after(() => epsnet.close());

/** The error that a promise is rejected with. */
async function kindOf(promise) {
  const error = await promise.then(() => assert.fail("no error"), (problem) => problem);
  assert(error instanceof EpsnetError, String(error));
  return error.kind;
}

test("the example of the README", async () => {
  const net = await epsnet.octagon(123).net("0.1");
  assert.equal(net.certificate.verdict, "VERIFIED");
  assert.deepEqual(net.certificate.verified_by, ["certify", "certify-exact"]);
  assert.match(net.certificate.text, /\nVERIFIED\n$/);
  const certificate = await epsnet.certify(net.bytes);
  assert.equal(certificate.sha256, net.certificate.sha256);
  assert.equal(net.info.vertices, net.certificate.counts.vertices);
  assert.match(await net.svg(), /^<svg /);
  assert.match(await net.page({ title: "A title" }), /<title>A title/);
  const again = await net.surface.net("0.1");
  assert.deepEqual(again.bytes, net.bytes);
});

test("surfaces from everywhere", async () => {
  const { names, version } = await epsnet.about();
  assert.match(version, /^\d+\.\d+\.\d+$/);
  assert(names.some(({ name }) => name === "bolza"));
  assert.equal((await epsnet.named("klein").info()).genus, 3);
  assert.equal((await epsnet.named("wiman", 7).info()).genus, 7);
  assert.deepEqual(await epsnet.named("wiman", 7).file(), await epsnet.named("wiman-7").file());
  assert.equal(await kindOf(epsnet.named("wiman").info()), "SurfaceError");
  assert.equal((await epsnet.regular(4).info()).genus, 4);
  assert.deepEqual((await epsnet.coordinates({ graph: "theta", lengths: [2], twists: [0] })).edges, [[0, 1], [0, 1], [0, 1]]);
  assert.equal((await epsnet.fenchelNielsen({ graph: "chain", genus: 2, seed: 1 }).info()).genus, 2);
  const { edges, lengths } = await epsnet.coordinates({ graph: "chain", genus: 2, seed: 1 });
  assert.deepEqual([edges.length, lengths.length], [3, 3]);
  const file = await octagon(7).file();
  assert.deepEqual(await epsnet.surfaceFromFile(file).file(), file);
  assert.equal((await epsnet.surfaceFromFile((await octagon(7).net("1")).bytes).info()).genus, 2);
});

test("geodesics, distances, bounds, eigenvalues", async () => {
  const surface = octagon(123);
  const systole = await surface.systole();
  const [lower, upper] = systole.geodesics[0].length;
  assert(lower <= upper && upper - lower < 1e-9);
  const spectrum = await surface.spectrum("3");
  assert.deepEqual(spectrum.geodesics[0].length, systole.geodesics[0].length);
  const net = await surface.net("0.5");
  const distance = await net.distance({ vertex: 0 }, { triangle: 5, weights: [1, 1, 1] });
  assert(distance.value[0] > 0);
  assert.match(await net.svg({ layers: [systole, distance] }), /^<svg /);
  assert.equal((await net.locate(distance.q)).place, "inside");
  const diameter = await surface.diameter({ width: 0.1 });
  assert.equal(diameter.certificate.verdict, "VERIFIED");
  assert((await surface.distance(diameter.p, { tile: 0 })).value[1] <= diameter.value[1]);
  const eigenvalues = await surface.eigenvalues({ count: 1, digits: 3 });
  assert(eigenvalues.eigenvalues[0].count >= 1 && eigenvalues.next > eigenvalues.eigenvalues[0].in[0]);
  assert.match(await eigenvalues.eigenfunctionSvg(1), /class="nodal-lines"/);
  assert.equal(await kindOf(eigenvalues.eigenfunctionSvg(1000)), "ArgumentError");
  assert.equal(await kindOf(surface.eigenvalues({ count: 1, below: 1 })), "ArgumentError");
});

test("closed curves, and eigenvalues with phases", async () => {
  const bolza = epsnet.named("bolza");
  const systole = (await bolza.systole()).geodesics[0];
  const found = await bolza.closedCurves([systole, [0, 0]]);
  assert.equal(found.certificate.verdict, "VERIFIED");
  assert.deepEqual(found.basis, [2, 3, 4, 5]);
  assert.deepEqual(found.curves.map(({ power, self_intersections }) => [power, self_intersections]).slice(0, 2), [[1, 0], [2, 1]]);
  assert.deepEqual(found.curves[2].homology, [1, 0, 0, 0]);
  const [meet] = found.pairs.filter(({ first, second }) => first === 2 && second === 3);
  assert.deepEqual([meet.intersections, Math.abs(meet.algebraic)], [1, 1]);
  assert.equal(found.fill, false);
  assert.match(await found.svg(), /^<svg /);
  assert.equal(await kindOf(bolza.closedCurves([[0, 4]])), "ArgumentError"); // Null-homotopic.

  const half = await bolza.eigenvalues({ count: 1, digits: 2, phases: ["1/2", 0, 0, 0.0] });
  assert(half.eigenvalues[0].first === 0 && half.eigenvalues[0].in[0] > 0);
  assert.equal(half.certificate.verdict, "VERIFIED");
  assert.equal(await kindOf(bolza.eigenvalues({ phases: [0] })), "ArgumentError");
});

test("isometries, pants, twists, covers, Dirichlet domains", async () => {
  const bolza = epsnet.named("bolza");
  const group = await bolza.isometries();
  assert.deepEqual([group.order, group.orientation_preserving, group.isometries.length], [96, 48, 96]);
  assert.equal(group.certificate.verdict, "VERIFIED");
  assert.equal((await octagon(1).isometries()).name, "C2");

  const surface = octagon(5);
  const pants = await surface.pants();
  assert.equal(pants.certificate.verdict, "VERIFIED");
  assert.deepEqual([pants.own, pants.edges.length, pants.cuffs.length, pants.pants.length], [false, 3, 3, 2]);
  assert.match(await pants.svg(), /^<svg /);
  const systole = (await surface.systole()).geodesics[0];
  const ofOne = await surface.pants({ curves: [systole] });
  assert(ofOne.cuffs.some(({ length }) => length[0] <= systole.length[1] && systole.length[0] <= length[1]));
  const again = await pants.fenchelNielsen().systole();
  assert(Math.abs(again.geodesics[0].length[0] - systole.length[0]) < 1e-9);
  assert.equal((await pants.fenchelNielsen().pants()).own, true);

  // A Dehn twist changes the marking, a twist the surface.
  const marked = surface.dehnTwist(systole, -2);
  assert.equal((await marked.isometricTo(surface)).isometric, "yes");
  assert.equal((await surface.twist(systole, "1/3").isometricTo(surface)).isometric, "no");
  assert.deepEqual(await surface.dehnTwistWords(systole, 0), Array.from({ length: 8 }, (_, side) => [side]));
  assert.equal(await kindOf(surface.dehnTwist([0, 0]).info()), "ArgumentError");
  assert.equal(await kindOf(surface.pants({ curves: [[-1]] })), "ArgumentError");

  assert.equal((await surface.generators()).length, 4);
  assert.equal((await surface.cover({ permutations: [[1, 0], [0, 1], [0, 1], [0, 1]] }).info()).genus, 3);
  const cover = surface.cover({ degree: 3, seed: 1 });
  assert.equal((await cover.info()).genus, 4);
  assert.equal((await cover.net("0.7")).certificate.verdict, "VERIFIED");
  assert.equal(await kindOf(surface.cover({ degree: 51, seed: 1 }).info()), "SurfaceError");
  const file = epsnet.surfaceFromFile(await surface.file());
  assert.equal((await file.isometricTo(file.cover({ degree: 1, seed: 1 }))).isometric, "yes");

  const domain = await bolza.dirichletDomain();
  assert.deepEqual([domain.sides.length, domain.vertices.length], [8, 8]);
  assert.match(await domain.svg({ size: 300 }), /^<svg [^>]*300/);
  assert((await bolza.dirichletDomain({ base: { tile: 0, z: ["0.1", "0.2"] } })).sides.length > 8);
});

test("files are what certify says they are", async () => {
  for (const folder of ["verified", "refuted", "undecided", "malformed"]) {
    const name = fs.readdirSync(path.join(data, "certify", folder))[0];
    const certificate = await epsnet.certify(fs.readFileSync(path.join(data, "certify", folder, name)), { name });
    assert.equal(certificate.verdict.toLowerCase(), folder, name);
    assert.equal(certificate.file, name);
  }
  assert.equal((await epsnet.certify("")).verdict, "MALFORMED");
});

test("errors have their kind", async () => {
  assert.equal(await kindOf(epsnet.named("nowhere").info()), "SurfaceError");
  assert.equal(await kindOf(octagon(1.5).info()), "ArgumentError");
  assert.equal(await kindOf(octagon(2 ** 40).info()), "ArgumentError");
  assert.equal(await kindOf(octagon(1).net("-1")), "ArgumentError");
  assert.equal(await kindOf(octagon(1).net("0.5", { pseudo: true })), "ArgumentError");
  assert.equal(await kindOf(octagon(1).svg({ size: 100, colour: 7 }).then(() => octagon(1).net("x"))), "ArgumentError");
  assert.equal(await kindOf(epsnet.surfaceFromFile("{}").info()), "FormatError");
  assert.equal(await kindOf(epsnet.svg("nonsense")), "FormatError");
  assert.equal(await kindOf(epsnet.ask({ do: "nothing" })), "ArgumentError");
  assert.equal(await kindOf(epsnet.ask([])), "ArgumentError");
});

test("texts of megabytes fit", async () => {
  const net = await octagon(123).net("0.02");
  assert(net.bytes.length > 2e6);
  assert.equal((await epsnet.certify(net.text)).verdict, "VERIFIED");
});

test("progress and cancellation", async () => {
  const steps = [];
  const controller = new AbortController();
  const job = octagon(123).net("0.003", {
    signal: controller.signal,
    progress: (what, share) => {
      steps.push([what, share]);
      controller.abort();
    },
  });
  const next = octagon(321).net("1"); // Waits, and is answered by a new worker.
  await assert.rejects(job, { name: "AbortError" });
  assert(steps.every(([what, share]) => typeof what === "string" && share >= 0 && share <= 1) && steps.length > 0);
  assert.equal((await next).certificate.verdict, "VERIFIED");
  await assert.rejects(octagon(1).net("1", { signal: AbortSignal.abort() }), { name: "AbortError" });
});
