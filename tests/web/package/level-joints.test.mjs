/**
 * Tests joints of Tiled maps in TypeScript: the data that are read, the joints in a world, and that
 * both are as in the C reader.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { level, readLevelFile, thud } from "../support/package.mjs";

const engine = await thud.load();
const { buildLevel, LevelError, readLevel } = level;

const dynamic = { name: "body", value: "dynamic" };
const refersTo = (values) =>
  Object.entries(values).map(([name, value]) => ({ name, type: "object", value }));
/** A map with two dynamic boxes, 1 and 2, a static one, 3, and these objects. */
const mapOf = (...objects) =>
  JSON.stringify({
    type: "map",
    width: 20,
    height: 10,
    tilewidth: 32,
    tileheight: 32,
    layers: [
      {
        type: "objectgroup",
        name: "o",
        objects: [
          { id: 1, x: 64, y: 64, width: 32, height: 32, properties: [dynamic] },
          { id: 2, x: 200, y: 40, width: 64, height: 16, rotation: 30, properties: [dynamic] },
          { id: 3, x: 0, y: 300, width: 640, height: 20 },
          ...objects,
        ],
      },
    ],
  });
const joint = (type, refers, values = {}, rest = { point: true }) => ({
  id: 9,
  type,
  x: 96,
  y: 48,
  ...rest,
  properties: [
    ...refersTo(refers),
    ...Object.entries(values).map(([name, value]) => ({ name, value })),
  ],
});
const line = { polyline: [{ x: 0, y: 0 }, { x: 96, y: -128 }] };
const both = { a: 1, b: 2 };

async function problemsOf(text) {
  const error = await readLevel("test", text).then(() => null, (reason) => reason);
  assert.ok(error instanceof LevelError, String(error));
  return error.problems.map((problem) => problem.text);
}

for (const kind of ["hinge", "slider", "weld", "wheel", "target", "filter"])
  test(`object_of_class_${kind}_is_one_between_its_bodies`, async () => {
    const read = await readLevel("test", mapOf(joint(kind, both)));
    assert.deepEqual(read.problems, []);
    assert.equal(read.joints.length, 1);
    const [{ a, b, options }] = read.joints;
    assert.deepEqual([a, b, options.kind], [0, 1, kind]);
    const world = buildLevel(engine, read);
    const [made] = world.joints();
    const state = world.jointStateOf(made);
    assert.equal(state.kind, kind);
    assert.ok(kind === "filter" || state.gap < 1e-6);
    world.close();
  });

test("line_is_a_distance_and_a_rope_is_as_long", async () => {
  const rope = joint("distance", both, { along_lower: 0 }, line);
  const [{ options }] = (await readLevel("test", mapOf(rope))).joints;
  assert.equal(options.length, 5);
  assert.deepEqual([options.along.lower, options.along.upper], [0, 5]);
  const spring = joint("distance", both, { along_frequency: 2 }, line);
  const { along } = (await readLevel("test", mapOf(spring))).joints[0].options;
  assert.deepEqual([along.target, along.frequency, along.lower], [5, 2, undefined]);
});

test("joint_without_a_holds_to_a_body_without_shapes", async () => {
  const read = await readLevel("test", mapOf(joint("hinge", { b: 1 })));
  assert.equal(read.bodies.length, 4);
  assert.deepEqual(read.bodies[3].shapes, []);
  assert.deepEqual(read.bodies[3].body.position, [3, 8.5]);
  assert.deepEqual([read.joints[0].a, read.joints[0].b], [3, 0]);
});

test("gear_comes_after_the_joints_that_it_ties", async () => {
  const axle = (id, b) => ({ ...joint("hinge", { b }), id });
  const gear = joint("gear", { a: 11, b: 10 }, { ratio: -2.5 });
  const read = await readLevel("test", mapOf(gear, axle(10, 1), axle(11, 2)));
  const { a, b, options } = read.joints[2];
  assert.deepEqual([a, b, options.kind, options.ratio], [1, 0, "gear", -2.5]);
  const world = buildLevel(engine, read);
  assert.equal(world.joints().length, 3);
  world.close();
});

for (const [what, object, expected] of [
  ["hinge_without_b", joint("hinge", { a: 1 }), /object 9: a hinge needs b/],
  ["hinge_of_nothing", joint("hinge", { a: 1, b: 77 }), /object 9: b refers to object 77, which is no body/],
  ["hinge_of_one_body", joint("hinge", { a: 1, b: 1 }), /object 9: a and b are the same object/],
  ["hinge_of_what_stands", joint("hinge", { b: 3 }), /object 9: a hinge needs one dynamic body/],
  ["gear_of_bodies", joint("gear", both), /object 9: a refers to object 1, which is no joint/],
  ["distance_at_a_point", joint("distance", both), /object 9: a distance is drawn as a line/],
  ["turn_in_degrees", joint("hinge", both, { turn_upper: 90 }), /object 9: turn_upper is out of range/],
  ["class_of_an_object_of_javascript", joint("constructor", both), null],
])
  test(`${what}_is_told`, async () => {
    if (expected) assert.match((await problemsOf(mapOf(object))).join("\n"), expected);
    const read = await readLevel("test", mapOf(object), { skip: true });
    assert.equal(read.joints.length, 0);
    buildLevel(engine, read).close();
  });

test("wheel_of_the_playgrounds_car_turns_and_carries_it_over_both_bridges", async () => {
  const world = buildLevel(engine, await readLevel("playground", readLevelFile("playground.tmj")));
  const wheels = world.joints().filter((id) => world.jointStateOf(id).kind === "wheel");
  assert.equal(wheels.length, 2);
  const { bodyA: car } = world.jointStateOf(wheels[0]);
  const start = world.bodyStateOf(car).position[0];
  for (let i = 0; i < 720; i++) world.step();
  assert.ok(start < 25 && world.bodyStateOf(car).position[0] > 52);
  world.close();
});
