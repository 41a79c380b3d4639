/**
 * Tests Mover.walk: movers fall, jump and land by the world's gravity, and keep the speed of what
 * carried them when they leave it.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { thud } from "../support/package.mjs";

const { aabb, circle, Mover, Rollback } = thud;
const engine = await thud.load();
const STEP = 1 / 60;
const FLOOR = aabb(50, 1, { offset: [0, -1] });

function start(shapes = [FLOOR], options = {}, gravity = [0, -10]) {
  const world = engine.createWorld({ gravity });
  world.createBody({ shapes });
  const hero = new Mover(world, { shape: circle(0.5), position: [0, 0.51], ...options });
  const walk = (how, steps) => {
    let report;
    for (let i = 0; i < steps; i++) {
      world.step();
      report = hero.walk(how);
    }
    return report;
  };
  return { world, hero, walk };
}

function near(value, wanted, error, message) {
  assert.ok(Math.abs(value - wanted) <= error, `${message}: ${value}, not ${wanted}`);
}

test("walker_falls_as_gravity_has_it_and_lands", () => {
  for (const gravityScale of [1, 2, 0.5]) {
    const { hero, walk } = start([FLOOR], { position: [0, 20], gravityScale });
    const { velocity, position } = walk({}, 30);
    near(velocity[1], -10 * gravityScale * 30 * STEP, 1e-5, "speed");
    near(position[1], 20 - 10 * gravityScale * ((30 * 31) / 2) * STEP * STEP, 1e-4, "height");
    const { ground } = walk({}, 200);
    assert.ok(ground);
    near(hero.position[1], 0.51, 0.01, "on the floor");
  }
});

test("jump_rises_to_its_height_once_however_long_it_is_asked_for", () => {
  const { hero, walk } = start();
  walk({}, 5);
  let [top, jumps, stood] = [0, 0, true];
  for (let i = 0; i < 100; i++) {
    const { ground } = walk({ jump: 6 }, 1);
    if (stood && !ground) jumps++;
    stood = ground !== null;
    top = Math.max(top, hero.position[1]);
  }
  near(top, 0.51 + 36 / 20, 0.1, "top");
  assert.equal(jumps, 2, "1.2 s each");
});

test("ceiling_ends_the_rise_and_who_is_in_the_air_does_not_jump", () => {
  const { hero, walk } = start([FLOOR, aabb(5, 0.5, { offset: [0, 2.5] })]);
  walk({}, 5);
  walk({ jump: 9 }, 1);
  const { velocity } = walk({ jump: 9 }, 10);
  assert.ok(velocity[1] <= 0, `${velocity}`);
  assert.ok(hero.position[1] < 1.5);
});

test("walker_goes_up_and_down_slopes_on_the_ground_and_off_ledges", () => {
  const world = engine.createWorld();
  const points = [[-5, 0], [2, 0], [6, 2], [10, 0], [14, 0]];
  world.createTerrain(world.createBody(), { kind: "irregular", points });
  const hero = new Mover(world, { shape: circle(0.5), position: [0, 0.51] });
  hero.walk();
  for (let i = 0; i < 150; i++) {
    world.step();
    assert.ok(hero.walk({ speed: 5 }).ground, `step ${i}, ${hero.position}`);
  }
  assert.ok(hero.position[0] > 11.5);
  for (let i = 0; i < 60; i++) hero.walk({ speed: 5 });
  assert.ok(hero.position[1] < -0.5, "off the end");
});

test("who_jumps_off_what_moves_keeps_its_speed_until_a_wall", () => {
  const { world, hero } = start([aabb(1, 99, { offset: [12, 0] })], { position: [0, 2] });
  const train = world.createBody({
    kind: "kinematic",
    position: [0, 1],
    velocity: [3, 1],
    shapes: [aabb(2, 0.4)],
  });
  const step = (how) => {
    world.step();
    return hero.walk(how);
  };
  for (let i = 0; i < 10; i++) step();
  const ahead = () => hero.position[0] - world.positionOf(train)[0];
  const before = ahead();
  for (let i = 0; i < 20; i++) step();
  near(ahead(), before, 1e-4, "carried");
  const { velocity } = step({ jump: 5, speed: 1 });
  world.destroy(train);
  near(velocity[0], 4, 1e-4, "speed to the right");
  near(velocity[1], 6, 1e-4, "speed upward");
  const [from] = hero.position;
  for (let i = 0; i < 20; i++) step({ speed: 1 });
  near(hero.position[0] - from, (20 * 4) / 60, 0.01, "in the air");
  for (let i = 0; i < 200; i++) step({ speed: 1 });
  assert.equal(hero.state().drift, 0, "the wall has it");
  near(hero.position[0], 10.49, 0.01, "at the wall");
});

test("walker_drops_through_planks_where_it_is_told_to", () => {
  const { hero, walk } = start([FLOOR, aabb(2, 0.1, { offset: [0, 2], category: 2 })], { oneWay: 2 });
  walk({}, 2);
  walk({ jump: 8 }, 1);
  assert.ok(walk({}, 90).ground);
  near(hero.position[1], 2.61, 0.01, "on the plank");
  walk({ drop: true }, 10);
  assert.ok(walk({}, 60).ground);
  near(hero.position[1], 0.51, 0.01, "on the floor");
});

test("up_and_gravity_may_point_anywhere", () => {
  const { hero, walk } = start(
    [aabb(1, 50, { offset: [-1, 0] })],
    { up: [1, 0], position: [2, 0] },
    [-10, 0],
  );
  assert.ok(walk({}, 60).ground);
  walk({ speed: 3 }, 60);
  near(hero.position[0], 0.51, 0.01, "on the wall");
  near(hero.position[1], -3, 0.01, "to the right");
});

test("walker_put_back_or_played_again_goes_the_same_way", () => {
  const { world, hero, walk } = start();
  walk({ speed: 2 }, 3);
  walk({ speed: 2, jump: 7 }, 5);
  const [snapshot, state] = [world.snapshot(), structuredClone(hero.state())];
  assert.ok(state.rise > 5);
  const end = walk({ speed: 2 }, 40);
  world.restore(snapshot);
  hero.restore(state);
  assert.deepEqual(walk({ speed: 2 }, 40), end);
  hero.place([0, 9]);
  assert.equal(hero.state().rise, 0);

  const step = ([held]) => {
    world.step();
    hero.walk({ speed: held, jump: 5 });
  };
  const rollback = new Rollback(world, { idle: [1], step, movers: [hero] });
  for (let i = 0; i < 50; i++) rollback.advance();
  rollback.input(0, 0, 2);
  rollback.input(0, 20, 1);
  rollback.settle();
  near(hero.position[0], (20 * 2 + 30) / 60, 0.02, "as told later");
});

test("wrong_walks_are_refused_and_move_nothing", () => {
  const { world, hero } = start();
  const state = hero.state();
  for (const [walk, message] of [
    [{ speed: NaN }, /^walk: speed must be a finite number: NaN/],
    [{ jump: -1 }, /^walk: jump must be 0 or more: -1/],
    [{ jumps: 9 }, /"jumps"; the nearest is "jump"/],
    [{ speed: 1e12 }, /walk|move/],
  ])
    assert.throws(() => hero.walk(walk), { name: "ThudError", code: "invalid", message });
  assert.deepEqual(hero.state(), state);
  const above = new Mover(world, { shape: circle(0.5), position: [0, 5], up: [0, 0] });
  assert.throws(() => above.walk(), { code: "invalid", message: /up is \[0, 0\]/ });
});
