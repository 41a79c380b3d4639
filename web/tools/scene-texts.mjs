/**
 * What scene modules say of themselves, and the plugin of Vite by which the page knows it without
 * loading them. It is read and not run: each stands on a line of a fixed form, as the C build, which
 * has no JavaScript, reads title, sentence and sizes likewise (demo/scenes/CMakeLists.txt).
 */
import { readdirSync, readFileSync } from "node:fs";
import { basename } from "node:path";
import { fileURLToPath } from "node:url";

const FOLDER = fileURLToPath(new URL("../public/scenes", import.meta.url));

const STRING = '"([^"\\\\\\n]+)"';
const LINES = {
  title: [`export const title =\\s+${STRING};`, 'export const title = "…";'],
  about: [`export const about =\\s+${STRING};`, 'export const about = "…";'],
  menu: [
    `export const menu = \\{ group: ${STRING}, place: (\\d+) \\};`,
    'export const menu = { group: "…", place: 110 };',
  ],
};
/** In a module that is no scene of the menu. */
const IN_NO_MENU = /^export const menu = null;/m;

/** { name, title, about, group, place } of a module's text, or null if it is in no menu. */
export function readSceneText(name, text) {
  if (IN_NO_MENU.test(text)) return null;
  const [[title], [about], [group, place]] = Object.values(LINES).map(([pattern, form]) => {
    const found = new RegExp(`^${pattern}$`, "m").exec(text);
    if (!found) throw new Error(`web/public/scenes/${name}.js lacks a line of this form: ${form}`);
    return found.slice(1);
  });
  return { name, title, about, group, place: Number(place) };
}

/** In the order of the menu: by place. A group's scenes stand together. */
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

function sceneFiles() {
  const names = readdirSync(FOLDER).filter((file) => file.endsWith(".js"));
  return names.map((file) => `${FOLDER}/${file}`);
}

/** All scenes of the menu, in its order. */
export function readSceneTexts() {
  const read = (path) => readSceneText(basename(path, ".js"), readFileSync(path, "utf8"));
  return orderScenes(sceneFiles().map(read).filter(Boolean));
}

/** What the page imports: titles by name by group, and sentences by name. */
const MODULES = {
  "virtual:scene-titles"() {
    const groups = {};
    for (const { name, title, group } of readSceneTexts()) (groups[group] ??= {})[name] = title;
    return groups;
  },
  "virtual:scene-abouts": () =>
    Object.fromEntries(readSceneTexts().map(({ name, about }) => [name, about])),
};

export function sceneTexts() {
  return {
    name: "scene-texts",
    resolveId: (id) => (id in MODULES ? `\0${id}` : null),
    load(id) {
      const make = MODULES[id.slice(1)];
      if (!make) return null;
      for (const path of sceneFiles()) this.addWatchFile(path);
      return `export default ${JSON.stringify(make())};`;
    },
    configureServer(server) {
      for (const event of ["add", "unlink"])
        server.watcher.on(event, (path) => path.startsWith(FOLDER) && server.restart());
    },
  };
}
