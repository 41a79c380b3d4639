/** Compares each kind of joint in the npm package with a formula. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { near, yard } from "../support/joints.mjs";

const DT = 1 / 60;
const G = 10;

/**
 * The period in seconds: the time between the first and the last upward zero crossing of `read`,
 * over the number of periods.
 */
function periodOf(world, read, seconds) {
  const rises = [];
  for (let i = 0, before = read(); i < seconds / DT; i++) {
    world.step();
    const now = read();
    if (before < 0 && now >= 0) rises.push(DT * (i + 1 - now / (now - before)));
    before = now;
  }
  assert.ok(rises.length > 3, `${rises.length} rises`);
  return (rises.at(-1) - rises[0]) / (rises.length - 1);
}

test("hinge_swings_with_the_period_of_a_pendulum", (t) => {
  const { world, hook, ball } = yard(t, { quality: "high" });
  const [length, radius, swing] = [2, 0.3, 0.1];
  const position = [length * Math.sin(swing), 5 - length * Math.cos(swing)];
  const [bodyA, bodyB] = [hook([0, 5]), ball(position, radius, { angle: swing })];
  const joint = world.createJoint({ kind: "hinge", bodyA, bodyB, at: [0, 5] });
  const period = periodOf(world, () => world.bodyStateOf(bodyB).position[0], 15);
  const arm = (radius ** 2 / 2 + length ** 2) / length;
  near(period, 2 * Math.PI * Math.sqrt(arm / G) * (1 + swing ** 2 / 16), 0.005);
  near(world.jointStateOf(joint).gap, 0, 1e-3);
});

test("spring_swings_with_its_frequency_about_its_target", (t) => {
  const { world, hook, ball } = yard(t, { quality: "high", gravity: [0, 0] });
  const [bodyA, bodyB] = [hook([0, 0]), ball([3.5, 0])];
  const along = { frequency: 1.5, damping: 0, target: 3 };
  const joint = world.createJoint({ kind: "distance", bodyA, bodyB, along });
  near(periodOf(world, () => world.jointStateOf(joint).value.along - 3, 6), 1 / 1.5, 0.01);
});

test("rod_keeps_what_was_between_its_ends_and_takes_another_length", (t) => {
  const { world, hook, ball, run } = yard(t);
  const [bodyA, bodyB] = [hook([0, 5]), ball([0, 3])];
  const ends = { from: [0, 4.5], to: [0, 3.1] };
  const joint = world.createJoint({ kind: "distance", bodyA, bodyB, ...ends });
  near(world.jointOptionsOf(joint).length, 1.4, 1e-6);
  run(60);
  near(world.jointStateOf(joint).value.along, 1.4, 0.01);
  world.setJointLength(joint, 0.9);
  run(120);
  near(world.bodyStateOf(bodyB).position[1], 4.5 - 0.9 - 0.1, 0.01);
});

test("rope_is_slack_until_its_length_and_bears_the_weight_there", (t) => {
  const { world, hook, ball, run } = yard(t);
  const [bodyA, bodyB] = [hook([0, 5]), ball([0, 4])];
  const along = { upper: 2 };
  const joint = world.createJoint({ kind: "distance", bodyA, bodyB, along });
  run(12);
  near(world.bodyStateOf(bodyB).velocity[1], -G * 12 * DT, 1e-4, "falls freely");
  run(240);
  near(world.jointStateOf(joint).value.along, 2, 0.01);
  const weight = world.bodyStateOf(bodyB).mass * G;
  near(world.jointStateOf(joint).force[1], weight, 0.01 * weight);
});

test("slider_moves_on_its_axis_alone_and_stops_at_its_limit", (t) => {
  const { world, hook, box, run } = yard(t);
  const [bodyA, bodyB] = [hook([0, 5]), box([1, 6], 0.2, 0.4)];
  const slope = { at: [1, 6], axis: [1, 1], along: { lower: -1.5, upper: 2 } };
  const joint = world.createJoint({ kind: "slider", bodyA, bodyB, ...slope });
  run(18);
  const speed = world.bodyStateOf(bodyB).velocity;
  near(speed[0], speed[1], 0.02);
  near(Math.hypot(...speed), G * Math.SQRT1_2 * 18 * DT, 0.05);
  run(240);
  const { value, gap } = world.jointStateOf(joint);
  near(value.along, -1.5, 0.01);
  near(value.across, 0, 0.01);
  assert.ok(gap < 0.01);
  near(world.bodyStateOf(bodyB).position[1], 6 - 1.5 * Math.SQRT1_2, 0.01);
  near(world.bodyStateOf(bodyB).angle, 0, 0.01);
});

test("weld_holds_a_beam_level_and_tells_its_weight_and_torque", (t) => {
  const { world, hook, box, run } = yard(t);
  const [bodyA, bodyB] = [hook([0, 5], { angle: 0.7 }), box([1, 5], 1, 0.1)];
  const joint = world.createJoint({ kind: "weld", bodyA, bodyB, at: [0, 5] });
  run(180);
  const { force, torque, value, angleGap } = world.jointStateOf(joint);
  const weight = world.bodyStateOf(bodyB).mass * G;
  near(value.turn, 0, 0.005);
  assert.ok(angleGap < 0.005);
  near(force[1], weight, 0.02 * weight);
  near(torque, weight, 0.02 * weight);
});

