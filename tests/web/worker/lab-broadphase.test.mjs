/**
 * Tests the counts of a broadphase in JavaScript, and the laboratory's scene that reads them out.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { buildScene } from "../../../web/tools/scenes.mjs";
import { thud } from "../support/package.mjs";

const engine = await thud.load();
const CHOICES = ["all", "grid", "sweep", "sweep_y", "sweep_widest", "sweep_both"];

/** A world of circles of radius 0.25 at the places, after one step. */
function worldOf(options, places) {
  const world = engine.createWorld({ gravity: [0, 0], ...options });
  for (const position of places) {
    const body = world.createBody({ kind: "dynamic", position, maySleep: false });
    world.createCircle(body, { radius: 0.25, mask: 0 });
  }
  world.step();
  return world;
}

const square = (side, apart) =>
  Array.from({ length: side * side }, (_, i) => [apart * (i % side), apart * Math.floor(i / side)]);

test("every_broadphase_finds_the_same_pairs_and_counts_its_tests", () => {
  const side = 12;
  for (const broadphase of CHOICES) {
    const world = worldOf({ broadphase }, square(side, 0.4));
    const counts = world.broadphaseCounts();
    assert.equal(counts.moved, side * side, broadphase);
    assert.equal(counts.found, 4 * (side - 1) ** 2 + 2 * (side - 1), broadphase);
    if (broadphase === "all") assert.equal(counts.tested, (144 * 143) / 2);
    assert.ok(counts.tested >= counts.found, broadphase);
    assert.equal(counts.cells > 0, broadphase === "grid");
    world.close();
  }
});

test("cell_size_is_a_choice_of_the_world_with_a_range", () => {
  const fours = worldOf({ cellSize: 4 }, square(16, 1.01));
  const { cells, cellShapes, cellShapesMax } = fours.broadphaseCounts();
  assert.deepEqual([cells, cellShapes, cellShapesMax], [16, 256, 16]);
  fours.close();
  for (const cellSize of [-1, 16385, Infinity])
    assert.throws(() => engine.createWorld({ cellSize }), { code: "invalid" });
});

const textOf = (paint, control, name) =>
  Object.fromEntries(paint.readings[control])[name];
const numberOf = (...wanted) => Number(textOf(...wanted).split(" ")[0].replaceAll(",", ""));

function makeStep(scene, step) {
  scene.update({ step });
  scene.world.step();
  return scene.paint();
}

test("scene_reads_out_the_same_pairs_of_every_broadphase_and_its_own_tests", async () => {
  const { scene } = await buildScene(engine, "lab_broadphase", { size: 200 });
  const tested = {};
  for (let i = 0; i < 30; i++) makeStep(scene, i);
  const found = new Set();
  for (const broadphase of CHOICES) {
    scene.state.broadphase = broadphase;
    const paint = scene.paint();
    tested[broadphase] = numberOf(paint, "counts", "Pairs tested");
    found.add(textOf(paint, "counts", "Pairs found"));
    assert.equal(numberOf(paint, "counts", "Tests a circle"), tested[broadphase] / 200);
  }
  assert.equal(found.size, 1);
  assert.equal(tested.all, (200 * 199) / 2);
  for (const quick of ["grid", "sweep", "sweep_y", "sweep_widest"])
    assert.ok(tested[quick] < tested.all / 4, `${quick}: ${tested[quick]}`);
  scene.close();
  scene.world.close();
});

test("scene_gathers_all_circles_in_one_cell_in_which_the_grid_tests_all_pairs", async () => {
  const { scene } = await buildScene(engine, "lab_broadphase", { size: 100 });
  Object.assign(scene.state, { broadphase: "grid", cellSize: 20, arrangement: "gathered" });
  const paint = [makeStep(scene, 0), makeStep(scene, 1)].at(-1);
  assert.equal(numberOf(paint, "cells", "Cells used"), 1);
  assert.equal(numberOf(paint, "cells", "Most in a cell"), 100);
  assert.equal(numberOf(paint, "counts", "Pairs tested"), (100 * 99) / 2);
  assert.ok(numberOf(paint, "counts", "Pairs found") > 4000);
  scene.close();
  scene.world.close();
});

test("scene_repairs_fewer_inversions_than_there_are_pairs_and_more_than_none", async () => {
  const { scene } = await buildScene(engine, "lab_broadphase", { size: 300 });
  scene.state.broadphase = "sweep";
  for (let i = 0; i < 5; i++) makeStep(scene, i);
  const repaired = numberOf(makeStep(scene, 5), "counts", "Inversions repaired");
  assert.ok(repaired > 0 && repaired < 300 * 8, `${repaired}`);
  scene.close();
  scene.world.close();
});
