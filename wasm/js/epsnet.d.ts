/** ε-nets of closed hyperbolic surfaces, computed and proved. docs/wasm.md of epsnet describes this interface. */

/** A number that is exact: a string such as "0.1" or "1/10". A number of JavaScript is taken by its shortest decimal. */
export type Exact = string | number;
/** The ends of an enclosure, rounded outward; null stands for infinity. */
export type Interval = [number | null, number | null];
/** The bytes of a file. */
export type Bytes = Uint8Array | ArrayBuffer | string;
export type Verdict = "VERIFIED" | "REFUTED" | "UNDECIDED" | "MALFORMED";

/** What every request may be given. */
export interface JobOptions {
  /** Ends the computation, by ending the worker; the promise is rejected with the reason of the signal. */
  signal?: AbortSignal;
  /** Is told now and then what is being done, and the share that is done, from 0 to 1. */
  progress?: (what: string, share: number) => void;
}

/** The object of `certify --json` (docs/exchange-formats.md), and the text that `certify` prints. */
export interface Certificate {
  /** Null if there is none: see `error` and `no_claim`. */
  verdict: Verdict | null;
  file: string;
  sha256?: string;
  rule?: string;
  message?: string;
  error?: string;
  /** Why the file claims nothing, as one of a surface does. */
  no_claim?: string;
  second_checker?: { verdict: Verdict; rule: string; message: string } | null;
  verified_by?: string[];
  claim?: string;
  rules?: { rule: string; verdict: Verdict; text: string }[];
  counts?: Record<string, number>;
  geodesics?: Record<string, number>;
  enclosures?: Record<string, Interval>;
  text: string;
}

/** "SurfaceError", "NetError", "LimitError", "FormatError", "ArgumentError", "MemoryError" or "EpsnetError". */
export class EpsnetError extends Error {
  kind: string;
  constructor(kind: string, message: string);
}

/** A point: of a tile, with exact coordinates; the centre of a tile; a vertex of a net, or a point of one of its triangles. */
export type Point =
  | { tile: number; z?: [Exact, Exact] }
  | { vertex: number }
  | { triangle: number; weights: [Exact, Exact, Exact] };

export interface PictureOptions {
  /** Of an eigenvalues file: the number of the eigenvalue whose function is drawn. */
  eigenfunction?: number;
  /** Width and height in pixels. */
  size?: number;
  /** The vertex in the centre. */
  centre?: number;
  /** How the triangles of a net are filled. */
  colour?: "none" | "circumradius" | "chart" | "distance";
  legend?: boolean;
  /** What is drawn of a net; by default triangles and vertices. */
  show?: ("triangles" | "vertices" | "dirichlet" | "combinatorial-dirichlet" | "tiles" | "disks" | "half-disks")[];
}

