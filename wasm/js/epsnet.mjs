// epsnet: ε-nets of closed hyperbolic surfaces, computed and proved. docs/wasm.md describes this interface, epsnet.d.ts its types.
//
// A surface is a recipe, a net and all else that is proved is the text of its file; a worker computes and keeps nothing. So a computation is
// cancelled by ending the worker.

/** What went wrong; `kind` is a name such as "SurfaceError". */
export class EpsnetError extends Error {
  constructor(kind, message) {
    super(message);
    this.name = "EpsnetError";
    this.kind = kind;
  }
}

const encoder = new TextEncoder();
const decoder = new TextDecoder();

// The worker.

let worker = null;
let current = null; // The job that the worker is at.
let waiting = [];
let lastId = 0;

async function startWorker() {
  const url = new URL("./worker.mjs", import.meta.url);
  if (typeof process === "object" && process.versions?.node) {
    const { Worker } = await import("node:worker_threads");
    const started = new Worker(url);
    started.on("message", receive.bind(null, started));
    started.on("error", (error) => fail(started, error));
    return { post: (message) => started.postMessage(message), end: () => started.terminate(), idle: () => started.unref(), busy: () => started.ref(), started };
  }
  const started = new Worker(url, { type: "module" });
  started.onmessage = ({ data }) => receive(started, data);
  started.onerror = (event) => fail(started, event);
  return { post: (message) => started.postMessage(message), end: () => started.terminate(), idle() {}, busy() {}, started };
}

/** Takes the worker away; the next job gets a new one. */
function endWorker() {
  worker?.then((running) => running.end(), () => {});
  worker = null;
}

async function next() {
  if (current !== null || waiting.length === 0) return;
  const job = (current = waiting.shift());
  worker ??= startWorker();
  try {
    const running = await worker;
    if (current !== job) return; // Cancelled meanwhile.
    job.started = running.started;
    running.busy();
    running.post({ id: job.id, what: job.what, files: job.files });
  } catch (error) {
    settle(job, () => job.reject(new EpsnetError("EpsnetError", `no worker: ${error?.message ?? error}`)));
  }
}

function settle(job, how) {
  if (current !== job) return;
  current = null;
  job.signal?.removeEventListener("abort", job.cancel);
  how();
  worker?.then((running) => { if (current === null) running.idle(); }, () => {});
  next();
}

function receive(started, { id, json, files, error, broken, progress }) {
  const job = current;
  if (job === null || job.id !== id || job.started !== started) return;
  if (progress) return job.progress?.(progress.what, progress.share);
  if (broken) endWorker();
  settle(job, () => (error ? job.reject(new EpsnetError(error.kind, error.message)) : job.resolve({ json, files, ...JSON.parse(json) })));
}

function fail(started, event) {
  const job = current;
  if (job === null || job.started !== started) return;
  endWorker();
  settle(job, () => job.reject(new EpsnetError("EpsnetError", `the worker failed: ${event?.message ?? "it could not be loaded"}`)));
}

/** Asks the module (docs/wasm.md, "Requests"). Resolves to the members of the answer's object, and `files`, arrays of bytes. */
export function ask(what, files = [], { signal, progress } = {}) {
  return new Promise((resolve, reject) => {
    requireNumbers(what, "request");
    const aborted = () => reject(signal.reason ?? new DOMException("This operation was aborted", "AbortError"));
    if (signal?.aborted) return aborted();
    const job = { id: ++lastId, what, files, resolve, reject, signal, progress };
    job.cancel = () => {
      if (current === job) {
        endWorker();
        settle(job, aborted);
      } else {
        waiting = waiting.filter((other) => other !== job);
        aborted();
      }
    };
    signal?.addEventListener("abort", job.cancel, { once: true });
    waiting.push(job);
    next();
  });
}

/** Ends the worker, and with it what it computes. The next request starts a new one. */
export function close() {
  const jobs = current === null ? waiting : [current, ...waiting];
  waiting = [];
  current = null;
  endWorker();
  for (const job of jobs) job.reject(new EpsnetError("EpsnetError", "closed"));
}

function bytesOf(data) {
  if (typeof data === "string") return encoder.encode(data);
  if (data instanceof Uint8Array) return data;
  if (data instanceof ArrayBuffer) return new Uint8Array(data);
  throw new TypeError("expected a string, an ArrayBuffer or a Uint8Array");
}

