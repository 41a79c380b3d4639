/**
 * Tests the laboratory's terrain: its numbers against weights, heights and friction that are computed
 * here, the ground of the world against the line that is shown, and what pointer and keys change.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { halvings, longLine } from "../../../web/public/scenes/lab_terrain/cost.js";
import { buildScene, openSession } from "../../../web/tools/scenes.mjs";
import { thud } from "../support/package.mjs";

const engine = await thud.load();
const LINES = ["flat", "uniform", "irregular"];
const near = (actual, expected, tolerance = 0.0051) =>
  assert.ok(Math.abs(actual - expected) <= tolerance, `${actual}, not ${expected}`);
const NO_KEYS = { left: false, right: false, up: false, down: false, fire: false, restart: false };

/** Makes steps with these keys down. */
function steps(scene, count, keys = {}) {
  for (let i = 0; i < count; i++) {
    scene.update({ step: i, held: { ...NO_KEYS, ...keys }, pointer: null });
    scene.world.step();
  }
}

/** The rows below a control, by their names; numbers where the value begins with one. */
function rowsOf(scene, name) {
  return Object.fromEntries(scene.paint().readings[name]);
}

/** x and y of the vertices, as the state has them; of flat ground at x = 0 and 1. */
function verticesOf(state) {
  if (state.line === "flat") return [[0, 0], [1, state.y8 / 8]];
  return Array.from({ length: 9 }, (_, i) => [
    state.line === "uniform" ? 2 * i - 8 : state[`x${i}`],
    state[`y${i}`],
  ]);
}

/** The two weights, and what they make of heights and texture coordinates. */
function byHand(state, x) {
  const points = verticesOf(state);
  const right = state.line === "flat" ? 1 : points.findIndex(([px], i) => i > 0 && px > x);
  const [[x0, y0], [x1, y1]] = points.slice(right - 1, right + 1);
  const weights = [(x1 - x) / (x1 - x0), (x - x0) / (x1 - x0)];
  const us = state.line === "flat" ? [0.5, 0.5625] : [(right - 1) / 8, right / 8];
  const u = weights[0] * us[0] + weights[1] * us[1];
  const friction = (1 - u) * state.left + u * state.right;
  return { weights, height: weights[0] * y0 + weights[1] * y1, u, friction, right };
}

for (const line of LINES)
  test(`place_on_${line}_ground_has_the_weights_height_and_friction_worked_out_here`, async () => {
    const { scene, close } = await buildScene(engine, "lab_terrain");
    scene.state.line = line;
    for (const x of [-7.9, -3.05, 0, 0.7, 4.55, 7.9]) {
      scene.state.x = x;
      const rows = rowsOf(scene, "weights");
      const wanted = byHand(scene.state, x);
      rows["Their weights"].split(" and ").forEach((weight, i) => near(Number(weight), wanted.weights[i]));
      near(Number(rows.Height), wanted.height);
      near(Number(rows["Texture coordinate"]), wanted.u);
      near(Number(rows.Friction), wanted.friction);
      const names = line === "flat" ? "x = 0 and x = 1" : `${wanted.right - 1} and ${wanted.right}`;
      assert.equal(rows["Between vertices"], names);
    }
    close();
  });

for (const line of LINES)
  test(`box_on_${line}_ground_has_the_friction_of_its_place_and_stops_where_the_sum_says`, async () => {
    const { scene, close } = await buildScene(engine, "lab_terrain");
    scene.state.line = line;
    // An even slope, on which the box never leaves the ground.
    for (let i = 0; i < 9; i++)
      scene.state[`y${i}`] = 0.05 * (line === "irregular" ? scene.state[`x${i}`] : 2 * i - 8);
    steps(scene, 60);
    const rows = rowsOf(scene, "box");
    const { friction } = byHand(scene.state, Number(rows["At x"]));
    near(Number(rows["Friction of the ground"]), friction);
    near(Number(rows["With the box’s 1"]), Math.sqrt(friction), 0.01);
    steps(scene, 200);
    const { ["It last stopped at x"]: stopped, ["By v dv = −g (μ + slope) dx"]: summed } = rowsOf(scene, "box");
    near(Number(stopped), Number(summed), 0.06);
    // With the friction of its start all the way it would stop sooner.
    const even = -7.2 + 49 / (20 * (Math.sqrt(byHand(scene.state, -7.2).friction) + 0.05));
    assert.ok(Number(stopped) - even > 0.12, `${stopped} and ${even}`);
    close();
  });