/** A file that is verified, with its certificate. */
export class ProvedFile {
  readonly bytes: Uint8Array;
  readonly text: string;
  readonly certificate: Certificate;
  svg(options?: PictureOptions & { layers?: ProvedFile[] } & JobOptions): Promise<string>;
}
export interface Geodesics extends ProvedFile {
  readonly geodesics: { length: Interval; simple: boolean; word: number[] }[];
}
export interface Bound extends ProvedFile {
  readonly value: Interval;
  /** A point where the function is at least the lower end of `value`; for a radius, at most the upper end. */
  readonly p: { tile: number; z: [string, string] };
}
export interface Distance extends ProvedFile {
  readonly value: Interval;
  /** Whether all paths have exactly the same length. */
  readonly equal: boolean;
  readonly paths: number[][];
  readonly p: { tile: number; z: [string, string] };
  readonly q: { tile: number; z: [string, string] };
}
/** Eigenvalues of the Laplacian that are verified. */
export class Eigenvalues extends ProvedFile {
  /** λ_first and those after it, `count` in all, with multiplicity, are in each interval. */
  readonly eigenvalues: { first: number; count: number; in: Interval }[];
  /** All others are at least that. */
  readonly next: number;
  /** The picture of the eigenfunction of λ_index, from 1 on. */
  eigenfunctionSvg(index: number, options?: { size?: number; centre?: number } & JobOptions): Promise<string>;
}
/** The numbers of the sides that a path crosses, or what has them: a closed geodesic, a cuff. */
export type Curve = number[] | { word: number[] };
/** An isometry, by what it does with the group: by generator, the word of the element to which it goes. */
export interface Isometry {
  preserves_orientation: boolean;
  images: number[][];
}
/** All isometries of a surface, verified; number 0 is the identity. */
export class IsometryGroup extends ProvedFile {
  readonly order: number;
  readonly orientation_preserving: number;
  /** "C6", "D4", "C2 x C2"; empty for other groups. */
  readonly name: string;
  /** Generators of the group of the surface. */
  readonly words: number[][];
  /** Numbers of isometries that generate all. */
  readonly generators: number[];
  /** `fixed_points` only where they are points alone. */
  readonly isometries: (Isometry & { order: number; fixed_points?: number })[];
}
/** Closed curves up to free homotopy, verified: the given ones, and after them those of the homology basis. */
export interface ClosedCurves extends ProvedFile {
  /** `power`: the greatest k for which it is a k-th power; `homology`: coefficients of its class, by curve of `basis`. */
  readonly curves: { length: Interval; power: number; self_intersections: number; homology: number[]; word: number[] }[];
  /** Of two of `curves` by their numbers: the geometric and the algebraic intersection number. */
  readonly pairs: { first: number; second: number; intersections: number; algebraic: number }[];
  /** Numbers of curves: a₁, b₁, a₂, b₂, …, which are a symplectic basis of the homology. */
  readonly basis: number[];
  /** Whether the given ones fill the surface; only true is verified. */
  readonly fill: boolean;
}
/** Whether two surfaces are isometric, as the module decides. */
export interface IsometricAnswer {
  isometric: "yes" | "no" | "undecided";
  reason: string;
  words?: number[][];
  isometry?: Isometry;
}
/** Pairs of pants of which a surface is glued, with its Fenchel–Nielsen coordinates, verified. */
export class PantsDecomposition extends ProvedFile {
  /** Whether they are those of which `fenchelNielsen` made the surface. */
  readonly own: boolean;
  /** By cuff: the pairs of pants on its two sides. */
  readonly edges: [number, number][];
  readonly cuffs: { ends: [number, number][]; length: Interval; twist: Interval; word: number[]; across: number[] }[];
  /** By pair of pants: paths around its three cuffs. */
  readonly pants: [number[], number[], number[]][];
  /** The surface of these coordinates, or with other twists. */
  fenchelNielsen(twists?: Exact[]): Surface;
}
/** A Dirichlet domain: sides and pairings read off a verified triangulation, vertices rounded. */
export class DirichletDomain {
  readonly bytes: Uint8Array;
  readonly text: string;
  /** Counterclockwise; `distance` is that of the base point from the line of the side. */
  readonly sides: { partner: number; distance: number; word: number[] }[];
  /** In the disk with the base point at 0. */
  readonly vertices: [number, number][];
  /** How many sides of length 0 are left out. */
  readonly ties: number;
  svg(options?: { size?: number } & JobOptions): Promise<string>;
}
/** A triangle of a net that contains a point. */
export interface Location {
  place: "inside" | "side" | "corner";
  triangle: number;
  number: number;
  word: number[];
  weights: [number, number, number];
  distances: [number, number, number];
  nearest: number;
}

/** An ε-net that is verified. */
export class Net extends ProvedFile {
  /** Facts, as of `epsnet info --json`. */
  readonly info: Record<string, unknown>;
  readonly surface: Surface;
  page(options?: { title?: string; layers?: ProvedFile[] } & JobOptions): Promise<string>;
  /** What the viewer of wasm/page shows of it. */
  viewerData(options?: { title?: string; layers?: ProvedFile[] } & JobOptions): Promise<object>;
  distance(p: Point, q: Point, options?: JobOptions): Promise<Distance>;
  locate(point: Point, options?: JobOptions): Promise<Location>;
}

