#!/usr/bin/env node
/**
 * Cuts the package's thud.wasm in two: thud-first.wasm with what the page's first scene runs, for a
 * quick first visit, and thud-rest.wasm with everything else. Which functions that are is found by
 * running that scene in an instrumented copy (wasm-split of binaryen, which comes with emscripten).
 */
import { execFileSync } from "node:child_process";
import { readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { load } from "../package/dist/node.js";
import { buildScene, FIRST_SCENE, runScene, sceneFile } from "./scenes.mjs";

/** What is first needed later than this, a second in, comes with the rest, which is asked for as soon as
 * there is a picture: a visitor whose rest has not come by then waits for it once. */
const STEPS = 60;

const path = (name) => fileURLToPath(new URL(`../package/dist/thud${name}`, import.meta.url));
const time = (file) => statSync(file, { throwIfNoEntry: false })?.mtimeMs ?? 0;
const [whole, first, rest] = [path(".wasm"), path("-first.wasm"), path("-rest.wasm")];
const split = (...options) => execFileSync("wasm-split", [...options, "--all-features"]);

/** What the page's worker asks of a scene that runs. */
function use(world) {
  world.setMaxError(0);
  world.poses(0);
  const { handles } = world.shapeTable();
  const shape = { kind: "shape", index: handles[0] - 1, generation: handles[1] };
  if (world.shapeState(shape).kind === "terrain") world.terrain(shape);
  world.bodyState(world.shapeState(shape).body);
  world.shapeTableAwake();
  world.stats();
  world.error();
  world.hash();
  world.snapshot(); // which the page takes every few steps; to go back waits for a visitor
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
  for (const file of [instrumented, profile]) rmSync(file);
  const kilobytes = (file) => `${Math.round(readFileSync(file).length / 1000)} kB`;
  console.log(`thud-first.wasm ${kilobytes(first)}, thud-rest.wasm ${kilobytes(rest)}`);
}
