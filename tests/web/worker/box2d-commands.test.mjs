/**
 * Tests that the page's Box2D copy (`rival`) follows changes of the thud world and commands to its
 * bodies.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  addBall,
  addBox,
  addGround,
  box2d,
  engine,
  heightOf,
  near,
  rivalry,
  step,
  withRival,
} from "../support/box2d.mjs";
import { demoWasm, thud } from "../support/package.mjs";

const {
  Box2DWorld,
  explode,
  holds,
  inWorld,
  recordOf,
  letGo,
  moveHold,
  setUp,
  takeHold,
  watchWorlds,
} = rivalry;

/** Takes hold of a body in both engines, as the page's session does. */
function hold(world, rival, known, slot, anchor, [x, y]) {
  known.forwardTo(rival);
  const held = takeHold(world, { slot, anchor, x: 0, y: 0 }, known.options.lengthScale ?? 1);
  moveHold(world, held, [x, y]);
  return held;
}

test("pulled_body_comes_to_the_pointer_in_both_and_hardly_overshoots", () => {
  const build = (world) => (addGround(world), addBox(world, [0, 0.5]));
  withRival({}, build, (world, rival, body, known) => {
    const anchor = [0.4, 0.4];
    hold(world, rival, known, body.index, anchor, [3, 4]);
    let highest = 0;
    step(world, rival, 120, () => {
      for (const hands of [world, rival])
        highest = Math.max(highest, inWorld(hands.bodyStateOf(body), anchor)[1]);
    });
    for (const hands of [world, rival]) {
      const [x, y] = inWorld(hands.bodyStateOf(body), anchor);
      assert.ok(Math.hypot(x - 3, y - 4) < 0.1, `${x} ${y}`);
    }
    assert.ok(highest < 4.3, `${highest}`);
  });
});

test("pulled_body_stops_spinning_by_and_by", () => {
  const build = (world) => addBox(world, [0, 0]);
  withRival({ gravity: [0, 0] }, build, (world, rival, body, known) => {
    for (const hands of [world, rival]) hands.setVelocity(body, [0, 0], 5);
    hold(world, rival, known, body.index, [0, 0], [0, 0]);
    step(world, rival, 12);
    for (const hands of [world, rival])
      near(hands.bodyStateOf(body).angularVelocity, 5 * Math.exp(-1), 0.25);
  });
});

test("body_that_is_let_go_falls_in_both_and_the_hand_is_gone", () => {
  const build = (world) => (addGround(world), addBox(world, [0, 0.5]));
  withRival({}, build, (world, rival, body, known) => {
    const held = hold(world, rival, known, body.index, [0, 0], [0, 4]);
    const { bodies } = world.stats();
    step(world, rival, 60);
    letGo(world, held);
    assert.equal(holds(world, held), false);
    step(world, rival, 90);
    for (const hands of [world, rival]) near(hands.bodyStateOf(body).position[1], 0.5, 0.02);
    assert.equal(world.stats().bodies, bodies - 1);
    assert.equal(world.joints().length, 0);
    assert.equal(rival.bodies, 2);
  });
});

test("explosion_throws_the_bodies_in_its_radius_outward_alike", () => {
  const build = (world) => [2, -1, 9].map((x) => addBall(world, [x, 0]));
  withRival({ gravity: [0, 0] }, build, (world, rival, bodies) => {
    for (const hands of [world, rival]) {
      explode(hands, bodies, { x: 0, y: 0, radius: 4, speed: 10 });
      const speeds = bodies.map((body) => hands.bodyStateOf(body).velocity[0]);
      near(speeds[0], 5, 1e-4);
      near(speeds[1], -7.5, 1e-4);
      assert.equal(speeds[2], 0);
    }
  });
});

