/** Tests setting and reading joints in the npm package, their events and their handles. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { near, yard } from "../support/joints.mjs";
import { thud } from "../support/package.mjs";

const DT = 1 / 60;
const G = 10;

const SPRING = { frequency: 3, damping: 0.5, target: 0.25, springForce: 40 };
const MOTOR = { motorSpeed: 2, motorForce: 8 };
const LIMITS = { lower: -0.5, upper: 0.75 };
/** The options of each kind, as they must be read back. */
const ALL = {
  distance: { length: 1.5, along: { ...SPRING, lower: 0.5, upper: 3, ...MOTOR } },
  hinge: { turn: { ...SPRING, ...MOTOR, ...LIMITS } },
  slider: { along: { ...SPRING, ...MOTOR, ...LIMITS } },
  weld: { along: SPRING, across: LIMITS, turn: MOTOR },
  wheel: { along: SPRING, turn: { ...MOTOR, ...LIMITS } },
  target: { along: SPRING, across: MOTOR, turn: LIMITS },
  filter: {},
};

test("every_kind_is_read_as_it_was_made_and_makes_another_like_it", (t) => {
  const { world, hook, ball } = yard(t);
  const [bodyA, bodyB] = [hook([0, 5]), ball([0, 4])];
  const more = {
    collideConnected: true,
    breakForce: 500,
    breakTorque: 250,
    onlyReports: true,
    enabled: false,
    userData: 77,
  };
  const frames = {
    frameA: { position: [0.5, 0.25], angle: 0.5 },
    frameB: { position: [-0.5, 0], angle: 0 },
  };
  for (const [kind, own] of Object.entries(ALL)) {
    const placed = kind === "filter" ? {} : frames;
    const joint = world.createJoint({ kind, bodyA, bodyB, ...own, ...more, ...placed });
    const read = world.jointOptionsOf(joint);
    const { frameA, ...rest } = read;
    if (frameA) {
      near(frameA.angle, 0.5, 1e-8);
      assert.deepEqual(frameA.position, [0.5, 0.25]);
    }
    for (const [name, value] of Object.entries({ kind, bodyA, bodyB, ...more }))
      assert.deepEqual(rest[name], value, `${kind}: ${name}`);
    for (const [name, value] of Object.entries(own))
      if (typeof value === "number") assert.equal(rest[name], value);
      else assert.deepEqual({ ...rest[name], ...value }, rest[name], `${kind}: ${name}`);
    const other = world.createJoint(read);
    assert.deepEqual(world.jointOptionsOf(other), read);
    const { userData, enabled } = world.jointStateOf(other);
    assert.deepEqual([userData, enabled], [77, false]);
  }
  assert.equal(world.joints().length, 14);
  assert.equal(world.jointsOf(bodyB).length, 14);
  assert.deepEqual(new Set(world.jointsOf(bodyA)), new Set(world.joints()));
});

test("what_is_not_named_stays_as_it_was", (t) => {
  const { world, hook, ball } = yard(t);
  const [bodyA, bodyB] = [hook([0, 5]), ball([0, 4])];
  const turn = { ...SPRING, ...LIMITS };
  const joint = world.createJoint({ kind: "hinge", bodyA, bodyB, at: [0, 5], breakForce: 9, turn });
  world.setDrive(joint, "turn", { target: 0.5, lower: -1 });
  world.setJointBreaking(joint, { breakTorque: 7 });
  world.setJointFrame(joint, "b", { angle: 0.25 });
  world.setJointUserData(joint, 5);
  const read = world.jointOptionsOf(joint);
  const wanted = { ...turn, target: 0.5, lower: -1 };
  assert.deepEqual({ ...read.turn, ...wanted }, read.turn);
  assert.deepEqual([read.breakForce, read.breakTorque, read.onlyReports], [9, 7, false]);
  assert.deepEqual(read.frameB.position, [0, 1]);
  near(read.frameB.angle, 0.25, 1e-8);
  assert.equal(read.userData, 5);
  world.setDrive(joint, "turn", { lower: -Infinity, upper: Infinity });
  assert.ok(!("lower" in world.jointOptionsOf(joint).turn));
  world.setDrive(joint, "turn", { lower: 0.5 });
  const { lower, upper } = world.jointOptionsOf(joint).turn;
  assert.equal(lower, 0.5);
  near(upper, Math.PI, 1e-5);
});

