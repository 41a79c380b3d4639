/**
 * Tests that the page's Box2D copy of a thud world moves, weighs and is measured as the thud world.
 */
import assert from "node:assert/strict";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { test } from "node:test";
import {
  addBall,
  addBox,
  addGround,
  box2d,
  engine,
  heightOf,
  importRival,
  near,
  rivalry,
  step,
  withRival,
} from "../support/box2d.mjs";
import { root } from "../support/package.mjs";

const { Box2DWorld, Ruler } = rivalry;

test("ball_on_flat_ground_rests_as_high_as_in_thud", () => {
  const build = (world) => (addGround(world), addBall(world, [3, 2]));
  withRival({}, build, (world, rival, ball) => {
    step(world, rival, 180);
    near(heightOf(rival, ball), world.bodyStateOf(ball).position[1], 0.01);
    near(heightOf(rival, ball), 0.5, 0.01);
    near(rival.poses()[4 * ball.index], 3, 1e-3);
  });
});

test("balls_dropped_on_both_kinds_of_line_stay_in_their_hollow", () => {
  const heights = [3, 1, 0, 0, 0, 0, 0, 0, 0, 1, 3];
  const uniform = { kind: "uniform", x0: -10, spacing: 2, heights };
  const points = [[-10, 3], [-7, 1], [-3, 0], [5, 0], [10, 3]];
  for (const terrain of [uniform, { kind: "irregular", points }]) {
    const build = (world) => {
      addGround(world, terrain);
      return [-9, 0.3, 8].map((x) => addBall(world, [x, 5]));
    };
    withRival({}, build, (world, rival, balls) => {
      step(world, rival, 240);
      for (const { index } of balls) {
        const [x, y] = rival.poses().subarray(4 * index);
        assert.ok(x > -7 && x < 8, `${terrain.kind}: x ${x}`);
        assert.ok(y > 0.49 && y < 2, `${terrain.kind}: y ${y}`);
      }
      near(heightOf(rival, balls[1]), world.bodyStateOf(balls[1]).position[1], 0.01);
    });
  }
});

test("pyramid_of_boxes_stands", () => {
  const build = (world) => {
    const ground = world.createBody({ position: [0, -1] });
    world.createAabb(ground, { halfWidth: 20, halfHeight: 1 });
    const boxes = [];
    for (let row = 0; row < 8; row++)
      for (let i = 0; i < 8 - row; i++) boxes.push(addBox(world, [i + row / 2, row + 0.5]));
    return boxes;
  };
  withRival({}, build, (world, rival, boxes) => {
    step(world, rival, 120);
    const poses = rival.poses();
    for (const { index } of boxes) {
      const start = world.bodyStateOf(boxes[index - 1]).position;
      near(poses[4 * index], start[0], 0.02);
      near(poses[4 * index + 1], start[1], 0.05);
      near(poses[4 * index + 2], 1, 1e-4);
    }
    assert.ok(rival.penetration() < 0.02);
  });
});

test("masses_and_inertia_equal_those_of_thud_in_any_unit", () => {
  for (const lengthScale of [1, 32]) {
    const build = (world) => {
      const bodies = [0, 4, 8].map((x) => world.createBody({ kind: "dynamic", position: [x, 0] }));
      const density = 0.7;
      const box = { halfWidth: 2, halfHeight: 5, angle: 0.4, offset: [1, 2], density };
      world.createCircle(bodies[0], { radius: 3, density });
      world.createObb(bodies[1], box);
      world.createCircle(bodies[1], { radius: 2, offset: [-3, 1] });
      world.createAabb(bodies[2], { halfWidth: 2, halfHeight: 1 });
      return bodies;
    };
    withRival({ lengthScale }, build, (world, rival, bodies) => {
      for (const body of bodies) {
        const [own, other] = [world.bodyStateOf(body), rival.bodyStateOf(body)];
        near(other.mass, own.mass, 1e-4 * own.mass, "mass");
        near(other.inertia, own.inertia, 1e-4 * own.inertia, "inertia");
        for (const k of [0, 1]) near(other.center[k], own.center[k], 1e-4, "centre");
      }
    });
  }
});

