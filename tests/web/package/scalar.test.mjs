/**
 * Tests the engine for browsers without SIMD: it gives the same results, and contains no SIMD
 * instruction.
 */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { level, levelFiles, readLevelFile, thud } from "../support/package.mjs";

const STEPS = 120;
const dist = new URL("../../../web/package/dist/", import.meta.url);
const simd = await thud.load(new URL("thud.wasm", dist));
const scalar = await thud.load(new URL("thud-scalar.wasm", dist));

async function hashOf(engine, file) {
  const read = await level.readLevel(file, readLevelFile(file), { skip: true });
  const world = level.buildLevel(engine, read);
  for (let i = 0; i < STEPS; i++) world.step();
  const hash = world.hash();
  world.close();
  return hash;
}

for (const file of levelFiles)
  test(`level_${file}_has_equal_hash_with_and_without_simd`, async () => {
    assert.equal(await hashOf(scalar, file), await hashOf(simd, file));
  });

/** Whether i32x4.add or f32x4.mul occurs, which any engine built for SIMD contains. */
function usesSimd(bytes) {
  return [[0xfd, 0xae, 0x01], [0xfd, 0xe6, 0x01]].some((code) => bytes.includes(Buffer.from(code)));
}

test("scalar_module_has_no_simd_and_the_other_has", () => {
  assert.ok(usesSimd(readFileSync(new URL("thud.wasm", dist))));
  assert.ok(!usesSimd(readFileSync(new URL("thud-scalar.wasm", dist))));
});