/** A closed hyperbolic surface: how it is made. Nothing is computed, and no error reported, before something is asked for. */
export class Surface {
  readonly recipe: object;
  info(options?: JobOptions): Promise<Record<string, unknown>>;
  file(options?: JobOptions): Promise<Uint8Array>;
  svg(options?: { size?: number } & JobOptions): Promise<string>;
  net(epsilon: Exact, options?: { pseudo?: boolean; sparse?: boolean; base?: Point } & JobOptions): Promise<Net>;
  systole(options?: JobOptions): Promise<Geodesics>;
  spectrum(upTo: Exact, options?: JobOptions): Promise<Geodesics>;
  thickThin(options?: JobOptions): Promise<Geodesics>;
  diameter(options?: { width?: number } & JobOptions): Promise<Bound>;
  radius(options?: { width?: number } & JobOptions): Promise<Bound>;
  embeddedDisk(options?: { width?: number } & JobOptions): Promise<Bound>;
  distance(p: Point, q: Point, options?: JobOptions): Promise<Distance>;
  isometries(options?: JobOptions): Promise<IsometryGroup>;
  isometricTo(other: Surface, options?: JobOptions): Promise<IsometricAnswer>;
  /** Along `curves`, which others complete; its own, if it was made of some; or, with `find`, along short closed geodesics. */
  pants(options?: { curves?: Curve[]; find?: boolean } & JobOptions): Promise<PantsDecomposition>;
  /** How closed curves meet, their classes in homology, and whether they fill the surface. */
  closedCurves(curves: Curve[], options?: JobOptions): Promise<ClosedCurves>;
  dirichletDomain(options?: { base?: Point } & JobOptions): Promise<DirichletDomain>;
  /** Words, one for each pair of sides of the fundamental polygon. */
  generators(options?: JobOptions): Promise<number[][]>;
  /** By side: what a Dehn twist makes of the path across it. */
  dehnTwistWords(curve: Curve, power?: number, options?: JobOptions): Promise<number[][]>;
  /** Permutations: one for each of `generators`, the images of the sheets 0, 1, …; or a random cover, of a degree up to 50. */
  cover(sheets: { permutations: number[][] } | { degree: number; seed: number }): Surface;
  /** The same surface with another marking, after a Dehn twist to the left. */
  dehnTwist(curve: Curve, power?: number): Surface;
  /** Cut along the closed geodesic of a simple curve, and glued with one side moved to the left. */
  twist(curve: Curve, by: Exact): Surface;
  /**
   * The first `count` (10), or all that are less than `below`; `digits` from 1 to 10, up to 2 without eigenfunctions.
   * With `phases`, a number of turns for each generator in the order of the sides (docs/eigenvalues.md), those of functions on the plane with
   * f(γz) = χ(γ) f(z), from λ₀ on; `digits` up to 3.
   */
  eigenvalues(options?: { count?: number; below?: number; digits?: number; epsilon?: Exact; phases?: Exact[] } & JobOptions): Promise<Eigenvalues>;
}

export interface FenchelNielsen {
  /** "chain", "ring", "tree", "theta" (genus 2), "random", or the edges, as "0-1 0-1 0-1". */
  graph?: string;
  genus?: number;
  seed?: number;
  lengths?: Exact[];
  twists?: Exact[];
}

export function octagon(seed: number): Surface;
/** "bolza"; of a family "wiman-7", or "wiman" and 7. */
export function named(name: string, genus?: number): Surface;
export function regular(genus: number): Surface;
export function fenchelNielsen(coordinates: FenchelNielsen): Surface;
export function map(darts: { rotation: number[]; edges: number[] }): Surface;
export function surfaceFromFile(data: Bytes, name?: string): Surface;
export function coordinates(
  request: FenchelNielsen,
  options?: JobOptions,
): Promise<{ genus: number; edges: [number, number][]; lengths: string[]; twists: string[] }>;
/** What both checkers say; `json` is the line of `certify --json`. Never rejected for what is in the file. */
export function certify(
  data: Bytes,
  options?: { name?: string; exact?: boolean } & JobOptions,
): Promise<Certificate & { json: string }>;
export function svg(data: Bytes, options?: PictureOptions & { layers?: Bytes[] } & JobOptions): Promise<string>;
export function about(options?: JobOptions): Promise<{ version: string; names: { name: string; description: string }[] }>;
/** Any request of docs/wasm.md. */
export function ask(what: object, files?: Uint8Array[], options?: JobOptions): Promise<Record<string, unknown>>;
/** Ends the worker, and with it what it computes. */
export function close(): void;

declare const epsnet: {
  octagon: typeof octagon;
  named: typeof named;
  regular: typeof regular;
  fenchelNielsen: typeof fenchelNielsen;
  map: typeof map;
  surfaceFromFile: typeof surfaceFromFile;
  coordinates: typeof coordinates;
  certify: typeof certify;
  svg: typeof svg;
  about: typeof about;
  ask: typeof ask;
  close: typeof close;
  Surface: typeof Surface;
  Net: typeof Net;
  Eigenvalues: typeof Eigenvalues;
  IsometryGroup: typeof IsometryGroup;
  PantsDecomposition: typeof PantsDecomposition;
  DirichletDomain: typeof DirichletDomain;
  ProvedFile: typeof ProvedFile;
  EpsnetError: typeof EpsnetError;
};
export default epsnet;
