#!/usr/bin/env node
/**
 * Splits the package's thud.wasm into two files for a fast first load: thud-first.wasm with the
 * functions that the page's first scene calls, and thud-rest.wasm with all others. They are found
 * by running that scene in an instrumented copy (wasm-split of binaryen, which is part of
 * emscripten).
 */
import { execFileSync } from "node:child_process";
import { readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { load } from "../package/dist/node.js";
import { buildScene, FIRST_SCENE, runScene, sceneFile } from "./scenes.mjs";

/**
 * Steps of the scene that are recorded: somewhat more than half a second, before its bodies first
 * touch. Chosen: contacts take 7 kB. A function that is first called later is in thud-rest.wasm,
 * which the page fetches after its first frame; if it has not arrived by then, the call blocks once
 * until it has.
 */
const STEPS = 33;

const path = (name) => fileURLToPath(new URL(`../package/dist/thud${name}`, import.meta.url));
const time = (file) => statSync(file, { throwIfNoEntry: false })?.mtimeMs ?? 0;
const [whole, first, rest] = [path(".wasm"), path("-first.wasm"), path("-rest.wasm")];
const split = (...options) => execFileSync("wasm-split", [...options, "--all-features"]);

/**
 * Calls the functions that the page's worker calls for a running scene, so that they are recorded.
 */
function use(world) {
  world.setMaxError(0);
  world.poses(0);
  const { handles } = world.shapeTable();
  const shape = { kind: "shape", index: handles[0] - 1, generation: handles[1] };
  if (world.shapeStateOf(shape).kind === "terrain") world.terrainOf(shape);
  world.bodyStateOf(world.shapeStateOf(shape).body);
  world.shapeTableAwake();
  world.stats();
  world.stepError();
  world.hash();
  world.snapshot(); // the page takes snapshots from the start; restore is called by a visitor only
}

const here = (file) => fileURLToPath(new URL(`../${file}`, import.meta.url));
const firstScene = `public/${sceneFile(FIRST_SCENE)}`;
const sources = ["tools/split-wasm.mjs", "src/scene/registry.ts", firstScene];
const newest = Math.max(time(whole), ...sources.map((file) => time(here(file))));
if (Math.min(time(first), time(rest)) <= newest) {
  const [instrumented, profile] = [path("-instrumented.wasm"), path(".profile")];
  split(whole, "--instrument", "-o", instrumented);
  const engine = await load(instrumented);
  const { scene } = await buildScene(engine, FIRST_SCENE, { choices: { timed: true } });
  use(scene.world);
  runScene(scene, STEPS);
  use(scene.world);
  scene.world.close();
  const { __write_profile, malloc } = engine.exports;
  const length = __write_profile(0, 0);
  const at = malloc(length);
  __write_profile(at, length);
  writeFileSync(profile, new Uint8Array(engine.buffer, at, length));
  split(whole, `--profile=${profile}`, "-o1", first, "-o2", rest);
  // Splitting leaves code behind that the first file no longer needs. A second pass finds what the
  // first one has made smaller.
  execFileSync("wasm-opt", [first, "-Oz", "-Oz", "--all-features", "-o", first]);
  for (const file of [instrumented, profile]) rmSync(file);
  const kilobytes = (file) => `${Math.round(readFileSync(file).length / 1000)} kB`;
  console.log(`thud-first.wasm ${kilobytes(first)}, thud-rest.wasm ${kilobytes(rest)}`);
}
