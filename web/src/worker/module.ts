/** Scene modules: a file of web/public/scenes, or the text that a visitor made of it. */
import type { SceneModule } from "../scene/scene";
import { explainImport, SceneError } from "./explain";
import { raiseFence } from "./fence";

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
    raiseFence(base);
    const text = withWholeAddresses(code, file);
    const url = URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
    try {
      module = (await import(/* @vite-ignore */ url)) as Partial<SceneModule>;
    } catch (error) {
      throw await explainImport(error, code, file);
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
