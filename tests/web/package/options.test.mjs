/**
 * Tests that the npm package refuses unknown options by name, and reads back options as they were
 * given.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { buildLevel, readLevel } from "../../../web/package/dist/level.js";
import { ballLevel, thud } from "../support/package.mjs";

const engine = await thud.load();
const world = engine.createWorld();
const ground = world.createBody();
const circle = { kind: "circle", radius: 0.5 };
const box = { halfWidth: 1, halfHeight: 2 };
const flat = { kind: "flat" };
const mover = (options) => new thud.Mover(world, { shape: circle, position: [0, 3], ...options });
const walker = mover({});
const bounds = { lower: [0, 0], upper: [1, 1] };

/** The call, its unknown option, and the nearest known option. */
const REFUSED = [
  ["createWorld", () => engine.createWorld({ Gravity: [0, -1] }), "Gravity", "gravity"],
  ["quality", () => engine.createWorld({ quality: { substep: 8 } }), "substep", "substeps"],
  ["setQuality", () => world.setQuality({ base: "high", stiffness: 0.1 }), "stiffness", "contactStiffness"],
  ["createBody", () => world.createBody({ gravityscale: 0 }), "gravityscale", "gravityScale"],
  ["createBody", () => world.createBody({ type: "dynamic" }), "type", "kind"],
  ["createBody", () => world.createBody({ isStatic: true }), "isStatic", "kind"],
  ["createBody", () => world.createBody({ mass: 2 }), "mass", "shapes"],
  ["createBody", () => world.createBody({ friction: 2 }), "friction", "shapes"],
  ["createJoint", () => world.createJoint({ kind: "distance", bodyA: ground, bodyB: ground, stiffness: 1 }), "stiffness", "along"],
  ["createCircle", () => world.createCircle(ground, { radious: 1 }), "radious", "radius"],
  ["createAabb", () => world.createAabb(ground, { halfwidth: 1 }), "halfwidth", "halfWidth"],
  ["createAabb", () => world.createAabb(ground, { halfExtents: [1, 2] }), "halfExtents", "halfWidth"],
  ["createObb", () => world.createObb(ground, { ...box, isSensor: true }), "isSensor", "sensor"],
  ["createTerrain", () => world.createTerrain(ground, flat, { fricton: 1 }), "fricton", "friction"],
  ["terrain", () => world.createTerrain(ground, { ...flat, slop: 1 }), "slop", "slope"],
  ["castRay", () => world.castRay([0, 0], [1, 0], { masks: 1 }), "masks", "mask"],
  ["castShapeAll", () => world.castShapeAll({ ...circle, r: 1 }, [0, 0], [1, 0]), "r", "radius"],
  ["closest", () => world.closest([0, 0], 1, { sensor: true }), "sensor", "sensors"],
  ["overlap", () => world.overlap({ ...circle, centre: [0, 0] }), "centre", "center"],
  ["Mover", () => mover({ maxslope: 1 }), "maxslope", "maxSlope"],
  ["Mover, filter", () => mover({ filter: { categories: 1 } }), "categories", "category"],
  ["move", () => walker.move([1, 0], 1 / 60, { drops: true }), "drops", "drop"],
  ["draw", () => world.draw({ ...bounds, colors: true }), "colors", "colours"],
  ["readLevel", () => readLevel("ball", ballLevel(), { skips: true }), "skips", "skip"],
  [
    "buildLevel",
    async () => buildLevel(engine, await readLevel("ball", ballLevel()), { detections: "swept" }),
    "detections",
    "detection",
  ],
];

for (const [call, act, name, nearest] of REFUSED)
  test(`${call}_refuses_${name}_by_name_with_the_nearest_known_one`, async () => {
    const { bodies, shapes } = world.stats();
    // Functions that read files reject later.
    await assert.rejects(async () => act(), (error) => {
      assert.ok(error instanceof thud.ThudError, String(error));
      assert.equal(error.code, "invalid");
      const told = /no option is called "(.*)"; the nearest is "(.*)"/.exec(error.message) ?? [];
      assert.deepEqual(told.slice(1), [name, nearest], error.message);
      return true;
    });
    world.step();
    assert.deepEqual([world.stats().bodies, world.stats().shapes], [bodies, shapes]);
  });

/** The call, and its unknown option, which is like none that the call has. */
const UNLIKE = [
  ["createCircle", () => world.createCircle(ground, { radius: 1, angle: 1 }), "angle"],
  ["overlap of bounds", () => world.overlap({ kind: "bounds", ...bounds, min: 1 }), "min"],
  ["Mover, shape", () => mover({ shape: { kind: "aabb", ...box, angle: 1 } }), "angle"],
  ["createBody", () => world.createBody({ plugin: {} }), "plugin"],
  ["sum", () => thud.minkowskiSum(engine, circle, { ...circle, x: 1 }, [0, 0]), "x"],
];