test("pull_is_as_strong_in_pixels_as_in_metres", () => {
  for (const lengthScale of [1, 32]) {
    const build = (world) => addBall(world, [0, 0], { radius: 0.5 * lengthScale });
    withRival({ lengthScale, gravity: [0, 0] }, build, (world, rival, body, known) => {
      hold(world, rival, known, body.index, [0, 0], [100 * lengthScale, 0]);
      step(world, rival, 3);
      for (const hands of [world, rival])
        near(hands.bodyStateOf(body).velocity[0] / lengthScale, 20, 1, `scale ${lengthScale}`);
    });
  }
});

test("bodies_within_a_circle_are_those_whose_centre_of_mass_is", () => {
  const build = (world) => {
    const off = world.createBody({ kind: "dynamic", position: [9, 0] });
    world.createCircle(off, { radius: 0.5, offset: [-8, 0] });
    return [addBall(world, [2, 0]), off, addBall(world, [0, 3.5])];
  };
  withRival({ gravity: [0, 0] }, build, (_, rival, bodies) => {
    const found = rival.within(0, 0, 3).map(({ index }) => index);
    assert.deepEqual(found.sort(), [bodies[0].index, bodies[1].index].sort());
  });
});

test("dug_ground_lets_a_ball_sink_into_the_crater", () => {
  const line = { kind: "irregular", points: [[-20, 0], [-5, 0], [5, 0], [20, 0]] };
  const build = (world) => [addGround(world, line), addBall(world, [0, 0.5])];
  withRival({}, build, (world, rival, [ground, ball]) => {
    step(world, rival, 10);
    near(heightOf(rival, ball), 0.5, 0.01);
    world.dig(ground, [0, 0], 3);
    step(world, rival, 180);
    near(heightOf(rival, ball), -2.5, 0.1);
    near(heightOf(rival, ball), world.bodyStateOf(ball).position[1], 0.1);
    assert.ok(rival.penetration() < 0.02);
  });
});

test("bodies_that_come_and_go_do_so_in_the_rival_under_the_slot_of_thud", () => {
  const build = (world) => (addGround(world), addBall(world, [0, 0.5]));
  withRival({}, build, (world, rival, first) => {
    step(world, rival, 1);
    world.destroy(first);
    rival.sync();
    assert.ok(Number.isNaN(heightOf(rival, first)));
    assert.ok(!rival.isValid(first));
    // A destroyed body's slot is free from the next step on.
    step(world, rival, 1);
    const second = addBall(world, [4, 6], { radius: 0.3 });
    assert.equal(second.index, first.index);
    assert.ok(!rival.isValid(second));
    step(world, rival, 120);
    assert.throws(() => rival.bodyStateOf(first), /no body in slot/);
    near(heightOf(rival, second), 0.3, 0.01);
    const shapes = world.shapesOf(second);
    world.createCircle(second, { radius: 0.8 });
    rival.sync();
    near(rival.bodyStateOf(second).mass, Math.PI * (0.09 + 0.64), 1e-3);
    world.destroy(shapes[0]);
    step(world, rival, 120);
    near(heightOf(rival, second), 0.8, 0.02);
    near(rival.bodyStateOf(second).mass, Math.PI * 0.64, 1e-3);
  });
});

test("body_switched_off_is_gone_and_comes_back_as_it_is_switched_on", () => {
  const build = (world) => {
    const shell = addBall(world, [0, 3], { velocity: [1, 0] });
    world.setEnabled(shell, false);
    return shell;
  };
  withRival({ gravity: [0, 0] }, build, (world, rival, shell) => {
    step(world, rival, 3);
    assert.ok(!rival.isValid(shell));
    world.setEnabled(shell, true);
    step(world, rival, 60);
    near(rival.bodyStateOf(shell).position[0], 1, 1e-3);
    world.setEnabled(shell, false);
    step(world, rival, 1);
    assert.ok(Number.isNaN(heightOf(rival, shell)));
  });
});

