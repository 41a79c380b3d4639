#!/usr/bin/env node
/**
 * Draws a thumbnail of each scene to web/public/thumbs: it runs the scene for some steps in Node.js
 * and draws its state. A thumbnail that is newer than its sources is kept.
 */
import { mkdirSync, statSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { load } from "../package/dist/node.js";
import { drawScene } from "./picture.mjs";
import {
  buildScene,
  cssColour,
  rampColour,
  runScene,
  SCENES,
  sourceOf,
  thumbnailFile,
  THUMBNAILS,
} from "./scenes.mjs";

const web = new URL("../", import.meta.url);
const path = (file) => fileURLToPath(new URL(file, web));
const timeOf = (place) => statSync(place, { throwIfNoEntry: false })?.mtimeMs ?? 0;
const time = (file) => timeOf(path(file));

/** The time of the newest source on which all thumbnails depend, ms. */
const COMMON = Math.max(
  ...[
    "src/scene/thumbnails.ts",
    "src/scene/setting.ts",
    "src/scene/random.ts",
    "src/draw/palette.ts",
    "tools/picture.mjs",
    "tools/scenes.mjs",
    "tools/thumbnails.mjs",
    "package/dist/thud.wasm",
  ].map(time),
);
/** Nine colours. Chosen: so few that most bodies share an SVG path with many others. */
const COLOURS = Array.from({ length: 9 }, (_, i) => cssColour(rampColour(i / 8)));

const thud = await load();
mkdirSync(path("public/thumbs"), { recursive: true });
for (const { name } of SCENES) {
  const { size, steps = 60, view } = THUMBNAILS[name] ?? {};
  const file = `public/${thumbnailFile(name)}`;
  if (time(file) > Math.max(COMMON, timeOf(sourceOf(name)))) continue;
  const { scene, close } = await buildScene(thud, name, { size });
  runScene(scene, steps);
  writeFileSync(path(file), drawScene(scene, COLOURS, view));
  close();
}
