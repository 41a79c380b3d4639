/**
 * Reads title, description and place in the menu from the modules of scenes, and provides them to
 * the page as virtual modules by a plugin of Vite, so that the page need not load all scenes. The
 * modules are not run: each value is on a line of a fixed form, which the C build, without
 * JavaScript, reads in the same way (demo/scenes/CMakeLists.txt).
 */
import { readdirSync, readFileSync } from "node:fs";
import { basename } from "node:path";
import { fileURLToPath } from "node:url";

const FOLDER = fileURLToPath(new URL("../public/scenes", import.meta.url));
/** Games of examples/games are scenes as well: "pool.mjs" is the scene "game_pool". */
const GAMES = fileURLToPath(new URL("../../examples/games", import.meta.url));

/** A string literal without escapes, as a regular expression. */
const STRING = '"([^"\\\\\\n]+)"';
/** For each value the regular expression of its line, and the form that an error message shows. */
const LINES = {
  title: [`export const title =\\s+${STRING};`, 'export const title = "…";'],
  about: [`export const about =\\s+${STRING};`, 'export const about = "…";'],
  menu: [
    `export const menu = \\{ group: ${STRING}, place: (\\d+) \\};`,
    'export const menu = { group: "…", place: 110 };',
  ],
};
/** The line of a module that is not in the menu. */
const IN_NO_MENU = /^export const menu = null;/m;

/**
 * { name, title, about, group, place } from the text of a module; null where it is not in the menu.
 * Throws where a line is missing.
 */
export function readSceneText(name, text, file = `web/public/scenes/${name}.js`) {
  if (IN_NO_MENU.test(text)) return null;
  const [[title], [about], [group, place]] = Object.values(LINES).map(([pattern, form]) => {
    const found = new RegExp(`^${pattern}$`, "m").exec(text);
    if (!found) throw new Error(`${file} lacks a line of this form: ${form}`);
    return found.slice(1);
  });
  return { name, title, about, group, place: Number(place) };
}

/**
 * The scenes in the order of the menu, by place. Throws where two have the same place, or where the
 * scenes of a group do not follow each other.
 */
export function orderScenes(scenes) {
  const ordered = [...scenes].sort((a, b) => a.place - b.place);
  const done = new Set();
  ordered.forEach(({ name, group, place }, i) => {
    const before = ordered[i - 1];
    if (before?.place === place) throw new Error(`${before.name} and ${name} have one place, ${place}`);
    if (before && before.group !== group) done.add(before.group);
    if (done.has(group))
      throw new Error(`${name}: place ${place} lies outside of the group “${group}”`);
  });
  return ordered;
}

/** The paths of the games' modules, by the names of their scenes. */
export const GAME_FILES = new Map(
  readdirSync(GAMES)
    .filter((file) => file.endsWith(".mjs"))
    .map((file) => [`game_${basename(file, ".mjs")}`, `${GAMES}/${file}`]),
);

/** The paths of all scenes' modules, by name. */
function sceneFiles() {
  const files = readdirSync(FOLDER).filter((file) => file.endsWith(".js"));
  return [...files.map((file) => [basename(file, ".js"), `${FOLDER}/${file}`]), ...GAME_FILES];
}

/** All scenes of the menu, in its order. */
export function readSceneTexts() {
  const read = ([name, path]) => readSceneText(name, readFileSync(path, "utf8"), path);
  return orderScenes(sceneFiles().map(read).filter(Boolean));
}

/** The virtual modules: titles by name in each group, and descriptions by name. */
const MODULES = {
  "virtual:scene-titles"() {
    const groups = {};
    for (const { name, title, group } of readSceneTexts()) (groups[group] ??= {})[name] = title;
    return groups;
  },
  "virtual:scene-abouts": () =>
    Object.fromEntries(readSceneTexts().map(({ name, about }) => [name, about])),
};

/** The plugin. */
export function sceneTexts() {
  return {
    name: "scene-texts",
    resolveId: (id) => (id in MODULES ? `\0${id}` : null),
    load(id) {
      const make = MODULES[id.slice(1)];
      if (!make) return null;
      for (const [, path] of sceneFiles()) this.addWatchFile(path);
      return `export default ${JSON.stringify(make())};`;
    },
    configureServer(server) {
      for (const event of ["add", "unlink"])
        server.watcher.on(event, (path) => path.startsWith(FOLDER) && server.restart());
    },
  };
}
