/** The page's scenes in Node.js, as the tests and the thumbnails run them. */
import { readFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { runnerImport } from "vite";
import { sceneTexts } from "./scene-texts.mjs";

const web = new URL("../", import.meta.url);

/** The exports of one of the page's sources. */
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

/** A world's options on the page while the visitor has chosen nothing. */
export const USUAL_OPTIONS = optionsOf(USUAL);

const NO_KEYS = noKeys();

/** Where the page finds "levels/…" and "terrain/…". */
export function readText(file) {
  return readFile(new URL(`../assets/${file}`, web), "utf8");
}

/** Vite's runner, which is closed by then, would have to import them otherwise. */
const loaders = {
  loadReader: () => import("../package/dist/level.js"),
  loadGeometry: () => import("../package/dist/geometry/index.js"),
};

const loadMover = async () => (await import("../package/dist/node.js")).Mover;

/**
 * Builds a scene of the registry: { module, setting, scene, close }. `options` as for createSetting;
 * `close` is for all that the scene has made.
 */
export async function buildScene(thud, name, options = {}) {
  const module = await import(new URL(`public/${sceneFile(name)}`, web).href);
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

/** A running scene of the registry, as the page's worker has it. `options`: size, seed; `by` is stage.ts's
 * setUp of another bundle. */
export async function openSession(thud, name, options = {}, by = setUp) {
  const module = await import(new URL(`public/${sceneFile(name)}`, web).href);
  const request = { name, seed: 0, choices: USUAL, ...options };
  return by(1, module, thud, request, readText, { ...loaders, loadMover });
}

/** Makes steps as the page does, with nobody at the keys. */
export function runScene(scene, steps, from = 0) {
  for (let step = from; step < from + steps; step++) {
    scene.update?.({ step, held: NO_KEYS, pointer: null });
    scene.world.step();
    scene.stepped?.();
  }
}
