/**
 * Tests that values out of range are refused with name and range, and that both ends of each range
 * are accepted.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import * as ranges from "../../../web/package/dist/checks/ranges.js";
import { thud } from "../support/package.mjs";

const engine = await thud.load();
const SCALE = 4;
const world = engine.createWorld({ lengthScale: SCALE });
const circle = { kind: "circle", radius: 1 };
const sizes = { halfWidth: 1, halfHeight: 1 };
const body = world.createBody({ kind: "dynamic", shapes: [circle] });
const other = world.createBody({ kind: "dynamic", shapes: [circle] });
const ground = world.createBody();

/** Creates and destroys a body with one shape, or a shape. */
const made = (options) => world.destroy(world.createBody({ kind: "dynamic", ...options }));
const shape = (create, usual) => (options) => {
  const of = world.createBody({ kind: "kinematic" });
  try {
    world[create](of, { ...usual, ...options });
  } finally {
    world.destroy(of);
  }
};
const query = (name, usual) => (options) => {
  const { origin, center, point, translation, maxDistance } = { ...usual, ...options };
  const first = { castShape: [circle, center], closest: [point] }[name] ?? [origin];
  world[name](...first, ...(name === "closest" ? [maxDistance] : [translation]));
};
const only = (table, ...names) => Object.fromEntries(names.map((name) => [name, table[name]]));
const { QUERY_RANGES, ASKER_RANGES, SHAPE_RANGES } = ranges;
const zero = [0, 0];
const ray = { origin: zero, translation: zero };
const asked = { circle: { radius: 1 }, aabb: sizes, obb: { ...sizes, angle: 0 } };
const mover = (options) => new thud.Mover(world, { shape: circle, position: zero, ...options }).close();
const walker = new thud.Mover(world, { shape: circle, position: zero });
const terrain = (kind, usual) => (line) => {
  world.destroy(world.createTerrain(ground, { kind, ...usual, ...line }));
};
const hinge = (options) => {
  world.destroy(world.createJoint({ kind: "hinge", bodyA: body, bodyB: other, ...options }));
};

/**
 * The call, the prefix of names in its messages, its ranges, and the function that makes it. Some
 * list the ends that can be tested.
 */
const CALLS = [
  ["createWorld", "", ranges.WORLD_RANGES, (options) => engine.createWorld(options).close()],
  ["createWorld", "quality.", ranges.QUALITY_RANGES, (quality) => engine.createWorld({ quality }).close()],
  ["setQuality", "", ranges.QUALITY_RANGES, (quality) => world.setQuality(quality)],
  ["createBody", "", ranges.BODY_RANGES, made],
  ["createCircle", "", SHAPE_RANGES.circle, shape("createCircle", { radius: 1 })],
  ["createAabb", "", SHAPE_RANGES.aabb, shape("createAabb", sizes)],
  ["createObb", "", SHAPE_RANGES.obb, shape("createObb", sizes)],
  ["createTerrain", "", only(ranges.TERRAIN_RANGES, "slope"), terrain("flat", {})],
  [
    "createTerrain",
    "",
    only(ranges.TERRAIN_RANGES, "spacing", "x0"),
    terrain("uniform", { x0: 0, spacing: 1, heights: [0, 1] }),
    "no ends",
  ],
  ["setMass", "", ranges.MASS_RANGES, (mass) => world.setMass(body, { mass: 1, inertia: 1, ...mass })],
  ["castRay", "", only(QUERY_RANGES, "origin", "translation"), query("castRay", ray), "no ends"],
  ["castRayAll", "", only(QUERY_RANGES, "origin"), query("castRayAll", ray)],
  ["castShape", "", only(QUERY_RANGES, "center"), query("castShape", { ...ray, center: zero })],
  [
    "closest",
    "",
    only(QUERY_RANGES, "point", "maxDistance"),
    query("closest", { point: zero, maxDistance: 1 }),
  ],
  [
    "overlap",
    "",
    only(QUERY_RANGES, "center"),
    (options) => world.overlap({ ...circle, center: zero, ...options }),
  ],
  [
    "overlap",
    "",
    only(QUERY_RANGES, "lower", "upper"),
    (options) => world.overlap({ kind: "bounds", lower: zero, upper: zero, ...options }),
    "no ends",
  ],
  ...Object.entries(asked).map(([kind, usual]) => [
    "castShapeAll",
    "",
    ASKER_RANGES[kind],
    (options) => world.castShapeAll({ kind, ...usual, ...options }, zero, zero),
  ]),
  [
    "explode",
    "",
    ranges.EXPLOSION_RANGES,
    (options) => world.explode({ [options.radius === 0 ? "falloff" : "radius"]: 1, ...options }),
  ],
  ["applyWind", "", ranges.WIND_RANGES, (wind) => world.applyWind(body, zero, wind)],
  ["applyBuoyancy", "", ranges.WATER_RANGES, (water) => world.applyBuoyancy(body, water), "no ends"],
  [
    "applyTyre",
    "",
    ranges.TYRE_RANGES,
    (tyre) => world.applyTyre(body, { at: zero, grip: 1, ...tyre }),
  ],
  ["Mover", "", ranges.MOVER_RANGES, mover],
  ["walk", "", ranges.WALK_RANGES, (walk) => walker.walk(walk)],
  ["hinge", "", ranges.JOINT_RANGES, (options) => hinge({ at: zero, ...options }), "no ends"],
  [
    "hinge",
    "frameA.",
    ranges.FRAME_RANGES,
    (frameA) => hinge({ frameA, frameB: { position: zero } }),
  ],
];

