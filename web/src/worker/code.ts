/**
 * Imports the text of a scene: what the visitor has edited, in place of the scene's file, or a game,
 * which imports the package by its name as in a project. This module is loaded only when there is
 * such a text, because most visits run scenes unchanged.
 */
import type { Position, Program } from "acorn";
import { raiseFence } from "./fence";
import { SceneError, troubleOf } from "./trouble";

/**
 * Imports `own`, the visitor's text, or else the text of `file`, as a module. `base` is the page's
 * address; the relative imports of the text are resolved against `file`. Throws a SceneError that says
 * why and where, if the import fails.
 */
export async function importCode(base: string, file: URL, own: string | undefined): Promise<unknown> {
  if (own !== undefined) raiseFence(base);
  const code = own ?? (await textOf(file));
  const text = withWholeAddresses(await withPackage(code), file);
  const url = URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
  try {
    return await import(/* @vite-ignore */ url);
  } catch (error) {
    throw await explain(error, code, file);
  } finally {
    URL.revokeObjectURL(url);
  }
}

async function textOf(file: URL): Promise<string> {
  const response = await fetch(file);
  if (!response.ok) throw new Error(`${file.pathname} cannot be loaded: ${response.status}`);
  return response.text();
}

/** An import of names, or of all, from the package. */
const OF_PACKAGE = /^([ \t]*)import\s+(\{[^}]*\}|\*\s+as\s+\w+)\s+from\s*(["'])thud\3/gm;
/** Where the text finds what the package exports. */
const PLACE = "thudPackage";

/**
 * Replaces imports from "thud" by constants, on as many lines: a module that is imported from a blob URL
 * cannot resolve the name, and Firefox lets it import no other blob URL. Throws a SceneError for a name
 * that the package does not export.
 */
async function withPackage(code: string): Promise<string> {
  if (code.search(OF_PACKAGE) < 0) return code;
  const exported: object = await import("thud");
  if (!(PLACE in globalThis)) Object.defineProperty(globalThis, PLACE, { value: exported });
  return code.replace(OF_PACKAGE, (_, indent: string, names: string, _quote: string, at: number) => {
    if (names.startsWith("*")) return `${indent}const ${names.replace(/^\*\s+as\s+/, "")} = ${PLACE}`;
    for (const one of names.slice(1, -1).split(",")) {
      const [name] = one.trim().split(/\s/);
      if (name && !(name in exported)) {
        const line = code.slice(0, at + indent.length).split("\n").length;
        throw new SceneError({ message: `“thud” exports no “${name}”.`, line });
      }
    }
    return `${indent}const ${names.replace(/\bas\b/g, ":")} = ${PLACE}`;
  });
}

/**
 * Replaces relative paths in import statements by absolute URLs: a module that is imported from a
 * blob URL cannot resolve relative paths.
 */
function withWholeAddresses(code: string, file: URL): string {
  return code.replace(
    /(\bfrom\s*|\bimport\s*\(?\s*)(["'])(\.{1,2}\/[^"'\n]+)\2/g,
    (_, before: string, quote: string, path: string) =>
      `${before}${quote}${new URL(path, file).href}${quote}`,
  );
}

/**
 * Finds out why a text could not be imported, and where. Browsers do not tell the place of a syntax
 * error, nor which import failed; so the text is parsed here, and each imported file is fetched.
 */
async function explain(error: unknown, code: string, file: URL): Promise<SceneError> {
  const trouble = troubleOf(error);
  if (trouble.line) return new SceneError(trouble);
  const { parse } = await import("acorn");
  let program: Program;
  try {
    program = parse(code, { ecmaVersion: "latest", sourceType: "module", locations: true });
  } catch (found) {
    const { loc, message } = found as SyntaxError & { loc: Position };
    return at(loc, message.replace(/ \(\d+:\d+\)$/, ""));
  }
  for (const node of program.body) {
    if (!("source" in node) || !node.source || !node.loc) continue;
    const path = String(node.source.value);
    if (path === "thud") continue;
    if (!/^\.{1,2}\//.test(path))
      return at(node.loc.start, `“${path}” is no file of this page: import "./…" from beside it, or "thud".`);
    const address = new URL(path, file).href;
    if (!(await isThere(address))) return at(node.loc.start, `There is no file “${path}”.`);
    // The file exists, but does not export a name that the text imports: the browser's message says
    // which.
    if (trouble.message.includes(address) || trouble.message.includes(`'${path}'`))
      return at(node.loc.start, trouble.message.replaceAll(address, path));
  }
  return new SceneError(trouble);
}

/** An error at a place of the visitor's text. Acorn counts columns from 0, the page from 1. */
function at({ line, column }: Position, message: string): SceneError {
  return new SceneError({ message, line, column: column + 1 });
}

async function isThere(address: string): Promise<boolean> {
  try {
    return (await fetch(address)).ok;
  } catch {
    return false;
  }
}
