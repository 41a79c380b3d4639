/** Tests the npm package in Node: worlds, handles, errors, views, events and queries. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { root, thud } from "../support/package.mjs";

const engine = await thud.load();

function ballOnGround(options = {}) {
  const world = engine.createWorld(options);
  const ground = world.createBody();
  world.createTerrain(ground, { kind: "flat" });
  const ball = world.createBody({ kind: "dynamic", position: [0, 5] });
  const shape = world.createCircle(ball, { radius: 0.5 });
  return { world, ground, ball, shape };
}

function throwsCode(code, act, text = /./) {
  assert.throws(act, (error) => {
    assert.ok(error instanceof thud.ThudError, String(error));
    assert.equal(error.code, code);
    assert.match(error.message, text);
    return true;
  });
}

test("module_imports_only_clock_callbacks_and_memory_growth", async () => {
  const bytes = readFileSync(`${root}web/package/dist/thud.wasm`);
  const imports = WebAssembly.Module.imports(await WebAssembly.compile(bytes));
  assert.deepEqual(imports.map(({ name }) => name).sort(), [
    "emscripten_notify_memory_growth",
    ...["thud_asked", "thud_cast_hit", "thud_clock"],
    "thud_filtered",
    "thud_stepped",
    ...["thud_told", "thud_told_body", "thud_told_category"],
  ]);
});

test("load_of_missing_file_throws_load_error", async () => {
  await assert.rejects(thud.load("no-such.wasm"), { code: "load" });
});

test("load_of_bytes_that_are_no_wasm_throws_load_error", async () => {
  await assert.rejects(thud.load(new Uint8Array([1, 2, 3])), { code: "load" });
  const page = new Response("<!doctype html>", { headers: { "content-type": "text/html" } });
  await assert.rejects(thud.load(page), { code: "load", message: /is a page .text.html./ });
});

test("load_of_foreign_module_throws_load_error", async () => {
  const empty = new Uint8Array([0, 0x61, 0x73, 0x6d, 1, 0, 0, 0]);
  await assert.rejects(thud.load(empty), { code: "load" });
});

test("box_on_a_conveyor_belt_gets_its_speed", () => {
  const world = engine.createWorld();
  const belt = world.createBody();
  const shape = world.createAabb(belt, { halfWidth: 50, halfHeight: 0.5, surfaceSpeed: 2 });
  const box = world.createBody({ kind: "dynamic", position: [0, 1] });
  world.createAabb(box, { halfWidth: 0.5, halfHeight: 0.5 });
  for (let i = 0; i < 60; i++) world.step();
  assert.ok(Math.abs(world.bodyStateOf(box).velocity[0] - 2) < 0.01);
  assert.equal(world.shapeStateOf(shape).surfaceSpeed, 2);
  const tooFast = { halfWidth: 1, halfHeight: 1, surfaceSpeed: 1e9 };
  throwsCode("invalid", () => world.createAabb(belt, tooFast), /surfaceSpeed/);
  throwsCode("invalid", () => world.createBody({ velocity: [1, 0] }), /static/);
  world.close();
});

test("disabled_body_stays_where_it_is_until_it_is_enabled", () => {
  const { world, ball } = ballOnGround();
  world.setEnabled(ball, false);
  for (let i = 0; i < 60; i++) world.step();
  assert.equal(world.bodyStateOf(ball).enabled, false);
  assert.equal(world.bodyStateOf(ball).position[1], 5);
  world.setEnabled(ball, true);
  for (let i = 0; i < 10; i++) world.step();
  assert.ok(world.bodyStateOf(ball).position[1] < 4.95);
  world.close();
});

test("free_fall_of_one_second_matches_parabola", () => {
  const world = engine.createWorld();
  const body = world.createBody({ kind: "dynamic", position: [3, 100], velocity: [2, 0] });
  world.createCircle(body, { radius: 0.5 });
  for (let i = 0; i < 60; i++) world.step();
  const { position, velocity } = world.bodyStateOf(body);
  assert.ok(Math.abs(position[0] - 5) < 1e-3, `x ${position[0]}`);
  assert.ok(Math.abs(position[1] - 95) < 0.1, `y ${position[1]}`);
  assert.ok(Math.abs(velocity[1] + 10) < 1e-3, `vy ${velocity[1]}`);
  world.close();
});

test("ball_dropped_on_ground_rests_at_its_radius", () => {
  const { world, ball } = ballOnGround();
  for (let i = 0; i < 300; i++) world.step();
  assert.ok(Math.abs(world.bodyStateOf(ball).position[1] - 0.5) < 0.02);
  assert.ok(world.stats().contacts === 1);
  world.close();
});

test("poses_show_every_body_by_its_slot", () => {
  const { world, ground, ball } = ballOnGround();
  world.step();
  const poses = world.poses();
  const [x, y] = world.bodyStateOf(ball).position;
  assert.equal(poses[4 * ball.index], Math.fround(x));
  assert.ok(Math.abs(poses[4 * ball.index + 1] - y) < 1e-6);
  assert.equal(poses[4 * ground.index + 2], 1);
  world.close();
});

test("poses_view_is_reused_and_survives_growth_of_memory", () => {
  const { world, ball } = ballOnGround();
  world.step();
  const before = world.poses();
  assert.equal(world.poses(), before, "no new view without need");
  const y = before[4 * ball.index + 1];
  const buffer = engine.buffer;
  for (let i = 0; engine.buffer === buffer; i++) {
    const body = world.createBody({ kind: "dynamic", position: [10 + 2 * i, 50] });
    world.createCircle(body, { radius: 0.5 });
    assert.ok(i < 1e6, "memory never grows");
  }
  const after = world.poses();
  assert.equal(after.buffer, engine.buffer);
  assert.equal(after[4 * ball.index + 1], y);
  world.step();
  assert.notEqual(world.poses()[4 * ball.index + 1], y);
  world.close();
});

test("poses_of_destroyed_body_are_not_a_number", () => {
  const { world, ball } = ballOnGround();
  world.destroy(ball);
  world.step();
  assert.ok(Number.isNaN(world.poses()[4 * ball.index]));
  world.close();
});

test("stale_body_handle_is_refused_even_when_its_slot_is_used_again", () => {
  const { world, ball } = ballOnGround();
  world.destroy(ball);
  assert.equal(world.isValid(ball), false);
  throwsCode("stale", () => world.bodyStateOf(ball));
  throwsCode("stale", () => world.destroy(ball));
  const next = world.createBody({ kind: "dynamic" });
  throwsCode("stale", () => world.setVelocity(ball, [1, 0]));
  assert.ok(world.isValid(next));
  world.close();
});

test("stale_shape_handle_is_refused", () => {
  const { world, shape } = ballOnGround();
  world.destroy(shape);
  assert.equal(world.isValid(shape), false);
  throwsCode("stale", () => world.shapeStateOf(shape));
  world.close();
});

test("handle_of_another_world_is_refused", () => {
  const a = ballOnGround();
  const b = ballOnGround();
  throwsCode("stale", () => a.world.bodyStateOf(b.ball));
  a.world.close();
  b.world.close();
});

test("closed_world_throws_on_every_use", () => {
  const { world } = ballOnGround();
  world.close();
  throwsCode("stale", () => world.step(), /destroyed/);
  throwsCode("stale", () => world.poses());
  throwsCode("stale", () => world.close());
});

test("bad_values_throw_with_the_logs_message_and_change_nothing", () => {
  const { world, ball } = ballOnGround();
  const hash = world.hash();
  throwsCode("invalid", () => engine.createWorld({ timeStep: NaN }));
  throwsCode("invalid", () => world.createBody({ position: [NaN, 0] }), /: ./);
  throwsCode("invalid", () => world.createCircle(ball, { radius: -1 }), /: ./);
  throwsCode("invalid", () => world.createBody({ kind: "flying" }), /flying/);
  throwsCode("invalid", () => world.createBody({ userData: -1 }), /userData/);
  throwsCode("invalid", () => world.advance(-1));
  throwsCode("invalid", () => world.setVelocity(ball, [Infinity, 0]));
  assert.equal(world.hash(), hash);
  assert.equal(world.stats().bodies, 2);
  world.close();
});

test("unsorted_terrain_is_refused", () => {
  const world = engine.createWorld();
  const ground = world.createBody();
  const points = [
    [0, 0],
    [-1, 0],
  ];
  throwsCode("invalid", () => world.createTerrain(ground, { kind: "irregular", points }));
  world.close();
});

test("terrain_is_read_back_as_given_and_heights_can_be_changed", () => {
  const world = engine.createWorld();
  const ground = world.createBody();
  const heights = [0, 1, 4, 9];
  const shape = world.createTerrain(ground, { kind: "uniform", x0: -2, spacing: 0.5, heights });
  world.setHeights(shape, 1, [7, 8]);
  const terrain = world.terrainOf(shape);
  assert.equal(terrain.kind, "uniform");
  assert.deepEqual(Array.from(terrain.heights), [0, 7, 8, 9]);
  assert.deepEqual([terrain.x0, terrain.spacing], [-2, 0.5]);
  world.close();
});

test("options_of_bodies_and_shapes_are_read_back", () => {
  const world = engine.createWorld();
  const body = world.createBody({ kind: "kinematic", position: [1, 2], userData: 2 ** 40 + 1 });
  const shape = world.createObb(body, {
    halfWidth: 1,
    halfHeight: 2,
    offset: [0.5, 0.25],
    friction: 0.25,
    category: 0x80000000,
    sensor: true,
  });
  assert.equal(world.bodyStateOf(body).kind, "kinematic");
  assert.equal(world.bodyStateOf(body).userData, 2 ** 40 + 1);
  const state = world.shapeStateOf(shape);
  assert.deepEqual(
    [state.kind, state.halfWidth, state.halfHeight, state.offset, state.friction, state.category],
    ["obb", 1, 2, [0.5, 0.25], 0.25, 0x80000000],
  );
  assert.equal(state.sensor, true);
  assert.deepEqual(world.shapesOf(body), [shape]);
  world.close();
});

test("impulse_changes_velocity_by_impulse_over_mass", () => {
  const { world, ball } = ballOnGround({ gravity: [0, 0] });
  const { mass, center } = world.bodyStateOf(ball);
  world.applyImpulse(ball, [mass * 3, 0], center);
  world.step();
  assert.ok(Math.abs(world.bodyStateOf(ball).velocity[0] - 3) < 1e-5);
  world.close();
});

test("events_tell_begin_and_hit_of_a_landing_ball", () => {
  const { world, shape } = ballOnGround();
  let begins = 0;
  let hits = 0;
  for (let i = 0; i < 120; i++) {
    world.step();
    const { begin, hit } = world.events();
    for (const event of begin)
      if ([event.a, event.b].some((id) => id.index === shape.index)) begins++;
    for (const event of hit) {
      hits++;
      assert.ok(Math.abs(event.speed - Math.sqrt(2 * 10 * 4.5)) < 0.5, `speed ${event.speed}`);
    }
  }
  assert.deepEqual([begins, hits], [1, 1]);
  world.close();
});

test("ray_hits_ball_before_ground_and_nothing_sideways", () => {
  const { world, shape } = ballOnGround();
  const hit = world.castRay([0, 10], [0, -20]);
  assert.deepEqual(hit.shape, shape);
  assert.ok(Math.abs(hit.point[1] - 5.5) < 1e-4);
  assert.equal(world.castRay([-10, 20], [20, 0]), null);
  world.close();
});

test("overlap_finds_by_true_form_not_by_bounds", () => {
  const { world, shape } = ballOnGround();
  // Only the corner of the ball's AABB is in this area, not the ball.
  const lower = [0.45, 5.4];
  const upper = [0.6, 5.6];
  assert.deepEqual(world.overlap({ kind: "circle", center: [0, 5.6], radius: 0.2 }), [shape]);
  assert.deepEqual(world.overlap({ kind: "circle", center: [0.5, 5.5], radius: 0.1 }), []);
  assert.deepEqual(world.overlap({ kind: "bounds", lower, upper }), []);
  assert.deepEqual(world.overlap({ kind: "bounds", lower: [0.2, 5.2], upper }), [shape]);
  world.close();
});

test("shape_table_lists_every_shape_with_its_handles", () => {
  const { world, ball, shape } = ballOnGround();
  const { count, rows, handles } = world.shapeTable();
  assert.equal(count, 2);
  const at = Array.from({ length: count }, (_, i) => i).find(
    (i) => rows[10 * i] === ball.index && rows[10 * i + 1] === 0,
  );
  assert.equal(rows[10 * at + 6], 0.5);
  assert.deepEqual(Array.from(handles.slice(4 * at, 4 * at + 2)), [
    shape.index + 1,
    shape.generation,
  ]);
  assert.equal(world.shapeTableAwake()[at], 1);
  world.close();
});

test("debug_draw_gives_contacts_once_the_ball_lies", () => {
  const { world } = ballOnGround();
  const draw = () => world.draw({ contacts: true, lower: [-10, -10], upper: [10, 10] });
  assert.equal(draw().points.length, 0);
  for (let i = 0; i < 120; i++) world.step();
  assert.ok(draw().points.length >= 3);
  world.close();
});

test("debug_draw_gives_motions_pairs_and_the_intervals_of_a_plane_sweep", () => {
  const world = new thud.World(engine, { broadphase: "sweep", gravity: [0, 0] });
  const ball = (x, velocity) => {
    const body = world.createBody({ kind: "dynamic", position: [x, 0], velocity });
    world.createCircle(body, { radius: 0.5 });
  };
  ball(0, [60, 0]);
  ball(3, [0, 0]);
  ball(3.95, [0, 0]);
  world.step();
  const view = { lower: [-10, -10], upper: [10, 10] };
  const count = (options, list, stride, style) => {
    const values = world.draw({ ...view, ...options })[list];
    let found = 0;
    const last = list === "shapes" ? 7 : stride - 1;
    for (let i = 0; i < values.length; i += stride)
      if (values[i + last] === thud.DRAW_STYLES.indexOf(style)) found++;
    return found;
  };
  assert.equal(count({ motions: true }, "shapes", 9, "motion"), 2);
  assert.equal(count({ motions: true }, "lines", 5, "motion"), 2);
  assert.equal(count({ pairs: true }, "lines", 5, "pair touching"), 1);
  assert.equal(count({ axes: true }, "lines", 5, "interval"), 1);
  assert.equal(count({ axes: true }, "lines", 5, "interval overlapping"), 2);
  assert.equal(count({ cells: true }, "shapes", 9, "cell"), 0);
  world.close();
});

test("advance_runs_whole_steps_and_keeps_the_rest_as_alpha", () => {
  const { world } = ballOnGround();
  const { steps, alpha } = world.advance(2.5 / 60, 10);
  assert.equal(steps, 2);
  assert.ok(Math.abs(alpha - 0.5) < 1e-9);
  world.close();
});

test("stats_time_every_stage_when_asked", () => {
  const { world } = ballOnGround({ timed: true });
  let [whole, parts] = [0, 0]; // sums over all steps, because one step may be shorter than the clock's resolution
  for (let i = 0; i < 100; i++) {
    world.step();
    const { stepSeconds, stageSeconds } = world.stats();
    assert.deepEqual(Object.keys(stageSeconds), engine.stageNames);
    whole += stepSeconds;
    for (const seconds of Object.values(stageSeconds)) parts += seconds;
  }
  assert.equal(world.stats().steps, 100);
  assert.ok(whole > 0 && parts > 0.5 * whole && parts <= whole * (1 + 1e-9), `${parts} s of ${whole}`);
  world.close();
});

test("error_of_a_step_tells_overlap_and_lost_energy", () => {
  const world = engine.createWorld({ gravity: [0, 0] });
  const ground = world.createBody();
  world.createTerrain(ground, { kind: "flat" });
  const sunk = world.createBody({ kind: "dynamic", position: [0, 0.4] });
  world.createCircle(sunk, { radius: 0.5 });
  const slider = world.createBody({ kind: "dynamic", position: [5, 0.5], velocity: [3, -3] });
  world.createCircle(slider, { radius: 0.5 });
  assert.deepEqual(Object.values(world.stepError()), [0, 0, 0, 0, 0, 0, 0, 0, 0, 0]);
  const before = world.measure();
  world.step();
  const { penetrationMax, penetrationMean, residual, energyChange, overlaps } = world.stepError();
  const after = world.measure();
  assert.ok(penetrationMax > 0.02 && penetrationMax < 0.1);
  assert.ok(Math.abs(penetrationMax - after.penetrationMax) < 1e-6);
  assert.ok(penetrationMean > 0 && penetrationMean < penetrationMax);
  assert.ok(residual >= 0 && residual < 1);
  assert.ok(Math.abs(energyChange - (after.kineticEnergy - before.kineticEnergy)) < 1e-4);
  assert.ok(energyChange < -1);
  assert.equal(overlaps, 1);
  world.close();
});

test("time_budget_that_no_step_meets_leaves_one_substep", () => {
  const { world } = ballOnGround({ timeBudget: 1e-12, quality: "high" });
  world.step();
  assert.equal(world.stats().substeps, 8);
  for (let i = 0; i < 60; i++) world.step();
  assert.equal(world.stats().substeps, 1);
  world.close();
  throwsCode("invalid", () => engine.createWorld({ timeBudget: -1 }), /timeBudget/);
});

test("hash_is_16_hex_digits_and_equal_for_equal_runs", () => {
  const hashes = [0, 1].map(() => {
    const { world } = ballOnGround();
    for (let i = 0; i < 60; i++) world.step();
    const hash = world.hash();
    world.close();
    return hash;
  });
  assert.match(hashes[0], /^[0-9a-f]{16}$/);
  assert.equal(hashes[0], hashes[1]);
});
