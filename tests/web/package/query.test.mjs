/** Tests queries and movers of the npm package. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { thud } from "../support/package.mjs";

const engine = await thud.load();

function near(actual, expected, tolerance, what) {
  assert.ok(Math.abs(actual - expected) <= tolerance, `${what}: ${actual}, not ${expected}`);
}

function addBox(world, x, y, halfWidth, halfHeight, options = {}) {
  const body = world.createBody({ position: [x, y], ...options.body });
  return world.createAabb(body, { halfWidth, halfHeight, ...options.shape });
}

/** Ground at height 0, and three boxes in a row at height 5. */
function boxesInARow() {
  const world = engine.createWorld({ gravity: [0, 0] });
  const ground = world.createBody();
  world.createTerrain(ground, { kind: "flat" });
  return { world, boxes: [0, 4, 8].map((x) => addBox(world, x, 5, 1, 1)) };
}

test("circle_cast_meets_the_first_box_at_its_face", () => {
  const { world, boxes } = boxesInARow();
  const circle = { kind: "circle", radius: 0.5 };
  const hit = world.castShape(circle, [-5, 5], [20, 0]);
  assert.equal(hit.shape.index, boxes[0].index);
  near(hit.fraction, 3.5 / 20, 1e-9, "fraction");
  assert.deepEqual(hit.normal, [-1, 0]);
  near(hit.point[0], -1, 1e-6, "x");
  assert.equal(hit.depth, 0);
  assert.equal(world.castShape(circle, [-5, 9], [20, 0]), null);
  world.close();
});

test("casts_of_all_hits_come_nearest_first_and_a_hundred_fit", () => {
  const { world, boxes } = boxesInARow();
  const along = world.castRayAll([-5, 5], [20, 0]);
  assert.deepEqual(
    along.map(({ shape }) => shape.index),
    boxes.map(({ index }) => index),
  );
  const box = { kind: "obb", halfWidth: 1, halfHeight: 0.5, angle: 0.3 };
  assert.equal(world.castShapeAll(box, [20, 5], [-30, 0]).length, 3);
  for (let i = 0; i < 100; i++) addBox(world, i, 20, 0.3, 0.3);
  assert.equal(world.castRayAll([-5, 20], [200, 0]).length, 100);
  assert.deepEqual(world.castRayAll([-5, 40], [200, 0]), []);
  world.close();
});

test("cast_from_inside_hits_at_0_and_tells_its_depth", () => {
  const { world } = boxesInARow();
  const hit = world.castShape({ kind: "circle", radius: 0.5 }, [0, 5.75], [0, 9]);
  assert.equal(hit.fraction, 0);
  near(hit.depth, 0.75, 1e-9, "depth");
  assert.deepEqual(hit.normal, [0, 1]);
  world.close();
});

test("closest_shape_is_told_with_its_distance_and_none_beyond_reach", () => {
  const { world, boxes } = boxesInARow();
  const found = world.closest([4.5, 7], 10);
  assert.equal(found.shape.index, boxes[1].index);
  near(found.distance, 1, 1e-9, "distance");
  near(world.closest([4, 5.75], 10).distance, -0.25, 1e-9, "inside");
  assert.equal(world.closest([4.5, 7], 0.9), null);
  assert.throws(() => world.closest([0, 0], -1), { code: "invalid" });
  assert.throws(() => world.castShape({ kind: "circle", radius: 0 }, [0, 9], [0, -9]), {
    code: "invalid",
  });
  world.close();
});

/** Moves a mover this many times under a gravity of 20. */
function walk(mover, speed, moves, options) {
  let velocity = [0, 0];
  let report;
  for (let i = 0; i < moves; i++) {
    report = mover.move([speed, velocity[1] - 20 / 60], 1 / 60, options);
    velocity = report.velocity;
  }
  return report;
}

