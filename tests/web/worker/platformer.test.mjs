/**
 * Tests the game Platformer and its level: a scripted run takes every coin and reaches the flag,
 * and the game follows its rules.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { findBodies } from "../../../web/public/scenes/platformer_game/bodies.js";
import { buildScene } from "../../../web/tools/scenes.mjs";
import { drive, hold, look, RUN, WAY } from "./platformer-run.mjs";
import { level, readLevelFile, thud } from "../support/package.mjs";

const PLANK = 2;
const COIN = 4;
const FEET = 0.75; // metres below the figure's centre

const engine = await thud.load();
const map = await level.readLevel("adventure", readLevelFile("adventure.tmj"));
const coins = map.bodies.filter(({ shapes: [{ material }] }) => material.category === COIN);

/** Starts the game; with a place, the figure stands there. */
async function start(place, choices = {}) {
  const { scene } = await buildScene(engine, "platformer_game", { choices });
  if (place) {
    // Moves the figure as the game does after a lost life: back to a checkpoint, here `place`.
    Object.assign(scene.state, { home: place, phase: "hurt", hurtFor: 1000 });
    hold(scene, "", 1);
  }
  return scene;
}

function figures(scene) {
  return Object.fromEntries(scene.paint().figures.map(({ label, value }) => [label, value]));
}

function crateAt(scene) {
  const [crate] = findBodies(scene.world, ({ kind }) => kind === "dynamic");
  return crate.position;
}

test("level_adventure_reads_without_problems_and_asks_for_a_character", () => {
  assert.deepEqual(map.problems, []);
  assert.equal(map.character, true);
  assert.equal(coins.length, 40);
});

test("scripted_run_takes_every_coin_and_wins_with_all_lives", async () => {
  const scene = await start();
  drive(scene, RUN);
  assert.equal(scene.state.phase, "won");
  const { Coins, Lives, Time } = figures(scene);
  assert.deepEqual({ Coins, Lives }, { Coins: "40 of 40", Lives: "3" });
  assert.match(scene.paint().message, new RegExp(`^You made it: ${Time}, 40 of 40 coins`));
  assert.ok(scene.state.steps > 40 * 60 && scene.state.steps < 90 * 60, `${scene.state.steps}`);
  scene.world.close();
});

for (const quality of ["draft", "exact"])
  test(`scripted_run_wins_at_quality_${quality}_too`, async () => {
    const scene = await start(null, { quality });
    drive(scene, RUN);
    assert.equal(figures(scene).Coins, "40 of 40");
    assert.equal(scene.state.phase, "won");
    scene.world.close();
  });

test("same_inputs_give_the_same_hash_and_state", async () => {
  const first = await start();
  const inputs = drive(first, RUN.slice(0, RUN.indexOf(WAY.ontoLift[0])));
  const second = await start();
  for (const keys of inputs) hold(second, keys, 1);
  assert.equal(second.world.hash(), first.world.hash());
  // The mover's memory contains handles, which differ between worlds.
  const played = ({ state }) => ({ ...state, figure: { ...state.figure, mover: null } });
  assert.deepEqual(played(second), played(first));
  assert.ok(first.state.taken.length > 20, "it gets somewhere");
  first.world.close();
  second.world.close();
});

test("state_restored_in_mid_run_leads_to_the_same_end", async () => {
  const scene = await start();
  const here = RUN.indexOf(WAY.liftAcross[6]);
  drive(scene, RUN.slice(0, here));
  hold(scene, "", 10);
  assert.ok(look(scene).standing && look(scene).x > 84, "it rides the lift across");
  const bytes = scene.world.snapshot();
  const state = structuredClone(scene.state);
  const inputs = drive(scene, RUN.slice(here));
  const end = { hash: scene.world.hash(), state: structuredClone(scene.state) };
  assert.equal(end.state.phase, "won");
  scene.world.restore(bytes);
  scene.state = state;
  scene.restored();
  for (const keys of inputs) hold(scene, keys, 1);
  assert.deepEqual({ hash: scene.world.hash(), state: scene.state }, end);
  scene.world.close();
});

test("spikes_cost_a_life_and_lead_back_to_the_checkpoint_with_the_coins_kept", async () => {
  const scene = await start();
  drive(scene, WAY.firstSteps); // until the first pit is crossed
  hold(scene, "right", 30);
  hold(scene, "", 30);
  const taken = [...scene.state.taken];
  hold(scene, "left", 60); // back into the pit
  assert.equal(scene.state.phase, "hurt");
  assert.match(scene.paint().message, /2 lives left/);
  hold(scene, "", 60);
  assert.equal(scene.state.phase, "playing");
  assert.equal(figures(scene).Lives, "2");
  assert.deepEqual(scene.state.taken, taken);
  assert.ok(Math.abs(look(scene).x - 28) < 0.1, "at the checkpoint behind the pit");
  scene.world.close();
});

test("last_life_lost_ends_the_game_and_restart_begins_it_anew", async () => {
  const scene = await start([24, 4]); // above spikes, where every life is lost
  drive(scene, [["", ({ phase }) => phase === "over"]]);
  assert.equal(figures(scene).Lives, "0");
  assert.match(scene.paint().message, /^Game over/);
  hold(scene, "restart", 1);
  const { Coins, Lives, Time } = figures(scene);
  assert.deepEqual({ Coins, Lives, Time }, { Coins: "0 of 40", Lives: "3", Time: "0.0 s" });
  assert.deepEqual([look(scene).x, look(scene).y], [...map.spawn]);
  scene.world.close();
});

