/**
 * Tests edits of bodies and shapes in the npm package, forces at points, conversion of points, and
 * reading of single values.
 */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { root, thud } from "../support/package.mjs";

const engine = await thud.load();

function near(actual, expected, within = 1e-6) {
  const pairs = [actual].flat().map((value, i) => [value, [expected].flat()[i]]);
  for (const [value, wanted] of pairs)
    assert.ok(Math.abs(value - wanted) <= within, `${actual} is not ${expected}`);
}

function steps(world, count) {
  for (let i = 0; i < count; i++) world.step();
}

/** A box of 2 by 1 m on a wide floor. */
function boxOnFloor(options = {}) {
  const world = engine.createWorld(options);
  const floor = world.createBody();
  const ground = world.createAabb(floor, { halfWidth: 50, halfHeight: 1, offset: [0, -1] });
  const box = world.createBody({ kind: "dynamic", position: [0, 0.5] });
  const shape = world.createObb(box, { halfWidth: 1, halfHeight: 0.5 });
  steps(world, 30);
  return { world, floor, ground, box, shape };
}

test("filter_that_meets_nothing_lets_the_box_fall_and_what_is_not_named_stays", () => {
  const { world, box, shape } = boxOnFloor();
  world.setFilter(shape, { category: 4, group: 7 });
  steps(world, 30);
  near(world.positionOf(box)[1], 0.5, 0.01);
  world.setFilter(shape, { mask: 0, group: 0 });
  const { category, mask, group } = world.shapeStateOf(shape);
  assert.deepEqual([category, mask, group], [4, 0, 0]);
  world.step();
  assert.equal(world.events().end.length, 1);
  steps(world, 60);
  assert.ok(world.positionOf(box)[1] < -2);
});

test("materials_are_as_they_were_set", () => {
  const { world, box, shape, ground } = boxOnFloor();
  world.setFriction(shape, 0);
  world.setRestitution(shape, 0.25);
  world.setSurfaceSpeed(ground, 0);
  world.setVelocity(box, [3, 0]);
  steps(world, 60);
  near(world.velocityOf(box).velocity[0], 3, 0.01);
  world.setFriction(shape, 1);
  world.setSurfaceSpeed(ground, 2);
  steps(world, 120);
  near(world.velocityOf(box).velocity[0], 2, 0.02);
  const { friction, restitution } = world.shapeStateOf(shape);
  assert.deepEqual([friction, restitution], [1, 0.25]);
});

test("density_and_sizes_weigh_the_body_anew", () => {
  const { world, box, shape } = boxOnFloor();
  world.setDensity(shape, 3);
  near(world.bodyStateOf(box).mass, 6);
  world.setHalfExtents(shape, 0.5, 0.5);
  near(world.bodyStateOf(box).mass, 3);
  const ball = world.createBody({ kind: "dynamic", position: [5, 5] });
  const disc = world.createCircle(ball, { radius: 1 });
  const { shapes } = world.revision;
  world.setRadius(disc, 2);
  assert.ok(world.revision.shapes > shapes);
  near(world.bodyStateOf(ball).mass, 4 * Math.PI, 1e-4);
  assert.throws(() => world.setRadius(shape, 1), { code: "invalid" });
});

test("locked_axes_stay_where_they_are_and_follow_setTransform", () => {
  const world = engine.createWorld();
  const ball = { kind: "dynamic", shapes: [{ kind: "circle", radius: 0.5 }] };
  const high = world.createBody({ ...ball, position: [3, 5], locks: { y: true } });
  const low = world.createBody({ ...ball, position: [6, 5] });
  world.setLocks(low, { x: true });
  assert.deepEqual(world.locksOf(high), { x: false, y: true });
  assert.deepEqual(world.locksOf(low), { x: true, y: false });
  assert.deepEqual(world.bodies(), [high, low]);
  world.setVelocity(high, [2, 0]);
  world.setVelocity(low, [2, 0]);
  steps(world, 60);
  near(world.positionOf(high), [5, 5], 1e-3);
  near(world.positionOf(low)[0], 6, 1e-3);
  assert.ok(world.positionOf(low)[1] < 1);
  world.setTransform(high, [-4, 9]);
  world.setLocks(low, {});
  assert.deepEqual(world.locksOf(low), { x: false, y: false });
  steps(world, 60);
  near(world.positionOf(high)[1], 9, 1e-3);
  const count = world.bodies().length;
  assert.throws(() => world.createBody({ locks: { x: true } }), { code: "invalid" });
  assert.throws(() => world.createBody({ kind: "dynamic", locks: { z: true } }), { code: "invalid" });
  assert.equal(world.bodies().length, count);
});