test("mover_walks_up_a_step_and_stops_at_a_wall", () => {
  const world = engine.createWorld();
  world.createTerrain(world.createBody(), { kind: "flat" });
  addBox(world, 4, 0, 1, 0.3);
  const wall = addBox(world, 8, 0, 1, 3);
  const mover = new thud.Mover(world, {
    shape: { kind: "aabb", halfWidth: 0.3, halfHeight: 0.8 },
    position: [0, 1],
  });
  const onStep = walk(mover, 5, 45);
  near(onStep.position[1], 0.3 + 0.8 + 0.006, 1e-3, "height on the step");
  assert.ok(onStep.ground);
  const report = walk(mover, 5, 90);
  near(report.position[0], 7 - 0.3 - 0.006, 1e-3, "place at the wall");
  assert.equal(report.hits[0].shape.index, wall.index);
  assert.deepEqual(report.velocity, [0, 0]);
  mover.close();
  assert.throws(() => mover.move([0, 0], 1 / 60), { code: "stale" });
  world.close();
});

test("mover_rides_a_kinematic_platform_and_drops_through_a_one_way_plank", () => {
  const world = engine.createWorld();
  world.createTerrain(world.createBody(), { kind: "flat" });
  addBox(world, 0, 3, 2, 0.1, { shape: { category: 2 } });
  const lift = world.createBody({ kind: "kinematic", position: [10, 1] });
  world.createAabb(lift, { halfWidth: 2, halfHeight: 0.2 });
  world.setVelocity(lift, [1, 2], 0);
  const options = { shape: { kind: "circle", radius: 0.5 }, position: [0, 4], oneWay: 2 };
  const mover = new thud.Mover(world, options);
  near(walk(mover, 0, 60).position[1], 3.61, 1e-3, "on the plank");
  near(walk(mover, 0, 60, { drop: true }).position[1], 0.51, 1e-3, "on the ground");
  mover.place([10, 2]);
  walk(mover, 0, 30);
  let report;
  for (let i = 0; i < 60; i++) {
    world.step();
    report = walk(mover, 0, 1);
    assert.equal(report.ground.body.index, lift.index);
  }
  near(report.position[0], 11, 1e-3, "carried aside");
  near(report.position[1], 3 + 0.2 + 0.51, 1e-3, "carried up");
  near(report.ground.velocity[1], 2, 1e-6, "speed of the ground");
  mover.close();
  world.close();
});

test("scripted_walk_ends_at_the_same_bits_as_the_native_one", () => {
  const world = engine.createWorld({ gravity: [0, 0] });
  world.createTerrain(world.createBody(), {
    kind: "irregular",
    points: [[-10, 0], [2, 0.5], [5, 3], [9, 2], [30, 4]],
  });
  const turned = world.createBody({ position: [12, 3], angle: 0.3 });
  world.createObb(turned, { halfWidth: 1, halfHeight: 0.5 });
  world.createCircle(world.createBody({ position: [17, 4] }), { radius: 1 });
  const mover = new thud.Mover(world, { shape: { kind: "circle", radius: 0.5 }, position: [0, 2] });
  let end;
  for (let i = 0; i < 300; i++)
    end = mover.move([i % 100 < 80 ? 6 : -4, i % 50 < 10 ? 7 : -5], 1 / 64).position;
  // tests/engine/api/test_mover.c has the same walk with the same end.
  assert.deepEqual(end, [14.504182945844535, 3.036515603702544]);
  world.close();
});

test("mover_out_of_range_is_refused_with_the_message_of_the_log", () => {
  const world = engine.createWorld();
  const mover = new thud.Mover(world, {
    shape: { kind: "circle", radius: 0.5 },
    position: [0, 0],
    skin: 3,
  });
  assert.throws(() => mover.move([0, 0], 1 / 60), { code: "invalid", message: /mover/ });
  assert.throws(() => mover.move([NaN, 0], 1 / 60), { code: "invalid" });
  world.close();
});

/** Boxes of 2 by 2 m in a row, each on its own body. */
function row(count, options = {}) {
  const world = engine.createWorld({ gravity: [0, 0] });
  const bodies = Array.from({ length: count }, (_, i) => world.createBody({ position: [4 * i, 0] }));
  const shapes = bodies.map((body) =>
    world.createAabb(body, { halfWidth: 1, halfHeight: 1, ...options }),
  );
  return { world, bodies, shapes };
}

