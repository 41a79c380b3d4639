/**
 * For pages that want to be quick at their first visit: `load` without what explains refusals and looks
 * at the types of options, which "thud/explain" brings later: until then "1" is taken for 1. Everything else is that of "thud".
 */
import { besideModule, type Engine, instantiate, type WasmSource } from "./engine.js";
import { ThudError } from "./error.js";
import type { RestSource } from "./rest.js";

/** As the `load` of "thud", whose errors tell less until `explainErrors` is called. */
export async function load(
  source: WasmSource = besideModule(),
  rest?: RestSource,
): Promise<Engine> {
  if (typeof source !== "string" && !(source instanceof URL)) return instantiate(source, rest);
  let response: Response;
  try {
    response = await fetch(source);
  } catch (cause) {
    throw new ThudError("load", `${source} cannot be fetched`, { cause });
  }
  return instantiate(response, rest);
}