test("joint_that_is_switched_off_lets_go_and_holds_again", (t) => {
  const { world, hook, ball, run } = yard(t);
  const [bodyA, bodyB] = [hook([0, 5]), ball([0, 4])];
  const joint = world.createJoint({ kind: "hinge", bodyA, bodyB, at: [0, 5] });
  run(30);
  world.setJointEnabled(joint, false);
  run(12);
  near(world.bodyStateOf(bodyB).velocity[1], -G * 12 * DT, 0.02);
  world.setJointEnabled(joint, true);
  run(120);
  near(world.bodyStateOf(bodyB).position[1], 4, 0.02);
});

test("overload_breaks_a_joint_or_is_only_told", (t) => {
  const { world, hook, ball, run } = yard(t);
  const bodyA = hook([0, 5]);
  const [bodyB, light, held] = [ball([0, 4], 0.5), ball([2, 4], 0.1), ball([4, 4], 0.5)];
  const heavy = world.bodyStateOf(bodyB).mass * G;
  const rod = (x) => ({ kind: "distance", bodyA, from: [x, 5], to: [x, 4], breakForce: 0.5 * heavy });
  const breaks = world.createJoint({ ...rod(0), bodyB, userData: 12 });
  const holds = world.createJoint({ ...rod(2), bodyB: light });
  const reports = world.createJoint({ ...rod(4), bodyB: held, onlyReports: true });
  assert.deepEqual(world.jointEvents(), []);
  run(1);
  const events = world.jointEvents();
  assert.deepEqual(
    events.map(({ joint, broken }) => [joint, broken]),
    [[breaks, true], [reports, false]],
  );
  assert.deepEqual([events[0].bodyA, events[0].bodyB, events[0].userData], [bodyA, bodyB, 12]);
  assert.ok(events[0].force > 0.5 * heavy);
  assert.deepEqual([breaks, holds, reports].map((joint) => world.isValid(joint)), [false, true, true]);
  run(60);
  assert.deepEqual(world.jointEvents().map(({ joint }) => joint), [reports]);
  assert.ok(world.bodyStateOf(bodyB).position[1] < 0);
});

test("handles_are_stale_once_a_joint_or_its_body_is_destroyed", (t) => {
  const { world, hook, ball, run } = yard(t);
  const [bodyA, bodyB] = [hook([0, 5]), ball([0, 4])];
  const make = () => world.createJoint({ kind: "hinge", bodyA, bodyB, at: [0, 5] });
  const [first, second] = [make(), make()];
  const { shapes } = world.revision;
  world.destroy(first);
  assert.equal(world.revision.shapes, shapes, "no shape has gone");
  assert.deepEqual([world.isValid(first), world.isValid(second)], [false, true]);
  const calls = [
    () => world.destroy(first),
    () => world.jointStateOf(first),
    () => world.jointOptionsOf(first),
    () => world.setDrive(first, "turn", {}),
    () => world.setJointLength(first, 1),
    () => world.setJointFrame(first, "a", {}),
    () => world.setJointBreaking(first, {}),
    () => world.setJointEnabled(first, false),
    () => world.setJointUserData(first, 1),
  ];
  for (const call of calls) assert.throws(call, { name: "ThudError", code: "stale" }, String(call));
  const third = make();
  assert.equal(world.isValid(first), false, "although its place is taken");
  assert.equal(third.index, first.index);
  world.destroy(bodyB);
  run(1);
  assert.deepEqual([world.isValid(second), world.isValid(third)], [false, false]);
  assert.deepEqual(world.joints(), []);
  assert.throws(() => world.jointsOf(bodyB), { code: "stale" });
  assert.throws(make, { code: "stale" });
});

