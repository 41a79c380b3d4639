/** Scene modules: a file of web/public/scenes, or the text that a visitor made of it. */
import type { SceneModule } from "../scene/scene";
import { SceneError } from "./trouble";

/** `base` is the page's address; `code` takes the place of the file's text. */
export async function importScene(
  base: string,
  name: string,
  code: string | undefined,
): Promise<SceneModule> {
  const file = new URL(`scenes/${name}.js`, base);
  const module = (
    code === undefined
      ? await import(/* @vite-ignore */ file.href)
      : await (await import("./code")).importCode(base, file, code)
  ) as Partial<SceneModule>;
  if (typeof module.default !== "function")
    throw new SceneError({
      message: "A scene exports a function: export default function ({ createWorld }) { … }",
      line: 1,
    });
  return module as SceneModule;
}