test("many_rays_hit_what_each_alone_hits", () => {
  const { world } = row(8);
  const rays = [];
  for (let i = 0; i < 200; i++) rays.push(0.17 * i, 5, 0.01 * (i - 100), i % 9 === 0 ? -1 : -10);
  const alone = Array.from({ length: 200 }, (_, i) => {
    const [x, y, dx, dy] = rays.slice(4 * i);
    return world.castRay([x, y], [dx, dy]);
  });
  assert.deepEqual(world.castRays(rays), alone);
  assert.deepEqual(world.castRays(Float64Array.from(rays)), alone);
  assert.ok(alone.some((hit) => hit === null) && alone.some((hit) => hit !== null));
  assert.deepEqual(world.castRays([]), []);
  assert.throws(() => world.castRays([0, 5, 0, -10, NaN, 0, 0, 1]), { code: "invalid" });
});

test("query_ignores_a_body_and_heeds_groups_wherever_it_asks", () => {
  const { world, bodies, shapes } = row(3, { group: -3 });
  const [first, second] = shapes;
  const ray = (filter) => world.castRay([-5, 0], [20, 0], filter)?.shape;
  assert.deepEqual(ray(), first);
  assert.deepEqual(ray({ ignore: bodies[0] }), second);
  assert.equal(ray({ group: -3 }), undefined);
  assert.deepEqual(ray({ group: 3 }), first);
  assert.deepEqual(world.castRays([-5, 0, 20, 0], { ignore: bodies[0] })[0].shape, second);
  const circle = { kind: "circle", radius: 0.5 };
  assert.deepEqual(world.castShape(circle, [-5, 0], [20, 0], { ignore: bodies[0] }).shape, second);
  assert.equal(world.castRayAll([-5, 0], [20, 0], { ignore: bodies[1] }).length, 2);
  assert.deepEqual(world.closest([0, 0], 20, { ignore: bodies[0] }).shape, second);
  const everywhere = { kind: "bounds", lower: [-9, -9], upper: [20, 9] };
  assert.equal(world.overlap(everywhere, { ignore: bodies[0] }).length, 2);
  assert.equal(world.overlap(everywhere, { group: -3 }).length, 0);
  world.destroy(bodies[0]);
  assert.deepEqual(ray({ ignore: bodies[0] }), second);
  assert.throws(() => ray({ ignored: bodies[0] }), /no option is called "ignored"/);
});

test("mover_passes_the_body_that_it_ignores", () => {
  const { world, bodies } = row(1);
  const options = { shape: { kind: "circle", radius: 0.5 }, position: [-4, 0], up: [0, 0] };
  const stopped = new thud.Mover(world, options);
  const passing = new thud.Mover(world, { ...options, filter: { ignore: bodies[0] } });
  for (let i = 0; i < 60; i++) [stopped, passing].forEach((mover) => mover.move([8, 0], 1 / 60));
  assert.ok(stopped.state().position[0] < -1.4);
  assert.ok(passing.state().position[0] > 3.9);
});

test("one_shape_is_asked_whatever_its_filter", () => {
  const { world, bodies, shapes } = row(2, { mask: 0, category: 0 });
  const [, second] = shapes;
  const hit = world.shapeCastRay(second, [-5, 0], [20, 0]);
  assert.deepEqual([hit.shape, hit.point, hit.normal[0]], [second, [3, 0], -1]);
  assert.equal(world.shapeCastRay(second, [-5, 3], [20, 0]), null);
  assert.equal(world.containsPoint(second, [4.5, 0.5]), true);
  assert.equal(world.containsPoint(second, [0, 0]), false);
  const { point, distance } = world.closestPointOf(second, [8, 0]);
  assert.deepEqual([point, distance], [[5, 0], 3]);
  assert.deepEqual(world.boundsOf(second), { lower: [3, -1], upper: [5, 1] });
  world.destroy(bodies[1]);
  for (const ask of [
    () => world.shapeCastRay(second, [-5, 0], [20, 0]),
    () => world.containsPoint(second, [0, 0]),
    () => world.closestPointOf(second, [0, 0]),
    () => world.boundsOf(second),
  ])
    assert.throws(ask, { code: "stale" });
});

