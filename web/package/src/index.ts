/**
 * thud: rigid bodies in two dimensions.
 *
 *     import { load } from "thud";
 *     const thud = await load();
 *     const world = thud.createWorld();
 */
import { type Engine, instantiate, type WasmSource } from "./engine.js";
import { ThudError } from "./error.js";

export { Engine, type WasmSource } from "./engine.js";
export { type ErrorCode, ThudError } from "./error.js";
export { Mover, type MoverState } from "./mover.js";
export * from "./query-types.js";
export * from "./types.js";
export * from "./view-types.js";
export { World } from "./world.js";

/** Loads the engine; without a source, the thud.wasm that lies beside this file. */
export async function load(
  source: WasmSource = new URL("./thud.wasm", import.meta.url),
): Promise<Engine> {
  if (typeof source !== "string" && !(source instanceof URL)) return instantiate(source);
  let response: Response;
  try {
    response = await fetch(source);
  } catch (cause) {
    throw new ThudError("load", `${source} cannot be fetched`, { cause });
  }
  return instantiate(response);
}
