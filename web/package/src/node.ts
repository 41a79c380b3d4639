/** "thud" in Node.js: the same exports, with a `load` that also reads files. */
import { once } from "node:events";
import { readFile } from "node:fs/promises";
import { explainErrors } from "./checks/explain.js";
import { defaultWasmUrl, type Engine, instantiate, type WasmSource } from "./engine.js";
import { messageOf, ThudError } from "./error.js";
import { load as loadFromWeb } from "./index.js";
import { areOptions, type LoadOptions, shareFromOf, threadsOf } from "./load-options.js";
import type { RestSource } from "./rest.js";
import { serveThread, type ThreadStart } from "./thread.js";

export * from "./index.js";

/**
 * Loads the engine; without a source, thud.wasm beside this file. A source may be a path or a file:
 * URL, too. Rejects with a ThudError "load".
 */
export async function load(source?: WasmSource, rest?: RestSource): Promise<Engine>;
/** The same with options, of which `threads` shares large steps among several threads. */
export async function load(options: LoadOptions): Promise<Engine>;
export async function load(
  given: WasmSource | LoadOptions = defaultWasmUrl(),
  rest?: RestSource,
): Promise<Engine> {
  explainErrors();
  if (!areOptions(given)) return instantiateOrFetch(given, rest);
  const threads = threadsOf(given);
  const shareFrom = shareFromOf(given);
  if (threads > 1) {
    const { loadThreads } = await import("./threads.js");
    // The address is made here, since a bundler may put threads.js into another folder.
    const { module = new URL("./thud-threads.wasm", import.meta.url) } = given.threadFiles ?? {};
    const files = { module: isFile(module) ? await read(module) : module };
    const engine = await loadThreads(threads, files, startThread, shareFrom);
    if (engine) return engine;
  }
  return instantiateOrFetch(given.source ?? defaultWasmUrl());
}

async function instantiateOrFetch(source: WasmSource, rest?: RestSource): Promise<Engine> {
  if (!isFile(source)) return loadFromWeb(source, rest);
  return instantiate(await read(source), isFile(rest) ? await read(rest) : rest);
}

/** Starts a thread, a ThreadStarter: a worker that does not keep the process alive. */
async function startThread(start: ThreadStart): Promise<void> {
  const { Worker } = await import("node:worker_threads");
  const code =
    `const { parentPort, workerData } = require("node:worker_threads");` +
    `(${serveThread})(workerData, () => parentPort.postMessage(null));`;
  // Options of the process, such as --input-type, are not for this code.
  const worker = new Worker(code, { eval: true, execArgv: [], workerData: start });
  await once(worker, "message"); // rejects where the worker has an error
  worker.unref();
}

/** The bytes of a file. Rejects with a ThudError "load". */
async function read(file: URL | string): Promise<Uint8Array<ArrayBuffer>> {
  try {
    return (await readFile(file)) as Uint8Array<ArrayBuffer>;
  } catch (cause) {
    const why = messageOf(cause);
    throw new ThudError("load", `the wasm module cannot be read: ${why}`, { cause });
  }
}

/** Whether a source is a file: URL, or a path rather than a URL, which begins with a scheme and "://". */
function isFile(source: unknown): source is URL | string {
  if (source instanceof URL) return source.protocol === "file:";
  return typeof source === "string" && !/^[a-z]+:\/\//i.test(source);
}
