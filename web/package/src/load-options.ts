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
  /**
   * The threads share steps with so many blocks of contacts (`Stats.blocks`; those with two points, as
   * of boxes, count twice) or more, or with four times as many awake bodies. With fewer, the data of
   * bodies that move between processors cost more time than a second thread saves. A whole number from
   * 1 (all that have a contact or four bodies) to 4294967295 (none); default 2048, as measured with two
   * threads.
   */
  shareFrom?: number;
  /** The engine without threads: as the first argument of `load`. */
  source?: WasmSource;
  /** Where the files that threads need are, for bundlers that do not copy them. */
  threadFiles?: ThreadFiles;
}

const NAMES: readonly (keyof LoadOptions)[] = ["threads", "shareFrom", "source", "threadFiles"];
/** THUD_WORKERS_MAX. */
const THREADS_MAX = 64;
/** The maximum of thud_job_system.share_from. */
const SHARE_FROM_MAX = 2 ** 32 - 1;

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

/** The option `shareFrom`; 0: the default. Throws a ThudError "invalid" for a wrong number. */
export function shareFromOf({ shareFrom }: LoadOptions): number {
  if (shareFrom === undefined) return 0;
  if (!Number.isInteger(shareFrom) || shareFrom < 1 || shareFrom > SHARE_FROM_MAX)
    throw new ThudError("invalid", `load: shareFrom must be a whole number from 1 to ${SHARE_FROM_MAX}: ${shown(shareFrom)}`);
  return shareFrom;
}
