/** Tests the engine in two wasm files, which the page loads one after the other. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { thud } from "../support/package.mjs";

const file = (name) => new URL(`../../../web/package/dist/thud-${name}.wasm`, import.meta.url);

/** The hash of a pile that uses features of the second file. */
function hashOf(engine) {
  const world = engine.createWorld({ quality: "exact", detection: "swept" });
  const ground = world.createBody();
  world.createTerrain(ground, { kind: "irregular", points: [[-9, 2], [0, 0], [9, 2]] });
  for (let i = 0; i < 30; i++) {
    const body = world.createBody({ kind: "dynamic", position: [(i % 5) - 2, 3 + i] });
    if (i % 2) world.createCircle(body, { radius: 0.4, restitution: 0.5 });
    else world.createObb(body, { halfWidth: 0.4, halfHeight: 0.3, angle: i });
  }
  for (let i = 0; i < 120; i++) world.step();
  world.castRay([0, 50], [0, -100]);
  const hash = world.hash();
  world.close();
  return hash;
}

test("engine_in_two_files_gives_the_same_bits_as_in_one", async () => {
  const whole = await thud.load();
  const halves = await thud.load(file("first"), file("rest"));
  await halves.complete();
  assert.equal(hashOf(halves), hashOf(whole));
});

test("call_of_the_second_file_before_it_was_asked_for_brings_it", async () => {
  const whole = await thud.load();
  const halves = await thud.load(file("first"), file("rest"));
  assert.equal(hashOf(halves), hashOf(whole));
  await halves.complete();
  assert.equal(hashOf(halves), hashOf(whole));
});

test("second_file_that_is_none_is_refused_by_complete", async () => {
  const halves = await thud.load(file("first"), new Uint8Array([1, 2, 3]));
  await assert.rejects(halves.complete(), { name: "ThudError", code: "load" });
});

test("first_file_is_much_smaller_than_the_whole", () => {
  const size = (url) => readFileSync(url).length;
  const whole = size(new URL("../../../web/package/dist/thud.wasm", import.meta.url));
  assert.ok(size(file("first")) < 0.7 * whole);
  assert.ok(size(file("first")) + size(file("rest")) < 1.1 * whole);
});
