/**
 * Tests numbers in place of handles: the same calls give the same results, and stale numbers are
 * refused.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { thud } from "../support/package.mjs";

const { handleOf, numberAt, numberOf } = thud;
const engine = await thud.load();
const circle = { kind: "circle", radius: 0.5 };

test("number_of_a_handle_is_safe_and_turns_back_into_it", () => {
  const world = engine.createWorld();
  const body = world.createBody({ kind: "dynamic", shapes: [circle] });
  const [shape] = world.shapesOf(body);
  for (const id of [body, shape]) {
    const number = numberOf(id);
    assert.ok(Number.isSafeInteger(number) && number > 0);
    assert.deepEqual(handleOf(number, id.kind), id);
    assert.deepEqual(handleOf(number), id);
    assert.equal(numberAt([id.index + 1, id.generation], 0, id.kind), number);
  }
  const last = { kind: "joint", index: 0x7fffe, generation: 0xffffffff };
  assert.equal(numberOf(last), Number.MAX_SAFE_INTEGER);
  for (const kind of ["body", "shape", "joint"]) {
    const one = { ...last, kind };
    assert.deepEqual(handleOf(numberOf(one), kind), one);
    assert.throws(() => numberOf({ ...one, index: 0x7ffff }), { code: "invalid" });
    assert.equal(numberAt([0, 0], 0, kind), 0);
  }
  assert.throws(() => numberAt([1, 1], 0), /a kind is "body", "shape" or "joint": undefined/);
  world.close();
});

test("world_made_and_moved_by_numbers_is_that_made_by_handles", () => {
  const run = (make, refer) => {
    const world = engine.createWorld();
    world.createTerrain(refer(world.createBody()), { kind: "flat" });
    const bodies = Array.from({ length: 4 }, (_, i) =>
      make(world, { kind: "dynamic", position: [i, 2 + i], shapes: [circle] }),
    );
    world.createJoint({ kind: "hinge", bodyA: bodies[2], bodyB: bodies[3], at: [2.5, 4.5] });
    for (let i = 0; i < 60; i++) {
      world.applyCenterForce(bodies[0], [1, 0]);
      world.applyImpulse(bodies[1], [0.01, 0], [1, 3]);
      world.step();
    }
    world.destroy(bodies[0], "body");
    world.step();
    const hash = world.hash();
    world.close();
    return hash;
  };
  const byHandles = run((world, options) => world.createBody(options), (id) => id);
  assert.equal(run((world, options) => world.spawn(options), numberOf), byHandles);
});

test("reads_by_number_are_those_by_handle", () => {
  const world = engine.createWorld();
  const body = world.createBody({ kind: "dynamic", position: [1, 2], angle: 0.5, shapes: [circle] });
  const number = numberOf(body);
  world.setVelocity(number, [3, 4], 5);
  world.setUserData(number, 7, "body");
  assert.deepEqual(world.bodyStateOf(number), world.bodyStateOf(body));
  const [shape] = world.shapesOf(number);
  assert.deepEqual(world.bodyOf(numberOf(shape)), body);
  assert.deepEqual([world.userDataOf(number, "body"), world.isValid(number, "body")], [7, true]);
  const into = new Float64Array(6);
  world.motionOf(number, into);
  const { velocity, angularVelocity } = world.velocityOf(body);
  const angle = world.rotationOf(body).angle;
  assert.deepEqual([...into], [...world.positionOf(body), angle, ...velocity, angularVelocity]);
  const pair = [0, 0];
  assert.equal(world.worldPoint(number, [1, 0], pair), pair);
  assert.deepEqual(pair, world.worldPoint(body, [1, 0]));
  const hit = world.castRay([1, 9], [0, -9]);
  assert.ok(world.castRayInto([1, 9], [0, -9], null, into));
  const told = [numberOf(hit.shape), ...hit.point, ...hit.normal, hit.fraction];
  assert.deepEqual([...into], told);
  assert.equal(world.castRayInto([1, 9], [0, -9], { ignore: number }, into), false);
  world.close();
});

test("number_that_is_stale_foreign_or_none_is_refused", () => {
  const world = engine.createWorld();
  const other = engine.createWorld();
  const number = world.spawn({ kind: "dynamic", shapes: [circle] });
  assert.throws(() => other.applyCenterForce(number, [1, 0]), { code: "stale" });
  world.destroy(number);
  for (const none of [number, 0, -1, 0.5, NaN, Infinity, 2 ** 60])
    assert.throws(() => world.applyCenterForce(none, [1, 0]), { code: "stale" }, String(none));
  for (const none of [undefined, null, "ball"])
    assert.throws(() => world.applyCenterForce(none, [1, 0]), { name: "ThudError", code: "null" });
  assert.equal(world.isValid(number, "body"), false);
  assert.throws(() => world.spawn({ kind: "dynamic", shapes: [{ ...circle, radius: 0 }] }), /radius/);
  assert.deepEqual(world.bodies(), []);
  for (const one of [world, other]) one.close();
});