test("free_fall_in_pixels_follows_the_parabola", () => {
  const options = { lengthScale: 32, gravity: [0, -320] };
  const build = (world) => addBall(world, [100, 1000], { radius: 16, velocity: [64, 0] });
  withRival(options, build, (world, rival, ball) => {
    step(world, rival, 60);
    near(rival.poses()[4 * ball.index], 164, 0.1);
    // Semi-implicit Euler with 4 substeps is h g t / 2 below the parabola.
    near(heightOf(rival, ball), 1000 - 160 - 320 / 240 / 2, 0.1);
    near(rival.bodyStateOf(ball).velocity[1], -320, 0.1);
    near(rival.poses(0)[4 * ball.index], 164 - 64 / 60, 0.1);
    near(rival.poses(1, 150, 800)[4 * ball.index], 14, 0.1);
  });
});

test("body_is_as_fast_as_thud_lets_it_be", () => {
  const build = (world) => addBall(world, [0, 0], { velocity: [1000, 0] });
  for (const [maximumSpeed, distance] of [[undefined, 1000], [500, 500]])
    withRival({ gravity: [0, 0], maximumSpeed }, build, (world, rival, ball) => {
      step(world, rival, 60);
      near(rival.bodyStateOf(ball).position[0], distance, 0.1);
      near(world.bodyStateOf(ball).position[0], distance, 0.1);
    });
});

test("aabb_and_body_of_fixed_rotation_do_not_turn", () => {
  const build = (world) => {
    const aabb = world.createBody({ kind: "dynamic", position: [0, 0] });
    world.createAabb(aabb, { halfWidth: 1, halfHeight: 1 });
    const fixed = world.createBody({ kind: "dynamic", position: [9, 0], fixedRotation: true });
    world.createObb(fixed, { halfWidth: 1, halfHeight: 1, angle: 0.3 });
    return [aabb, fixed];
  };
  withRival({ gravity: [0, 0] }, build, (world, rival, bodies) => {
    for (const body of bodies) {
      const { center, inertia } = rival.bodyStateOf(body);
      assert.equal(inertia, 0);
      rival.applyImpulse(body, [0, 9], [center[0] + 1, center[1]]);
    }
    step(world, rival, 30);
    for (const body of bodies) {
      near(rival.bodyStateOf(body).angle, 0, 1e-6);
      assert.ok(rival.bodyStateOf(body).position[1] > 1);
    }
  });
});

test("energy_of_the_start_equals_that_of_thud_and_the_formula", () => {
  const build = (world) => {
    addGround(world);
    const ball = addBall(world, [2, 7], { radius: 1, velocity: [3, -4] });
    world.setVelocity(ball, [3, -4], 2);
    return ball;
  };
  withRival({ gravity: [0, -9.81] }, build, (world, rival) => {
    const [kinetic, potential] = rival.energy();
    const mass = Math.PI;
    near(kinetic, 0.5 * mass * 25 + 0.5 * (0.5 * mass) * 4, 1e-3);
    near(potential, mass * 9.81 * 7, 1e-3);
    const own = world.measure();
    near(kinetic, own.kineticEnergy, 1e-3);
    near(potential, own.potentialEnergy, 1e-3);
  });
});

test("penetration_of_overlapping_circles_is_the_radii_less_the_distance", () => {
  const build = (world) => {
    const rock = world.createBody();
    world.createCircle(rock, { radius: 1 });
    return [addBall(world, [1.2, 0]), addBall(world, [0, 5]), addBall(world, [0.8, 5])];
  };
  withRival({ gravity: [0, 0] }, build, (world, rival, [first, second]) => {
    near(rival.penetration(), 0.3, 1e-5);
    rival.setTransform(first, [1.4, 0]);
    near(rival.penetration(), 0.2, 1e-5);
    rival.setTransform(first, [2, 0]);
    rival.setTransform(second, [-1, 5]);
    assert.equal(rival.penetration(), 0);
  });
});

test("ruler_reads_the_poses_of_thud_far_from_the_origin", () => {
  const origin = [1e6, -1e6];
  const world = engine.createWorld({ gravity: [0, 0] });
  addBall(world, origin);
  addBall(world, [origin[0] + 0.75, origin[1]]);
  const ruler = new Ruler(world);
  ruler.sync();
  near(ruler.penetration(world.poses(1, ...origin), ...origin), 0.25, 1e-5);
  ruler.close();
  world.close();
});

