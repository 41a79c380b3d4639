/**
 * Tests that the native and the wasm build, and the level readers in C and in TypeScript, give
 * equal hashes after 300 steps.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { nativeHash, skip } from "../support/native.mjs";
import {
  buildScene,
  demoWasm,
  level,
  levelFiles,
  readLevelFile,
  sceneNames,
  thud,
} from "../support/package.mjs";

const STEPS = 300;
const engine = await thud.load(demoWasm);

function hashAfterSteps(world, step = () => world.step()) {
  for (let i = 0; i < STEPS; i++) step();
  const hash = world.hash();
  world.close();
  return hash;
}

const names = sceneNames(engine);

test("there_are_four_levels_at_least", () => {
  assert.ok(levelFiles.length >= 4);
});

for (const file of levelFiles)
  test(`level_${file}_has_equal_hash_native_and_wasm`, { skip }, async () => {
    const read = await level.readLevel(file.replace(/\.tmj$/, ""), readLevelFile(file));
    const hash = hashAfterSteps(level.buildLevel(engine, read));
    assert.equal(hash, nativeHash(`assets/levels/${file}`, STEPS));
  });

names.forEach((name, index) =>
  test(`scene_${name}_has_equal_hash_native_and_wasm`, { skip }, () => {
    const world = buildScene(engine, index);
    const step = () => engine.check(engine.exports.api_scene_step(world.address));
    assert.equal(hashAfterSteps(world, step), nativeHash(name, STEPS));
  }),
);

for (const detection of ["overlap", "bisect", "swept"])
  for (const name of ["bullets", "cradle", "slopes"])
    test(`scene_${name}_with_${detection}_has_equal_hash_native_and_wasm`, { skip }, () => {
      const world = buildScene(engine, names.indexOf(name), { detection, broadphase: "sweep" });
      const options = ["--detection", detection, "--broadphase", "all"];
      assert.equal(hashAfterSteps(world), nativeHash(name, STEPS, ...options));
    });
