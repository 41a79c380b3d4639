/**
 * Tests that the page's Box2D copy has the joints of a thud world, and that both are measured
 * alike.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { addBall, addBox, near, step, withRival } from "../support/box2d.mjs";

const UP = [0, 1];
const SOFT = { frequency: 2, damping: 1 };

/**
 * Bodies that hang on a wall: start, joint, place after two seconds or null (the same in both), and
 * tolerance.
 */
const HUNG = {
  rod: [[2, 6], { kind: "distance", from: [0, 6], to: [2, 6], length: 2 }, null],
  rope: [[0, 5], { kind: "distance", from: [0, 6], to: [0, 5], along: { upper: 3 } }, [0, 3]],
  spring: [
    [0, 4],
    { kind: "distance", from: [0, 6], to: [0, 4], along: { ...SOFT, target: 2 } },
    [0, 4 - 10 / (4 * Math.PI) ** 2],
  ],
  spring_at_its_length: [
    [0, 4],
    { kind: "distance", from: [0, 6], to: [0, 4], along: SOFT },
    [0, 4 - 10 / (4 * Math.PI) ** 2],
  ],
  hinge: [[2, 6], { kind: "hinge", at: [0, 6], turn: { lower: -0.5, upper: 0.5 } }, [1.755, 5.041]],
  slider: [[0, 6], { kind: "slider", at: [0, 6], axis: UP, along: { lower: -2 } }, [0, 4]],
  weld: [[1, 6], { kind: "weld", at: [0, 6] }, [1, 6]],
  target: [
    [0, 6],
    { kind: "target", at: [0, 6], along: { ...SOFT, target: 1 }, across: SOFT, turn: SOFT },
    [1, 6 - 10 / (4 * Math.PI) ** 2],
  ],
};


for (const [name, [at, options, rest]] of Object.entries(HUNG))
  test(`body_on_a_${name}_comes_to_the_same_place_in_both`, () => {
    const build = (world) => {
      const bodyA = world.createBody();
      const bodyB = addBox(world, at);
      world.createJoint({ bodyA, bodyB, ...options });
      return bodyB;
    };
    withRival({ sleeping: false }, build, (world, rival, body) => {
      step(world, rival, 120);
      const [ours, theirs] = [world, rival].map((hands) => hands.bodyStateOf(body).position);
      if (rest)
        for (const place of [ours, theirs])
          near(Math.hypot(place[0] - rest[0], place[1] - rest[1]), 0, 0.03, `${name} ${place}`);
      else near(Math.hypot(ours[0] - theirs[0], ours[1] - theirs[1]), 0, 0.1, name);
      for (const [length, angle] of rival.jointGaps()) {
        assert.ok(length < 0.02, `${name}: ${length}`);
        assert.ok(angle < 0.02, `${name}: ${angle}`);
      }
      assert.equal(rival.bodies, 1, "the wall has no shapes");
    });
  });

test("wheel_that_drives_a_car_drives_it_as_far_in_both_in_any_unit", () => {
  for (const unit of [1, 32]) {
    const build = (world) => {
      const ground = world.createBody({ position: [0, -unit] });
      world.createAabb(ground, { halfWidth: 80 * unit, halfHeight: unit });
      const car = world.createBody({ kind: "dynamic", position: [0, 0.9 * unit] });
      world.createObb(car, { halfWidth: unit, halfHeight: 0.2 * unit, density: 1 / unit ** 2 });
      for (const x of [-0.7 * unit, 0.7 * unit]) {
        const options = { radius: 0.4 * unit, friction: 1, density: 1 / unit ** 2 };
        const wheel = addBall(world, [x, 0.4 * unit], options);
        const along = { frequency: 5, damping: 0.7, target: -0.05 * unit, lower: -0.2 * unit };
        const turn = { motorSpeed: -5, motorForce: unit ** 2 };
        world.createJoint({ kind: "wheel", bodyA: car, bodyB: wheel, at: [x, 0.4 * unit], along, turn });
      }
      return car;
    };
    const options = { gravity: [0, -10 * unit], lengthScale: unit, sleeping: false };
    withRival(options, build, (world, rival, car) => {
      step(world, rival, 120);
      const [ours, theirs] = [world, rival].map((hands) => hands.bodyStateOf(car).position[0] / unit);
      assert.ok(ours > 2, `unit ${unit}: ${ours}`);
      near(ours, theirs, 0.05 * ours, `unit ${unit}`);
    });
  }
});