const FINITE = 3.4e38;
const own = { hinge: ["from", "to"] };

for (const [call, path, table, act, ends] of CALLS)
  for (const [name, range] of Object.entries(table)) {
    if (own[call]?.includes(name)) continue;
    const unit = range.scaled && !["createWorld", "Mover"].includes(call) ? SCALE : 1;
    const [least, most] = [range.least * unit, range.most * unit];
    const whole = ["substeps", "rays"].includes(name);
    const beyond = (end, sign) => (whole ? end + sign : end + sign * Math.max(1e-3 * Math.abs(end), 1e-6));
    const wrong = [NaN, Infinity, most < FINITE ? beyond(most, 1) : NaN];
    // For a value that is 0 or at least a minimum, one in between is invalid.
    wrong.push(range.above ? least : least <= -FINITE ? NaN : range.orZero ? -1 : beyond(least, -1));
    // A joint without anchors is attached at the origins of its bodies.
    const pairs = (value) => [[value, 0], [0, value], ...(call === "hinge" ? [] : [value, null])];
    const values = range.pair ? wrong.flatMap(pairs) : wrong;

    test(`${call}_tells_${path}${name}_and_its_range`, () => {
      for (const value of values)
        assert.throws(
          () => act({ [name]: value }),
          (error) => {
            assert.equal(error.name, "ThudError", error.stack);
            assert.equal(error.code, "invalid");
            assert.ok(error.message.startsWith(`${call}: ${path}${name} must be `), error.message);
            return true;
          },
          String(value),
        );
    });

    if (!ends && name !== "up")
      test(`${call}_takes_both_ends_of_${path}${name}`, () => {
        const low = range.above ? Math.min(1e-3, most / 2) : least;
        for (const value of [low, most, ...(range.orZero ? [0] : [])])
          if (Math.abs(value) < FINITE) act({ [name]: range.pair ? [value, 0] : value });
      });
  }

