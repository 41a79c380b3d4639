/**
 * Tests that invalid joints in the npm package throw an error that names the fault, and change
 * nothing.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { thud } from "../support/package.mjs";

const engine = await thud.load();
const world = engine.createWorld();
const bodyA = world.createBody();
const bodyB = world.createBody({ kind: "dynamic", position: [1, 2] });
const still = world.createBody();
world.createCircle(bodyB, { radius: 0.5 });
const pair = { bodyA, bodyB };
const hinge = world.createJoint({ kind: "hinge", ...pair, at: [0, 0] });
const rod = world.createJoint({ kind: "distance", ...pair });

const make = (options) => () => world.createJoint({ ...pair, at: [0, 0], ...options });
const rope = (options) => () => world.createJoint({ kind: "distance", ...pair, ...options });
const turn = (drive) => make({ kind: "hinge", turn: drive });
const along = (drive) => make({ kind: "slider", along: drive });

const REFUSED = [
  [make({ kind: "hing" }), /joint kind "hing" is none of distance, hinge/],
  [make({ kind: "hinge", atBody: 1 }), /hinge: no option is called "atBody"$/],
  [make({ kind: "hinge", along: {} }), /hinge: no option is called "along"/],
  [make({ kind: "hinge", length: 1 }), /hinge: no option is called "length"/],
  [rope({ at: [0, 0] }), /distance: no option is called "at"/],
  [turn({ motorspeed: 1 }), /turn: no option is called "motorspeed"; the nearest is "motorSpeed"/],
  [make({ kind: "weld", at: undefined, frameA: { x: 1 } }), /frameA: no option is called "x"/],
  [make({ kind: "hinge", bodyA: undefined }), /hinge: bodyA must be a body/],
  [make({ kind: "hinge", bodyB: hinge }), /hinge: bodyB must be a body/],
  [() => world.createJoint({ kind: "gear", jointA: hinge, jointB: bodyB }), /jointB must be a joint/],
  [make({ kind: "hinge", bodyA: still, bodyB: bodyA }), /one of them dynamic/],
  [make({ kind: "wheel", bodyA: bodyB, bodyB: bodyA }), /wheel/],
  [make({ kind: "hinge", frameA: {} }), /hinge: at and frameA exclude each other/],
  [make({ kind: "hinge", frameB: {} }), /hinge: at and frameB exclude each other/],
  [rope({ to: [0, 0], frameB: {} }), /a place in the world and frameB exclude each other/],
  [make({ kind: "slider", at: undefined, axis: [1, 0] }), /slider: axis goes with at/],
  [make({ kind: "slider", at: undefined, angle: 1 }), /slider: angle goes with at/],
  [make({ kind: "slider", axis: [1, 0], angle: 1 }), /axis and angle exclude each other/],
  [make({ kind: "slider", axis: [0, 0] }), /slider: axis points nowhere/],
  [make({ kind: "slider", axis: [NaN, 0] }), /slider: axis points nowhere/],
  [make({ kind: "hinge", at: [NaN, 0] }), /hinge: at must be two numbers from/],
  [make({ kind: "hinge", at: { x: 1, y: 2 } }), /hinge: at must be two numbers from/],
  [make({ kind: "hinge", angle: 1e9 }), /hinge: angle must be from -1000000 to 1000000/],
  [turn({ frequency: -3 }), /hinge: turn.frequency must be from 0 to 10000: -3/],
  [turn({ damping: NaN }), /hinge: turn.damping must be from 0 to 1000: NaN/],
  [turn({ target: 4 }), /hinge: turn.target must be from -3.1415927 to 3.1415927: 4/],
  [turn({ motorSpeed: 2e6 }), /hinge: turn.motorSpeed must be/],
  [turn({ motorForce: -1 }), /hinge: turn.motorForce must be from 0 to 1e\+30: -1/],
  [turn({ springForce: Infinity }), /hinge: turn.springForce must be/],
  [turn({ lower: 1, upper: -1 }), /hinge: turn.lower is above turn.upper/],
  [turn({ upper: 7 }), /hinge: turn.upper must be/],
  [along({ lower: NaN }), /slider: along.lower must be/],
  [along({ motorSpeed: 2e6 }), /slider: along.motorSpeed must be/],
  [rope({ length: -1 }), /distance: length must be from 0 to 999000: -1/],
  [rope({ from: [0, 0], to: [0, 0] }), /length/],
  [rope({ breakForce: -1 }), /distance: breakForce must be from 0 to 1e\+30: -1/],
  [rope({ userData: 0.5 }), /userData must be a whole number/],
  [() => world.setDrive(hinge, "along", {}), /drives no such direction/],
  [() => world.setDrive(hinge, "around", {}), /direction "around" is none of along, across, turn/],
  [() => world.setDrive(hinge, "turn", { speed: 1 }), /turn: no option is called "speed"/],
  [() => world.setDrive(hinge, "turn", { frequency: 1e5 }), /turn.frequency must be/],
  [() => world.setJointLength(hinge, 1), /no distance/],
  [() => world.setJointLength(rod, 0), /setJointLength: length must be above 0/],
  [() => world.setJointFrame(rod, "c", {}), /side "c" is none of a, b/],
  [() => world.setJointFrame(rod, "a", { position: [1e9, 0] }), /setJointFrame: frameA.position must be/],
  [() => world.setJointBreaking(rod, { breakforce: 1 }), /the nearest is "breakForce"/],
  [() => world.setJointBreaking(rod, { breakTorque: -1 }), /breakTorque must be/],
  [() => world.setJointUserData(rod, -1), /userData must be/],
];

for (const [act, message] of REFUSED)
  test(`refuses ${String(act).slice(0, 40)} with ${message}`, () => {
    const before = [world.snapshot(), world.joints()];
    assert.throws(act, (error) => {
      assert.ok(error instanceof thud.ThudError, String(error));
      assert.equal(error.code, "invalid");
      assert.match(error.message, message);
      return true;
    });
    assert.deepEqual([world.snapshot(), world.joints()], before);
  });

test("limits_that_are_infinite_are_none_and_one_alone_is_open_on_the_other_side", () => {
  const read = (drive) => {
    const joint = world.createJoint({ kind: "slider", ...pair, at: [0, 0], along: drive });
    const { lower, upper } = world.jointOptionsOf(joint).along;
    world.destroy(joint);
    return [lower, upper];
  };
  assert.deepEqual(read({}), [undefined, undefined]);
  assert.deepEqual(read({ lower: -Infinity, upper: Infinity }), [undefined, undefined]);
  const [lower, upper] = read({ lower: -2 });
  assert.equal(lower, -2);
  assert.ok(upper > 0.99e6);
  assert.deepEqual(read({ lower: 0.5, upper: 0.5 }), [0.5, 0.5]);
});
