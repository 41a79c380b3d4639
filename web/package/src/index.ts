/**
 * "thud": rigid bodies in two dimensions, as WebAssembly. This file lists what the package exports.
 *
 *     import { load } from "thud";
 *     const thud = await load();
 *     const world = thud.createWorld();
 */
import { explainErrors } from "./checks/explain.js";
import { defaultWasmUrl, type Engine, type WasmSource } from "./engine.js";
import { load as loadFirst } from "./first.js";
import { areOptions, type LoadOptions, shareFromOf, threadsOf } from "./load-options.js";
import type { RestSource } from "./rest.js";

export { Engine, type WasmSource } from "./engine.js";
export { type LoadOptions } from "./load-options.js";
export { type RestSource } from "./rest.js";
export { type ThreadFiles } from "./threads.js";
export { type ErrorCode, ThudError } from "./error.js";
export * from "./fields/field-types.js";
export * from "./joint-types.js";
export { type MinkowskiSum, minkowskiSum } from "./minkowski.js";
export { Mover, type MoverState } from "./mover.js";
export { readHello, type Welcome, WelcomeReader, writeHello } from "./net/messages.js";
export { RollbackPeers, type RollbackPeersOptions } from "./net/peers.js";
export { Rollback, type RollbackDifference, type RollbackOptions } from "./net/rollback.js";
export * from "./query-types.js";
export * from "./rules/rule-types.js";
export * from "./types.js";
export * from "./view-types.js";
export { handleOf, numberAt, numberOf } from "./plain/handles.js";
export * from "./plain/shapes.js";
export { World } from "./world.js";

/**
 * Loads the engine; without a source, thud.wasm beside this file. For a fast first load of a page
 * there is the same engine in two files: give thud-first.wasm as the source, thud-rest.wasm as the
 * rest, and call `complete` after the first frame is drawn. Rejects with a ThudError "load".
 */
export async function load(source?: WasmSource, rest?: RestSource): Promise<Engine>;
/** The same with options, of which `threads` shares large steps among several threads. */
export async function load(options: LoadOptions): Promise<Engine>;
export async function load(
  given: WasmSource | LoadOptions = defaultWasmUrl(),
  rest?: RestSource,
): Promise<Engine> {
  explainErrors();
  if (!areOptions(given)) return loadFirst(given, rest);
  const threads = threadsOf(given);
  const shareFrom = shareFromOf(given);
  if (threads > 1) {
    const { loadThreads } = await import("./threads.js");
    const engine = await loadThreads(threads, given.threadFiles, undefined, shareFrom);
    if (engine) return engine;
  }
  return loadFirst(given.source);
}