test("belt_carries_a_box_to_the_side_to_which_it_does_in_thud", () => {
  for (const surfaceSpeed of [2, -2]) {
    const build = (world) => {
      const belt = world.createBody({ position: [0, -0.5] });
      world.createAabb(belt, { halfWidth: 30, halfHeight: 0.5, surfaceSpeed });
      const points = [[40, 0], [100, 0]];
      addGround(world, { kind: "irregular", points }, { surfaceSpeed });
      return [addBox(world, [0, 0.5]), addBox(world, [70, 0.5])];
    };
    withRival({}, build, (world, rival, boxes) => {
      step(world, rival, 120);
      for (const box of boxes) {
        near(world.bodyStateOf(box).velocity[0], surfaceSpeed, 0.05, "thud");
        near(rival.bodyStateOf(box).velocity[0], surfaceSpeed, 0.05, "Box2D");
      }
    });
  }
});

test("friction_and_restitution_hold_on_ground_lines", () => {
  const points = [[-50, 20], [0, 0], [50, 0]];
  const build = (world) => {
    addGround(world, { kind: "irregular", points }, { friction: 0.8, restitution: 0.5 });
    const slope = Math.atan2(-20, 50);
    return [addBox(world, [-25 + 0.19, 10 + 0.47], slope), addBall(world, [20, 5.5])];
  };
  withRival({}, build, (world, rival, [box, ball]) => {
    let [least, highest] = [Infinity, 0];
    step(world, rival, 105, () => {
      least = Math.min(least, heightOf(rival, ball));
      if (least < 0.6) highest = Math.max(highest, heightOf(rival, ball));
    });
    near(rival.poses()[4 * box.index], -25 + 0.19, 0.05, "the box slid to");
    near(highest, 0.5 + 5 / 4, 0.1, "the ball bounced to");
  });
});

test("filters_groups_and_sensors_let_pass_what_thud_lets_pass", () => {
  const bit = 0x80000000;
  const build = (world) => {
    addGround(world);
    const shelf = world.createBody({ position: [0, 3] });
    world.createAabb(shelf, { halfWidth: 50, halfHeight: 0.1, category: bit, group: -3 });
    return [
      addBall(world, [0, 4]),
      addBall(world, [5, 4], { mask: 1 }),
      addBall(world, [10, 4], { group: -3 }),
      addBall(world, [15, 4], { mask: bit + 1 }),
      addBall(world, [20, 4], { sensor: true }),
    ];
  };
  withRival({}, build, (world, rival, balls) => {
    step(world, rival, 120);
    for (const ball of balls)
      near(heightOf(rival, ball), world.bodyStateOf(ball).position[1], 0.3, `ball ${ball.index}`);
  });
});

test("damping_and_gravity_scale_slow_and_lift_as_in_thud", () => {
  const build = (world) =>
    [{ linearDamping: 1.5, angularDamping: 3 }, { gravityScale: -0.5 }].map((options, i) => {
      const [velocity, angularVelocity] = [[5, 0], 4];
      const position = [4 * i, 0];
      const motion = { kind: "dynamic", position, velocity, angularVelocity };
      const body = world.createBody({ ...motion, ...options });
      world.createCircle(body, { radius: 0.5 });
      return body;
    });
  withRival({}, build, (world, rival, bodies) => {
    step(world, rival, 60);
    for (const body of bodies) {
      const [own, other] = [world.bodyStateOf(body), rival.bodyStateOf(body)];
      near(other.velocity[0], own.velocity[0], 0.02);
      near(other.velocity[1], own.velocity[1], 0.1);
      near(other.angularVelocity, own.angularVelocity, 0.05);
    }
    assert.ok(rival.bodyStateOf(bodies[0]).velocity[0] < 2);
  });
});