/** Options of the job, which are not of the request. */
const OPTIONS = ["signal", "progress"];

const PICTURE = ["size", "centre", "colour", "legend", "show", "eigenfunction"];

/** The options of a request, which are among the known ones, without those of the job. */
function members(options, known) {
  for (const name of Object.keys(options)) {
    if (!known.includes(name) && !OPTIONS.includes(name)) {
      throw new EpsnetError("ArgumentError", `unknown option "${name}", expected ${[...known, ...OPTIONS].join(", ")}`);
    }
  }
  return Object.fromEntries(Object.entries(options).filter(([name, value]) => !OPTIONS.includes(name) && value !== undefined));
}

/** Throws for numbers that JSON does not have, wherever they are in a request. */
function requireNumbers(value, name) {
  if (typeof value === "number" && !Number.isFinite(value)) throw new EpsnetError("ArgumentError", `${name}: expected a number, not ${value}`);
  if (value === null || typeof value !== "object") return;
  for (const [member, inner] of Object.entries(value)) requireNumbers(inner, Array.isArray(value) ? name : member);
}

/** A file that both checkers were asked about: its bytes, and its certificate. */
export class ProvedFile {
  constructor({ files: [bytes, text], json, files, ...facts }) {
    this.bytes = bytes;
    this.certificate = { ...facts.certificate, text: decoder.decode(text) };
    for (const [name, value] of Object.entries(facts)) if (name !== "certificate") this[name] = value;
  }
  /** The text of the file. */
  get text() {
    return decoder.decode(this.bytes);
  }
  /** Its picture, as SVG. */
  async svg({ layers = [], ...options } = {}) {
    const what = { do: "svg", file: 0, layers: layers.map((_, k) => k + 1), ...members(options, PICTURE) };
    return decoder.decode((await ask(what, [this.bytes, ...layers.map((layer) => layer.bytes)], options)).files[0]);
  }
}

/** Eigenvalues that are verified. */
export class Eigenvalues extends ProvedFile {
  /** The picture of the eigenfunction of λ_index, from 1 on, as SVG. */
  async eigenfunctionSvg(index, options) {
    return this.svg({ eigenfunction: index, ...options });
  }
}

/** An ε-net that is verified. */
export class Net extends ProvedFile {
  /** The surface of the net, from its file. */
  get surface() {
    return new Surface({ file: 0, name: "net" }, [this.bytes]);
  }
  /** A page to travel in, as HTML: one file that needs nothing else. */
  async page({ layers = [], ...options } = {}) {
    const what = { do: "page", net: 0, layers: layers.map((_, k) => k + 1), ...members(options, ["title"]) };
    return decoder.decode((await ask(what, [this.bytes, ...layers.map((layer) => layer.bytes)], options)).files[0]);
  }
  /** What the viewer of wasm/page shows of it. */
  async viewerData({ layers = [], ...options } = {}) {
    const what = { do: "viewer", net: 0, layers: layers.map((_, k) => k + 1), ...members(options, ["title"]) };
    return JSON.parse((await ask(what, [this.bytes, ...layers.map((layer) => layer.bytes)], options)).json);
  }
  /** The distance of two points, {vertex}, {triangle, weights} or {tile, z}, with all shortest geodesics. */
  async distance(p, q, options = {}) {
    members(options, []);
    return new ProvedFile(await ask({ do: "distance", surface: { file: 0 }, net: 0, p, q }, [this.bytes], options));
  }
  /** The triangle that contains a point. */
  async locate(point, options = {}) {
    members(options, []);
    const { json, files, ...found } = await ask({ do: "locate", net: 0, point }, [this.bytes], options);
    return found;
  }
}

/** All isometries of a surface, verified. */
export class IsometryGroup extends ProvedFile {}

/** Pairs of pants of which a surface is glued, with its Fenchel–Nielsen coordinates, verified. */
export class PantsDecomposition extends ProvedFile {
  /** The surface of these coordinates: the middles of the intervals, or other twists. */
  fenchelNielsen(twists = this.cuffs.map(({ twist }) => middle(twist))) {
    const graph = this.edges.map((edge) => edge.join("-")).join(" ");
    return fenchelNielsen({ graph, lengths: this.cuffs.map(({ length }) => middle(length)), twists });
  }
}
const middle = ([lower, upper]) => (lower + upper) / 2;