test("events_of_a_shape_are_told_as_its_options_and_setEvents_say", () => {
  const { world, box, shape } = boxOnFloor();
  assert.equal(world.shapeStateOf(shape).events, true);
  world.setEvents(shape, false);
  assert.equal(world.shapeStateOf(shape).events, false);
  world.setTransform(box, [0, 5]);
  world.step();
  assert.equal(world.events().end.length, 1); // its begin event was reported
  const quiet = world.createCircle(world.createBody({ kind: "dynamic", position: [5, 1] }), {
    radius: 0.5,
    events: false,
  });
  assert.equal(world.shapeStateOf(quiet).events, false);
  for (let i = 0; i < 90; i++) {
    world.step();
    const { begin, hit } = world.events();
    assert.equal(begin.length + hit.length, 0);
  }
  assert.throws(() => world.setEvents({ kind: "shape", index: 99, generation: 1 }, true), { code: "stale" });
});

test("sensor_that_a_shape_becomes_stops_nothing", () => {
  const { world, box, shape } = boxOnFloor();
  world.setSensor(shape, true);
  steps(world, 60);
  assert.ok(world.positionOf(box)[1] < -2);
  assert.equal(world.shapeStateOf(shape).sensor, true);
});

test("body_of_another_kind_does_what_that_kind_does", () => {
  const { world, box } = boxOnFloor();
  world.setKind(box, "kinematic");
  world.setVelocity(box, [0, 1]);
  steps(world, 60);
  near(world.positionOf(box)[1], 1.5, 0.02);
  world.setKind(box, "static");
  assert.deepEqual(world.velocityOf(box), { velocity: [0, 0], angularVelocity: 0 });
  world.setKind(box, "dynamic");
  steps(world, 120);
  near(world.positionOf(box)[1], 0.5, 0.02);
  assert.throws(() => world.setKind(box, "floating"), /kind "floating" is none of static/);
});

test("settings_of_a_body_hold", () => {
  const { world, box } = boxOnFloor({ gravity: [0, 0] });
  world.setTransform(box, [0, 10]);
  world.setDamping(box, 1, 2);
  world.setVelocity(box, [1, 0], 1);
  steps(world, 60);
  near(world.velocityOf(box).velocity[0], Math.exp(-1), 0.02);
  near(world.velocityOf(box).angularVelocity, Math.exp(-2), 0.02);
  world.setFixedRotation(box, true);
  assert.equal(world.velocityOf(box).angularVelocity, 0);
  world.setGravity([0, -10]);
  world.setGravityScale(box, 0);
  world.setDamping(box, 0, 0);
  world.setVelocity(box, [0, 0]);
  steps(world, 60);
  near(world.positionOf(box)[1], 10, 1e-4);
  world.setMaySleep(box, false);
  steps(world, 120);
  assert.equal(world.bodyStateOf(box).awake, true);
  world.setDetection(box, "swept");
  world.setDetection(box, null);
  assert.throws(() => world.setDetection(box, "sometimes"), { code: "invalid" });
});