test("kinematic_body_moves_as_steered_and_jumps_as_placed", () => {
  const build = (world) => {
    const lift = world.createBody({ kind: "kinematic", position: [0, 0], velocity: [0, 1] });
    world.createAabb(lift, { halfWidth: 3, halfHeight: 0.5 });
    return [lift, addBall(world, [0, 1])];
  };
  withRival({}, build, (world, rival, [lift, ball]) => {
    step(world, rival, 60);
    near(heightOf(rival, lift), 1, 1e-3);
    near(heightOf(rival, ball), 2, 0.02);
    world.setVelocity(lift, [2, 0]);
    step(world, rival, 30);
    near(rival.poses()[4 * lift.index], 1, 1e-3);
    world.setTransform(lift, [7, 9]);
    world.setVelocity(lift, [0, 0]);
    rival.sync();
    near(rival.bodyStateOf(lift).position[0], 7, 1e-6);
  });
});

test("what_scene_code_does_to_a_body_is_done_to_the_rival_once", () => {
  const build = (world) => addBall(world, [0, 0]);
  withRival({ gravity: [0, 0] }, build, (world, rival, ball, known) => {
    known.forwardTo(rival);
    const { mass } = world.bodyStateOf(ball);
    world.applyImpulse(ball, [3 * mass, 0], [0, 0]);
    assert.throws(() => world.applyImpulse(ball, [NaN, 0], [0, 0]));
    near(rival.bodyStateOf(ball).velocity[0], 3, 1e-5);
    known.apart(() => world.applyImpulse(ball, [5 * mass, 0], [0, 0]));
    near(rival.bodyStateOf(ball).velocity[0], 3, 1e-5);
    world.setVelocity(ball, [1, 2], 3);
    const later = addBall(world, [9, 9]);
    world.setVelocity(later, [0, 7]);
    rival.sync();
    assert.deepEqual(rival.bodyStateOf(later).velocity, [0, 7]);
    assert.deepEqual(rival.bodyStateOf(ball).velocity, [1, 2]);
    world.setGravity([0, -6]);
    world.applyCenterForce(ball, [60 * mass, 0]);
    step(world, rival, 1);
    near(rival.bodyStateOf(ball).velocity[0], 2, 1e-4);
    near(rival.bodyStateOf(ball).velocity[1], 1.9, 1e-4);
    known.forwardTo(null);
    world.setTransform(later, [0, 0]);
    assert.ok(rival.bodyStateOf(later).position[0] > 8);
  });
});

test("pushes_at_points_and_turns_are_done_to_the_rival_too", () => {
  const build = (world) => addBall(world, [0, 0]);
  withRival({ gravity: [0, 0] }, build, (world, rival, ball, known) => {
    known.forwardTo(rival);
    const { mass, inertia } = world.bodyStateOf(ball);
    world.applyCenterImpulse(ball, [2 * mass, mass]);
    world.applyAngularImpulse(ball, 3 * inertia);
    assert.deepEqual(rival.bodyStateOf(ball).velocity.map(Math.round), [2, 1]);
    near(rival.bodyStateOf(ball).angularVelocity, 3, 1e-4);
    world.setVelocity(ball, [0, 0], 0);
    world.applyForce(ball, [0, 60 * mass], [0.5, 0]);
    step(world, rival, 1);
    const [thuds, rivals] = [world, rival].map((hands) => hands.bodyStateOf(ball));
    near(rivals.velocity[1], 1, 1e-3);
    near(rivals.angularVelocity, thuds.angularVelocity, 1e-2);
    world.setVelocity(ball, [0, 0], 0);
    world.applyTorque(ball, 60 * inertia);
    step(world, rival, 1);
    near(rival.bodyStateOf(ball).angularVelocity, 1, 1e-2);
    assert.deepEqual(rival.bodyStateOf(ball).velocity, [0, 0]);
  });
});

test("force_on_a_body_that_just_came_acts_on_the_rival_too", () => {
  withRival({ gravity: [0, 0] }, () => {}, (world, rival, _, known) => {
    known.forwardTo(rival);
    const ball = addBall(world, [0, 0]);
    world.applyCenterForce(ball, [60 * world.bodyStateOf(ball).mass, 0]);
    const bar = addBall(world, [9, 0]);
    world.applyForce(bar, [0, 60], [9.5, 0]);
    step(world, rival, 1);
    near(rival.bodyStateOf(ball).velocity[0], 1, 1e-3);
    near(rival.bodyStateOf(bar).angularVelocity, world.bodyStateOf(bar).angularVelocity, 1e-2);
    step(world, rival, 1);
    near(rival.bodyStateOf(ball).velocity[0], 1, 1e-3);
  });
});

