/**
 * Tests the tyres of a car seen from above: they hold sideways, slide, drive and brake, and never
 * reverse a motion.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { thud } from "../support/package.mjs";

const { aabb, circle, obb } = thud;
const engine = await thud.load();
const STEP = 1 / 60;

/** A car of mass 8 that points along [0.8, 0.6]. */
function createCar(options = {}) {
  const world = engine.createWorld({ gravity: [0, 0] });
  const angle = Math.atan2(0.6, 0.8);
  const car = world.createBody({ kind: "dynamic", angle, shapes: [obb(2, 1)], ...options });
  return { world, car };
}

/** The velocity of a point in the car's frame, along and across the car. */
function speeds({ world, car }, at) {
  return world.localVector(car, world.velocityAt(car, world.worldPoint(car, at)));
}

function near(value, wanted, message) {
  assert.ok(Math.abs(value - wanted) <= 1e-5 * (1 + Math.abs(wanted)), `${message}: ${value}`);
}

for (const at of [[0, 0], [1.5, 0.7], [-1.5, 0.7]])
  for (const steer of [0, 0.5, 2.5])
    test(`tyre_at_${at}_steered_${steer}_stops_what_is_across_and_no_more`, () => {
      const one = createCar();
      one.world.setVelocity(one.car, [5, -3], 1.5);
      const slides = one.world.applyTyre(one.car, { at, steer, grip: 1e6 });
      const [x, y] = speeds(one, at);
      near(y * Math.cos(steer) - x * Math.sin(steer), 0, "across");
      near(slides, 0, "slides");
      assert.ok(Math.hypot(x, y) > 0.1);
    });

test("tyre_that_would_need_more_than_its_grip_slides", () => {
  const one = createCar();
  const { world, car } = one;
  world.setVelocity(car, world.worldVector(car, [3, 2]));
  const slides = world.applyTyre(car, { at: [0, 0], grip: 120 });
  const [along, across] = speeds(one, [0, 0]);
  near(along, 3, "along");
  near(across, 2 - (120 * STEP) / 8, "across");
  near(slides, across, "slides");
});

test("four_tyres_hold_a_car_that_slides_and_spins_and_never_shake_it", () => {
  const one = createCar();
  const { world, car } = one;
  world.setVelocity(car, world.worldVector(car, [0, 4]), 3);
  let last = Infinity;
  for (let i = 0; i < 60; i++) {
    for (const at of [[1.2, 0.7], [1.2, -0.7], [-1.2, 0.7], [-1.2, -0.7]])
      world.applyTyre(car, { at, grip: 40 });
    world.step();
    const { velocity, angularVelocity } = world.velocityOf(car);
    const energy = 8 * Math.hypot(...velocity) ** 2 + world.bodyStateOf(car).inertia * angularVelocity ** 2;
    assert.ok(energy <= last + 1e-6, `${energy} after ${last}`);
    last = energy;
  }
  near(speeds(one, [1.2, 0])[1], 0, "front");
  near(speeds(one, [-1.2, 0])[1], 0, "rear");
});

test("thrust_drives_and_brake_stops_without_going_back", () => {
  const one = createCar();
  const { world, car } = one;
  const speed = () => speeds(one, [0, 0])[0];
  const roll = (tyre) => world.applyTyre(car, { at: [0, 0], grip: 1e4, ...tyre });
  roll({ thrust: 96 });
  near(speed(), 0.2, "thrust");
  roll({ thrust: -48 });
  near(speed(), 0.1, "thrust back");
  roll({ brake: 24 });
  near(speed(), 0.05, "brake");
  roll({ brake: 1000 });
  near(speed(), 0, "brake to a stop");
  roll({ thrust: 96, brake: 1000 });
  near(speed(), 0, "thrust against the brake");
  roll({ thrust: 480, grip: 96 });
  near(speed(), 0.2, "thrust beyond the grip");
  world.setVelocity(car, world.worldVector(car, [1, 1]));
  roll({ brake: 96, grip: 96 });
  near(speeds(one, [0, 0])[1], 1, "no grip is left across");
});

