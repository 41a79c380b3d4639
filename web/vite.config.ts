/** How the page is bundled into dist/: a static folder that any host can serve. */
import { readdirSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { defineConfig, type Plugin } from "vite";
import { box2dLoader } from "./tools/box2d-plugin.mjs";
import { codeNames } from "./tools/code-names.mjs";
import { offline } from "./tools/offline-plugin.mjs";
import { sceneTexts } from "./tools/scene-texts.mjs";

/** What of assets/ the scenes read: the page finds it under the same names. */
const ASSETS = [
  { folder: "levels", suffix: ".tmj" },
  { folder: "terrain", suffix: ".csv" },
].flatMap(({ folder, suffix }) => {
  const source = fileURLToPath(new URL(`../assets/${folder}`, import.meta.url));
  return readdirSync(source)
    .filter((name) => name.endsWith(suffix))
    .map((name) => ({ name: `${folder}/${name}`, path: `${source}/${name}` }));
});

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

export default defineConfig({
  // Relative addresses: the built folder can be served from anywhere.
  base: "./",
  plugins: [sceneAssets, sceneTexts(), codeNames(), offline()],
  build: {
    target: "es2022",
    // The content security policy allows neither inline scripts nor data: addresses.
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
  },
  // Box2D is a chunk of its own in the worker, which only modules can have.
  worker: { format: "es", plugins: () => [box2dLoader()] },
  server: { fs: { allow: [".."] } },
});
