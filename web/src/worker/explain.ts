/** What went wrong in a scene, with its place in the scene's text. */
import type { Position, Program } from "acorn";
import type { Trouble } from "./protocol";

/** Something wrong in a scene's own text. */
export class SceneError extends Error {
  constructor(readonly trouble: Trouble) {
    super(trouble.message);
  }
}

/** A place of a stack: of a text that was imported from memory, or of a file of the scenes. */
const PLACE = /(?:blob:[^\s)]*?|\/(scenes\/[\w/.-]+?\.js)(?:\?[^\s:)]*)?):(\d+):(\d+)/;

/** What went wrong while a scene was built or ran. */
export function troubleOf(error: unknown): Trouble {
  if (error instanceof SceneError) return error.trouble;
  if (!(error instanceof Error)) return { message: `The scene threw ${String(error)}` };
  const [, file, line, column] = PLACE.exec(error.stack ?? "") ?? [];
  const details = (error as { problems?: { text: string }[] }).problems?.map(({ text }) => text);
  return {
    message: details && details.length > 0 ? "The level cannot be used:" : error.message,
    file,
    line: line ? Number(line) : undefined,
    column: column ? Number(column) : undefined,
    details,
  };
}

/**
 * Why a text could not be imported. Browsers keep the place of a syntax error to themselves, and
 * which import failed; a parser tells. `file` is the address that the text's imports start from.
 */
export async function explainImport(error: unknown, code: string, file: URL): Promise<SceneError> {
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
    if (!/^\.{1,2}\//.test(path))
      return at(node.loc.start, `“${path}” is no file of this page: import "./…" from beside it.`);
    const address = new URL(path, file).href;
    if (!(await isThere(address))) return at(node.loc.start, `There is no file “${path}”.`);
    // An import that is there but lacks a name: the browser tells both.
    if (trouble.message.includes(address) || trouble.message.includes(`'${path}'`))
      return at(node.loc.start, trouble.message.replaceAll(address, path));
  }
  return new SceneError(trouble);
}

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