test("tyres_act_in_the_world's_step_whatever_its_length", () => {
  const one = createCar();
  one.world.setTimeStep(0.1);
  one.world.applyTyre(one.car, { at: [0, 0], thrust: 8, grip: 100 });
  near(speeds(one, [0, 0])[0], 0.1, "speed");
});

test("body_that_cannot_turn_is_held_as_a_whole_and_one_at_rest_sleeps_on", () => {
  const one = createCar({ shapes: [aabb(1, 1)], angle: 0 });
  const { world, car } = one;
  world.setVelocity(car, [0, 2]);
  near(world.applyTyre(car, { at: [1, 1], grip: 1e6 }), 0, "slides");
  assert.deepEqual(world.velocityOf(car), { velocity: [0, 0], angularVelocity: 0 });
  for (let i = 0; i < 120; i++) {
    world.step();
    world.applyTyre(car, { at: [1, 1], brake: 10, grip: 10 });
  }
  assert.deepEqual(world.awakeBodies(), []);
  world.applyTyre(car, { at: [1, 1], thrust: 10, grip: 10 });
  assert.deepEqual(world.awakeBodies(), [car]);
});

test("grip_brings_a_point_to_a_speed_along_an_axis_as_far_as_it_can", () => {
  const { world, car } = createCar({ angle: 0 });
  world.setVelocity(car, [3, 2], 0);
  world.applyGrip(car, [0, 0], [0, 1], 0, 1e6);
  world.step();
  const { velocity } = world.velocityOf(car);
  assert.ok(Math.abs(velocity[0] - 3) < 1e-4 && Math.abs(velocity[1]) < 1e-4, `${velocity}`);
  world.applyGrip(car, [0, 0], [1, 0], -5, 60 * world.bodyStateOf(car).mass);
  world.step();
  assert.ok(Math.abs(world.velocityOf(car).velocity[0] - 2) < 1e-4);
  assert.throws(() => world.applyGrip(car, [0, 0], [0, 0], 0, 1), { code: "invalid" });
  assert.throws(() => world.applyGrip(car, [0, 0], [1, 0], 0, -1), /maxForce must be from 0 to 1e30: -1/);
  world.close();
});

test("static_and_kinematic_bodies_are_left_alone", () => {
  const world = engine.createWorld();
  const ground = world.createBody({ shapes: [circle(1)] });
  const lift = world.createBody({ kind: "kinematic", velocity: [1, 2], shapes: [circle(1)] });
  for (const body of [ground, lift]) world.applyTyre(body, { at: [0, 0], thrust: 10, grip: 10 });
  assert.equal(world.applyTyre(lift, { at: [0, 0], grip: 10 }), 2);
  assert.deepEqual(world.velocityOf(lift).velocity, [1, 2]);
  assert.deepEqual(world.velocityOf(ground).velocity, [0, 0]);
});

test("wrong_tyres_are_refused_and_push_nothing", () => {
  const { world, car } = createCar();
  const hash = world.hash();
  for (const [tyre, message] of [
    [{ grip: 1 }, /^applyTyre: at must be two numbers .* it is missing/],
    [{ at: [0, 0] }, /^applyTyre: grip must be from 0 to 1e30: it is missing/],
    [{ at: [0, 0], grip: -1 }, /^applyTyre: grip must be from 0 to 1e30: -1/],
    [{ at: null, grip: 1 }, /^applyTyre: at must be two numbers: null/],
    [{ at: [0, 0], grip: 1, steering: 1 }, /"steering"; the nearest is "steer"/],
  ])
    assert.throws(() => world.applyTyre(car, tyre), { name: "ThudError", code: "invalid", message });
  assert.equal(world.hash(), hash);
  world.destroy(car);
  assert.throws(() => world.applyTyre(car, { at: [0, 0], grip: 1 }), { code: "stale" });
});

test("tyre_on_a_body_whose_velocity_is_infinite_is_refused", () => {
  const { world, car } = createCar();
  for (let i = 0; i < 12; i++) world.applyImpulse(car, [3e38, 0], world.bodyStateOf(car).center);
  const before = world.velocityOf(car);
  const roll = () => world.applyTyre(car, { at: [0, 0], brake: 10, grip: 10 });
  assert.throws(roll, { code: "invalid", message: /apply tyre: the body's velocity is not finite/ });
  assert.deepEqual(world.velocityOf(car), before);
});
