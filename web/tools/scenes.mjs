/** Builds and runs the page's scenes in Node.js, for tests, thumbnails and hashes. */
import { copyFile, mkdir, readFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { runnerImport } from "vite";
import { GAME_FILES, sceneTexts } from "./scene-texts.mjs";

const web = new URL("../", import.meta.url);

/** Imports a TypeScript source of the page, by its path from web/. */
export async function importTypeScript(path) {
  const settings = { configFile: false, plugins: [sceneTexts()] };
  const { module } = await runnerImport(fileURLToPath(new URL(path, web)), settings);
  return module;
}

export const { FIRST_SCENE, SCENES, sceneFile, thumbnailFile } =
  await importTypeScript("src/scene/registry.ts");
export const { ABOUTS } = await importTypeScript("src/scene/abouts.ts");
export const { THUMBNAILS } = await importTypeScript("src/scene/thumbnails.ts");
const { noKeys } = await importTypeScript("src/scene/scene.ts");
export const { cssColour, rampColour } = await importTypeScript("src/draw/palette.ts");
export const { random } = await importTypeScript("src/scene/random.ts");
export const { createSetting } = await importTypeScript("src/scene/setting.ts");
const { USUAL } = await importTypeScript("src/page/url.ts");
const { optionsOf, setUp } = await importTypeScript("src/worker/stage.ts");

/** The options of a world on the page as long as the visitor has chosen none. */
export const USUAL_OPTIONS = optionsOf(USUAL);

const NO_KEYS = noKeys();

/** The text of a file in assets/, such as "levels/quarry.tmj", which the page fetches. */
export function readText(file) {
  return readFile(new URL(`../assets/${file}`, web), "utf8");
}

/**
 * Imports for the scene's setting. They are made here, since the sources of the page were imported
 * by Vite's runner, which is closed by the time they are called.
 */
const loaders = {
  loadReader: () => import("../package/dist/level.js"),
  loadGeometry: () => import("../package/dist/geometry/index.js"),
  loadRollback: async () => (await import("../package/dist/node.js")).Rollback,
};

const loadMover = async () => (await import("../package/dist/node.js")).Mover;

/** The path of a scene's module. */
export function sourceOf(name) {
  return GAME_FILES.get(name) ?? fileURLToPath(new URL(`public/${sceneFile(name)}`, web));
}

/**
 * Imports a scene's module. A game imports "thud", which is found from a copy of it here, as from a
 * folder in which the package is installed.
 */
export async function importScene(name) {
  if (!GAME_FILES.has(name)) return import(sourceOf(name));
  const folder = new URL("generated/games/", web);
  await mkdir(folder, { recursive: true });
  const copy = new URL(`${name}.mjs`, folder);
  await copyFile(sourceOf(name), copy);
  return import(copy.href);
}

/**
 * Builds a scene of the registry. Returns { module, setting, scene, close }; `close` frees the
 * scene and all its worlds. `options`: those of createSetting.
 */
export async function buildScene(thud, name, options = {}) {
  const module = await importScene(name);
  const mover = await loadMover();
  const setting = createSetting(module, { thud, readText, mover, ...loaders, ...options });
  const worlds = [];
  for (const make of ["createWorld", "buildLevel"]) {
    const own = setting[make];
    setting[make] = (...given) => {
      worlds.push(own(...given));
      return worlds.at(-1);
    };
  }
  const scene = await module.default(setting);
  const close = () => {
    scene.close?.();
    for (const world of worlds) world.close();
  };
  return { module, setting, scene, close };
}

/**
 * Opens a session of a scene, as the page's worker does. `options`: size, seed and so on; `by`: the
 * function setUp of stage.ts, which may be that of another bundle.
 */
export async function openSession(thud, name, options = {}, by = setUp) {
  const module = await importScene(name);
  const request = { name, seed: 0, choices: USUAL, ...options };
  return by(1, module, thud, request, readText, { ...loaders, loadMover });
}

/** Runs steps of a scene as the page does, with no key pressed. `from`: the number of the first. */
export function runScene(scene, steps, from = 0) {
  for (let step = from; step < from + steps; step++) {
    scene.update?.({ step, held: NO_KEYS, pointer: null });
    scene.world.step();
    scene.stepped?.();
  }
}