test("mass_that_is_given_holds_until_it_is_taken_back", () => {
  const { world, box, shape } = boxOnFloor();
  world.setMass(box, { mass: 10, inertia: 4, center: [0, -0.25] });
  world.setDensity(shape, 100);
  const { mass, inertia, center } = world.bodyStateOf(box);
  near([mass, inertia], [10, 4]);
  near(center, [0, world.positionOf(box)[1] - 0.25]);
  world.setMass(box, null);
  near(world.bodyStateOf(box).mass, 200, 1e-3);
  assert.throws(() => world.setMass(box, { mass: 0, inertia: 1 }), { code: "invalid" });
  assert.throws(() => world.setMass(box, { mas: 1 }), /no option is called "mas"/);
});

test("pushes_move_and_turn_as_formulas_say", () => {
  const { world, box } = boxOnFloor({ gravity: [0, 0] });
  world.setTransform(box, [100, 10]);
  const { mass, inertia } = world.bodyStateOf(box);
  world.applyCenterImpulse(box, [2, 4]);
  near(world.velocityOf(box).velocity, [2 / mass, 4 / mass]);
  world.applyAngularImpulse(box, 0.5);
  near(world.velocityOf(box).angularVelocity, 0.5 / inertia);
  world.setVelocity(box, [0, 0], 0);
  world.applyForce(box, [0, 60], [101, 10]);
  world.step();
  near(world.velocityOf(box).velocity, [0, 1 / mass], 1e-4);
  near(world.velocityOf(box).angularVelocity, 1 / inertia, 1e-3);
});

test("target_is_reached_with_the_next_step", () => {
  const world = engine.createWorld();
  const lift = world.createBody({ kind: "kinematic" });
  world.createObb(lift, { halfWidth: 1, halfHeight: 0.1 });
  for (let i = 1; i <= 60; i++) {
    world.setTarget(lift, [0.01 * i, 0.02 * i], 0.005 * i);
    world.step();
    near(world.positionOf(lift), [0.01 * i, 0.02 * i], 1e-5);
  }
  near(world.rotationOf(lift).angle, 0.3, 1e-5);
  const ball = world.createBody({ kind: "dynamic" });
  assert.throws(() => world.setTarget(ball, [0, 1]), { code: "invalid" });
});

test("points_go_from_body_to_world_and_back", () => {
  const world = engine.createWorld();
  const body = world.createBody({ kind: "kinematic", position: [3, 4], angle: Math.PI / 2 });
  world.setVelocity(body, [1, 0], 2);
  near(world.worldPoint(body, [1, 0]), [3, 5]);
  near(world.localPoint(body, [3, 5]), [1, 0]);
  near(world.worldVector(body, [1, 0]), [0, 1]);
  near(world.localVector(body, [0, 1]), [1, 0]);
  near(world.velocityAt(body, [3, 5]), [-1, 0]);
  const { angle, cosine, sine } = world.rotationOf(body);
  near([angle, cosine, sine], [Math.PI / 2, 0, 1]);
});

test("user_data_of_bodies_and_shapes_and_the_body_of_a_shape_are_told", () => {
  const { world, box, shape } = boxOnFloor();
  world.setUserData(shape, 2 ** 53 - 1);
  world.setUserData(box, 42);
  assert.equal(world.userDataOf(shape), 2 ** 53 - 1);
  assert.equal(world.userDataOf(box), 42);
  assert.equal(world.shapeStateOf(shape).userData, 2 ** 53 - 1);
  assert.deepEqual(world.bodyOf(shape), box);
  assert.throws(() => world.setUserData(shape, -1), /userData/);
  world.destroy(shape);
  assert.throws(() => world.userDataOf(shape), { code: "stale" });
});

test("settings_tell_by_what_the_next_step_is_made_and_can_be_set_again", () => {
  const quality = { base: "high", substeps: 6, detection: "bisect", islands: false };
  const world = engine.createWorld({ gravity: [1, 2], timeStep: 0.01, quality });
  const now = world.stepSettings();
  assert.deepEqual(now.gravity, [1, 2]);
  assert.equal(now.timeStep, 0.01);
  assert.equal(now.sleeping, true);
  const { base, substeps, detection, islands } = now.quality;
  assert.deepEqual({ base, substeps, detection, islands }, quality);
  const other = engine.createWorld();
  assert.equal(other.stepSettings().quality.base, "default");
  assert.equal(other.stepSettings().quality.islands, true);
  other.setQuality(now.quality);
  assert.deepEqual(other.stepSettings().quality, now.quality);
});