test("flat_terrain_has_no_bounds_and_a_line_has", () => {
  const world = engine.createWorld();
  const flat = world.createTerrain(world.createBody(), { kind: "flat" });
  assert.throws(() => world.boundsOf(flat), { code: "invalid" });
  const points = [[-2, 1], [0, 3], [4, -1]];
  const line = world.createTerrain(world.createBody({ position: [1, 0] }), { kind: "irregular", points });
  assert.deepEqual(world.boundsOf(line), { lower: [-1, -1], upper: [5, 3] });
});

test("free_flight_is_told_ahead_and_steps_lead_there", () => {
  const world = engine.createWorld({ gravity: [0, -10], sleeping: false });
  const ball = { shapes: [{ kind: "obb", halfWidth: 0.5, halfHeight: 0.2 }] };
  const options = { kind: "dynamic", position: [1, 2], velocity: [3, 8], angularVelocity: 2, ...ball };
  const free = world.createBody(options);
  const damped = world.createBody({ ...options, position: [90, 2], linearDamping: 0.5, angularDamping: 2 });
  world.createBody();
  const before = world.hash();
  const { position, angle, velocity, angularVelocity, seconds, met } = world.extrapolate(free, 0.5);
  near(position[0], 2.5, 1e-6, "x");
  near(position[1], 2 + 4 - 1.25, 1e-6, "y");
  near(angle, 1, 1e-6, "angle");
  assert.deepEqual([velocity, angularVelocity, seconds, met], [[3, 3], 2, 0.5, null]);
  const left = Math.exp(-0.25), speed = (1 - left) / 0.5;
  near(world.extrapolate(damped, 0.5).position[0], 90 + 3 * speed, 1e-6, "damped x");
  near(world.extrapolate(damped, 0.5).angularVelocity, 2 * Math.exp(-1), 1e-6, "damped spin");
  const all = world.extrapolateAwake(0.5);
  assert.equal(all.length, 8);
  assert.deepEqual([...all.subarray(0, 4)], [free.index, ...position, angle]);
  assert.equal(all[4], damped.index);
  assert.equal(world.hash(), before);
  for (let i = 0; i < 30; i++) world.step();
  for (const [at, body] of [free, damped].entries()) {
    const { position: there, angle: turned } = world.bodyStateOf(body);
    near(there[0], all[4 * at + 1], 1e-5, "stepped x");
    near(there[1], all[4 * at + 2], 1e-5, "stepped y");
    near(turned, all[4 * at + 3], 1e-5, "stepped angle");
  }
  assert.equal(engine.createWorld().extrapolateAwake(1).length, 0);
});

test("prediction_stops_at_what_is_met_first", () => {
  const { world, boxes } = boxesInARow();
  const shapes = [{ kind: "circle", radius: 0.5 }];
  const ball = world.createBody({ kind: "dynamic", position: [-5, 5], velocity: [7, 0], shapes });
  const { position, met, seconds, velocity } = world.predict(ball, 2);
  near(position[0], -1.5, 1e-6, "x");
  near(seconds, 0.5, 1e-6, "seconds");
  assert.deepEqual([met, velocity], [boxes[0], [7, 0]]);
  assert.equal(world.predict(ball, 0.4).met, null);
  near(world.extrapolate(ball, 2).position[0], 9, 1e-6, "x without stop");
  const refused = { code: "invalid", message: /^predict: seconds must be from 0 to 60: -1/ };
  assert.throws(() => world.predict(ball, -1), refused);
  world.destroy(ball);
  assert.throws(() => world.extrapolate(ball, 1), { code: "stale" });
});