test("motor_turns_at_its_speed_and_no_harder_than_its_torque", (t) => {
  const { world, hook, ball, run } = yard(t);
  const [bodyA, bodyB] = [hook([0, 5]), ball([0, 5], 0.5)];
  const turn = { motorSpeed: 6, motorForce: 0.5 };
  const joint = world.createJoint({ kind: "hinge", bodyA, bodyB, at: [0, 5], turn });
  const { inertia } = world.bodyStateOf(bodyB);
  run(12);
  near(world.bodyStateOf(bodyB).angularVelocity, (0.5 / inertia) * 12 * DT, 0.01);
  near(world.jointStateOf(joint).torque, 0.5, 1e-3);
  run(120);
  near(world.bodyStateOf(bodyB).angularVelocity, 6, 1e-3);
  world.setDrive(joint, "turn", { motorSpeed: -2 });
  run(240);
  near(world.bodyStateOf(bodyB).angularVelocity, -2, 1e-3, "the same torque, the other way");
});

test("wheel_sinks_into_its_spring_by_the_formula_and_turns", (t) => {
  const { world, hook, ball, run } = yard(t);
  const [bodyA, bodyB] = [hook([0, 5]), ball([0, 4], 0.3)];
  const along = { frequency: 2, damping: 1 };
  const turn = { motorSpeed: 4, motorForce: 5 };
  const joint = world.createJoint({ kind: "wheel", bodyA, bodyB, at: [0, 4], along, turn });
  run(240);
  near(world.jointStateOf(joint).value.along, -G / (2 * Math.PI * 2) ** 2, 0.003);
  near(world.bodyStateOf(bodyB).position[0], 0, 0.003);
  near(world.bodyStateOf(bodyB).angularVelocity, 4, 1e-3);
});

test("target_is_followed_where_its_frame_is_put_and_no_harder_than_its_force", (t) => {
  const { world, hook, ball, run } = yard(t);
  const [bodyA, bodyB] = [hook([0, 0]), ball([0, 0], 0.3)];
  const weight = world.bodyStateOf(bodyB).mass * G;
  const spring = { frequency: 5, damping: 1, springForce: 3 * weight };
  const springs = { along: spring, across: spring };
  const joint = world.createJoint({ kind: "target", bodyA, bodyB, at: [0, 0], ...springs });
  run(60);
  world.setJointFrame(joint, "a", { position: [3, 2] });
  assert.deepEqual(world.jointOptionsOf(joint).frameA, { position: [3, 2], angle: 0 });
  run(1);
  near(Math.hypot(...world.jointStateOf(joint).force), 3 * weight, 0.01 * weight);
  run(240);
  const [x, y] = world.bodyStateOf(bodyB).position;
  near(x, 3, 0.01);
  near(y, 2 - G / (2 * Math.PI * 5) ** 2, 0.01);
});

test("filter_and_every_other_joint_keep_two_bodies_from_meeting", (t) => {
  const { world, hook, ball, run } = yard(t);
  const bodyA = hook([0, 0]);
  world.createAabb(bodyA, { halfWidth: 5, halfHeight: 1 });
  const bodyB = ball([0, 1.5], 0.3);
  const other = ball([2, 1.5], 0.3);
  const joint = world.createJoint({ kind: "filter", bodyA, bodyB });
  run(60);
  assert.ok(world.bodyStateOf(bodyB).position[1] < 0);
  near(world.bodyStateOf(other).position[1], 1.3, 0.02);
  world.setTransform(bodyB, [0, 1.5]);
  world.setVelocity(bodyB, [0, 0]);
  world.destroy(joint);
  run(60);
  near(world.bodyStateOf(bodyB).position[1], 1.3, 0.02);
});

test("frames_are_worked_out_from_a_place_where_turned_bodies_are", (t) => {
  const { world, hook, box, run } = yard(t, { gravity: [0, 0] });
  const bodyA = hook([3, -2], { angle: 0.8 });
  const bodyB = box([5, 1], 0.5, 0.2, { angle: -2 });
  const [at, angle] = [[4, 4], 0.3];
  const joint = world.createJoint({ kind: "weld", bodyA, bodyB, at, angle });
  const { frameA, frameB } = world.jointOptionsOf(joint);
  for (const [body, frame] of [[bodyA, frameA], [bodyB, frameB]]) {
    const { position, angle: turned } = world.bodyStateOf(body);
    const [c, s] = [Math.cos(turned), Math.sin(turned)];
    const [x, y] = frame.position;
    near(position[0] + c * x - s * y, at[0], 1e-6);
    near(position[1] + s * x + c * y, at[1], 1e-6);
    near(frame.angle + turned, angle, 1e-8);
  }
  run(1);
  near(world.jointStateOf(joint).gap, 0, 1e-6);
  near(world.jointStateOf(joint).angleGap, 0, 1e-6);
  const slides = { at, axis: [3 * Math.cos(angle), 3 * Math.sin(angle)] };
  const slider = world.createJoint({ kind: "slider", bodyA, bodyB, ...slides });
  near(world.jointOptionsOf(slider).frameA.angle, frameA.angle, 1e-8);
});

test("axis_points_where_its_angle_does_in_every_direction", (t) => {
  const { world, hook, ball } = yard(t);
  const [bodyA, bodyB] = [hook([0, 5]), ball([0, 4])];
  const directions = Array.from({ length: 64 }, (_, i) => [Math.cos(i / 10), Math.sin(i / 10)]);
  directions.push([1, 0], [0, 1], [-1, 0], [0, -1], [-1, -1e-9], [1e200, 1e200], [-3e-200, 4e-200]);
  for (const axis of directions) {
    const joint = world.createJoint({ kind: "slider", bodyA, bodyB, at: [0, 4], axis });
    const { angle } = world.jointOptionsOf(joint).frameA;
    near(angle, Math.atan2(axis[1], axis[0]), 1e-8, String(axis));
    world.destroy(joint);
  }
});
