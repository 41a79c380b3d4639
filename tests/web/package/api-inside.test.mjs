/**
 * Tests what the package shows of the engine's internals: contacts, debug drawing, statistics,
 * Minkowski sums.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { thud } from "../support/package.mjs";

const engine = await thud.load();
const VIEW = { lower: [-20, -20], upper: [20, 20] };

function boxOnGround(options = {}) {
  const world = engine.createWorld(options);
  const ground = world.createBody();
  const line = world.createTerrain(ground, { kind: "flat" });
  const box = world.createBody({ kind: "dynamic", position: [3, 0.5] });
  const shape = world.createObb(box, { halfWidth: 1, halfHeight: 0.5 });
  for (let i = 0; i < 60; i++) world.step();
  return { world, ground, line, box, shape };
}

/** Puts a box of a thousand times the mass on the box. */
function load({ world }) {
  const heavy = world.createBody({ kind: "dynamic", position: [3, 1.5] });
  world.createObb(heavy, { halfWidth: 1, halfHeight: 0.5, density: 1000 });
  for (let i = 0; i < 60; i++) world.step();
  return heavy;
}

/** How often each style occurs in the lines, or the points, of a drawing. */
function stylesOf(world, options, list = "lines", stride = 5) {
  const values = world.draw({ ...VIEW, ...options })[list];
  const found = {};
  for (let i = stride - 1; i < values.length; i += stride) {
    const name = thud.DRAW_STYLES[values[i]];
    found[name] = (found[name] ?? 0) + 1;
  }
  return found;
}

function near(value, wanted, tolerance) {
  assert.ok(Math.abs(value - wanted) <= tolerance, `${value} is not near ${wanted}`);
}

test("contacts_of_a_box_at_rest_carry_its_weight_at_two_corners", () => {
  const { world, ground, line, box, shape } = boxOnGround();
  const [contact, ...others] = world.contactsOf(box);
  assert.equal(others.length, 0);
  assert.deepEqual([contact.a, contact.b], [line, shape]);
  assert.deepEqual([contact.bodyA, contact.bodyB], [ground, box]);
  near(contact.normal[1], 1, 1e-6);
  const corners = contact.points.map(({ point }) => point).sort((p, q) => p[0] - q[0]);
  near(corners[0][0], 2, 0.02);
  near(corners[1][0], 4, 0.02);
  near(corners[0][1], 0, 0.02);
  const impulse = contact.points.reduce((sum, { normalImpulse }) => sum + normalImpulse, 0);
  near(impulse, (2 * 10) / 60, 0.02);
  for (const { separation } of contact.points) near(separation, 0, 0.01);
  near(contact.tangentImpulse, 0, 1e-3);
  assert.equal(contact.direct, false);
  world.close();
});

test("contacts_of_a_body_apart_are_none_and_of_a_destroyed_one_throw", () => {
  const { world, box } = boxOnGround();
  const apart = world.createBody({ kind: "dynamic", position: [0, 9] });
  world.createCircle(apart, { radius: 1 });
  assert.deepEqual(world.contactsOf(apart), []);
  world.destroy(box);
  assert.throws(() => world.contactsOf(box), { code: "stale" });
  world.close();
});

test("island_that_is_solved_directly_shows_in_contacts_stats_and_overlay", () => {
  const scene = boxOnGround({ sleeping: false });
  const { world } = scene;
  assert.equal(world.stats().directIslands, 0);
  assert.equal(stylesOf(world, { islands: true })["solved directly"], undefined);
  const heavy = load(scene);
  assert.ok(world.contactsOf(heavy).every(({ direct }) => direct));
  const { directIslands, directBodies, softIslands } = world.stats();
  assert.deepEqual([directIslands, directBodies, softIslands], [1, 2, 0]);
  assert.equal(stylesOf(world, { islands: true })["solved directly"], 2);
  world.close();
});

test("debug_draw_of_manifolds_gives_every_point_with_depth_and_impulse", () => {
  const { world } = boxOnGround();
  assert.deepEqual(stylesOf(world, { manifolds: true }, "points", 3), { manifold: 2 });
  assert.deepEqual(stylesOf(world, { manifolds: true }), { depth: 2, impulse: 2 });
  world.close();
});

