/**
 * Tests that values which JavaScript would convert to numbers are refused with the field, the value
 * and what is allowed.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { thud } from "../support/package.mjs";

const engine = await thud.load();
const world = engine.createWorld();
const body = world.createBody({ kind: "dynamic", shapes: [{ kind: "circle", radius: 0.5 }] });
const other = world.createBody({ kind: "dynamic", position: [4, 0], shapes: [{ kind: "circle", radius: 0.5 }] });
const [shape] = world.shapesOf(body);
const pair = { bodyA: body, bodyB: other };
const make = (options) => () => world.createBody(options);
const circle = (options) => () => world.createCircle(body, { radius: 1, ...options });
const box = (options) => () => world.createAabb(body, options);
const joint = (options) => () => world.createJoint({ ...pair, ...options });

const BITS = "must be bits, a whole number from 0 to 0xffffffff";
const GROUP = "must be a whole number from -2147483648 to 2147483647";
const ZERO = { category: 0, mask: 0 };
const TEXT = "; in quotes it is a text";

/** Calls that are refused, and the messages. */
const REFUSED = [
  ...["category", "mask"].flatMap((name) =>
    [NaN, Infinity, 0.5, 2 ** 33, 2 ** 32, -(2 ** 31) - 1, true, null].map((value) => [
      circle({ [name]: value }),
      `createCircle: ${name} ${BITS}: ${value}`,
    ]),
  ),
  [circle({ category: "x" }), `createCircle: category ${BITS}: "x"${TEXT}`],
  [circle({ mask: "2" }), `createCircle: mask ${BITS}: "2"${TEXT}`],
  [circle({ group: 2 ** 31 }), `createCircle: group ${GROUP}: 2147483648`],
  [circle({ group: 0.5 }), `createCircle: group ${GROUP}: 0.5`],
  [() => world.setFilter(shape, { category: NaN }), `setFilter: category ${BITS}: NaN`],
  [() => world.castRay([0, 5], [0, -9], { mask: 0.5 }), `filter: mask ${BITS}: 0.5`],
  [() => world.castRay([0, 5], [0, -9], ZERO), "castRay: filter: category and mask are both 0"],
  [() => world.closest([0, 5], 9, ZERO), "closest: filter: category and mask are both 0"],
  [() => world.overlap({ kind: "circle", center: [0, 0], radius: 1 }, ZERO), "overlap: filter: category and mask"],
  [make({ angle: "1" }), `createBody: angle must be a number: "1"${TEXT}`],
  [make({ angle: true }), "createBody: angle must be a number: true"],
  [make({ fixedRotation: "no" }), `createBody: fixedRotation must be true or false: "no"${TEXT}`],
  [make({ fixedRotation: 0 }), "createBody: fixedRotation must be true or false: 0"],
  [make({ kind: 2 }), "createBody: kind must be a word: 2"],
  [make({ kind: { a: 1 } }), "createBody: kind must be a word: { a: 1 }"],
  [
    make({ position: [1, 2, 3] }),
    "createBody: position must be two numbers: [1, 2, 3]; the third is none of a place, and an angle is told by itself",
  ],
  [make({ velocity: ["1", 2] }), 'createBody: velocity must be two numbers: ["1", 2]'],
  [
    make({ position: { x: 1, y: 2 } }),
    "createBody: position must be two numbers from -1e9 to 1e9: { x: 1, y: 2 }; write [x, y]",
  ],
  [make({ shapes: { kind: "circle" } }), 'createBody: shapes must be a list: { kind: "circle" }'],
  [make([1]), 'createBody: no option is called "0"'],
  [make(5), "createBody: options are an object: 5"],
  [circle({ radius: "1" }), `createCircle: radius must be a number: "1"${TEXT}`],
  [circle({ userData: { id: 1 } }), "createCircle: userData must be a whole number from 0 to 2^53 - 1: { id: 1 }"],
  [() => engine.createWorld({ substeps: 2.5 }), "createWorld: substeps must be a whole number: 2.5"],
  [() => engine.createWorld({ sleeping: "false" }), `createWorld: sleeping must be true or false: "false"${TEXT}`],
  [() => engine.createWorld({ gravity: [0, -10, 0] }), "createWorld: gravity must be two numbers: [0, -10, 0]"],
  [() => world.setTransform(body, [0, 5, 1]), "position must be two numbers: [0, 5, 1]"],
  [() => world.applyForce(body, [0, 1], [0, 0, 0]), "point must be two numbers: [0, 0, 0]"],
  [() => world.castRay([0, 0, 0], [1, 0]), "origin must be two numbers: [0, 0, 0]"],
  [() => world.setTransform(body, [0, 5], "1"), 'setTransform: angle must be from -1e6 to 1e6: "1"'],
  [() => world.setVelocity(body, ["1", 0]), 'setVelocity: velocity must be two finite numbers: ["1", 0]'],
  [() => world.setFriction(shape, "0.5"), 'setFriction: friction must be from 0 to 1e6: "0.5"'],
  [() => world.setFriction(shape, [0.5]), "setFriction: friction must be from 0 to 1e6: [0.5]"],
  [() => world.setGravity(["0", -10]), 'setGravity: gravity must be two finite numbers: ["0", -10]'],
  [() => world.setFixedRotation(body, "no"), 'fixed must be true or false: "no"'],
  [() => world.setSleeping("no"), 'sleeping must be true or false: "no"'],
  [() => world.setAwake(body, 0), "awake must be true or false: 0"],
  [() => world.setLocks(body, { x: 1 }), "setLocks: x must be true or false: 1"],
  [joint({ kind: "hinge" }), "hinge: at is missing, its place in the world"],
  [joint({ kind: "weld", turn: { frequency: 1 } }), "weld: at is missing, its place in the world"],
  [joint({ kind: "hinge", at: [0, 0, 0] }), "hinge: at must be two numbers: [0, 0, 0]"],
  [
    joint({ kind: "hinge", at: [0, 0], motorSpeed: 3 }),
    'hinge: no option is called "motorSpeed"; it is one of "turn": turn: { motorSpeed: … }',
  ],
  [
    joint({ kind: "slider", at: [0, 0], upper: 3 }),
    'slider: no option is called "upper"; it is one of "along": along: { upper: … }',
  ],
  [box({ width: 1 }), 'createAabb: no option is called "width"; the nearest is "halfWidth" (half of it)'],
  [box({ height: 1 }), 'createAabb: no option is called "height"; the nearest is "halfHeight" (half of it)'],
  [
    () => world.castRay([0, 5], [0, -9], { exclude: body }),
    'filter: no option is called "exclude"; the nearest is "ignore"',
  ],
  [() => world.step(1 / 60), /^step: 0.01666.* is not taken: a step is as long as setTimeStep says, /],
  [() => world.step(undefined), /^step: undefined is not taken: /],
];

