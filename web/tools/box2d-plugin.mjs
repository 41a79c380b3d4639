/**
 * A plugin of Vite that leaves out what Box2D's loader brings for uses that the page has not: the
 * script of its threads, which would be bundled twice and never fetched, and Node.js.
 */
const LOADER = /\/box2d3-wasm\/.*\/Box2D\.(deluxe|compat)\.mjs$/;

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
