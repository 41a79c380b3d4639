/**
 * Tests the scenes with rules between categories: they have the hashes of the C scenes, and respond
 * to the visitor.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { buildScene, openSession, runScene } from "../../../web/tools/scenes.mjs";
import { withRival } from "../support/box2d.mjs";
import { nativeHash, skip } from "../support/native.mjs";
import { thud } from "../support/package.mjs";

const engine = await thud.load();

for (const name of ["planks", "crates", "meetings"])
  test(`scene_${name}_has_the_native_hash_after_ten_seconds`, { skip }, async () => {
    const { scene } = await buildScene(engine, name);
    runScene(scene, 600);
    assert.equal(scene.world.hash(), nativeHash(name, 600));
    scene.world.close();
  });

test("crate_that_a_visitor_drops_is_held_by_the_plank_below_and_rides_to_the_right", async () => {
  const session = await openSession(engine, "planks", { size: 1 });
  const { world } = session;
  session.do({ kind: "spawn", shape: "box", x: -2, y: 7.5, size: 0.4 });
  for (let i = 0; i < 150; i++) session.makeStep();
  const { position } = world.bodyStateOf(world.bodies().at(-1));
  assert.ok(Math.abs(position[1] - 6.15) < 0.05, `${position}`);
  assert.ok(position[0] > 0, `${position}`);
  session.close();
});

test("crate_that_broke_breaks_again_when_time_went_back", async () => {
  const session = await openSession(engine, "crates");
  const broken = () => session.scene.state.broken;
  while (broken() === 0) session.makeStep();
  const { step } = session;
  assert.ok(step > 40, `${step}`);
  assert.equal(session.world.bodies().length, 42 + 3 * broken());
  for (let i = 0; i < 120; i++) session.makeStep();
  const [hash, count] = [session.world.hash(), broken()];
  assert.ok(session.seek(step - 1));
  assert.equal(broken(), 0);
  while (session.step < step + 120) session.makeStep();
  assert.equal(session.world.hash(), hash);
  assert.equal(broken(), count);
  session.close();
});

test("rules_are_told_beside_box2d_which_has_none", () => {
  const build = (world) => world.createBody({ kind: "dynamic", position: [0, 0] });
  withRival({}, build, (world, rival) => {
    assert.deepEqual(rival.misses, []);
    world.setRule(2, 4, { kind: "oneWay" });
    assert.deepEqual(rival.misses, ["rules between kinds"]);
  });
});

test("what_a_visitor_sets_of_two_kinds_holds_in_place_of_the_timetable", async () => {
  const session = await openSession(engine, "meetings", { size: 16 });
  const { world } = session;
  const kindOf = (a, b) => world.rule(2 << a, 2 << b)?.kind ?? "collide";
  for (let i = 0; i < 10; i++) session.makeStep();
  assert.deepEqual([kindOf(0, 1), kindOf(2, 3), kindOf(1, 1)], ["ignore", "oneWay", "collide"]);
  session.do({ kind: "set", name: "meetings", value: "1000010000100001" });
  for (let i = 0; i < 100; i++) session.makeStep();
  assert.deepEqual([kindOf(0, 1), kindOf(2, 3), kindOf(1, 1)], ["collide", "collide", "ignore"]);
  assert.ok(session.seek(5));
  session.makeStep();
  assert.deepEqual([kindOf(0, 1), kindOf(2, 3), kindOf(1, 1)], ["ignore", "oneWay", "collide"]);
  session.close();
});