test("step_tells_how_far_joints_are_open", (t) => {
  const { world, hook, ball, run } = yard(t);
  const [bodyA, bodyB] = [hook([0, 5]), ball([0, 4], 0.5)];
  run(1);
  const { jointGapMax, jointGapMean, jointAngleMax } = world.stepError();
  assert.deepEqual([jointGapMax, jointGapMean, jointAngleMax], [0, 0, 0]);
  // The two welds contradict each other, so both stay half open.
  const joints = [-0.5, 0.5].map((angle) => {
    const frameA = { position: [2 * angle, -1], angle };
    return world.createJoint({ kind: "weld", bodyA, bodyB, frameA });
  });
  run(60);
  const error = world.stepError();
  const states = joints.map((joint) => world.jointStateOf(joint));
  const [first, second] = states.map(({ gap }) => gap);
  assert.ok(error.jointGapMax > 0.5 && error.jointAngleMax > 0.25);
  near(error.jointGapMax, Math.max(first, second), 1e-9);
  near(error.jointGapMean, (first + second) / 2, 1e-9);
  near(error.jointAngleMax, Math.max(...states.map(({ angleGap }) => angleGap)), 1e-9);
});

test("table_has_a_row_for_every_joint_as_its_bodies_are_drawn", (t) => {
  const { world, hook, box, run } = yard(t);
  assert.equal(world.jointTable().count, 0);
  const bodyA = hook([3, 5], { angle: 0.4 });
  const bodyB = box([4, 4], 0.5, 0.2, { angle: 1 });
  world.createObb(bodyB, { halfWidth: 0.2, halfHeight: 0.2, offset: [0.5, 0] });
  const along = { lower: -0.5, upper: 2 };
  const at = [3.5, 4.5];
  const slider = world.createJoint({ kind: "slider", bodyA, bodyB, at, angle: 0.4, along });
  const rod = world.createJoint({ kind: "distance", bodyA, bodyB, enabled: false, length: 3 });
  run(20);
  const { count, rows, handles } = world.jointTable(1, 1, 2);
  const at0 = thud.JOINT_ROW;
  assert.equal(count, 2);
  assert.equal(rows.length, 2 * at0.length);
  const read = (name, length = 1, row = 0) => {
    const start = row * at0.length + at0[name];
    return length === 1 ? rows[start] : [...rows.subarray(start, start + length)];
  };
  const state = world.jointStateOf(slider);
  const { position, angle, center } = world.bodyStateOf(bodyB);
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const { frameB } = world.jointOptionsOf(slider);
  const [x, y] = frameB.position;
  const close = (list, wanted) => list.forEach((value, i) => near(value, wanted[i], 2e-6));
  assert.deepEqual(["kind", "slotA", "slotB", "enabled", "awake"].map((name) => read(name)), [
    thud.JOINT_KINDS.indexOf("slider"),
    bodyA.index,
    bodyB.index,
    1,
    1,
  ]);
  close(read("anchorB", 2), frameB.position);
  close(read("placeA", 2), [at[0] - 1, at[1] - 2]);
  close(read("placeB", 2), [position[0] + c * x - s * y - 1, position[1] + s * x + c * y - 2]);
  close(read("axis", 2), [1, 0]);
  close(read("direction", 2), [Math.cos(0.4), Math.sin(0.4)]);
  close(read("centerB", 2), [center[0] - 1, center[1] - 2]);
  close(read("value", 3), [state.value.along, state.value.across, state.value.turn]);
  assert.deepEqual(read("lower", 3), [-0.5, 0, 0]);
  assert.deepEqual(read("upper", 3), [2, 0, 0]);
  close([read("gap"), read("angleGap"), ...read("force", 2)], [state.gap, state.angleGap, ...state.force]);
  assert.deepEqual(read("lower", 3, 1), [3, -Infinity, -Infinity]);
  assert.deepEqual(read("upper", 3, 1), [3, Infinity, Infinity]);
  assert.equal(read("enabled", 1, 1), 0);
  const ids = [slider, rod].flatMap((joint) =>
    [joint, bodyA, bodyB].flatMap(({ index, generation }) => [index + 1, generation]),
  );
  assert.deepEqual([...handles], ids);
  const before = world.poses(0)[4 * bodyB.index + 1];
  const now = world.poses(1)[4 * bodyB.index + 1];
  const half = world.jointTable(0.5).rows;
  assert.notEqual(before, now);
  near(half[at0.placeB + 1], world.poses(0.5)[4 * bodyB.index + 1] + Math.sin(angle) * x + c * y, 0.1);
  assert.notEqual(half[at0.placeB + 1], world.jointTable(1).rows[at0.placeB + 1]);
});