for (const [act, told] of REFUSED)
  test(`refused_with_${String(told).replace(/[^\w.]+/g, "_")}`, () => {
    const before = [world.hash(), world.bodies().length, world.shapes().length, world.joints().length];
    assert.throws(act, (error) => {
      assert.equal(error.name, "ThudError", error.stack);
      assert.equal(error.code, "invalid");
      if (told instanceof RegExp) assert.match(error.message, told);
      else assert.equal(error.message.slice(0, told.length), told);
      return true;
    });
    const after = [world.hash(), world.bodies().length, world.shapes().length, world.joints().length];
    assert.deepEqual(after, before);
  });

test("bits_that_javascript_makes_are_taken_both_signed_and_unsigned", () => {
  const made = world.createBody();
  for (const bits of [0, 1, 0xffffffff, ~4, 1 << 31, 0x80000000]) {
    const one = world.createCircle(made, { radius: 1, category: bits, mask: bits });
    assert.equal(world.shapeStateOf(one).category, bits >>> 0);
    world.setFilter(one, { mask: ~bits });
    assert.equal(world.shapeStateOf(one).mask, ~bits >>> 0);
  }
  world.destroy(made);
});

test("place_in_a_longer_typed_array_is_taken", () => {
  const kept = Float64Array.of(1, 2, 3, 4);
  const made = world.createBody({ position: kept });
  assert.deepEqual(world.positionOf(made), [1, 2]);
  world.setTransform(made, kept.subarray(2));
  assert.deepEqual(world.positionOf(made), [3, 4]);
  world.destroy(made);
});

test("joint_without_a_place_is_made_where_it_needs_none", () => {
  for (const options of [{ kind: "distance" }, { kind: "filter" }, { kind: "target" }, { kind: "hinge", frameB: {} }])
    world.destroy(world.createJoint({ ...pair, ...options }));
});

test("milliseconds_are_refused_and_time_that_passed_is_not", (t) => {
  let now = 20_000;
  t.mock.method(performance, "now", () => now);
  const told = /advance: 16.7 s are more than have passed; milliseconds are to be divided by 1000$/;
  const run = (act) => {
    const fresh = engine.createWorld();
    act((elapsed, ...rest) => fresh.advance(elapsed, ...rest), () => fresh.stats().steps);
    fresh.close();
  };
  // In the first second of a program the first call is refused, otherwise the second: at most one
  // is accepted.
  now = 900;
  run((advance, steps) => {
    assert.throws(() => advance(16.7), told);
    assert.equal(steps(), 0);
  });
  now = 60_000;
  run((advance) => {
    advance(16.7);
    now += 16.7;
    assert.throws(() => advance(16.7), told);
  });
  // A page in the background is called once a minute, and runs on; so does a program at ten times
  // the speed.
  run((advance, steps) => {
    for (let i = 1; i <= 5; i++) {
      now += 60_000;
      advance(60);
      assert.equal(steps(), 4 * i);
    }
    now += 200;
    advance(2);
  });
  // Time beyond maxSteps is kept and played later.
  run((advance, steps) => {
    for (let i = 1; i <= 3; i++) advance(5, 301);
    assert.ok(steps() >= 899, `${steps()}`);
  });
  run((advance) => assert.throws(() => advance(2e9), /elapsed must be from 0 to 1e9/));
});
