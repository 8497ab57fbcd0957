// The worker: it has the module, and answers one request after the other. Both in browsers and in Node.
import createModule from "./module.mjs";

const node = typeof process === "object" && Boolean(process.versions?.node);
const port = node ? (await import("node:worker_threads")).parentPort : self;

let progressOf; // The number of the request that is being answered.
let reported = 0;

// A browser does not keep messages for a worker that waits before it listens: so the first request waits for the module.
let module;
const ready = createModule({
  print: (text) => console.log(text),
  printErr: (text) => {
    // Not worth a word: the second part of the module, module.deferred.wasm, is loaded when it is needed first.
    if (!/^(placeholder function called|instantiated deferred module)/.test(text)) console.error(text);
  },
}).then((made) => {
  module = made;
  module.progress = (what, share) => {
    const now = Date.now();
    if (now - reported < 50) return;
    reported = now;
    port.postMessage({ id: progressOf, progress: { what, share } });
  };
});
ready.catch(() => {}); // Whoever asks is told.

/** Returns the bytes of a part of the answer, which outlive the module's memory. */
function output(number) {
  const start = module._epsnet_output(number) >>> 0;
  return module.HEAPU8.slice(start, start + (module._epsnet_output_size(number) >>> 0));
}

/** Gives the module a part of the request. */
function input(bytes) {
  const start = module._epsnet_new_input(bytes.length) >>> 0;
  if (start === 0 && bytes.length > 0) throw { kind: "MemoryError", message: "not enough memory for the files of the request" };
  module.HEAPU8.set(bytes, start);
}

function answer({ id, what, files }) {
  progressOf = id;
  reported = Date.now();
  input(new TextEncoder().encode(JSON.stringify(what)));
  for (const file of files) input(file);
  const parts = module._epsnet_ask();
  if (parts === 0) throw { kind: "MemoryError", message: "not enough memory" };
  const json = new TextDecoder().decode(output(0));
  const { error } = JSON.parse(json);
  if (error) throw error;
  const outputs = [];
  for (let number = 1; number < parts; number++) outputs.push(output(number));
  module._epsnet_forget();
  return { id, json, files: outputs };
}

async function handle(request) {
  try {
    await ready;
    const message = answer(request);
    port.postMessage(message, message.files.map((file) => file.buffer));
  } catch (error) {
    // What the module did not expect leaves it in an unknown state: the worker is to be ended.
    const kind = error.kind ?? "EpsnetError";
    const message = error.kind ? error.message : `the module failed: ${error?.message ?? error}; please report this`;
    port.postMessage({ id: request.id, error: { kind, message }, broken: !error.kind || kind === "MemoryError" });
  }
}

if (node) port.on("message", handle);
else port.onmessage = ({ data }) => handle(data);
