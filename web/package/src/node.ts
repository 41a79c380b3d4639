/** The package as Node.js sees it: the same, but that `load` also reads files. */
import { readFile } from "node:fs/promises";
import { type Engine, instantiate, type WasmSource } from "./engine.js";
import { ThudError } from "./error.js";
import { load as loadFromWeb } from "./index.js";

export * from "./index.js";

/** Loads the engine; without a source, the thud.wasm that lies beside this file. */
export async function load(
  source: WasmSource = new URL("./thud.wasm", import.meta.url),
): Promise<Engine> {
  const isFile = source instanceof URL ? source.protocol === "file:" : isPath(source);
  if (!isFile) return loadFromWeb(source);
  let bytes: Uint8Array;
  try {
    bytes = await readFile(source as URL | string);
  } catch (cause) {
    const why = cause instanceof Error ? cause.message : String(cause);
    throw new ThudError("load", `the wasm module cannot be read: ${why}`, { cause });
  }
  return instantiate(bytes as Uint8Array<ArrayBuffer>);
}

function isPath(source: unknown): boolean {
  return typeof source === "string" && !/^[a-z]+:\/\//i.test(source);
}