test("joints_set_filtered_and_destroyed_are_so_in_box2d", () => {
  const build = (world) => {
    const wall = world.createBody();
    const body = addBox(world, [0, 6]);
    const through = addBox(world, [0.2, 6.2]);
    world.createJoint({ kind: "filter", bodyA: body, bodyB: through });
    world.createJoint({ kind: "weld", bodyA: wall, bodyB: through, at: [0.2, 6.2] });
    const slider = { kind: "slider", bodyA: wall, bodyB: body, at: [0, 6] };
    return { body, joint: world.createJoint({ ...slider, along: { motorForce: 1e3 } }) };
  };
  withRival({ sleeping: false }, build, (world, rival, { body, joint }, known) => {
    known.forwardTo(rival);
    const places = () => [world, rival].map((hands) => hands.bodyStateOf(body).position);
    step(world, rival, 30);
    for (const [x, y] of places()) near(Math.hypot(x, y - 6), 0, 1e-3, "braked");
    world.setDrive(joint, "along", { motorSpeed: 2 });
    step(world, rival, 60);
    for (const [x, y] of places()) near(Math.hypot(x - 2, y - 6), 0, 0.05, "driven");
    world.setJointFrame(joint, "a", { position: [0, 7] });
    step(world, rival, 30);
    for (const [, y] of places()) near(y, 7, 0.01, "moved");
    world.setJointEnabled(joint, false);
    step(world, rival, 30);
    for (const [, y] of places()) assert.ok(y < 6.5, "let go");
    world.destroy(joint);
    step(world, rival, 1);
  });
});

test("joint_breaks_in_each_engine_by_what_it_bears_there", () => {
  const build = (world) => {
    const bodyA = world.createBody();
    return [5, 20].map((breakForce, i) => {
      const bodyB = addBall(world, [3 * i, 5]);
      world.createJoint({ kind: "weld", bodyA, bodyB, at: [3 * i, 5], breakForce });
      return bodyB;
    });
  };
  withRival({}, build, (world, rival, [weak, strong]) => {
    step(world, rival, 60);
    for (const hands of [world, rival]) {
      assert.ok(hands.bodyStateOf(weak).position[1] < 2);
      near(hands.bodyStateOf(strong).position[1], 5, 0.01);
    }
  });
});

test("joint_that_broke_in_box2d_alone_stays_broken_as_bodies_come", () => {
  const build = (world) => {
    const bodyA = world.createBody();
    const bodyB = addBall(world, [0, 5]);
    world.createJoint({ kind: "weld", bodyA, bodyB, at: [0, 5], breakForce: 20 });
    return bodyB;
  };
  withRival({}, build, (world, rival, ball) => {
    rival.sync();
    assert.equal(rival.jointGaps().length, 2, "a gap for each engine");
    // Box2D's ball alone is pulled by more than the joint bears.
    rival.applyCenterForce(ball, [0, -100]);
    step(world, rival, 2);
    assert.deepEqual(rival.jointGaps(), []);
    addBall(world, [9, 9]);
    rival.sync();
    assert.deepEqual(rival.jointGaps(), []);
    assert.equal(world.joints().length, 1);
  });
});

test("gears_are_left_out_and_told", () => {
  const build = (world) => {
    const bodyA = world.createBody();
    const [jointA, jointB] = [0, 2].map((x) => {
      const bodyB = addBall(world, [x, 0]);
      return world.createJoint({ kind: "hinge", bodyA, bodyB, at: [x, 0] });
    });
    return world.createJoint({ kind: "gear", jointA, jointB });
  };
  withRival({}, build, (world, rival, gear, known) => {
    known.forwardTo(rival);
    step(world, rival, 1);
    assert.deepEqual(rival.misses, ["gears"]);
    world.destroy(gear);
    step(world, rival, 1);
    assert.deepEqual(rival.misses, []);
  });
});

test("joint_gaps_of_both_are_those_that_thud_tells", () => {
  const build = (world) => {
    const bodyA = world.createBody();
    const bodyB = addBall(world, [0, 5]);
    world.createJoint({ kind: "hinge", bodyA, bodyB, frameA: { position: [0, 5.25] } });
    return bodyB;
  };
  withRival({ gravity: [0, 0] }, build, (world, rival) => {
    const [ours, theirs] = rival.jointGaps();
    near(ours[0], 0.25, 1e-6);
    near(theirs[0], 0.25, 1e-6);
    const [joint] = world.joints();
    near(world.jointStateOf(joint).gap, ours[0], 1e-6);
  });
});