test("soles_stand_on_the_highest_ground_below_them_and_the_slope_is_that_of_the_stance", async () => {
  const { scene, close } = await buildScene(engine, "lab_terrain");
  Object.assign(scene.state, { line: "uniform", x: 0, stance: 2 });
  for (let i = 0; i < 9; i++) scene.state[`y${i}`] = [0, 0, 0, 0, 0, 1, 0, 0, 0][i]; // a peak at x = 2
  const rows = rowsOf(scene, "foot");
  near(Number(rows["Left foot, height"]), 0);
  near(Number(rows["Right foot, height"]), 0.625); // the sole reaches from x = 0.75 to 1.25
  assert.equal(rows["Highest in the stance"], "0.50 at x 1.00");
  near(Number.parseFloat(rows["Lean by"]), (Math.atan2(0.5, 2) * 180) / Math.PI, 0.051);
  close();
});

test("pointer_drags_vertices_and_the_place_and_the_worlds_ground_follows", async () => {
  const { scene, close } = await buildScene(engine, "lab_terrain");
  const { state } = scene;
  scene.pointed({ x: 3.4, y: -0.3, down: false });
  assert.equal(state.near, 6);
  scene.pointed({ x: 3.4, y: -0.3, down: true });
  scene.pointed({ x: 4.12, y: 0.83, down: true });
  scene.pointed({ x: 99, y: 99, down: true }); // held within its limits, and left of the next vertex
  steps(scene, 1);
  const { points } = scene.world.terrainOf(state.ground);
  near(points[6][0], 6.2 + 0.25, 1.3);
  assert.ok(points.every(([x], i) => i === 0 || x > points[i - 1][0]));
  assert.equal(points[6][1], 3);
  scene.pointed({ x: 0, y: 0, down: false });
  scene.pointed({ x: 1.02, y: 3.5, down: true });
  assert.equal(state.x, 1);
  scene.pointed({ x: 1.02, y: 3.5, down: false });
  for (const line of LINES) {
    state.line = line;
    state.right = 0.4;
    steps(scene, 2);
    for (const x of [-7.4, -1, 2.9, 7])
      near(scene.world.frictionAt(state.ground, x), byHand({ ...state, x6: points[6][0], x7: points[7][0] }, x).friction, 1e-6);
  }
  close();
});

test("keys_move_the_place_raise_the_nearest_vertex_and_send_the_box", async () => {
  const { scene, close } = await buildScene(engine, "lab_terrain");
  const { state } = scene;
  steps(scene, 1);
  state.x = 1.5;
  const before = state.y5;
  steps(scene, 4, { up: true });
  near(state.y5, before + 0.2, 1e-9);
  steps(scene, 2, { down: true, right: true });
  near(state.y5, before + 0.1, 1e-9);
  near(state.x, 1.6, 1e-9);
  state.line = "flat";
  steps(scene, 2, { up: true });
  near(state.y8, 0.6, 1e-9);
  steps(scene, 30);
  const there = Number(rowsOf(scene, "box")["At x"]);
  steps(scene, 1, { fire: true });
  assert.ok(Number(rowsOf(scene, "box")["At x"]) < there - 1);
  steps(scene, 20, { fire: true }); // held down, it fires once
  assert.ok(Number(rowsOf(scene, "box")["At x"]) > -6);
  close();
});

test("look_ups_are_counted_and_timed_one_kind_with_each_picture", async () => {
  assert.deepEqual([2, 3, 5, 9, 10, 1025].map(halvings), [0, 1, 2, 3, 4, 10]);
  const { points } = longLine("irregular", 1000);
  assert.ok(points.every(([x], i) => i === 0 || x > points[i - 1][0]));
  const { scene, close } = await buildScene(engine, "lab_terrain");
  assert.deepEqual(rowsOf(scene, "cost"), {}); // it is not measured before it is ticked
  Object.assign(scene.state, { cost: true, size: 9 });
  const pictures = [1, 2, 3].map(() => Object.values(rowsOf(scene, "cost")));
  assert.deepEqual(pictures.map((values) => values.filter((value) => /^[\d.]+ ns$/.test(value)).length), [1, 2, 3]);
  assert.equal(rowsOf(scene, "cost").Vertices, "512");
  assert.ok("Irregular, 9 halvings" in rowsOf(scene, "cost"));
  close();
});

test("ground_and_texture_come_again_in_the_past", async () => {
  const session = await openSession(engine, "lab_terrain");
  for (let i = 0; i < 60; i++) session.makeStep();
  const { world, state } = session.scene;
  const hash = world.hash();
  state.line = "uniform";
  state.y4 = 2;
  for (let i = 0; i < 30; i++) session.makeStep();
  assert.equal(world.terrainOf(state.ground).kind, "uniform");
  session.seek(60);
  const again = session.scene;
  assert.deepEqual(again.world.hash(), hash);
  assert.equal(again.world.terrainOf(again.state.ground).kind, "irregular");
  near(again.world.frictionAt(again.state.ground, 0), byHand(again.state, 0).friction, 1e-6);
  session.close();
});