test("debug_draw_of_stages_tells_candidates_bounds_and_touching_apart", () => {
  const world = engine.createWorld({ gravity: [0, 0] });
  const ball = (x, y) => {
    const body = world.createBody({ kind: "dynamic", position: [x, y] });
    world.createCircle(body, { radius: 0.5 });
  };
  ball(0, 0);
  ball(1.04, 0);
  ball(0, 5);
  ball(0.8, 5.8);
  ball(9, 0);
  ball(9.95, 0);
  world.step();
  assert.deepEqual(stylesOf(world, { stages: true }), {
    "pair candidate": 1,
    pair: 1,
    "pair touching": 1,
  });
  world.close();
});

test("debug_draw_of_colours_gives_one_line_a_touching_pair", () => {
  const { world } = boxOnGround();
  const second = world.createBody({ kind: "dynamic", position: [3, 1.5] });
  world.createObb(second, { halfWidth: 1, halfHeight: 0.5 });
  for (let i = 0; i < 30; i++) world.step();
  const found = stylesOf(world, { colours: true });
  assert.ok(Object.keys(found).every((name) => name.startsWith("colour ")));
  assert.equal(Object.values(found).reduce((sum, n) => sum + n, 0), world.stats().contacts);
  world.close();
});

test("stats_count_pairs_of_motions_where_detection_sweeps", () => {
  const world = engine.createWorld({ gravity: [0, 0], detection: "swept" });
  for (const [x, speed] of [[0, 200], [3, -200]]) {
    const body = world.createBody({ kind: "dynamic", position: [x, 0], velocity: [speed, 0] });
    world.createCircle(body, { radius: 0.5 });
  }
  world.step();
  const { impacts, motionPairs, motionCircles, motionExact } = world.stats();
  assert.equal(impacts, 1);
  assert.ok(motionPairs >= motionCircles);
  assert.ok(motionCircles >= motionExact && motionExact >= 1);
  world.close();
});

test("minkowski_sum_of_circles_is_a_circle_of_both_radii", () => {
  const a = { kind: "circle", radius: 1 };
  const b = { kind: "circle", radius: 0.5 };
  const { overlaps, edge, outline } = thud.minkowskiSum(engine, a, b, [3, 0]);
  assert.equal(overlaps, false);
  near(edge[0], 1.5, 1e-12);
  near(edge[1], 0, 1e-12);
  for (let i = 0; i < outline.length; i += 2)
    near(Math.hypot(outline[i], outline[i + 1]), 1.5, 1e-12);
});

test("minkowski_sum_of_boxes_is_the_box_of_both_extents", () => {
  const a = { kind: "aabb", halfWidth: 1, halfHeight: 2 };
  const b = { kind: "aabb", halfWidth: 0.5, halfHeight: 0.25 };
  const { overlaps, edge, outline } = thud.minkowskiSum(engine, a, b, [1.4, 0]);
  assert.equal(overlaps, true);
  assert.deepEqual(edge, [1.5, 0]);
  assert.equal(Math.max(...outline), 2.25);
  assert.equal(Math.min(...outline), -2.25);
  const turned = { kind: "obb", halfWidth: 0.5, halfHeight: 0.25, angle: 0.3 };
  assert.equal(thud.minkowskiSum(engine, a, turned, [0, 0]).outline.length, 16);
});

test("minkowski_sum_of_box_and_circle_is_a_box_with_round_corners", () => {
  const a = { kind: "aabb", halfWidth: 1, halfHeight: 2 };
  const { outline } = thud.minkowskiSum(engine, a, { kind: "circle", radius: 0.5 }, [0, 0]);
  let area = 0;
  for (let i = 0; i < outline.length; i += 2) {
    const x = outline[i];
    const y = outline[i + 1];
    const outside = Math.hypot(Math.max(Math.abs(x) - 1, 0), Math.max(Math.abs(y) - 2, 0));
    near(outside, 0.5, 1e-12);
    const j = (i + 2) % outline.length;
    area += 0.5 * (x * outline[j + 1] - y * outline[j]);
  }
  /* The box, four rectangles of the circle's radius along its sides, and four quarters of the
   * circle. */
  near(area, 8 + 0.5 * 12 + Math.PI / 4, 0.01);
});

