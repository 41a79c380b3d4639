/**
 * Imports scene modules: a file of web/public/scenes, a game of examples/games, or a visitor's edited
 * text of either.
 */
import type { SceneModule } from "../scene/scene";
import { SceneError } from "./trouble";

/**
 * Imports the module of a scene. `base` is the page's address; `code` replaces the file's text.
 * Throws a SceneError if the module exports no function.
 */
export async function importScene(
  base: string,
  name: string,
  code: string | undefined,
): Promise<SceneModule> {
  const file = new URL(`scenes/${name}.js`, base);
  const isGame = name.startsWith("game_");
  const module = (
    code === undefined && !isGame
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