test("moving_platform_carries_the_figure_across_the_pit", async () => {
  const scene = await start([81.6, 4.8]);
  hold(scene, "", 10);
  const { x, lifts } = look(scene);
  const offset = x - lifts[0].position[0];
  hold(scene, "", 120);
  const later = look(scene);
  assert.equal(later.standing, true);
  assert.ok(later.x > x + 3, `from ${x} to ${later.x}`);
  // The figure moves before the step and the lift in it, so they differ by one step of the lift's
  // speed.
  assert.ok(Math.abs(later.x - later.lifts[0].position[0] - offset) < 0.06);
  scene.world.close();
});

test("one_way_plank_passes_from_below_holds_from_above_and_drops_with_down", async () => {
  const scene = await start([37, 4.8]);
  hold(scene, "", 10);
  hold(scene, "up", 60);
  const top = 6.4 + 0.15;
  assert.ok(Math.abs(look(scene).y - FEET - top) < 0.05, `on the plank: ${look(scene).y}`);
  hold(scene, "down", 60);
  assert.ok(Math.abs(look(scene).y - FEET - 4) < 0.05, `on the ground: ${look(scene).y}`);
  scene.world.close();
});

test("wall_is_too_high_without_the_crate_and_not_with_it", async () => {
  const scene = await start([106, 4.8]);
  const [x0] = crateAt(scene);
  hold(scene, "right", 60);
  hold(scene, "right up", 60);
  assert.ok(look(scene).x < 110, "the wall stops it");
  drive(scene, [
    ["left", ({ x }) => x < 105],
    ["left up", ({ x }) => x < 100.5], // jump over the crate
    ["right", ({ x }) => x > 108.1],
    ["", ({ standing }) => standing],
  ]);
  const [x1] = crateAt(scene);
  assert.ok(x1 > x0 + 5 && x1 > 109, `the crate was pushed from ${x0} to the wall: ${x1}`);
  drive(scene, [
    ["left", ({ x }) => x < 106.5],
    ["right", ({ x }) => x > 106.8],
    ["right up", ({ x }) => x > 109],
    ["", ({ standing }) => standing],
    ["up", ({ y }) => y > 8],
    ["right up", ({ x, standing }) => standing && x > 110],
  ]);
  assert.ok(Math.abs(look(scene).y - FEET - 8) < 0.05, "it stands on the wall");
  scene.world.close();
});

test("lost_life_puts_the_crates_back", async () => {
  const scene = await start([100, 4.8]);
  const [x0] = crateAt(scene);
  hold(scene, "right", 60);
  assert.ok(crateAt(scene)[0] > x0 + 1);
  Object.assign(scene.state, { phase: "hurt", hurtFor: 1000 });
  hold(scene, "", 2);
  assert.ok(Math.abs(crateAt(scene)[0] - x0) < 1e-3);
  scene.world.close();
});

test("picture_has_a_circle_for_every_coin_left_and_follows_the_figure", async () => {
  const scene = await start();
  const golden = () => scene.paint().marks.filter(({ ink, filled }) => ink === "gold" && filled);
  assert.equal(golden().length, coins.length);
  drive(scene, WAY.firstSteps.slice(0, 1));
  assert.equal(golden().length, coins.length - 2);
  const { follow, marks } = scene.paint();
  assert.ok(Math.abs(follow[0] - look(scene).x) < 1e-9);
  assert.equal(marks.filter(({ kind }) => kind === "figure").length, 1);
  const { rows, count } = scene.world.shapeTable();
  const sensors = Array.from({ length: count }, (_, i) => i).filter((i) => rows[10 * i + 3] !== 0);
  for (const i of sensors)
    assert.ok(scene.hidden.includes(rows[10 * i]), "painted, so not drawn as a body");
  scene.world.close();
});

test("grass_lies_on_what_stands_still_and_under_nothing_that_does", async () => {
  const scene = await start();
  const solid = (x, y) =>
    scene.world
      .overlap({ kind: "circle", center: [x, y], radius: 0.01 })
      .map((shape) => scene.world.shapeStateOf(shape))
      .some(({ body, category }) =>
        category !== PLANK && scene.world.bodyStateOf(body).kind === "static");
  const grass = scene.paint().marks.filter(({ kind, ink, points }) =>
    kind === "line" && ink === "good" && points.length === 2 && points[0][1] === points[1][1]);
  assert.ok(grass.length > 20, `${grass.length} lines`);
  for (const { points: [[left, y], [right]] } of grass)
    for (const x of [left + 0.05, (left + right) / 2, right - 0.05]) {
      assert.ok(solid(x, y - 0.05), `nothing below (${x}, ${y})`);
      assert.ok(!solid(x, y + 0.05), `covered at (${x}, ${y})`);
    }
  // The place where the figure starts.
  const [x, y] = map.spawn;
  assert.ok(grass.some(({ points: [[left, top], [right]] }) =>
    left < x && x < right && y - top < 2 && y > top));
  scene.world.close();
});
