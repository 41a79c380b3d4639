/** Tests that an invalid positional argument is refused with its name and range in the message. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { ARGUMENTS } from "../../../web/package/dist/checks/arguments.js";
import { thud } from "../support/package.mjs";

const engine = await thud.load();
const SCALE = 4;
const [LENGTHS, FINITE] = [1e6, 3.4e38];

/** Calls `act` with a world that has a body, shape or terrain of each kind that is needed. */
function inWorld(act) {
  const world = engine.createWorld({ lengthScale: SCALE });
  const ball = world.createBody({ kind: "dynamic", position: [0, 40] });
  const round = world.createCircle(ball, { radius: 1 });
  const box = world.createObb(world.createBody({ kind: "dynamic" }), { halfWidth: 1, halfHeight: 1 });
  const lift = world.createBody({ kind: "kinematic" });
  const line = { kind: "uniform", x0: -8, spacing: 1, heights: new Float64Array(17) };
  const ground = world.createTerrain(world.createBody(), line);
  const anchors = { bodyA: world.bodyOf(box), bodyB: ball };
  const rod = world.createJoint({ kind: "distance", ...anchors });
  const of = { setHalfExtents: box, setTarget: lift, setJointLength: rod };
  for (const name of ["dig", "raise", "replaceRange", "groundAt", "placeFoot"]) of[name] = ground;
  const before = world.hash();
  try {
    act({ world, ball, round, of });
    assert.equal(world.hash(), before, "what is refused changes nothing");
  } finally {
    world.close();
  }
}

/** Valid values of arguments. */
const USUAL = { dt: 1, density: 1, coefficient: 0.1, mass: 1, maxSteps: 1, seconds: 0.1, radius: 1, length: 1, halfWidth: 1, halfHeight: 1 };
const usual = (name, { pair, least }) => (pair ? [0, 0] : (USUAL[name] ?? Math.max(least, 0)));

/** Calls the method with the arguments in order; setMass and applyWind take them as options. */
function call({ world, ball, round, of }, module, method, given) {
  const values = Object.values(given);
  const { velocity, ...options } = given;
  if (method === "setMass") return world.setMass(ball, given);
  if (method === "applyWind") return world.applyWind(ball, velocity, options);
  if (method === "replaceRange") values.push([]);
  if (module.startsWith("api_world")) return world[method](...values);
  const subject = of[method] ?? (/_shape_/.test(module) ? round : ball);
  return world[method](subject, ...values);
}

/** Invalid values: twice the limits, NaN, and 0 where the range is open. */
const outside = ({ least, most, above, scaled }) => {
  const unit = scaled ? SCALE : 1;
  const wrong = [NaN, ...(most < FINITE ? [most * unit * 2] : [])];
  return above ? [...wrong, 0] : least > -FINITE ? [...wrong, least > 0 ? 0 : least * unit * 2 - 1] : wrong;
};

for (const [module, [method, ranges]] of Object.entries(ARGUMENTS))
  for (const [name, range] of Object.entries(ranges))
    test(`${method}_tells_${name}_and_its_range`, () => {
      const all = Object.entries(ranges).map(([other, its]) => [other, usual(other, its)]);
      const values = outside(range).filter((value) => !(range.orZero && value === 0));
      const given = range.pair ? values.flatMap((value) => [[value, 0], [0, value]]) : values;
      const isOption = ["setMass", "applyWind"].includes(method);
      if (!isOption && !["angle", "angularVelocity", "maxSteps"].includes(name)) given.push(undefined);
      for (const value of given)
        inWorld((made) =>
          assert.throws(
            () => call(made, module, method, { ...Object.fromEntries(all), [name]: value }),
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

test("range_of_an_argument_is_told_in_lengths_of_the_world", () => {
  inWorld(({ world, round, ball, of }) => {
    const refused = (act, told) => assert.throws(act, (error) => error.message === told);
    refused(() => world.setFriction(round, -1), "setFriction: friction must be from 0 to 1e6: -1");
    refused(() => world.setRadius(round, 1e6), "setRadius: radius must be from 0.0004 to 65536: 1000000");
    refused(() => world.setGravity([0, NaN]), "setGravity: gravity must be two finite numbers: [0, NaN]");
    refused(() => world.setTimeStep(2), "setTimeStep: seconds must be above 0 and at most 1: 2");
    const most = LENGTHS * SCALE;
    refused(() => world.setJointLength(of.setJointLength, 0), `setJointLength: length must be above 0 and at most ${most.toExponential().replace("+", "")}: 0`);
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

test("what_no_range_tells_keeps_the_words_of_the_engine", () => {
  inWorld(({ world, round, ball, of }) => {
    assert.throws(() => world.setRadius(of.setHalfExtents, 1), /the shape is no circle/);
    assert.throws(() => world.setTarget(ball, [0, 0]), /the body is not kinematic/);
    assert.throws(() => world.setHalfExtents(round, 1, 1), /the shape is no box/);
    assert.throws(() => world.setFriction({ ...round, generation: 9 }, NaN), { code: "stale" });
  });
});
