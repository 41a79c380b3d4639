/**
 * A plugin of Vite that removes from Box2D's loader what the page does not use: the script of its
 * threads, which would be bundled twice and never fetched, and the imports of Node.js modules.
 */

/** The files of the loader, as Vite names them. */
const LOADER = /\/box2d3-wasm\/.*\/Box2D\.(deluxe|compat)\.mjs$/;

/** Each expression, and the text that replaces it. */
const REPLACED = [
  [/new URL\("Box2D\.\w+\.mjs", import\.meta\.url\)/g, "import.meta.url"],
  [/await import\((["'])(module|worker_threads)\1\)/g, "{}"],
];

export function box2dLoader() {
  return {
    name: "box2d-loader",
    enforce: "pre",
    transform(code, id) {
      if (!LOADER.test(id)) return null;
      const changed = REPLACED.reduce((text, [found, by]) => text.replace(found, by), code);
      return { code: changed, map: null };
    },
  };
}
