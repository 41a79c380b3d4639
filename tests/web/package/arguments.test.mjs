/**
 * Tests that an invalid argument is refused with a message that names it and its range: positional
 * arguments, and the options of setMass and applyWind. ranges.test.mjs tests all other options.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { ARGUMENTS } from "../../../web/package/dist/checks/arguments.js";
import { thud } from "../support/package.mjs";

const engine = await thud.load();
/** The length scale of the test's world; not 1, so that limits in length scales differ from others. */
const SCALE = 4;
/** The maximum of joint lengths, length scales (THUD_JOINT_LENGTH_MAX). */
const JOINT_LENGTH_MAX = 1e6;
/** A range whose limit is beyond this, about the largest float, permits all finite numbers. */
const FLOAT_MAX = 3.4e38;
/** The arguments, by position, that have a default and may be missing. */
const OPTIONAL = ["angle", "angularVelocity", "maxSteps"];

/**
 * Calls `act` with a world, a dynamic body (`ball`), its circle, and `targets`: by method, the body,
 * shape or joint that it is called for where that is neither of these. Asserts that the world is as
 * before.
 */
function inWorld(act) {
  const world = engine.createWorld({ lengthScale: SCALE });
  const ball = world.createBody({ kind: "dynamic", position: [0, 40] });
  const circle = world.createCircle(ball, { radius: 1 });
  const box = world.createObb(world.createBody({ kind: "dynamic" }), { halfWidth: 1, halfHeight: 1 });
  const lift = world.createBody({ kind: "kinematic" });
  const line = { kind: "uniform", x0: -8, spacing: 1, heights: new Float64Array(17) };
  const ground = world.createTerrain(world.createBody(), line);
  const anchors = { bodyA: world.bodyOf(box), bodyB: ball };
  const rod = world.createJoint({ kind: "distance", ...anchors });
  const targets = { setHalfExtents: box, setTarget: lift, setJointLength: rod };
  for (const name of ["dig", "raise", "replaceRange", "groundAt", "frictionAt", "placeFoot"]) targets[name] = ground;
  const before = world.hash();
  try {
    act({ world, ball, circle, targets });
    assert.equal(world.hash(), before, "what is refused changes nothing");
  } finally {
    world.close();
  }
}

/** Valid values of arguments by name, where neither 0 nor the minimum of the range is to be taken. */
const VALID = { dt: 1, density: 1, coefficient: 0.1, mass: 1, maxSteps: 1, seconds: 0.1, radius: 1, length: 1, halfWidth: 1, halfHeight: 1 };
const validValue = (name, { pair, least }) => (pair ? [0, 0] : (VALID[name] ?? Math.max(least, 0)));

/**
 * Calls a method with its arguments (by name, in their order) for the target that it needs: none if
 * the name of the module's function (`exported`) begins with api_world; the circle if it has _shape_
 * in it; else the ball; or one of `targets`. setMass takes all arguments as options, applyWind all
 * but the velocity; replaceRange needs a list of points behind them.
 */
function call({ world, ball, circle, targets }, exported, method, named) {
  const values = Object.values(named);
  const { velocity, ...options } = named;
  if (method === "setMass") return world.setMass(ball, named);
  if (method === "applyWind") return world.applyWind(ball, velocity, options);
  if (method === "replaceRange") values.push([]);
  if (exported.startsWith("api_world")) return world[method](...values);
  const target = targets[method] ?? (/_shape_/.test(exported) ? circle : ball);
  return world[method](target, ...values);
}

/**
 * Invalid numbers for a range (Range in checks/ranges.ts): NaN; twice the maximum; and below the
 * minimum 0, where that is invalid (the minimum is above 0, or 0 but excluded by `above`), else
 * twice the minimum less 1. Limits that permit all finite numbers are not exceeded.
 */
const invalidNumbers = ({ least, most, above, scaled }) => {
  const unit = scaled ? SCALE : 1;
  const numbers = [NaN, ...(most < FLOAT_MAX ? [most * unit * 2] : [])];
  if (least > -FLOAT_MAX) numbers.push(above || least > 0 ? 0 : least * unit * 2 - 1);
  return numbers;
};

