/** Scenes of rules between kinds: equal to those of C, and what a visitor does in them. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { test } from "node:test";
import { buildScene, openSession, runScene } from "../../../web/tools/scenes.mjs";
import { step, withRival } from "../support/box2d.mjs";
import { findThudRun, root, thud } from "../support/package.mjs";

const engine = await thud.load();
const thudRun = findThudRun();
const skip = thudRun ? false : "thud-run is not built (./run test builds it)";

for (const name of ["planks"])
  test(`scene_${name}_has_the_native_hash_after_ten_seconds`, { skip }, async () => {
    const { scene } = await buildScene(engine, name);
    runScene(scene, 600);
    const options = ["--steps", "600", "--json"];
    const report = JSON.parse(
      execFileSync(thudRun, [name, ...options], { encoding: "utf8", cwd: root }),
    );
    assert.equal(scene.world.hash(), String(report.hash).replace(/^0x/, ""));
    scene.world.close();
  });

test("crate_that_a_visitor_drops_is_held_by_the_plank_below_and_rides_to_the_right", async () => {
  const session = await openSession(engine, "planks", { size: 1 });
  const { world } = session;
  session.do({ kind: "spawn", shape: "box", x: -2, y: 7.5, size: 0.4 });
  for (let i = 0; i < 150; i++) session.makeStep();
  const { position } = world.bodyState(world.bodies().at(-1));
  assert.ok(Math.abs(position[1] - 6.15) < 0.05, `${position}`);
  assert.ok(position[0] > 0, `${position}`);
  session.close();
});

test("what_acts_in_thud_alone_is_told_with_box2d", () => {
  const build = (world) => {
    const body = world.createBody({ kind: "dynamic", position: [0, 0] });
    world.createCircle(body, { radius: 0.5 });
    return body;
  };
  withRival({}, build, (world, rival, body, known) => {
    assert.deepEqual([...known.fields], []);
    world.applyBuoyancy(body, { density: 2 });
    world.applyWind(body, [3, 0]);
    world.applyBuoyancy(body, { density: 2 });
    step(world, rival, 1);
    assert.deepEqual([...known.fields], ["water", "wind"]);
    world.explode({ center: [0, 2], radius: 3 });
    assert.deepEqual([...known.fields], ["water", "wind", "explosions with cover"]);
  });
});
