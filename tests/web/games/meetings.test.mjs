/**
 * Tests world.meetings, which lists the pairs of a step by categories, and world.whatIf, which
 * plays steps and leaves the world as it was.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { thud } from "../support/package.mjs";

const engine = await thud.load();
const [WALL, BALL, GOAL] = [1, 2, 4];

function disc(world, category, x, vx, more = {}) {
  const shapes = [{ kind: "circle", radius: 0.5, category, restitution: 1, userData: 7, ...more }];
  const options = { velocity: [vx, 0], userData: 70 + category, shapes };
  return world.createBody({ kind: "dynamic", position: [x, 0], ...options });
}

function meet(world, a, b) {
  return [...world.eventPairs(a, b)].map((pair) => [pair.a.body.index, pair.b.body.index]);
}

test("meetings_are_of_the_kinds_asked_for_in_their_order", () => {
  const world = engine.createWorld({ gravity: [0, 0] });
  const [one, two] = [disc(world, BALL, 0, 2), disc(world, WALL, 1, 0)];
  const other = disc(world, BALL, -1, 2);
  world.step();
  assert.deepEqual([world.events().begin.length, world.events().hit.length], [2, 1]);
  const shape = (body) => world.shapesOf(body)[0];
  const side = (body, category) => {
    return { shape: shape(body), category, body, bodyData: 70 + category, shapeData: 7, sensor: false };
  };
  assert.deepEqual([...world.eventPairs(BALL, WALL)], [{ a: side(one, BALL), b: side(two, WALL) }]);
  assert.deepEqual([...world.eventPairs(WALL, BALL)], [{ a: side(two, WALL), b: side(one, BALL) }]);
  assert.equal(meet(world, BALL, BALL).length, 1);
  assert.equal(meet(world, BALL | GOAL, BALL | WALL).length, 2);
  assert.deepEqual(meet(world, GOAL, 0xffffffff), []);
  assert.deepEqual(meet(world, WALL, WALL), []);
  assert.ok(world.isValid(other));
  world.step();
  assert.deepEqual(meet(world, BALL, WALL), [], "they meet once");
});

test("meetings_tell_of_who_bounced_off_within_a_step_and_of_sensors", () => {
  const world = engine.createWorld({ gravity: [0, 0], detection: "swept" });
  const ball = disc(world, BALL, 0, 30);
  const wall = world.createBody({
    position: [3, 0],
    shapes: [{ kind: "aabb", halfWidth: 1, halfHeight: 1, restitution: 1 }],
  });
  const goal = world.createBody({
    shapes: [{ kind: "circle", radius: 1, offset: [-3, 0], sensor: true, category: GOAL }],
  });
  const told = { wall: 0, goal: 0 };
  for (let i = 0; i < 40; i++) {
    const [before] = world.velocityOf(ball).velocity;
    world.step();
    const turned = before > 0 && world.velocityOf(ball).velocity[0] < 0;
    const met = [...world.eventPairs(BALL, WALL)];
    if (!turned) continue;
    assert.deepEqual(met.map(({ a, b }) => [a.body, b.body]), [[ball, wall]]);
    assert.equal(world.events().begin.length, 0);
    told.wall++;
  }
  world.setVelocity(ball, [-30, 0]);
  world.setTransform(ball, [0, 0]);
  for (let i = 0; i < 10; i++) {
    world.step();
    for (const { a, b } of world.eventPairs(BALL, GOAL)) {
      assert.deepEqual([a.body, b.body, b.sensor], [ball, goal, true]);
      told.goal++;
    }
  }
  assert.deepEqual(told, { wall: 1, goal: 1 });
});

test("meetings_with_who_was_destroyed_are_none", () => {
  const world = engine.createWorld({ gravity: [0, 0] });
  const wall = disc(world, WALL, 1, 0);
  for (const y of [-0.2, 0.2])
    world.createCircle(disc(world, GOAL, 0, 1), { radius: 0.5, category: BALL, offset: [0, y] });
  world.step();
  let count = 0;
  for (const { b } of world.eventPairs(BALL, WALL)) {
    world.destroy(b.body);
    count++;
  }
  assert.equal(count, 1);
  assert.equal(world.isValid(wall), false);
  assert.deepEqual(meet(world, BALL, WALL), []);
  for (const [a, b] of [[-1.5, 1], [1, NaN], [2 ** 32, 1], [1, undefined]])
    assert.throws(() => world.eventPairs(a, b), { code: "invalid" });
  assert.deepEqual(meet(world, -1, 1 << 31), []);
});

test("what_if_returns_what_would_be_and_leaves_the_world_as_it_was", () => {
  const world = engine.createWorld();
  const ball = disc(world, BALL, 0, 2);
  world.step();
  const hash = world.hash();
  const [snapshot, steps] = [world.snapshot(), world.stats().steps];
  const there = world.whatIf(() => {
    for (let i = 0; i < 60; i++) world.step();
    disc(world, WALL, 9, 0);
    const inner = world.whatIf(() => world.destroy(ball));
    assert.equal(inner, undefined);
    return world.positionOf(ball);
  });
  assert.ok(there[1] < -4);
  assert.equal(world.hash(), hash);
  assert.deepEqual(world.snapshot(), snapshot);
  assert.equal(world.stats().steps, steps);
  const fail = () => {
    world.destroy(ball);
    throw new Error("lost");
  };
  assert.throws(() => world.whatIf(fail), /lost/);
  assert.ok(world.isValid(ball));
  assert.deepEqual(world.snapshot(), snapshot);
});
