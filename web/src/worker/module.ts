/** Scene modules: a file of web/public/scenes, or the text that a visitor made of it. */
import type { SceneModule } from "../scene/scene";
import type { Trouble } from "./protocol";

/** Something wrong in a scene's own text. */
export class SceneError extends Error {
  constructor(readonly trouble: Trouble) {
    super(trouble.message);
  }
}

/** `base` is the page's address; `code` takes the place of the file's text. */
export async function importScene(
  base: string,
  name: string,
  code: string | undefined,
): Promise<SceneModule> {
  const file = new URL(`scenes/${name}.js`, base);
  let module: Partial<SceneModule>;
  if (code === undefined) {
    module = (await import(/* @vite-ignore */ file.href)) as Partial<SceneModule>;
  } else {
    const text = withWholeAddresses(code, file);
    const url = URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
    try {
      module = (await import(/* @vite-ignore */ url)) as Partial<SceneModule>;
    } catch (error) {
      throw await explain(error, code);
    } finally {
      URL.revokeObjectURL(url);
    }
  }
  if (typeof module.default !== "function")
    throw new SceneError({
      message: "A scene exports a function: export default function ({ createWorld }) { … }",
      line: 1,
    });
  return module as SceneModule;
}

/** A text that is imported from memory finds its neighbours only by their whole address. */
function withWholeAddresses(code: string, file: URL): string {
  return code.replace(
    /(\bfrom\s*|\bimport\s*\(?\s*)(["'])(\.{1,2}\/[^"'\n]+)\2/g,
    (_, before: string, quote: string, path: string) =>
      `${before}${quote}${new URL(path, file).href}${quote}`,
  );
}

/** An error of the visitor's text with its line: from the parser, or from the stack. */
async function explain(error: unknown, code: string): Promise<Error> {
  if (!(error instanceof SyntaxError)) return new SceneError(troubleOf(error));
  // Browsers keep the place of a syntax error to themselves; a parser tells it.
  const { parse } = await import("acorn");
  try {
    parse(code, { ecmaVersion: "latest", sourceType: "module" });
  } catch (found) {
    const { loc, message } = found as { loc?: { line: number; column: number }; message: string };
    if (loc)
      return new SceneError({
        message: message.replace(/ \(\d+:\d+\)$/, ""),
        line: loc.line,
        column: loc.column + 1,
      });
  }
  return new SceneError({ message: error.message });
}

/** What went wrong while a scene ran, with its place in the scene's text if the stack names one. */
export function troubleOf(error: unknown): Trouble {
  if (error instanceof SceneError) return error.trouble;
  if (!(error instanceof Error)) return { message: String(error) };
  const place = /(?:blob:[^\s)]*?|\/scenes\/[\w/.-]+?\.js(?:\?[^\s:)]*)?):(\d+):(\d+)/.exec(
    error.stack ?? "",
  );
  const details = (error as { problems?: { text: string }[] }).problems?.map(({ text }) => text);
  return {
    message: details && details.length > 0 ? "The level cannot be used:" : error.message,
    line: place ? Number(place[1]) : undefined,
    column: place ? Number(place[2]) : undefined,
    details,
  };
}
