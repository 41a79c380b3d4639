/** Tests gears in the npm package, which connect two joints. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { thud } from "../support/package.mjs";

const engine = await thud.load();

function near(value, wanted, tolerance) {
  assert.ok(Math.abs(value - wanted) <= tolerance, `${value}, not ${wanted} ± ${tolerance}`);
}

/** Two wheels on a wall with a gear. */
function train(t, ratio) {
  const world = engine.createWorld({ sleeping: false });
  t.after(() => world.close());
  const wall = world.createBody();
  const wheels = [1, 0.5].map((radius, i) => {
    const wheel = world.createBody({ kind: "dynamic", position: [2 * i, 0] });
    world.createCircle(wheel, { radius });
    return wheel;
  });
  const axles = wheels.map((bodyB, i) =>
    world.createJoint({ kind: "hinge", bodyA: wall, bodyB, at: [2 * i, 0] }),
  );
  const [jointA, jointB] = axles;
  const gear = world.createJoint({ kind: "gear", jointA, jointB, ratio, userData: 3 });
  return { world, wall, wheels, axles, gear };
}

for (const ratio of [0.5, -2])
  test(`wheels_of_a_gear_share_their_spin_by_the_ratio_${ratio}_over_many_turns`, (t) => {
    const { world, wheels, gear } = train(t, ratio);
    world.setVelocity(wheels[0], [0, 0], 20);
    for (let i = 0; i < 300; i++) world.step();
    const [first, second] = wheels.map((wheel) => world.bodyStateOf(wheel));
    const shared = (20 * first.inertia) / (first.inertia + second.inertia / ratio ** 2);
    near(first.angularVelocity, shared, 0.01 * shared);
    near(second.angularVelocity, -shared / ratio, (0.01 * shared) / Math.abs(ratio));
    near(world.jointStateOf(gear).angleGap, 0, 2e-3);
  });

test("gear_is_read_as_it_was_made_and_drawn_at_its_joints", (t) => {
  const { world, wheels, axles, gear } = train(t, 0.5);
  const options = world.jointOptionsOf(gear);
  const [jointA, jointB] = axles;
  const { kind, ratio, userData, collideConnected } = options;
  assert.deepEqual([kind, ratio, userData, collideConnected], ["gear", 0.5, 3, true]);
  assert.deepEqual([options.jointA, options.jointB], [jointA, jointB]);
  assert.ok(!("bodyA" in options || "frameA" in options || "length" in options));
  const { bodyA, bodyB } = world.jointStateOf(gear);
  assert.deepEqual([bodyA, bodyB], wheels);
  const { rows } = world.jointTable();
  const { placeA, placeB, length } = thud.JOINT_ROW;
  const row = 2 * length;
  assert.deepEqual([...rows.subarray(row + placeA, row + placeA + 2)], [0, 0]);
  assert.deepEqual([...rows.subarray(row + placeB, row + placeB + 2)], [2, 0]);
});

test("gear_goes_with_either_joint", (t) => {
  const { world, wheels, axles, gear } = train(t, 1);
  assert.deepEqual(world.jointsOf(wheels[0]).length, 2);
  world.destroy(axles[1]);
  assert.equal(world.isValid(gear), false);
  assert.deepEqual(world.joints(), [axles[0]]);
  assert.equal(world.jointTable().count, 1);
  world.step();
  assert.deepEqual(world.jointsOf(wheels[0]), [axles[0]]);
});

test("gear_of_what_cannot_turn_another_is_refused", (t) => {
  const { world, wall, wheels, axles } = train(t, 1);
  const [jointA, jointB] = axles;
  const weld = world.createJoint({ kind: "weld", bodyA: wall, bodyB: wheels[0], at: [0, 0] });
  const refused = (options, message) =>
    assert.throws(() => world.createJoint({ kind: "gear", jointA, jointB, ...options }), {
      code: "invalid",
      message,
    });
  refused({ jointA: weld }, /a gear is of hinges/);
  refused({ jointB: jointA }, /the same body/);
  refused({ ratio: 0 }, /ratio is 0, not in \[0.0001, 10000\]/);
  refused({ ratio: 1e5 }, /gear: ratio must be from -10000 to 10000: 100000/);
  refused({ bodyA: wall }, /gear: no option is called "bodyA"/);
});