test("size_and_kind_that_change_at_once_do_so_in_the_rival", () => {
  const build = (world) => [addBall(world, [0, 0]), addBall(world, [0, 4])];
  withRival({ sleeping: false }, build, (world, rival, [below, above]) => {
    const [shape] = world.shapesOf(below);
    world.setKind(below, "static");
    world.setRadius(shape, 2);
    step(world, rival, 120);
    near(heightOf(rival, above), 2.5, 0.02);
    near(world.bodyStateOf(above).position[1], 2.5, 0.02);
  });
});

test("character_pushes_the_rivals_box_as_it_pushes_thuds", () => {
  withRival({ gravity: [0, 0] }, (world) => addBox(world, [1, 0.2]), (world, rival, box, known) => {
    // The mover has no body of its own, so only its push moves the box.
    const shape = { kind: "aabb", halfWidth: 0.3, halfHeight: 0.3 };
    const options = { shape, position: [0, 0], up: [0, 0], pushForce: 12 };
    const mover = new thud.Mover(world, options);
    known.watchMover(mover, options);
    known.forwardTo(rival);
    const run = (steps) => step(world, rival, steps, () => void mover.move([3, 0], 1 / 60));
    run(30);
    const [thuds, rivals] = [world, rival].map((hands) => hands.bodyStateOf(box));
    assert.ok(thuds.velocity[0] > 1.5, `thud's has ${thuds.velocity[0]} m/s`);
    assert.ok(Math.abs(thuds.angularVelocity) > 0.2, `and ${thuds.angularVelocity} 1/s`);
    near(rivals.position[0], thuds.position[0], 1e-3);
    near(rivals.velocity[0], thuds.velocity[0], 1e-3);
    near(rivals.angularVelocity, thuds.angularVelocity, 1e-3);
    // Out of the mover's reach, the box is not pushed.
    rival.setTransform(box, [-9, 0]);
    rival.setVelocity(box, [0, 0]);
    run(30);
    assert.deepEqual(rival.bodyStateOf(box).velocity, [0, 0]);
    mover.close();
  });
});

test("character_of_a_scene_pushes_the_rivals_box_too", async () => {
  const watched = await thud.load(demoWasm);
  watchWorlds(watched);
  let box;
  const scene = ({ createWorld, createMover }) => {
    const world = createWorld({ gravity: [0, 0] });
    box = addBox(world, [1, 0]);
    const shape = { kind: "circle", radius: 0.4 };
    const mover = createMover(world, { shape, position: [0, 0], up: [0, 0], pushForce: 12 });
    return { world, update: () => void mover.move([3, 0], 1 / 60) };
  };
  const choices = { quality: "default", substeps: 0, detection: "auto", broadphase: "grid" };
  const request = { name: "own", seed: 0, choices: { ...choices, maxError: 0 } };
  const session = await setUp(1, { default: scene }, watched, request, () => "");
  const known = recordOf(session.world);
  const rival = new Box2DWorld(box2d, session.world, known);
  known.forwardTo(rival);
  for (let i = 0; i < 30; i++) {
    session.makeStep();
    rival.sync();
    rival.step();
  }
  const [thuds] = session.world.bodyStateOf(box).velocity;
  assert.ok(thuds > 1.5, `thud's has ${thuds} m/s`);
  near(rival.bodyStateOf(box).velocity[0], thuds, 1e-3);
  rival.close();
  session.close();
});