for (const [exported, [method, ranges]] of Object.entries(ARGUMENTS))
  for (const [name, range] of Object.entries(ranges))
    test(`${method}_tells_${name}_and_its_range`, () => {
      const valid = Object.entries(ranges).map(([key, keyRange]) => [key, validValue(key, keyRange)]);
      const numbers = invalidNumbers(range).filter((number) => !(range.orZero && number === 0));
      const invalid = range.pair ? numbers.flatMap((number) => [[number, 0], [0, number]]) : numbers;
      const isOption = ["setMass", "applyWind"].includes(method);
      if (!isOption && !OPTIONAL.includes(name)) invalid.push(undefined);
      for (const value of invalid)
        inWorld((fixture) =>
          assert.throws(
            () => call(fixture, exported, method, { ...Object.fromEntries(valid), [name]: value }),
            (error) => {
              assert.equal(error.name, "ThudError", error.stack);
              assert.equal(error.code, "invalid");
              assert.ok(error.message.startsWith(`${method}: ${name} must be `), error.message);
              if (value === undefined) assert.match(error.message, /: it is missing(; without a point write \w+ or \w+)?$/);
              return true;
            },
            String(value),
          ),
        );
    });

test("message_gives_limits_of_lengths_times_the_length_scale_of_the_world", () => {
  inWorld(({ world, circle, ball, targets }) => {
    const refused = (act, message) => assert.throws(act, (error) => error.message === message);
    // Not lengths: friction, gravity, seconds.
    refused(() => world.setFriction(circle, -1), "setFriction: friction must be from 0 to 1e6: -1");
    refused(() => world.setGravity([0, NaN]), "setGravity: gravity must be two finite numbers: [0, NaN]");
    refused(() => world.setTimeStep(2), "setTimeStep: seconds must be above 0 and at most 1: 2");
    // 1e-4 to 16384 length scales; at most 1e6; within 1e9.
    refused(() => world.setRadius(circle, 1e6), "setRadius: radius must be from 0.0004 to 65536: 1000000");
    const max = (JOINT_LENGTH_MAX * SCALE).toExponential().replace("+", "");
    refused(() => world.setJointLength(targets.setJointLength, 0), `setJointLength: length must be above 0 and at most ${max}: 0`);
    refused(() => world.applyForce(ball, [0, 1], [1, 5e9]), "applyForce: point must be two numbers from -4e9 to 4e9: [1, 5000000000]");
  });
});

test("call_without_a_point_is_refused_with_the_name_of_the_call_at_the_centre", () => {
  inWorld(({ world, ball }) => {
    const told = (call, others) => (error) =>
      error.code === "invalid" &&
      error.message === `${call}: point must be two numbers from -4e9 to 4e9: it is missing; without a point write ${others}`;
    const forces = told("applyForce", "applyCenterForce or applyTorque");
    assert.throws(() => world.applyForce(ball, [0, 1]), forces);
    assert.throws(() => world.applyForce(ball, [0, 1], 0.5), forces);
    const impulses = told("applyImpulse", "applyCenterImpulse or applyAngularImpulse");
    assert.throws(() => world.applyImpulse(ball, [0, 1]), impulses);
    assert.throws(() => world.applyForce(ball, [NaN, 1]), /^ThudError: applyForce: force must be two/);
  });
});

test("errors_that_are_not_of_a_range_have_the_message_of_the_engine", () => {
  inWorld(({ world, circle, ball, targets }) => {
    assert.throws(() => world.setRadius(targets.setHalfExtents, 1), /the shape is no circle/);
    assert.throws(() => world.setTarget(ball, [0, 0]), /the body is not kinematic/);
    assert.throws(() => world.setHalfExtents(circle, 1, 1), /the shape is no box/);
  });
});

test("stale_handle_is_refused_before_an_invalid_argument", () => {
  inWorld(({ world, circle }) => {
    assert.throws(() => world.setFriction({ ...circle, generation: 9 }, NaN), { code: "stale" });
  });
});