test("spring_of_a_distance_rests_at_its_length_unless_it_has_a_target", (t) => {
  const { world, hook, ball } = yard(t, { gravity: [0, 0] });
  const [bodyA, bodyB] = [hook([0, 5]), ball([3, 5])];
  const along = { frequency: 5, damping: 1 };
  const joint = world.createJoint({ kind: "distance", bodyA, bodyB, length: 2, along });
  const rest = () => {
    for (let i = 0; i < 120; i++) world.step();
    return world.jointStateOf(joint).value.along;
  };
  near(rest(), 2, 1e-3);
  assert.equal(world.jointOptionsOf(joint).along.target, undefined);
  world.setDrive(joint, "along", { damping: 2 });
  world.setJointLength(joint, 1.5);
  near(rest(), 1.5, 1e-3);
  world.setDrive(joint, "along", { target: 1 });
  near(rest(), 1, 1e-3);
  world.setDrive(joint, "along", { target: -Infinity });
  near(rest(), 1.5, 1e-3);
  const end = { kind: "distance", bodyA, bodyB, from: [0, 5], to: [0, 5], along };
  assert.throws(() => world.createJoint(end), /length/);
});

test("limits_of_a_turn_reach_pi", (t) => {
  const { world, hook, ball } = yard(t);
  const turn = { lower: -Math.PI, upper: Math.PI };
  world.createJoint({ kind: "hinge", bodyA: hook([0, 5]), bodyB: ball([0, 4]), at: [0, 5], turn });
});

test("limit_spring_and_motor_are_told_apart", (t) => {
  const { world, hook, ball } = yard(t);
  const [bodyA, bodyB] = [hook([0, 5]), ball([0, 5])];
  const along = { lower: 0, frequency: 2, damping: 1, target: 0.02, motorForce: 0.05 };
  const axis = [0, 1];
  const joint = world.createJoint({ kind: "slider", bodyA, bodyB, at: [0, 5], axis, along });
  for (let i = 0; i < 60; i++) world.step();
  const { drive, force } = world.jointStateOf(joint);
  const { limit, spring, motor } = drive.along;
  const mass = Math.PI * 0.1 ** 2;
  near(spring, mass * (4 * Math.PI) ** 2 * 0.02, 3e-3);
  assert.ok(Math.abs(motor) <= 0.05001 && limit > 0.1, `${limit}, ${motor}`);
  near(limit + spring + motor, force[1], 1e-5);
  assert.deepEqual(drive.turn, { limit: 0, spring: 0, motor: 0 });
});

test("joint_table_has_no_row_of_a_joint_whose_body_is_destroyed", async () => {
  const world = (await thud.load()).createWorld();
  const [bodyA, bodyB, bodyC] = [0, 2, 4].map((x) => {
    const body = world.createBody({ kind: "dynamic", position: [x, 0] });
    world.createCircle(body, { radius: 0.5 });
    return body;
  });
  world.createJoint({ kind: "hinge", bodyA, bodyB, at: [1, 0] });
  const left = world.createJoint({ kind: "hinge", bodyA: bodyB, bodyB: bodyC, at: [3, 0] });
  world.step();
  world.destroy(bodyA);
  const { count, handles } = world.jointTable();
  assert.equal(count, 1);
  assert.deepEqual([...handles.slice(0, 2)], [left.index + 1, left.generation]);
  world.close();
});