test("minkowski_sum_of_bad_shapes_throws", () => {
  const a = { kind: "circle", radius: 1 };
  for (const radius of [0, -1, NaN, Infinity])
    assert.throws(() => thud.minkowskiSum(engine, a, { kind: "circle", radius }, [0, 0]), {
      code: "invalid",
    });
  assert.throws(() => thud.minkowskiSum(engine, a, a, [NaN, 0]), { code: "invalid" });
  assert.throws(() => thud.minkowskiSum(engine, a, { kind: "terrain" }, [0, 0]), {
    code: "invalid",
  });
});

test("quality_object_changes_what_it_names_of_its_base", () => {
  const { world } = boxOnGround({ quality: { base: "draft", substeps: 3 } });
  assert.equal(world.stats().substeps, 3);
  world.setQuality({ base: "high" });
  world.step();
  assert.equal(world.stats().substeps, 8);
  world.setQuality({ substeps: 5 });
  world.step();
  assert.equal(world.stats().substeps, 5);
  world.setQuality("draft");
  world.step();
  assert.equal(world.stats().substeps, 2);
  world.close();
});

test("draft_with_islands_takes_a_maximum_error_and_without_refuses_it", () => {
  const refused = { code: "invalid", message: /island solver/ };
  assert.throws(() => engine.createWorld({ quality: "draft", maxError: 0.01 }), refused);
  const quality = { base: "draft", islands: true };
  const scene = boxOnGround({ quality, maxError: 0.01, sleeping: false });
  load(scene);
  assert.equal(scene.world.stats().directIslands, 1);
  assert.ok(scene.world.measure().penetrationMax <= 0.01);
  assert.throws(() => scene.world.setQuality("draft"), refused);
  scene.world.close();
});

test("quality_object_with_bad_values_throws", () => {
  const world = engine.createWorld();
  for (const quality of [
    { base: "best" },
    { substeps: 65 },
    { contactStiffness: 2 },
    { contactDamping: -1 },
    { detection: "never" },
  ]) {
    assert.throws(() => world.setQuality(quality), { code: "invalid" });
    assert.throws(() => engine.createWorld({ quality }), { code: "invalid" });
  }
  world.close();
});

test("bisection_limit_is_the_thinnest_shape_a_step_and_who_breaks_it_is_counted", () => {
  const world = engine.createWorld({ gravity: [0, 0], detection: "bisect" });
  assert.equal(world.bisectionLimit(), Infinity);
  world.createAabb(world.createBody({ position: [9, 0] }), { halfWidth: 0.1, halfHeight: 4 });
  const ball = world.createBody({ kind: "dynamic" });
  world.createCircle(ball, { radius: 0.5 });
  assert.ok(Math.abs(world.bisectionLimit() - 0.2 * 60) < 1e-6);
  for (const [speed, count] of [[11.9, 0], [12.1, 1]]) {
    world.setVelocity(ball, [speed, 0]);
    world.step();
    assert.equal(world.stats().unbisectable, count);
  }
  world.close();
});

test("body_in_a_vice_is_held_and_its_lost_time_is_told", () => {
  const world = engine.createWorld({ gravity: [0, 0], detection: "swept" });
  const ball = world.createBody({ kind: "dynamic" });
  world.createCircle(ball, { radius: 0.5 });
  for (const side of [-1, 1]) {
    const options = { kind: "kinematic", position: [1.2 * side, 0], velocity: [-12 * side, 0] };
    world.createAabb(world.createBody(options), { halfWidth: 0.5, halfHeight: 3 });
  }
  let [held, lost] = [0, 0];
  for (let i = 0; i < 3; i++) {
    world.step();
    held += world.stats().heldBodies;
    lost += world.stats().heldSeconds;
  }
  assert.ok(held > 0 && lost > 0 && lost <= 3 / 60, `${held} held, ${lost} s lost`);
  world.close();
});
