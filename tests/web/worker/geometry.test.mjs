/**
 * Tests the package's geometry without a world, of two shapes and of a terrain line, and the scene
 * that shows it.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { buildScene, openSession } from "../../../web/tools/scenes.mjs";
import { geometry, thud } from "../support/package.mjs";

const engine = await thud.load();
const STILL = { way: [0, 0] };
const circle = (x, y, radius = 1) => ({ kind: "circle", center: [x, y], radius });
const box = (x, y, angle = 0) => (
  { kind: "obb", center: [x, y], halfWidth: 1, halfHeight: 1, angle }
);
const near = (actual, expected, tolerance = 1e-12) =>
  assert.ok(Math.abs(actual - expected) <= tolerance, `${actual}, not ${expected}`);

test("closest_points_of_circles_lie_on_their_surfaces", () => {
  const apart = geometry.closest(engine, circle(0, 0), circle(3, 4, 2));
  assert.equal(apart.overlaps, false);
  near(apart.distance, 2);
  near(apart.normal[0], 0.6);
  near(apart.pointA[1], 0.8);
  near(apart.pointB[0], 3 - 2 * 0.6);
  const deep = geometry.closest(engine, box(0, 0), box(1.5, 0));
  assert.equal(deep.overlaps, true);
  near(deep.distance, -0.5);
});

test("impact_is_where_the_way_enters_the_sum_and_where_halving_finds_it", () => {
  const a = box(0, 0, 0.3);
  const b = { kind: "aabb", center: [5, 1], halfWidth: 0.5, halfHeight: 1 };
  const moving = [a, { way: [1, 0] }, b, { way: [-3, 0] }];
  const impact = geometry.timeOfImpact(engine, ...moving);
  near(geometry.minkowskiCast(engine, ...moving).fraction, impact, 1e-12);
  const { time, bisectable } = geometry.timeOfCollision(engine, ...moving, 2 ** -20);
  assert.ok(time <= impact && impact - time <= 2 ** -20, `${time} before ${impact}`);
  assert.equal(bisectable, false, "it moves by more than it is thick");
  const away = [a, { way: [-0.1, 0] }, b, { way: [0.1, 0] }];
  assert.equal(geometry.timeOfImpact(engine, ...away), null);
  assert.equal(geometry.minkowskiCast(engine, ...away), null);
  const parted = geometry.timeOfCollision(engine, ...away, 2 ** -20);
  assert.deepEqual(parted, { time: null, bisectable: true });
});

test("turning_bar_meets_what_it_would_pass_unturned", () => {
  const bar = { kind: "obb", center: [0, 0], halfWidth: 2, halfHeight: 0.1, angle: 0 };
  const post = circle(0, 1.5, 0.2);
  assert.equal(geometry.timeOfImpact(engine, bar, STILL, post, STILL), null);
  const turning = { way: [0, 0], turn: Math.PI };
  const time = geometry.timeOfImpact(engine, bar, turning, post, STILL);
  near(time, 0.5 - Math.asin(0.2 / 1.5) / Math.PI, 0.03);
});

test("circles_pass_each_other_at_the_least_distance", () => {
  const passing = [circle(0, 0), { way: [4, 0] }, circle(2, 3), STILL];
  assert.deepEqual(geometry.approach(engine, ...passing), {
    ...{ time: null, minDistance: 3, minDistanceTime: 0.5 },
  });
  assert.throws(() => geometry.approach(engine, box(0, 0), STILL, circle(1, 1), STILL), {
    code: "invalid",
  });
});

test("volumes_hold_their_shape_and_overlap_by_their_own_form", () => {
  const turned = box(5, 0, Math.PI / 4);
  near(geometry.volumeAroundShape(engine, "circle", turned).radius, Math.SQRT2, 1e-9);
  near(geometry.volumeAroundShape(engine, "aabb", turned).halfWidth, Math.SQRT2, 1e-9);
  const own = geometry.volumeAroundShape(engine, "obb", turned);
  near(own.halfWidth, 1, 1e-9);
  near(Math.abs(Math.sin(2 * own.angle)), 1, 1e-9);
  const other = circle(3.8, -1.2, 0.5);
  const bounds = (kind) => [turned, other].map((one) => geometry.volumeAroundShape(engine, kind, one));
  assert.equal(geometry.volumesOverlap(engine, ...bounds("aabb")), true);
  assert.equal(geometry.closest(engine, turned, other).overlaps, false);
  const often = (exact) => geometry.overlapOften(engine, ...bounds("aabb"), exact, 7);
  assert.deepEqual([often(false), often(true)], [7, 7]);
  assert.equal(geometry.overlapOften(engine, turned, other, true, 7), 0);
});

test("boxes_face_to_face_touch_at_two_points_and_circles_at_one", () => {
  const two = geometry.contacts(engine, box(0, 0), box(0.5, 2), 0.1);
  assert.deepEqual(two.map(({ pointA: [x] }) => x).sort((a, b) => a - b), [-0.5, 1]);
  for (const { distance, normal } of two) {
    near(distance, 0);
    near(normal[1], 1);
  }
  const [point, ...more] = geometry.contacts(engine, circle(0, 0), circle(2.05, 0), 0.1);
  assert.deepEqual(more, []);
  near(point.distance, 0.05);
  near(point.pointB[0] - point.pointA[0], 0.05);
  assert.deepEqual(geometry.contacts(engine, circle(0, 0), circle(2.5, 0), 0.1), []);
});

test("ray_meets_the_near_side_of_a_shape_and_none_from_inside", () => {
  const found = geometry.castRay(engine, circle(5, 0), [0, 0], [8, 0]);
  near(found.fraction, 0.5);
  assert.deepEqual(found.normal, [-1, 0]);
  assert.equal(geometry.castRay(engine, circle(5, 0), [5, 0], [8, 0]), null);
  assert.equal(geometry.castRay(engine, circle(5, 3), [0, 0], [8, 0]), null);
  assert.throws(() => geometry.castRay(engine, circle(5, 0), [0, NaN], [8, 0]), { code: "invalid" });
});

test("volumes_fit_motions_points_and_each_other", () => {
  const flown = geometry.volumeAroundMotion(engine, "aabb", circle(0, 0), { way: [4, 2] });
  near(flown.center[0], 2, 1e-9);
  near(flown.halfWidth, 3, 1e-9);
  near(flown.halfHeight, 2, 1e-9);
  const corners = [[0, 0], [2, 0], [2, 2], [1, 1], [0, 2]];
  const round = geometry.volumeAroundPoints(engine, "circle", corners);
  near(round.radius, Math.SQRT2, 1e-9);
  for (const point of corners) assert.ok(geometry.volumeContainsPoint(engine, round, point));
  assert.equal(geometry.volumeContainsPoint(engine, round, [3, 1]), false);
  const both = geometry.mergeVolumes(engine, "circle", circle(0, 0), circle(6, 0));
  near(both.radius, 4, 1e-9);
  assert.equal(geometry.volumeContains(engine, both, circle(6, 0)), true);
  assert.equal(geometry.volumeContains(engine, both, circle(8, 0)), false);
  const hill = { kind: "irregular", points: [[-4, 0], [0, 3], [4, 0]] };
  const around = geometry.volumeAroundTerrain(engine, "aabb", hill, -2, 9);
  near(around.center[0], 1, 1e-9);
  near(around.halfHeight, 1.5, 1e-9);
  assert.throws(() => geometry.volumeAroundPoints(engine, "circle", []), { code: "invalid" });
});

test("line_without_a_world_has_height_weights_texture_and_feet", () => {
  const hill = { kind: "irregular", points: [[-4, 0], [0, 3], [4, 0]] };
  const at = geometry.terrainAt(engine, hill, 1);
  near(at.height, 2.25);
  assert.equal(at.segment, 1);
  near(at.weights[0], 0.75);
  near(at.normal[0], 0.6);
  // Texture coordinates go on without a step across the vertex at 0.
  const uv = [[0, 0], [1, 10], [5, 20]];
  const texture = (x) => geometry.textureAt(engine, hill, x, uv);
  assert.deepEqual(texture(-2), [0.5, 5]);
  assert.deepEqual(texture(2), [3, 15]);
  for (const side of [-1e-9, 0, 1e-9]) near(texture(side)[0], 1, 1e-8);
  const foot = geometry.footOn(engine, hill, 0, 4);
  near(foot.height, 3);
  near(foot.normal[1], 1);
  assert.deepEqual(geometry.segmentsOf(engine, hill, -1, 1), [0, 1]);
  assert.equal(geometry.segmentsOf(engine, hill, 5, 6), null);
  const flat = { kind: "flat", slope: 0.5 };
  near(geometry.terrainAt(engine, flat, 4).height, 2);
  const steps = { kind: "uniform", x0: 0, spacing: 2, heights: [0, 4, 0] };
  near(geometry.terrainAt(engine, steps, 1.5).height, 3);
});

test("shapes_meet_a_line_without_a_world_as_they_meet_each_other", () => {
  const floor = { kind: "uniform", x0: -10, spacing: 20, heights: [0, 0] };
  const ball = circle(0, 3);
  near(geometry.closestOnTerrain(engine, floor, ball).distance, 2);
  near(geometry.timeOfImpactOnTerrain(engine, floor, ball, { way: [0, -4] }), 0.5);
  near(geometry.timeOfCollisionOnTerrain(engine, floor, ball, { way: [0, -4] }, 1e-9), 0.5, 1e-8);
  assert.equal(geometry.timeOfImpactOnTerrain(engine, floor, ball, { way: [9, 0] }), null);
  const standing = geometry.contactsOnTerrain(engine, floor, box(0, 1), 0.1);
  assert.deepEqual(standing.map(({ pointB: [x] }) => x).sort((a, b) => a - b), [-1, 1]);
  const valley = { kind: "irregular", points: [[-4, 4], [0, 0], [4, 4]] };
  const resting = geometry.contactsOnTerrain(engine, valley, circle(0, Math.SQRT2), 0.01);
  assert.equal(resting.length, 2, "both slopes");
  const ray = geometry.castRayOnTerrain(engine, valley, [2, 6], [0, -8]);
  near(ray.fraction, 0.5);
  assert.equal(geometry.castRayOnTerrain(engine, valley, [2, 1], [0, 8]), null);
  assert.equal(geometry.closestOnTerrain(engine, floor, circle(0, 0.5)).overlaps, true);
});

test("calls_on_a_line_refuse_what_is_no_line", () => {
  const at = (line, x = 0) => () => geometry.terrainAt(engine, line, x);
  const wrong = [
    at({ kind: "irregular", points: [[0, 0]] }),
    at({ kind: "irregular", points: [[0, 0], [0, 1]] }),
    at({ kind: "uniform", x0: 0, spacing: 0, heights: [0, 1] }),
    at({ kind: "uniform", x0: 0, spacing: 1 }),
    at({ kind: "flat", slope: NaN }),
    at({ kind: "hill" }),
    at({ kind: "uniform", x0: 0, spacing: 1, heights: [0, 1] }, 5),
    () => geometry.textureAt(engine, { kind: "flat" }, 0.5, [[0, 0]]),
  ];
  for (const call of wrong) assert.throws(call, { code: "invalid" });
  assert.throws(at({ kind: "irregular", points: [[0, 0]] }), /terrainAt: a line has two or more/);
});

test("geometry_refuses_what_is_no_shape", () => {
  const bad = [circle(0, 0, 0), circle(NaN, 0), { ...box(0, 0), angle: Infinity }];
  for (const one of bad) {
    const calls = [
      () => geometry.closest(engine, one, box(0, 0)),
      () => geometry.timeOfImpact(engine, one, STILL, box(0, 0), STILL),
      () => geometry.timeOfCollision(engine, one, STILL, box(0, 0), STILL, 0.1),
      () => geometry.minkowskiCast(engine, one, STILL, box(0, 0), STILL),
      () => geometry.volumeAroundShape(engine, "obb", one),
      () => geometry.overlapOften(engine, one, box(0, 0), true, 1),
    ];
    for (const call of calls) assert.throws(call, { code: "invalid" });
  }
  assert.throws(() => geometry.volumeAroundShape(engine, "ball", box(0, 0)), { code: "invalid" });
  assert.throws(() => geometry.volumesOverlap(engine, circle(Infinity, 0), box(0, 0)), {
    code: "invalid",
  });
});

// ---- the scene ----

const rowOf = (paint, control, name) =>
  paint.readings[control].find(([label]) => label === name)?.[1];

test("least_separation_of_boxes_is_found_where_that_of_circles_is", async () => {
  const { scene } = await buildScene(engine, "geometry");
  Object.assign(scene.state, { xA: 0, yA: 0, wayXA: 4, wayYA: 0, widthA: 2 });
  Object.assign(scene.state, { xB: 2, yB: 3, wayXB: 0, wayYB: 0, widthB: 2, heightB: 2 });
  const found = (kindA, kindB) => {
    Object.assign(scene.state, { kindA, kindB });
    const paint = scene.paint();
    return ["Found", "Smallest separation", "It comes at"].map((name) => rowOf(paint, "ways", name));
  };
  assert.deepEqual(found("circle", "circle"), ["in closed form", "1.00", "0.50"]);
  assert.deepEqual(found("circle", "aabb").slice(0, 2), ["by a search", "1.00"]);
  scene.world.close();
});

test("scene_reads_out_what_bounds_a_shape_and_what_a_test_takes", async () => {
  const { scene } = await buildScene(engine, "geometry");
  Object.assign(scene.state, { kindA: "obb", widthA: 2, heightA: 2, angleA: 45 });
  for (let i = 0; i < 4; i++) scene.paint();
  const paint = scene.paint();
  assert.equal(rowOf(paint, "aabb", "A fills"), "50 %");
  assert.equal(rowOf(paint, "obb", "A fills"), "100 %");
  assert.equal(rowOf(paint, "circle", "A fills"), "64 %");
  for (const kind of ["circle", "aabb", "obb"])
    assert.ok(Number(rowOf(paint, kind, "Such tests in 1 µs")) > 0.01);
  scene.world.close();
});

const pointer = (x, y, down) => ({ kind: "pointer", x, y, down });

test("shape_is_dragged_also_while_the_scene_stands_and_again_in_the_past", async () => {
  const session = await openSession(engine, "geometry");
  const { state } = session.scene;
  session.makeStep();
  const far = rowOf(session.paint, "closest", "Distance");
  session.do(pointer(state.xA, state.yA, true));
  session.do(pointer(state.xB - 1, state.yB, true));
  session.do(pointer(state.xB, state.yB, true));
  session.do(pointer(state.xB, state.yB, false));
  assert.equal(rowOf(session.paint, "overlap", "Direct test"), "they overlap");
  assert.equal(session.paint.message, "The shapes overlap.");
  session.makeStep();
  assert.equal(session.seek(1), true);
  assert.equal(rowOf(session.paint, "closest", "Distance"), far);
  assert.equal(session.seek(2), true);
  assert.equal(rowOf(session.paint, "overlap", "Direct test"), "they overlap");
  session.close();
});

test("tip_turns_and_control_are_set_and_kept_in_bounds", async () => {
  const session = await openSession(engine, "geometry");
  const { state } = session.scene;
  session.do(pointer(state.xB + state.wayXB, state.yB + state.wayYB, true));
  session.do(pointer(100, 100, true));
  session.do(pointer(100, 100, false));
  assert.deepEqual([state.wayXB, state.wayYB], [12, 8]);
  const turn = (state.angleB * Math.PI) / 180;
  const reach = state.widthB / 2 + 0.7;
  session.do(pointer(state.xB + reach * Math.cos(turn), state.yB + reach * Math.sin(turn), true));
  session.do(pointer(state.xB, state.yB + 3, true));
  assert.ok(Math.abs(state.angleB - 90) < 1, `${state.angleB}`);
  session.do(pointer(0, 0, false));
  session.do({ kind: "set", name: "kindA", value: "circle" });
  assert.equal(state.kindA, "circle");
  session.do({ kind: "set", name: "grip", value: 1 });
  assert.equal(state.grip, null, "only controls are set");
  session.close();
});
