/** The options of `load`. */
import { shown } from "./checks/hook.js";
import { checkOptions } from "./checks/names.js";
import type { WasmSource } from "./engine.js";
import { ThudError } from "./error.js";
import type { ThreadFiles } from "./threads.js";

/** Options of `load`. */
export interface LoadOptions {
  /**
   * Threads that share the large steps of a world, the calling one included: 1 to 64, default 1.
   * Results are the same with any number. They are shared where a page is cross-origin isolated
   * (its server sends `Cross-Origin-Opener-Policy: same-origin` and `Cross-Origin-Embedder-Policy:
   * require-corp`), and in Node.js; elsewhere the engine is loaded without threads, which is no
   * error: `Engine.threads` tells. Threads are workers; each waits without work between steps. The
   * calling thread never sleeps in a step, so that the main thread of a page may make steps, too.
   */
  threads?: number;
  /** The engine without threads: as the first argument of `load`. */
  source?: WasmSource;
  /** Where the files that threads need are, for bundlers that do not copy them. */
  threadFiles?: ThreadFiles;
}

const NAMES: readonly (keyof LoadOptions)[] = ["threads", "source", "threadFiles"];
/** THUD_WORKERS_MAX. */
const THREADS_MAX = 64;

/** Whether the first argument of `load` is options: no source is a plain object. */
export function areOptions(given: WasmSource | LoadOptions): given is LoadOptions {
  return typeof given === "object" && Object.getPrototypeOf(given ?? new URL("a:")) === Object.prototype;
}

/** The number of threads. Throws a ThudError "invalid" for an unknown option and a wrong number. */
export function threadsOf(options: LoadOptions): number {
  checkOptions("load", options, NAMES);
  const { threads = 1 } = options;
  if (!Number.isInteger(threads) || threads < 1 || threads > THREADS_MAX)
    throw new ThudError("invalid", `load: threads must be a whole number from 1 to ${THREADS_MAX}: ${shown(threads)}`);
  return threads;
}
