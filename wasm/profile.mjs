// profile.mjs MODULE PROFILE: does with the module what a visitor does first, and writes which functions that called, for wasm-split.
// MODULE is linked with -sSPLIT_MODULE. What is forgotten here is loaded later, and works as well. wasm/split calls this.
import fs from "node:fs";
import path from "node:path";

const [file, profile] = process.argv.slice(2);
const { default: createModule } = await import(path.resolve(file));
const module = await createModule();
module.progress = () => {};

function input(bytes) {
  module.HEAPU8.set(bytes, module._epsnet_new_input(bytes.length) >>> 0);
}

/** The files of the answer to a request (docs/wasm.md). */
function ask(what, files = []) {
  input(new TextEncoder().encode(JSON.stringify(what)));
  files.forEach(input);
  const parts = Array.from({ length: module._epsnet_ask() }, (_, number) => {
    const start = module._epsnet_output(number) >>> 0;
    return module.HEAPU8.slice(start, start + (module._epsnet_output_size(number) >>> 0));
  });
  module._epsnet_forget();
  const { error } = JSON.parse(new TextDecoder().decode(parts[0]));
  if (error) throw new Error(`${JSON.stringify(what)}: ${error.message}`);
  return parts.slice(1);
}

const surfaces = [
  { octagon: 123 },
  { octagon: 5 },
  { named: "bolza" },
  { named: "klein" },
  { fenchel_nielsen: { genus: 2, seed: 7 } },
  { fenchel_nielsen: { graph: "0-1 0-1 0-1", lengths: ["2", "2", "3"], twists: ["0", "0.5", "1/3"] } },
];
ask({ do: "about" });
for (const surface of surfaces) {
  ask({ do: "surface", surface });
  if (surface.fenchel_nielsen) ask({ do: "coordinates", ...surface });
  for (const [epsilon, kind] of [["0.3", "net"], ["1/10", "net"], ["0.2", "sparse"], ["0.3", "pseudo"]]) {
    const [bytes] = ask({ do: "net", surface, epsilon, sparse: kind === "sparse", pseudo: kind === "pseudo" });
    ask({ do: "certify", file: 0, exact: true, name: "net.json" }, [bytes]);
    ask({ do: "viewer", net: 0, layers: [], title: `a net, ε = ${epsilon}, ${kind}` }, [bytes]);
  }
}

// The length of the profile first, with nothing written; then the profile, to memory that a request's input would take.
const write = module.wasmExports.__write_profile;
const length = write(0, 0);
const start = module._epsnet_new_input(length) >>> 0;
write(start, length);
fs.writeFileSync(profile, module.HEAPU8.slice(start, start + length));
