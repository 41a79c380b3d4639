/**
 * The page's scenes against those of demo/scenes: equal random numbers, and after two seconds equal
 * hashes, as tests/golden/hashes.txt has them from the native engine.
 */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { buildScene, random } from "../../web/tools/scenes.mjs";
import { root, thud } from "./support.mjs";

/** As in tests/unit/test_golden.c; sizes are the C scenes' where those are small. */
const STEPS = 120;
const SMALL = {
  bullets: 15,
  broadphases: 90,
  cradle: 5,
  detection: 16,
  digging: 240,
  heavy_on_light: 5,
  minkowski: 2,
  pyramid: 100,
  slopes: 20,
  tall_stack: 30,
};
const SIZE_OF_OTHERS = 600;

const engine = await thud.load();
const golden = readFileSync(`${root}tests/golden/hashes.txt`, "utf8")
  .trim()
  .split("\n")
  .map((line) => line.split(/\s+/));

for (const [name, hash] of golden)
  test(`scene_${name}_has_the_native_hash`, async () => {
    const size = SMALL[name] ?? SIZE_OF_OTHERS;
    const { scene, setting } = await buildScene(engine, name, { size });
    assert.equal(setting.size, size);
    for (let i = 0; i < STEPS; i++) scene.world.step();
    assert.equal(scene.world.hash(), hash);
    scene.world.close();
  });

test("random_numbers_are_those_of_the_C_scenes", () => {
  const first = (seed) => {
    const chance = random(seed);
    return [chance(0, 1), chance(0, 1), chance(0, 1)];
  };
  // Printed by demo/scenes/random.h; the last seed is the largest whole number there is.
  assert.deepEqual(first(0), [0.88331080821364261, 0.43152799704850997, 0.026433771592597743]);
  assert.deepEqual(first(1), [0.5665615751722809, 0.74578175726270113, 0.97100275358679622]);
  assert.deepEqual(
    first(Number.MAX_SAFE_INTEGER),
    [0.1434526250083874, 0.1904899463327181, 0.52937135741010444],
  );
});