test("version_is_the_package_s", () => {
  const { version } = JSON.parse(readFileSync(`${root}web/package/package.json`, "utf8"));
  assert.equal(engine.version, version);
});

test("changes_are_part_of_a_snapshot", () => {
  const { world, box, shape } = boxOnFloor();
  const before = world.snapshot();
  world.setFriction(shape, 0.01);
  world.setMass(box, { mass: 5, inertia: 1 });
  world.setVelocity(box, [2, 0]);
  const changed = world.snapshot();
  steps(world, 30);
  const hash = world.hash();
  world.restore(before);
  near(world.bodyStateOf(box).mass, 2);
  world.restore(changed);
  near(world.bodyStateOf(box).mass, 5);
  steps(world, 30);
  assert.equal(world.hash(), hash);
});

test("explosion_pushes_what_has_no_cover", () => {
  const world = engine.createWorld({ gravity: [0, 0] });
  const shapes = [{ kind: "circle", radius: 0.5 }];
  const [near, far, hidden] = [[3, 0], [-6, 0], [0, 6]].map((position) =>
    world.createBody({ kind: "dynamic", position, shapes }),
  );
  world.createBody({ position: [0, 3], shapes: [{ kind: "aabb", halfWidth: 2, halfHeight: 0.2 }] });
  const blast = { center: [0, 0], radius: 4, falloff: 4, impulse: 3 };
  assert.equal(world.explode(blast), 2);
  const speed = (body) => Math.hypot(...world.velocityOf(body).velocity);
  assert.ok(speed(near) > 2 && speed(far) > 0 && speed(far) < speed(near) && speed(hidden) === 0);
  assert.equal(world.explode({ ...blast, cover: "none", filter: { ignore: near } }), 2);
  assert.ok(speed(hidden) > 0);
  assert.throws(() => world.explode({ rays: 0 }), { code: "invalid" });
  assert.throws(() => world.explode({ center: [0, 0] }), /radius and falloff are 0/);
  assert.throws(() => world.explode({ cover: "half" }), /cover "half" is none of none, static, all/);
  assert.throws(() => world.explode({ centre: [0, 0] }), /the nearest is "center"/);
});

test("boat_floats_at_the_draught_that_the_densities_say", () => {
  const world = engine.createWorld({ sleeping: false });
  const options = { halfWidth: 2, halfHeight: 0.5, density: 0.25 };
  const boat = world.createBody({
    kind: "dynamic",
    position: [0, 1],
    shapes: [{ kind: "obb", ...options }],
  });
  for (let i = 0; i < 900; i++) {
    world.applyBuoyancy(boat, { point: [0, 0], density: 1 });
    world.step();
  }
  near(world.positionOf(boat)[1], 0.25, 1e-3);
  assert.throws(() => world.applyBuoyancy(boat, { normal: [0, 2] }), { code: "invalid" });
});

test("wind_carries_a_ball_along_and_grass_stops_it", () => {
  const world = engine.createWorld();
  const shapes = [{ kind: "circle", radius: 0.5 }];
  world.createTerrain(world.createBody(), { kind: "flat" });
  const ball = world.createBody({ kind: "dynamic", position: [0, 0.5], maySleep: false, shapes });
  for (let i = 0; i < 300; i++) {
    world.applyWind(ball, [5, 0]);
    world.step();
  }
  const { velocity } = world.velocityOf(ball);
  assert.ok(velocity[0] > 2 && velocity[0] < 5, `${velocity}`);
  for (let i = 0; i < 600; i++) {
    world.applyRollingResistance(ball, 0.1);
    world.step();
  }
  near(world.velocityOf(ball).velocity[0], 0, 0.02);
  assert.throws(() => world.applyWind(ball, [5, 0], { drag: -1 }), { code: "invalid" });
});