/** A Dirichlet domain, as read off a triangulation that is verified; its vertices are rounded. */
export class DirichletDomain {
  constructor(bytes) {
    this.bytes = bytes;
    const { sides, vertices, ties } = JSON.parse(this.text);
    Object.assign(this, { sides, vertices, ties });
  }
  /** The text of its file. */
  get text() {
    return decoder.decode(this.bytes);
  }
  /** Its picture, as SVG. */
  async svg(options = {}) {
    return decoder.decode((await ask({ do: "svg", dirichlet: 0, ...members(options, ["size"]) }, [this.bytes], options)).files[0]);
  }
}

/** A closed path, or what has one: a closed geodesic, a cuff. */
const wordOf = (curve) => curve?.word ?? curve;

/** A recipe whose files come after `count` others. */
function shifted(recipe, count) {
  if (recipe === null || typeof recipe !== "object" || Array.isArray(recipe)) return recipe;
  return Object.fromEntries(Object.entries(recipe).map(([name, value]) => [name, name === "file" ? value + count : shifted(value, count)]));
}

/** A closed hyperbolic surface: how it is made. Nothing is computed before it is asked for. */
export class Surface {
  constructor(recipe, files = []) {
    this.recipe = recipe;
    this.files = files;
  }
  #ask(what, options = {}, known = []) {
    return ask({ ...what, surface: this.recipe, ...members(options, known) }, this.files, options);
  }
  /** Facts: genus, tiles, area and more (`epsnet info --json`). */
  async info(options) {
    const { json, files, ...facts } = await this.#ask({ do: "surface" }, options);
    return facts;
  }
  /** The bytes of its surface file. */
  async file(options) {
    return (await this.#ask({ do: "surface" }, options)).files[0];
  }
  /** The picture of its tiles, as SVG. */
  async svg(options) {
    return decoder.decode((await this.#ask({ do: "svg" }, options, ["size"])).files[0]);
  }
  /** An ε-net; ε is exact: a string such as "0.1" or "1/10". Never resolves to a net that is not verified. */
  async net(epsilon, options) {
    return new Net(await this.#ask({ do: "net", epsilon }, options, ["pseudo", "sparse", "base"]));
  }
  /** A shortest closed geodesic. */
  async systole(options) {
    return new ProvedFile(await this.#ask({ do: "systole" }, options));
  }
  /** All primitive closed geodesics of length at most `upTo`. */
  async spectrum(upTo, options) {
    return new ProvedFile(await this.#ask({ do: "spectrum", up_to: upTo }, options));
  }
  /** The small curves, and the pieces into which they cut the surface. */
  async thickThin(options) {
    return new ProvedFile(await this.#ask({ do: "thick-thin" }, options));
  }
  /** An enclosure of the diameter. */
  async diameter(options) {
    return new ProvedFile(await this.#ask({ do: "diameter" }, options, ["width"]));
  }
  /** An enclosure of the radius. */
  async radius(options) {
    return new ProvedFile(await this.#ask({ do: "radius" }, options, ["width"]));
  }
  /** An enclosure of the radius of the largest embedded disk. */
  async embeddedDisk(options) {
    return new ProvedFile(await this.#ask({ do: "embedded-disk" }, options, ["width"]));
  }
  /** The distance of two points {tile, z: [x, y]}; numbers are exact in strings. */
  async distance(p, q, options) {
    return new ProvedFile(await this.#ask({ do: "distance", p, q }, options));
  }
  /** All isometries, also those that reverse the orientation. */
  async isometries(options) {
    return new IsometryGroup(await this.#ask({ do: "isometries" }, options));
  }
  /** Whether another surface is isometric: {isometric: "yes", "no" or "undecided", reason, words, isometry}. The module decides. */
  async isometricTo(other, options = {}) {
    members(options, []);
    const what = { do: "isometric", surface: this.recipe, other: shifted(other.recipe, this.files.length) };
    const { json, files, ...found } = await ask(what, [...this.files, ...other.files], options);
    return found;
  }
  /** Pairs of pants: along `curves`, which others complete; or its own, or with `find` those along short closed geodesics. */
  async pants({ curves, ...options } = {}) {
    return new PantsDecomposition(await this.#ask({ do: "pants", ...(curves && { curves: curves.map(wordOf) }) }, options, ["curves", "find"]));
  }
  /** How closed curves meet, their classes in homology, and whether they fill the surface. */
  async closedCurves(curves, options) {
    return new ProvedFile(await this.#ask({ do: "curves", curves: curves.map(wordOf) }, options));
  }
  /** The Dirichlet domain of a point. */
  async dirichletDomain(options) {
    return new DirichletDomain((await this.#ask({ do: "dirichlet" }, options, ["base"])).files[0]);
  }
  /** Words of generators of its group: one for each pair of sides of the fundamental polygon. */
  async generators(options) {
    return (await this.#ask({ do: "generators" }, options)).words;
  }
  /** By side: the path that a Dehn twist makes of the path across it. */
  async dehnTwistWords(curve, power = 1, options = {}) {
    return (await this.#ask({ do: "dehn-twist-words", curve: wordOf(curve), power }, options)).words;
  }
  /** A connected unbranched cover: of `permutations`, one for each of `generators`; or of a `degree`, random, with a `seed`. */
  cover(sheets) {
    const { permutations, degree, seed } = members(sheets, ["permutations", "degree", "seed"]);
    return new Surface({ cover: { surface: this.recipe, ...(permutations ? { permutations } : { degree, seed }) } }, this.files);
  }
  /** The surface with another marking: after a Dehn twist to the left along a simple closed curve; `power` says how often. */
  dehnTwist(curve, power = 1) {
    return new Surface({ dehn_twist: { surface: this.recipe, curve: wordOf(curve), power } }, this.files);
  }
  /** Cut along a simple closed geodesic and glued anew, the other side moved to the left by a length. */
  twist(curve, by) {
    return new Surface({ twist: { surface: this.recipe, curve: wordOf(curve), by } }, this.files);
  }
  /** The first eigenvalues of the Laplacian, also with phases. */
  async eigenvalues(options) {
    return new Eigenvalues(await this.#ask({ do: "eigenvalues" }, options, ["count", "below", "digits", "epsilon", "phases"]));
  }
}

/** The random octagon of a seed. */
export function octagon(seed) {
  return new Surface({ octagon: seed });
}
/** A surface by its name, such as "bolza"; of a family as "wiman-7", or "wiman", 7. */
export function named(name, genus) {
  return new Surface(genus === undefined ? { named: name } : { named: name, genus });
}
/** The regular surface of a genus. */
export function regular(genus) {
  return new Surface({ regular: genus });
}
/** The surface of Fenchel–Nielsen coordinates: {graph, genus, seed, lengths, twists}. */
export function fenchelNielsen(coordinates) {
  return new Surface({ fenchel_nielsen: coordinates });
}
/** The surface of a map: {rotation, edges}. */
export function map(darts) {
  return new Surface({ map: darts });
}
/** The surface of a file: of a surface file, of any file that `certify` checks, or of CGAL's. */
export function surfaceFromFile(data, name = "file") {
  return new Surface({ file: 0, name }, [bytesOf(data)]);
}
/** The coordinates that a request for Fenchel–Nielsen coordinates means: {genus, edges, lengths, twists}. */
export async function coordinates(request, options = {}) {
  members(options, []);
  const { json, files, ...found } = await ask({ do: "coordinates", fenchel_nielsen: request }, [], options);
  return found;
}
/** What both checkers say of a file: the object of `certify --json`, and `text`, that of `certify`. */
export async function certify(data, options = {}) {
  const { json, files, ...certificate } = await ask({ do: "certify", file: 0, ...members(options, ["name", "exact"]) }, [bytesOf(data)], options);
  return { ...certificate, text: decoder.decode(files[0]), json };
}
/** The picture of any file of epsnet, as SVG. */
export async function svg(data, { layers = [], ...options } = {}) {
  const what = { do: "svg", file: 0, layers: layers.map((_, k) => k + 1), ...members(options, PICTURE) };
  return decoder.decode((await ask(what, [bytesOf(data), ...layers.map(bytesOf)], options)).files[0]);
}
/** The version, and the names that `named` knows: {version, names: [{name, description}]}. */
export async function about(options = {}) {
  members(options, []);
  const { json, files, ...found } = await ask({ do: "about" }, [], options);
  return found;
}

export default {
  octagon, named, regular, fenchelNielsen, map, surfaceFromFile, coordinates, certify, svg, about, ask, close,
  Surface, Net, Eigenvalues, IsometryGroup, PantsDecomposition, DirichletDomain, ProvedFile, EpsnetError,
};
