/**
 * "thud/first": `load` without the code that explains errors and checks the types of options, for a
 * fast first load of a page. "thud/explain" adds that code later; until then the option "1" counts
 * as 1. Everything else is the same as in "thud".
 */
import { defaultWasmUrl, type Engine, instantiate, type WasmSource } from "./engine.js";
import { ThudError } from "./error.js";
import type { RestSource } from "./rest.js";

/** As `load` of "thud", with shorter error messages until `explainErrors` is called. */
export async function load(
  source: WasmSource = defaultWasmUrl(),
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