for (const [call, act, name] of UNLIKE)
  test(`${call}_refuses_${name}_without_naming_another_that_is_not_like_it`, () => {
    assert.throws(act, (error) => {
      assert.match(error.message, new RegExp(`no option is called "${name}"$`));
      return true;
    });
  });

test("pair_given_as_an_object_is_refused_and_not_passed_over", () => {
  assert.throws(() => engine.createWorld({ gravity: { x: 0, y: 0 } }), { code: "invalid" });
  assert.throws(() => world.createBody({ position: { x: 1, y: 2 } }), { code: "invalid" });
});

test("shape_is_read_by_the_names_that_it_was_made_with", () => {
  const material = {
    density: 2,
    friction: 0.25,
    restitution: 0.5,
    surfaceSpeed: 1,
    category: 2,
    mask: 6,
    group: -3,
    sensor: true,
    events: false,
    userData: 7,
  };
  const body = world.createBody({ kind: "kinematic" });
  const made = {
    circle: { ...material, radius: 0.75, offset: [1, 2] },
    aabb: { ...material, halfWidth: 0.5, halfHeight: 0.25, offset: [1, 2] },
    obb: { ...material, halfWidth: 0.5, halfHeight: 0.25, offset: [1, 2], angle: 0.5 },
  };
  const create = {
    circle: (options) => world.createCircle(body, options),
    aabb: (options) => world.createAabb(world.createBody({ kind: "kinematic" }), options),
    obb: (options) => world.createObb(body, options),
  };
  for (const [kind, options] of Object.entries(made)) {
    const { body: _, ...state } = world.shapeStateOf(create[kind](options));
    // The angle is stored as a cosine and a sine.
    if (kind === "obb") assert.ok(Math.abs(state.angle - options.angle) < 1e-8);
    assert.deepEqual(state, { kind, ...options, ...(kind === "obb" && { angle: state.angle }) });
    const { body: __, ...again } = world.shapeStateOf(create[kind](state));
    if (kind === "obb") assert.ok(Math.abs(again.angle - state.angle) < 1e-8);
    const same = kind === "obb" ? { ...state, angle: again.angle } : state;
    assert.deepEqual(again, same, "a shape is made of another's state");
  }
  const line = world.createTerrain(ground, { kind: "flat", slope: 0.5 }, material);
  const { body: of, ...state } = world.shapeStateOf(line);
  assert.deepEqual([of, state], [ground, { kind: "terrain", ...material }]);
  assert.deepEqual(world.terrainOf(line), { kind: "flat", slope: 0.5 });
});

test("shape_made_of_a_state_of_another_kind_is_refused", () => {
  assert.throws(() => world.createAabb(ground, { kind: "obb", ...box }), /createAabb: its kind is "obb"/);
});

test("options_of_an_object_with_inherited_ones_are_read", () => {
  class Ball {
    get radius() {
      return 0.5;
    }
  }
  const shape = world.createCircle(ground, new Ball());
  assert.equal(world.shapeStateOf(shape).radius, 0.5);
});

test("body_is_made_with_its_shapes_or_not_at_all", () => {
  const world = engine.createWorld();
  const body = world.createBody({
    kind: "dynamic",
    shapes: [
      { kind: "circle", radius: 0.5, density: 2 },
      { kind: "obb", halfWidth: 1, halfHeight: 0.25, offset: [0, 1], angle: 0.5 },
      { kind: "aabb", halfWidth: 1, halfHeight: 1, offset: [3, 0] },
    ],
  });
  const shapes = world.shapesOf(body).map((shape) => world.shapeStateOf(shape));
  assert.deepEqual(shapes.map(({ kind }) => kind).sort(), ["aabb", "circle", "obb"]);
  assert.equal(shapes.find(({ kind }) => kind === "circle").density, 2);
  const before = [world.bodies(), world.shapes()];
  const make = (shape) => () => world.createBody({ shapes: [{ kind: "circle", radius: 1 }, shape] });
  assert.throws(make({ kind: "circle", radius: -1 }), { code: "invalid" });
  assert.throws(make({ kind: "aabb", halfwidth: 1 }), /halfwidth/);
  assert.throws(make({ kind: "terrain" }), /kind is circle, aabb or obb/);
  assert.deepEqual([world.bodies(), world.shapes()], before);
});
