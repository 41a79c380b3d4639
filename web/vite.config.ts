/** Vite's configuration: bundles the page into dist/, a static folder that any host can serve. */
import { readdirSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { minify } from "terser";
import { defineConfig, type Plugin } from "vite";
import { box2dLoader } from "./tools/box2d-plugin.mjs";
import { codeNames } from "./tools/code-names.mjs";
import { offline } from "./tools/offline-plugin.mjs";
import { GAME_FILES, sceneTexts } from "./tools/scene-texts.mjs";

/** The games, which are scenes, with the same games in C. */
const GAMES = [...GAME_FILES].flatMap(([name, path]) => [
  { name: `scenes/${name}.js`, path },
  { name: `scenes/${name}.c`, path: path.replace(/mjs$/, "c") },
]);

/** The files of assets/ that scenes fetch, under the same names, and the games. */
const ASSETS = [
  { folder: "levels", suffix: ".tmj" },
  { folder: "terrain", suffix: ".csv" },
].flatMap(({ folder, suffix }) => {
  const source = fileURLToPath(new URL(`../assets/${folder}`, import.meta.url));
  return readdirSync(source)
    .filter((name) => name.endsWith(suffix))
    .map((name) => ({ name: `${folder}/${name}`, path: `${source}/${name}` }));
}).concat(GAMES);

/** Serves ASSETS in the development server, and copies them to the built page. */
const sceneAssets: Plugin = {
  name: "scene-assets",
  configureServer(server) {
    for (const { name, path } of ASSETS)
      server.middlewares.use(`/${name}`, (_request, response) => {
        response.setHeader("Content-Type", "text/plain; charset=utf-8");
        response.end(readFileSync(path));
      });
  },
  generateBundle() {
    for (const { name, path } of ASSETS)
      this.emitFile({ type: "asset", fileName: name, source: readFileSync(path) });
  },
};

/** Takes the comments out of the page. */
const bare: Plugin = {
  name: "bare",
  apply: "build",
  transformIndexHtml: (html) => html.replace(/\s*<!--.*?-->/gs, ""),
};

/** Takes comments and indentation out of the shaders, which stand in strings. */
const shaders: Plugin = {
  name: "shaders",
  apply: "build",
  transform(code, id) {
    if (!id.endsWith("/src/draw/shaders.ts")) return null;
    return { code: code.replace(/[ \t]*\/\/ .*$/gm, "").replace(/^[ \t]+/gm, ""), map: null };
  },
};

/** Characters of the largest chunk that is minified twice; a larger one takes seconds. Chosen. */
const LARGEST = 100_000;

/** Minifies once more, after esbuild: what a first visit waits for is 3 % smaller. */
const shorten: Plugin = {
  name: "shorten",
  apply: "build",
  async generateBundle(_, bundle) {
    for (const chunk of Object.values(bundle))
      if (chunk.type === "chunk" && chunk.code.length < LARGEST) {
        const { code } = await minify(chunk.code, { module: true, compress: { passes: 2 } });
        chunk.code = code!;
      }
  },
};

export default defineConfig({
  // Relative URLs, so that the built folder can be served under any path.
  base: "./",
  plugins: [sceneAssets, sceneTexts(), codeNames(), bare, shaders, shorten, offline()],
  build: {
    target: "es2022",
    // The content security policy allows neither inline scripts nor data: URLs.
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
  },
  // The worker imports Box2D as a chunk of its own, which only ES modules can do.
  worker: { format: "es", plugins: () => [box2dLoader(), shorten] },
  server: { fs: { allow: [".."] } },
});
