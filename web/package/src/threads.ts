/**
 * "thud/threads": the engine with threads, thud-threads.wasm. `load` of "thud" loads this file where
 * its option `threads` asks for it; programs that use "thud/first" may import it themselves.
 */
import { Engine } from "./engine.js";
import { messageOf, ThudError } from "./error.js";
import type { ThreadStart } from "./thread.js";

/** Where the two files are that threads need; by default both are beside this file. */
export interface ThreadFiles {
  /** thud-threads.wasm: its URL, its bytes or the compiled module. */
  module?: URL | string | BufferSource | WebAssembly.Module;
  /** The URL of thread.js, the script of the threads. Browsers alone need it. */
  script?: URL | string;
}

/** Starts a thread, and resolves when it has begun. */
export type ThreadStarter = (start: ThreadStart, script?: URL | string) => Promise<void>;

/** Pages of 64 KiB: those that thud-threads.wasm begins with, and its maximum, 2 GiB. */
const PAGES = { initial: 256, maximum: 32768 };
/** Bytes of a thread's stack, a multiple of 16. A step needs less than 16 KiB. Chosen. */
const STACK_BYTES = 1 << 18;

/** An engine on a shared memory. */
class ThreadedEngine extends Engine {
  /** Starts the threads but the calling one. `shareFrom` as in LoadOptions; 0: the default. */
  async start(module: WebAssembly.Module, memory: WebAssembly.Memory, threads: number, shareFrom: number, begin: (start: ThreadStart) => Promise<void>): Promise<void> {
    const { malloc, api_threads_set } = this.exports;
    const starts = Array.from({ length: threads - 1 }, () => {
      const stack = malloc(STACK_BYTES);
      if (stack === 0) throw new ThudError("memory", "out of memory");
      // malloc aligns to 8 bytes; the stack of a function is aligned to 16.
      return { module, memory, stack: (stack + STACK_BYTES) & ~15 };
    });
    try {
      await Promise.all(starts.map(begin));
    } catch (cause) {
      this.endThreads();
      throw new ThudError("load", `a thread cannot be started: ${messageOf(cause)}`, { cause });
    }
    api_threads_set(threads, shareFrom);
    this.threads = threads;
  }

  override endThreads(): void {
    this.exports.api_threads_end();
    this.exports.api_threads_set(1, 0);
    this.threads = 1;
  }
}

/**
 * Loads thud-threads.wasm and starts `threads` - 1 threads. Resolves to null where threads cannot
 * share memory: in a page that is not cross-origin isolated, or where so much of the address space
 * is not free. `shareFrom` as in LoadOptions; 0: the default. Rejects with a ThudError "load" where a
 * file is missing or wrong, and "memory".
 */
export async function loadThreads(
  threads: number,
  { module = new URL("./thud-threads.wasm", import.meta.url), script }: ThreadFiles = {},
  start: ThreadStarter = startWorker,
  shareFrom = 0,
): Promise<Engine | null> {
  const memory = sharedMemory();
  if (!memory) return null;
  let compiled: WebAssembly.Module;
  let engine: ThreadedEngine;
  try {
    compiled = module instanceof WebAssembly.Module ? module : await WebAssembly.compile(await bytesOf(module));
    engine = (await ThreadedEngine.instantiate(compiled, undefined, memory)) as ThreadedEngine;
  } catch (cause) {
    if (cause instanceof ThudError) throw cause;
    throw new ThudError("load", `thud-threads.wasm cannot be loaded: ${messageOf(cause)}`, { cause });
  }
  await engine.start(compiled, memory, threads, shareFrom, (one) => start(one, script));
  return engine;
}

/** A memory for several threads; null where there is none. */
function sharedMemory(): WebAssembly.Memory | null {
  // Browsers that hide SharedArrayBuffer, and those that refuse to send it to a worker.
  if (typeof SharedArrayBuffer !== "function" || globalThis.crossOriginIsolated === false) return null;
  try {
    return new WebAssembly.Memory({ ...PAGES, shared: true });
  } catch {
    return null;
  }
}

async function bytesOf(source: URL | string | BufferSource): Promise<BufferSource> {
  if (typeof source !== "string" && !(source instanceof URL)) return source;
  const response = await fetch(source);
  if (!response.ok) throw new Error(`${response.url}: ${response.status} ${response.statusText}`);
  return response.arrayBuffer();
}

/** The ThreadStarter of browsers. */
function startWorker(start: ThreadStart, script?: URL | string): Promise<void> {
  // Bundlers recognise `new Worker(new URL("…", import.meta.url), …)`, written like this. webpack
  // calls the file by this name.
  const worker = script
    ? new Worker(script, { type: "module", name: "thud-thread" })
    : new Worker(new URL("./thread.js", import.meta.url), { type: "module", name: "thud-thread" });
  return new Promise((done, fail) => {
    worker.onmessage = () => done();
    worker.onerror = ({ message }) => fail(new Error(message || "its script, thread.js, is missing"));
    worker.postMessage(start);
  });
}