test("settings_changed_before_or_beside_the_rival_hold_for_it", () => {
  const build = (world) => {
    world.setGravity([0, -6]);
    world.setTimeStep(0.02);
    world.setSleeping(false);
    return addBall(world, [0, 0]);
  };
  withRival({}, build, (world, rival, ball, known) => {
    step(world, rival, 1);
    near(rival.bodyStateOf(ball).velocity[1], -0.12, 1e-6);
    known.forwardTo(rival);
    world.setTimeStep(0.01);
    world.setGravity([0, 0]);
    world.setVelocity(ball, [0, 0]);
    step(world, rival, 200);
    assert.ok(rival.poses()[4 * ball.index + 1] > -0.1);
    world.setVelocity(ball, [0, 3]);
    step(world, rival, 1);
    near(heightOf(rival, ball) - rival.poses(0)[4 * ball.index + 1], 0.03, 1e-6);
    // So slow that the ball falls asleep, and stops, if sleeping is on.
    const drift = (sleeping) => {
      world.setSleeping(sleeping);
      world.setVelocity(ball, [0.01, 0]);
      step(world, rival, 100);
      return rival.bodyStateOf(ball).velocity[0];
    };
    near(drift(false), 0.01, 1e-6);
    assert.equal(drift(true), 0);
  });
});

test("worlds_of_a_watched_engine_are_known_with_their_bodies", async () => {
  const watched = await thud.load(demoWasm);
  const before = watched.createWorld();
  watchWorlds(watched);
  const options = { gravity: [0, -3] };
  const world = watched.createWorld(options);
  const body = world.createBody({ linearDamping: 0.25 });
  assert.equal(recordOf(before), undefined);
  assert.deepEqual(recordOf(world).options, options);
  assert.deepEqual(recordOf(world).bodyOptions(body), { linearDamping: 0.25 });
  assert.deepEqual(recordOf(world).bodyOptions(world.createBody()), {});
  const reused = { ...body, generation: body.generation + 1 };
  assert.equal(recordOf(world).bodyOptions(reused), undefined);
});

test("two_thousand_bodies_made_and_destroyed_leave_no_memory_behind", () => {
  const points = Array.from({ length: 50 }, (_, i) => [i, 0]);
  const build = (world) => addGround(world, { kind: "irregular", points });
  withRival({}, build, (world, rival, ground) => {
    const cycle = (count) => {
      for (let i = 0; i < count; i++) {
        const ball = addBall(world, [10 + (i % 20), 1]);
        if (i % 20 === 0) world.setHeights(ground, i % 50, [0.1 + ((i / 20) % 3)]);
        rival.sync();
        world.destroy(ball);
        rival.sync();
      }
    };
    cycle(100);
    const [bytes, heap] = [rival.bytes, box2d.HEAPU8.length];
    cycle(2000);
    assert.equal(rival.bytes, bytes);
    assert.equal(box2d.HEAPU8.length, heap);
  });
});

test("unwatched_world_is_looked_through_for_changes", () => {
  const world = engine.createWorld();
  const points = [[-20, 0], [20, 0]];
  const ground = addGround(world, { kind: "irregular", points });
  const rival = new Box2DWorld(box2d, world);
  const ball = addBall(world, [0, 0.5]);
  step(world, rival, 60);
  near(heightOf(rival, ball), 0.5, 0.01);
  world.setHeights(ground, 0, [-3, -3]);
  step(world, rival, 1);
  world.setHeights(ground, 0, [0, 0]);
  step(world, rival, 60);
  near(heightOf(rival, ball), 0.5, 0.01);
  world.setHeights(ground, 0, [-3, -3]);
  step(world, rival, 120);
  near(heightOf(rival, ball), -2.5, 0.01);
  rival.close();
  world.close();
});

test("worlds_closed_make_room_for_others", () => {
  // Box2D allows 128 worlds at most; creating more returns an invalid world, in which nothing
  // falls.
  const world = engine.createWorld();
  const ball = addBall(world, [0, 0]);
  for (let i = 0; i < 200; i++) {
    const rival = new Box2DWorld(box2d, world);
    rival.step();
    const height = heightOf(rival, ball);
    assert.ok(height < 0 && height > -0.01, `${height} in world ${i}`);
    rival.close();
  }
  world.close();
});
