/** "thud" in Node.js: the same exports, with a `load` that also reads files. */
import { readFile } from "node:fs/promises";
import { explainErrors } from "./checks/explain.js";
import { defaultWasmUrl, type Engine, instantiate, type WasmSource } from "./engine.js";
import { messageOf, ThudError } from "./error.js";
import { load as loadFromWeb } from "./index.js";
import type { RestSource } from "./rest.js";

export * from "./index.js";

/**
 * Loads the engine; without a source, thud.wasm beside this file. A source may be a path or a file:
 * URL, too. Rejects with a ThudError "load".
 */
export async function load(
  source: WasmSource = defaultWasmUrl(),
  rest?: RestSource,
): Promise<Engine> {
  const isFile = source instanceof URL ? source.protocol === "file:" : isPath(source);
  if (!isFile) return loadFromWeb(source, rest);
  const isRestFile =
    rest instanceof URL ? rest.protocol === "file:" : typeof rest === "string" && isPath(rest);
  explainErrors();
  const bytes = await read(source as URL | string);
  return instantiate(bytes, isRestFile ? await read(rest as URL | string) : rest);
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

/** Whether a string is a path rather than a URL, which begins with a scheme and "://". */
function isPath(source: unknown): boolean {
  return typeof source === "string" && !/^[a-z]+:\/\//i.test(source);
}
