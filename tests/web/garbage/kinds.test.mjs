/**
 * Tests that a method for one kind of handle refuses handles of all other kinds, as objects and as
 * numbers.
 */
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { test } from "node:test";
import { root, thud } from "../support/package.mjs";

const { handleOf, numberOf } = thud;
const engine = await thud.load();
const dist = `${root}web/package/dist/`;
const typings = readdirSync(dist, { recursive: true })
  .filter((file) => /(^|\/)world[\w-]*\.d\.ts$/.test(file))
  .map((file) => readFileSync(`${dist}${file}`, "utf8"))
  .join("\n");

/** Every method whose first argument is of one kind: [name, kind], read from the typings. */
const METHODS = [...typings.matchAll(/^ {4}(\w+)\(\w+: (Body|Shape|Joint)Ref\b(?! \|)/gm)].map(
  ([, name, kind]) => [name, kind.toLowerCase()],
);

/** Further arguments of methods that check them before the handle; others get [0, 1] and [0, 1]. */
const REST = {
  ...Object.fromEntries(
    ["Awake", "Enabled", "Events", "FixedRotation", "JointEnabled", "MaySleep", "Sensor"].map((name) => [
      `set${name}`,
      [true],
    ]),
  ),
  applyBuoyancy: [{ point: [0, 0], density: 1 }],
  applyTyre: [{ at: [0, 0], grip: 1 }],
  applyWind: [[1, 0], {}],
  createAabb: [{ halfWidth: 1, halfHeight: 1 }],
  createCircle: [{ radius: 1 }],
  createObb: [{ halfWidth: 1, halfHeight: 1 }],
  createTerrain: [{ kind: "flat" }],
  replaceRange: [0, 1, [[0, 0]]],
  setTexture: [{ vertices: [0.5, 0.5] }],
  setDetection: ["swept"],
  setDrive: ["turn", {}],
  setFilter: [{ mask: 1 }],
  setHeights: [0, [1]],
  setJointBreaking: [{ breakForce: 1 }],
  setJointFrame: ["a", {}],
  setJointUserData: [1],
  setKind: ["dynamic"],
  setLocks: [{ x: true }],
  setMass: [{ mass: 1, inertia: 1 }],
};

/** Two bodies with one shape each and a joint: handles of all kinds have the same slots. */
function makeWorld() {
  const world = engine.createWorld();
  const shapes = [{ kind: "circle", radius: 0.5 }];
  const bodies = world.createBodies({ kind: "dynamic", shapes }, [[0, 0], [3, 0]]);
  const joint = world.createJoint({ kind: "distance", bodyA: bodies[0], bodyB: bodies[1] });
  return { world, body: bodies[0], shape: world.shapesOf(bodies[0])[0], joint };
}

test("methods_of_one_kind_are_found", () => {
  assert.ok(METHODS.length > 60, `${METHODS}`);
  for (const name of ["setVelocity", "setFriction", "setDrive", "sensorOverlapsOf", "groundAt", "createTerrain"])
    assert.ok(METHODS.some(([one]) => one === name), name);
});

for (const [method, kind] of METHODS)
  test(`${method}_takes_no_handle_but_a_${kind}s`, () => {
    const { world, ...ids } = makeWorld();
    const before = world.hash();
    const rest = REST[method] ?? [[0, 1], [0, 1]];
    for (const other of ["body", "shape", "joint"].filter((one) => one !== kind))
      for (const id of [ids[other], numberOf(ids[other])])
        assert.throws(() => world[method](id, ...rest), {
          code: "invalid",
          message: `this is a ${other}, a ${kind} is wanted`,
        });
    const none = [{ index: 0, generation: ids[kind].generation }, "ball", null];
    for (const id of none)
      assert.throws(() => world[method](id, ...rest), { code: "null", message: /^this is no handle: / });
    assert.equal(world.hash(), before);
    world.close();
  });

test("calls_for_several_kinds_refuse_what_is_none_of_them_or_told_wrong", () => {
  const { world, body, shape, joint } = makeWorld();
  const wanted = (a, b) => ({ code: "invalid", message: `this is a ${a}, a ${b} is wanted` });
  for (const of of [(id) => id, numberOf]) {
    assert.throws(() => world.destroy(of(shape), "body"), wanted("shape", "body"));
    assert.throws(() => world.isValid(of(shape), "joint"), wanted("shape", "joint"));
    assert.throws(() => world.setUserData(of(joint), 1), wanted("joint", "body"));
    assert.throws(() => world.userDataOf(of(joint)), wanted("joint", "body"));
    assert.throws(() => world.castRay([0, 5], [0, -9], { ignore: of(shape) }), wanted("shape", "body"));
    assert.throws(
      () => world.createJoint({ kind: "weld", bodyA: of(body), bodyB: of(shape), at: [0, 0] }),
      /this is a shape, a body is wanted|bodyB must be a body/,
    );
    const mover = { shape: { kind: "circle", radius: 1 }, position: [0, 9], body: of(joint) };
    assert.throws(() => new thud.Mover(world, mover), wanted("joint", "body"));
    world.setUserData(of(shape), 3);
    assert.deepEqual([world.userDataOf(of(shape)), world.userDataOf(of(body))], [3, 0]);
  }
  assert.throws(() => world.pairOf({ a: body, b: shape }), wanted("body", "shape"));
  assert.throws(() => handleOf(numberOf(shape), "body"), wanted("shape", "body"));
  for (const id of [joint, shape, body]) {
    world.destroy(numberOf(id));
    assert.equal(world.isValid(numberOf(id)), false);
  }
  assert.deepEqual([world.isValid(0), world.bodies().length], [false, 1]);
  world.close();
});

test("spawn_beyond_what_numbers_name_leaves_nothing", () => {
  const world = engine.createWorld();
  const options = {};
  for (let i = 1; i < 0x80000; i++) world.spawn(options);
  assert.throws(() => world.spawn(options), /only the first 524287 of a kind have numbers/);
  assert.equal(world.bodies().length, 0x7ffff);
  world.close();
});