/** Refusals that are not about a single range. */
const OTHERS = [
  [() => world.createBody({ velocity: [1, 0] }), /a static body has no velocity/],
  [() => world.createBody(null), /createBody: options are an object: null/],
  [() => world.createBody({ shapes: 5 }), /createBody: shapes must be a list: 5/],
  [() => made({ shapes: [circle, { ...circle, radius: -1 }] }), /createBody: shapes\[1\]: .*radius must be/],
  [() => made({ shapes: [{ ...circle, radios: 1 }] }), /createBody: shapes\[0\]: .*"radios"/],
  [() => made({ userData: -1 }), /createBody: userData must be a whole number/],
  [() => made({ kind: "moving" }), /createBody: kind "moving" is none of static, kinematic/],
  [() => world.createCircle(body, {}), /createCircle: radius must be .*: it is missing/],
  [() => world.createCircle(body), /createCircle: options are an object: undefined/],
  [() => engine.createWorld({ quality: "best" }), /quality "best" is none of draft, default/],
  [() => engine.createWorld({ quality: 5 }), /quality: options are an object: 5/],
  [() => world.setQuality("high", 100), /setQuality: substeps must be .* to 64: 100/],
  [() => world.castRay([9e8 * SCALE, 0], [9e8 * SCALE, 0]), /castRay: translation leads out of the world/],
  [() => world.extrapolate(body, NaN), /extrapolate: seconds must be from 0 to 60: NaN/],
  [() => world.extrapolateAwake(61), /extrapolateAwake: seconds must be from 0 to 60: 61/],
  [() => world.predict(body, -1e-3), /predict: seconds must be from 0 to 60: -0.001/],
  [() => world.castRays([0, 0, 1, 0, NaN, 0, 1, 0]), /castRays: ray 1: origin must be two numbers/],
  [() => world.castRays([0, 0, 1, 0, 9e8 * SCALE, 0, 9e9, 0]), /castRays: ray 1: translation /],
  [() => world.overlap({ kind: "bounds", lower: [1, 0], upper: [0, 1] }), /overlap: lower must be below/],
  // NaN in a rule means that the field is not given.
  [() => world.setRule(1, 2, { friction: -1 }), /^setRule: friction must be from 0 to 1e6: -1$/],
  [() => world.setRule(1, 2, { restitution: 5 }), /^setRule: restitution must be from 0 to 4: 5$/],
  [() => world.setRule(1, 2, { surfaceSpeed: 1e7 }), /^setRule: surfaceSpeed must be from -4e6 to 4e6: /],
  [() => world.setRule(1, 2, { eventImpulse: -1 }), /^setRule: eventImpulse must be 0 or more: -1$/],
  [() => world.setRule(1, 2, { solidSide: null }), /^setRule: solidSide must be two numbers: null$/],
  [() => world.overlap({ kind: "bowl" }), /shape kind "bowl" is none of circle, aabb, obb$/],
  [() => terrain("uniform", { x0: 0, spacing: 1, heights: [0, NaN] })({}), /heights\[1\] must be a finite/],
  [() => terrain("uniform", { x0: 0, spacing: 1 })({}), /createTerrain: heights must be a list/],
  [() => terrain("irregular", { points: [[0, 0], [0, 1]] })({}), /points\[1\] must be right of points\[0\]/],
  [() => terrain("irregular", { points: [[0, 0], [1, NaN]] })({}), /points\[1\] must be two finite/],
  [() => terrain("irregular", { points: [[0, 0]] })({}), /points must be two or more: 1/],
  [() => hinge({ bodyB: body, at: zero }), /hinge: bodyA and bodyB must be two bodies, one of them/],
  [() => hinge({ at: [9e6, 0] }), /hinge: at is too far from its body/],
];

for (const [act, told] of OTHERS)
  test(`refusal_tells_${String(told).replace(/\W+/g, "_")}`, () => {
    const before = [world.bodies(), world.shapes()];
    assert.throws(act, (error) => {
      assert.equal(error.name, "ThudError", error.stack);
      assert.match(error.message, told);
      return error.code === "invalid";
    });
    assert.deepEqual([world.bodies(), world.shapes()], before);
  });

test("message_of_the_engine_spells_options_as_javascript_does", () => {
  const module = engine.exports;
  module.api_world_defaults();
  engine.slots[2] = 7;
  assert.throws(() => engine.check(module.api_world_create()), /world def: timeStep is 7, not in \(0, 1]/);
});
