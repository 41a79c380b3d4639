#!/usr/bin/env node
/**
 * Writes web/generated/hashes.json: for each scene the world hashes on the machine that builds the
 * page, at the scene's usual size and with default options, and the hash of the native engine. The
 * page compares them with those on the visitor's machine. A scene whose files have not changed is
 * not run again.
 */
import { createHash } from "node:crypto";
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { load } from "../package/dist/node.js";
import { GOLDEN, GOLDEN_STEPS } from "./golden.mjs";
import { buildScene, runScene, SCENES, sourceOf, USUAL_OPTIONS } from "./scenes.mjs";

/** Steps of each scene. */
const STEPS = 300;
/** Steps between two hashes, the resolution at which the page can say when a difference began. */
const EVERY = 60;

const path = (file) => fileURLToPath(new URL(`../${file}`, import.meta.url));
const OUTPUT = path("generated/hashes.json");

/** The files on which the hashes of all scenes depend, besides the scene's own. */
const COMMON = [
  "package/dist/thud.wasm",
  "src/scene/random.ts",
  "src/scene/setting.ts",
  "src/worker/stage.ts",
  "tools/hashes.mjs",
  "../assets/levels",
  "../assets/terrain",
].flatMap((file) => filesOf(path(file)));

/** All files in a folder, or the file itself. */
function filesOf(place) {
  if (!existsSync(place)) return [];
  try {
    return readdirSync(place).sort().flatMap((name) => filesOf(`${place}/${name}`));
  } catch {
    return [place];
  }
}

/** 16 digits that change with the content of the files. */
function keyOf(files) {
  const digest = createHash("sha256");
  for (const file of files) digest.update(readFileSync(file));
  return digest.digest("hex").slice(0, 16);
}

/** The hashes of a scene after each EVERY steps. */
async function hashesOf(thud, name) {
  const { scene, close } = await buildScene(thud, name, { choices: USUAL_OPTIONS });
  const hashes = [];
  for (let step = 0; step < STEPS; step += EVERY) {
    runScene(scene, EVERY, step);
    hashes.push(scene.world.hash());
  }
  close();
  return hashes;
}

const thud = await load();
const before = existsSync(OUTPUT) ? JSON.parse(readFileSync(OUTPUT, "utf8")).scenes : {};
const scenes = {};
const common = keyOf(COMMON);
for (const { name } of SCENES) {
  const file = sourceOf(name);
  const key = common + keyOf([file, ...filesOf(file.replace(/\.js$/, ""))]);
  const same = before[name]?.key === key;
  const hashes = same ? before[name].hashes : await hashesOf(thud, name);
  const native = GOLDEN.find((scene) => scene.name === name);
  scenes[name] = { key, hashes, native: native && { size: native.size, hash: native.hash } };
}
mkdirSync(path("generated"), { recursive: true });
writeFileSync(OUTPUT, JSON.stringify({ every: EVERY, nativeSteps: GOLDEN_STEPS, scenes }, null, 1));