test("fast_body_stops_at_a_thin_moving_wall_if_thud_sweeps_that_body", () => {
  for (const detection of ["swept", undefined]) {
    const build = (world) => {
      const wall = world.createBody({ kind: "dynamic", position: [10.5, 0] });
      world.createObb(wall, { halfWidth: 0.02, halfHeight: 2, density: 100 });
      return [wall, addBall(world, [0, 0], { radius: 0.1, velocity: [300, 0], detection })];
    };
    withRival({ gravity: [0, 0] }, build, (world, rival, [wall, ball]) => {
      step(world, rival, 10);
      const [from, to] = [wall, ball].map((body) => rival.bodyStateOf(body).position[0]);
      assert.equal(to < from, detection === "swept", `${detection}: ${to} ${from}`);
    });
  }
});

test("sleeping_pile_stays_put_and_holds_when_it_is_woken", () => {
  const build = (world) => {
    addGround(world);
    const boxes = [0.5, 1.5, 2.5].map((y) => addBox(world, [0, y]));
    for (let i = 0; i < 120; i++) world.step();
    assert.equal(world.stats().awakeBodies, 0);
    return boxes;
  };
  withRival({}, build, (world, rival, boxes) => {
    step(world, rival, 2);
    for (const box of boxes) assert.equal(rival.energy()[0], 0);
    rival.applyImpulse(boxes[2], [0.1, 0], rival.bodyStateOf(boxes[2]).center);
    step(world, rival, 60);
    boxes.forEach((box, i) => near(heightOf(rival, box), i + 0.5, 0.03));
  });
});

test("flavour_without_simd_moves_bodies_alike", async () => {
  const flavour = "node_modules/box2d3-wasm/build/dist/es/compat/Box2D.compat.mjs";
  const { default: start } = await import(`${root}web/${flavour}`);
  const world = engine.createWorld();
  addGround(world);
  const ball = addBall(world, [3, 2]);
  const rival = new Box2DWorld(await start(), world);
  step(world, rival, 120);
  near(heightOf(rival, ball), 0.5, 0.01);
  assert.ok(rival.penetration() < 0.01);
  rival.close();
  world.close();
});

test("box2d_that_is_missing_is_named_in_the_error", async () => {
  const folder = mkdtempSync(`${tmpdir()}/thud-rival-`);
  const { loadBox2D } = await importRival(folder);
  rmSync(folder, { recursive: true });
  await assert.rejects(loadBox2D(), /^Error: Box2D could not be loaded: .*Box2D\.deluxe\.mjs/);
});

/**
 * Drops a box onto a block at `x` and pushes it after a second; returns the state and the measures
 * of Box2D's box, with places relative to `x`.
 */
function dropAt(x) {
  let lain;
  const build = (world) => {
    const block = world.createBody({ position: [x, -0.5] });
    world.createAabb(block, { halfWidth: 4, halfHeight: 0.5 });
    return addBox(world, [x + 0.25, 1], 0.3);
  };
  withRival({}, build, (world, rival, box, known) => {
    known.forwardTo(rival);
    step(world, rival, 60);
    world.applyImpulse(box, [0.3, 0], [x + 0.25, 0.6]);
    step(world, rival, 10);
    const { position, center, velocity } = rival.bodyStateOf(box);
    lain = {
      place: [...position, ...center].map((value, i) => (i % 2 === 0 ? value - x : value)),
      velocity,
      pose: [...rival.poses(1, x, 0).slice(4 * box.index, 4 * box.index + 4)],
      near: rival.within(x, 0.5, 2).length,
      penetration: rival.penetration(),
      origin: rival.origin[0],
    };
  });
  return lain;
}

test("world_far_from_the_origin_is_given_moved_and_does_the_same", () => {
  const { origin, ...here } = dropAt(0);
  const { origin: far, ...there } = dropAt(1e7);
  assert.equal(origin, 0);
  near(far, 1e7, 1);
  assert.equal(there.near, here.near);
  near(there.penetration, here.penetration, 1e-5);
  for (const name of ["place", "velocity", "pose"])
    there[name].forEach((value, i) => near(value, here[name][i], 1e-4, `${name} ${i}`));
});

test("world_wider_than_box2d_can_keep_is_refused", () => {
  const world = engine.createWorld();
  addBall(world, [-2e6, 0]);
  addBall(world, [2e6, 0]);
  assert.throws(() => new Box2DWorld(box2d, world), /100 km.*2000 km from their middle/);
  world.close();
});
