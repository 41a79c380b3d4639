/**
 * Tests snapshots with joints in the npm package: a restore in the same world and in a new one
 * continues with the same bits.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { thud } from "../support/package.mjs";

const engine = await thud.load();

/** A joint of every kind between swinging and driven bodies above ground. */
function linkage(options = {}) {
  const world = engine.createWorld(options);
  const bodyA = world.createBody({ position: [0, 6] });
  world.createTerrain(bodyA, { kind: "flat" });
  let last = bodyA;
  const joints = [];
  const kinds = ["hinge", "distance", "slider", "weld", "wheel", "target", "filter", "hinge"];
  kinds.forEach((kind, i) => {
    const body = world.createBody({ kind: "dynamic", position: [i + 1, 8 + (i % 3)] });
    world.createObb(body, { halfWidth: 0.4, halfHeight: 0.1 });
    const pair = { bodyA: last, bodyB: body };
    const place = kind === "filter" || kind === "distance" ? {} : { at: [i + 0.5, 8] };
    const spring = { frequency: 2, motorForce: 4, motorSpeed: 1 };
    const drive = { hinge: { turn: spring }, wheel: { along: spring }, target: { across: spring } };
    joints.push(world.createJoint({ kind, ...pair, ...place, ...drive[kind], breakForce: 16 + i }));
    last = body;
  });
  const [jointA, jointB] = [8, 12].map((x) => {
    const wheel = world.createBody({ kind: "dynamic", position: [x, 3], angularVelocity: x });
    world.createCircle(wheel, { radius: 1 });
    return world.createJoint({ kind: "hinge", bodyA, bodyB: wheel, at: [x, 3] });
  });
  joints.push(world.createJoint({ kind: "gear", jointA, jointB, ratio: 0.5 }));
  return { world, bodyA, last, joints };
}

function walk(world, steps) {
  return Array.from({ length: steps }, () => {
    world.step();
    const live = world.joints();
    return [world.hash(), world.jointEvents(), live, live.map((joint) => world.jointStateOf(joint))];
  });
}

for (const quality of ["default", "exact"])
  test(`linkage_restored_at_${quality}_goes_the_same_way_in_its_world_and_in_a_new_one`, () => {
    const { world } = linkage({ quality });
    for (let i = 0; i < 10; i++) world.step();
    const options = world.joints().map((joint) => world.jointOptionsOf(joint));
    const snapshot = world.snapshot();
    const first = walk(world, 90);
    const fresh = engine.createWorld({ quality });
    assert.throws(() => fresh.restore(snapshot), { code: "invalid" });
    fresh.useJoints();
    for (const one of [world, fresh]) {
      one.restore(snapshot);
      assert.deepEqual(one.joints().map((joint) => one.jointOptionsOf(joint)), options);
      assert.deepEqual(walk(one, 90), first);
    }
    assert.ok(first.some(([, events]) => events.length > 0), "something breaks");
    fresh.close();
    world.close();
  });

test("joints_made_set_and_destroyed_after_the_snapshot_are_undone", () => {
  const { world, bodyA, last, joints } = linkage();
  for (let i = 0; i < 5; i++) world.step();
  const snapshot = world.snapshot();
  const play = () => {
    world.destroy(joints[0]);
    const made = world.createJoint({ kind: "distance", bodyA, bodyB: last, along: { upper: 9 } });
    world.setDrive(joints[4], "along", { frequency: 6 });
    world.setJointLength(joints[1], 2);
    world.setJointEnabled(joints[2], false);
    return [made, walk(world, 30)];
  };
  const first = play();
  assert.equal(world.isValid(joints[0]), false);
  world.restore(snapshot);
  assert.equal(world.isValid(joints[0]), true);
  assert.deepEqual(play(), first);
  world.close();
});
