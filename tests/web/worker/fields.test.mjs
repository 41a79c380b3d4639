/**
 * Tests the scenes with water, wind and explosions: input by a visitor, and the report that Box2D
 * lacks water and wind.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { buildScene, openSession, runScene } from "../../../web/tools/scenes.mjs";
import { step, withRival } from "../support/box2d.mjs";
import { nativeHash, skip } from "../support/native.mjs";
import { thud } from "../support/package.mjs";

const engine = await thud.load();
const NO_KEYS = { left: false, right: false, up: false, down: false, fire: false, restart: false };

function hold(scene, input, steps, from = 0) {
  for (let step = from; step < from + steps; step++) {
    scene.update({ step, pointer: null, ...input, held: { ...NO_KEYS, ...input.held } });
    scene.world.step();
  }
}

function moving(world) {
  return world
    .bodies()
    .map((body) => world.bodyStateOf(body))
    .filter(({ kind }) => kind === "dynamic");
}

for (const name of ["boats", "flags", "explosion"])
  test(`scene_${name}_has_the_native_hash_after_ten_seconds`, { skip }, async () => {
    const { scene } = await buildScene(engine, name);
    runScene(scene, 600);
    assert.equal(scene.world.hash(), nativeHash(name, 600));
    scene.world.close();
  });

test("crate_that_a_visitor_drops_floats_half_in_the_water", async () => {
  const session = await openSession(engine, "boats");
  const { world } = session;
  session.do({ kind: "spawn", shape: "box", x: -11.5, y: 4, size: 0.4 });
  for (let i = 0; i < 900; i++) session.makeStep();
  const { position, mass } = moving(world).at(-1);
  assert.ok(Math.abs(position[1]) < 0.05, `${position}`);
  assert.ok(mass > 0.4);
  session.close();
});

test("wind_turns_by_keys_and_takes_the_flags_along", async () => {
  const { scene } = await buildScene(engine, "flags", { size: 1 });
  const tip = () => moving(scene.world).at(-1).position[0] + 3.25;
  const wind = () => scene.paint().figures[0].value;
  runScene(scene, 300);
  assert.ok(tip() > 2);
  assert.match(wind(), /^→ \d+ m\/s$/);
  hold(scene, { held: { left: true } }, 120, 300);
  hold(scene, {}, 300, 420);
  assert.ok(tip() < -2);
  assert.match(wind(), /^← \d+ m\/s$/);
  hold(scene, { held: { left: true } }, 600, 720);
  assert.equal(scene.state.wind, -15);
  hold(scene, { held: { right: true } }, 100, 1320);
  assert.ok(Math.abs(scene.state.wind) < 0.01);
  scene.world.close();
});

test("explosion_goes_off_once_for_each_press_and_its_ring_fades", async () => {
  const { scene } = await buildScene(engine, "explosion");
  const rings = () => scene.paint().marks.filter(({ kind }) => kind === "circle").length / 3;
  const fastest = () => Math.max(...moving(scene.world).map(({ velocity }) => Math.hypot(...velocity)));
  const pointer = { x: 11, y: 5.5, down: true };
  hold(scene, {}, 5);
  assert.ok(fastest() < 1);
  assert.equal(rings(), 0);
  hold(scene, { pointer }, 1, 5);
  assert.ok(fastest() > 4);
  hold(scene, { pointer }, 5, 6);
  assert.equal(rings(), 1);
  hold(scene, { pointer: { ...pointer, down: false } }, 1, 11);
  hold(scene, { held: { fire: true } }, 3, 12);
  assert.equal(rings(), 2);
  hold(scene, {}, 42, 15);
  assert.equal(rings(), 0);
  scene.world.close();
});

test("explosion_that_went_back_in_time_does_the_same_again", async () => {
  const session = await openSession(engine, "explosion");
  for (let i = 0; i < 90; i++) session.makeStep();
  session.do({ kind: "pointer", x: 9, y: 6, down: true });
  for (let i = 0; i < 60; i++) session.makeStep();
  const hash = session.world.hash();
  const { again } = session.rerun(100);
  assert.equal(again, hash);
  session.close();
});

test("what_acts_in_thud_alone_is_told_with_box2d", () => {
  const build = (world) => {
    const body = world.createBody({ kind: "dynamic", position: [0, 0] });
    world.createCircle(body, { radius: 0.5 });
    return body;
  };
  withRival({}, build, (world, rival, body) => {
    assert.deepEqual(rival.misses, []);
    world.applyBuoyancy(body, { density: 2 });
    world.applyWind(body, [3, 0]);
    world.applyBuoyancy(body, { density: 2 });
    step(world, rival, 1);
    assert.deepEqual(rival.misses, ["water", "wind"]);
    world.explode({ center: [0, 2], radius: 3 });
    assert.deepEqual(rival.misses, ["water", "wind", "explosions with cover"]);
  });
});
