/**
 * Support for all tests in tests/web: the built package, the demo module with the built-in scenes,
 * and levels.
 */
import { readdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { fileURLToPath } from "node:url";

export const root = fileURLToPath(new URL("../../..", import.meta.url));
export const thud = await import(`${root}web/package/dist/node.js`);
export const geometry = await import(`${root}web/package/dist/geometry/index.js`);
export const level = await import(`${root}web/package/dist/level.js`);
export const demoWasm = new URL("../../../web/generated/thud-demo.wasm", import.meta.url);

export const levelFiles = readdirSync(`${root}assets/levels`).filter((name) =>
  name.endsWith(".tmj"),
);

export function readLevelFile(file) {
  return readFileSync(`${root}assets/levels/${file}`, "utf8");
}

/** The names of the built-in scenes, in the order of the demo module. */
export function sceneNames(engine) {
  return Array.from({ length: engine.exports.api_scene_count() }, (_, i) => {
    return engine.text(engine.exports.api_scene_name(i));
  });
}

export function buildScene(engine, index, options = {}) {
  thud.World.writeOptions(engine, options);
  engine.check(engine.exports.api_scene_create(index, 0));
  return new thud.World(engine, {}, engine.slots[0]);
}

/** The source of axe-core, which is a package of web/. */
export function axeSource() {
  const require = createRequire(new URL("../../../web/package.json", import.meta.url));
  return readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
}

/** A map of 20 by 15 metres: flat ground at y = 2 and a ball of radius 1 at (10, 10). */
export function ballLevel(extra = []) {
  return JSON.stringify({
    type: "map",
    orientation: "orthogonal",
    width: 20,
    height: 15,
    tilewidth: 32,
    tileheight: 32,
    properties: [{ name: "about", type: "string", value: "One ball" }],
    layers: [
      {
        type: "objectgroup",
        name: "things",
        objects: [
          { id: 1, x: 0, y: 416, polyline: [{ x: 0, y: 0 }, { x: 640, y: 0 }] },
          {
            id: 2,
            x: 288,
            y: 128,
            width: 64,
            height: 64,
            ellipse: true,
            properties: [{ name: "body", type: "string", value: "dynamic" }],
          },
          ...extra,
        ],
      },
    ],
  });
}
