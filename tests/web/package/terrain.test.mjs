/** Tests terrain in the npm package: heights and normals, placing feet, and edits. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { thud } from "../support/package.mjs";

const engine = await thud.load();

function near(value, wanted, tolerance = 1e-9) {
  assert.ok(Math.abs(value - wanted) <= tolerance, `${value} is not ${wanted}`);
}

function throwsCode(code, act) {
  assert.throws(act, (error) => error instanceof thud.ThudError && error.code === code);
}

/** A valley between two hills, on a body at (100, 50). */
function valley(kind = "irregular") {
  const world = engine.createWorld();
  const ground = world.createBody({ position: [100, 50] });
  const line =
    kind === "irregular"
      ? { kind, points: [[-10, 4], [-4, 0], [4, 0], [10, 4]] }
      : { kind, x0: -10, spacing: 0.5, heights: new Float64Array(41) };
  return { world, shape: world.createTerrain(ground, line) };
}

test("ground_at_gives_height_normal_and_weights_of_a_place_in_the_world", () => {
  const { world, shape } = valley();
  const { height, normal, segment, weights } = world.groundAt(shape, 107);
  near(height, 52);
  near(normal[0], -4 / Math.hypot(4, 6));
  near(normal[1], 6 / Math.hypot(4, 6));
  assert.equal(segment, 2);
  near(weights[0], 0.5);
  near(weights[1], 0.5);
  throwsCode("invalid", () => world.groundAt(shape, 89));
  world.close();
});

test("foot_stands_on_the_highest_ground_under_the_sole", () => {
  const { world, shape } = valley();
  const foot = world.placeFoot(shape, 104, 3);
  near(foot.height, 51);
  near(foot.x, 105.5);
  near(foot.normal[0], -1 / Math.hypot(1, 3));
  throwsCode("invalid", () => world.placeFoot(shape, 104, -1));
  world.close();
});

test("dig_and_raise_change_ground_and_wake_what_rests_there", () => {
  const { world, shape } = valley("uniform");
  const ball = world.createBody({ kind: "dynamic", position: [100, 50.5] });
  const far = world.createBody({ kind: "dynamic", position: [108, 50.5] });
  for (const body of [ball, far]) world.createObb(body, { halfWidth: 0.5, halfHeight: 0.5 });
  for (let i = 0; i < 120; i++) world.step();
  assert.equal(world.bodyStateOf(ball).awake, false);
  world.dig(shape, [100, 50], 2);
  near(world.groundAt(shape, 100).height, 48, 1e-6);
  world.step();
  assert.equal(world.bodyStateOf(ball).awake, true);
  assert.equal(world.bodyStateOf(far).awake, false);
  for (let i = 0; i < 200; i++) world.step();
  assert.ok(world.bodyStateOf(ball).position[1] < 49);
  world.raise(shape, 94, 2, 1);
  near(world.groundAt(shape, 94).height, 51);
  near(world.groundAt(shape, 92).height, 50);
  world.close();
});

test("replace_range_puts_other_points_between_two_places", () => {
  const { world, shape } = valley();
  world.replaceRange(shape, -5, 5, [[-2, 3], [0, 2], [1, 3]]);
  world.replaceRange(shape, 9, 11, []);
  assert.deepEqual(world.terrainOf(shape).points, [[-10, 4], [-2, 3], [0, 2], [1, 3]]);
  world.close();
});

test("edits_with_bad_input_throw_and_leave_the_ground", () => {
  const { world, shape } = valley();
  const flat = world.createTerrain(world.createBody(), { kind: "flat" });
  const before = world.terrainOf(shape);
  throwsCode("invalid", () => world.dig(shape, [0, NaN], 1));
  throwsCode("invalid", () => world.dig(shape, [100, 50], 0));
  throwsCode("invalid", () => world.dig(flat, [100, 50], 1));
  throwsCode("invalid", () => world.raise(shape, 100, -1, 1));
  throwsCode("invalid", () => world.replaceRange(shape, 1, 0, []));
  throwsCode("invalid", () => world.replaceRange(shape, -20, 20, [[1, 1]]));
  throwsCode("invalid", () => world.replaceRange(shape, 0, 5, [[2, 1], [1, 1]]));
  throwsCode("stale", () => world.dig({ ...shape, generation: shape.generation + 1 }, [0, 0], 1));
  assert.deepEqual(world.terrainOf(shape), before);
  world.close();
});

test("handle_is_right_where_the_call_makes_the_memory_grow", async () => {
  const fresh = await thud.load();
  let grown = 0;
  for (let i = 0; i < 6; i++) {
    const world = fresh.createWorld();
    const before = fresh.buffer.byteLength;
    const heights = new Float64Array(300_000);
    const ground = world.createTerrain(world.createBody(), { kind: "uniform", x0: 0, spacing: 1, heights });
    grown += fresh.buffer.byteLength > before;
    assert.ok(world.isValid(ground));
    assert.equal(world.terrainOf(ground).kind, "uniform");
  }
  assert.ok(grown > 0, "the memory has grown within a call");
});
