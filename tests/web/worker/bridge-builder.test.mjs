/** Tests the game Bridge builder, step by step as the page's worker runs it. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { LEVELS, placeOf, ROAD_HALF } from "../../../web/public/scenes/bridge_builder/levels.js";
import { buildScene } from "../../../web/tools/scenes.mjs";
import { thud } from "../support/package.mjs";

const engine = await thud.load();
const NO_KEYS = { left: false, right: false, up: false, down: false, fire: false, restart: false };

/** The road over each gorge and the beams that carry it: lines between points of the grid. */
const ROADS = LEVELS.map(({ columns }) => [[0, 0], [columns, 0]]);
const PROPS = [
  [[[0, -1], [1, 0]], [[4, -1], [3, 0]], [[1, 0], [2, -1]], [[2, -1], [3, 0]], [[2, -1], [2, 0]]],
  [
    [[0, 0], [1, 1]], [[1, 1], [4, 1]], [[4, 1], [5, 0]],
    [[1, 1], [1, 0]], [[2, 1], [2, 0]], [[3, 1], [3, 0]], [[4, 1], [4, 0]],
    [[1, 1], [2, 0]], [[2, 1], [3, 0]], [[4, 1], [3, 0]],
  ],
  [
    [[0, 0], [1, 1]], [[1, 1], [3, 2]], [[3, 2], [4, 2]], [[4, 2], [6, 1]], [[6, 1], [7, 0]],
    [[1, 1], [1, 0]], [[6, 1], [6, 0]], [[3, 2], [3, 0]], [[4, 2], [4, 0]], [[1, 1], [2, 0]],
    [[2, 0], [3, 2]], [[6, 1], [5, 0]], [[5, 0], [4, 2]], [[3, 2], [4, 0]], [[4, 2], [3, 0]],
  ],
];

/** A game and functions to play it. */
async function open({ level = 0, eachStep = () => {} } = {}) {
  const { scene } = await buildScene(engine, "bridge_builder");
  scene.state.level = level;
  const { world } = scene;
  let step = 0;
  const run = (count = 1, held = {}, pointer = null) => {
    for (let i = 0; i < count; i++) {
      scene.update({ step: step++, held: { ...NO_KEYS, ...held }, pointer });
      world.step();
      eachStep(scene);
    }
  };
  const press = (key) => {
    run(1, { [key]: true });
    run(1);
  };
  const point = ([x, y], down) => run(1, {}, { x, y, down });
  const drag = (from, to) => {
    const [first, last] = [from, to].map((place) => placeOf(LEVELS[scene.state.level], place));
    point(first, true);
    point(last, true);
    point(last, false);
  };
  const tap = (place) => drag(place, place);
  const until = (reached, limit) => {
    for (let i = 0; i < limit && !reached(scene.state); i++) run();
    assert.ok(reached(scene.state), `not within ${limit} steps: ${scene.paint().message}`);
  };
  const cross = () => {
    press("fire");
    until(({ phase }) => phase === "won" || phase === "lost", 900);
  };
  return { scene, world, run, press, drag, tap, until, cross };
}

function figureOf({ scene }, wanted) {
  return scene.paint().figures.find(({ label }) => label === wanted)?.value;
}

const beamsOf = ({ scene }) => scene.state.plan.beams.length;

test("good_bridges_carry_what_crosses_the_three_gorges_one_after_the_other", async () => {
  const game = await open();
  const { scene, world } = game;
  for (const [i, props] of PROPS.entries()) {
    assert.equal(scene.state.level, i);
    for (const line of [ROADS[i], ...props]) game.drag(...line);
    game.cross();
    assert.equal(scene.state.phase, "won", scene.paint().message);
    assert.equal(scene.state.broken, 0);
    assert.equal(scene.state.stars[i], 2);
    assert.match(scene.paint().message, /^★★☆ Across, with \d+ saved. Save \d+ for ★★★/);
    if (i < 2) game.press("fire");
  }
  assert.deepEqual(scene.paint().buttons, { left: "Again", fire: "New game" });
  game.press("fire");
  assert.equal(scene.state.level, 0);
  assert.deepEqual(scene.state.stars, [0, 0, 0]);
  world.close();
});

for (const level of LEVELS.keys())
  test(`road_alone_breaks_in_gorge_${level + 1}_and_what_was_on_it_falls`, async () => {
    const game = await open({ level });
    const { scene, world } = game;
    game.drag(...ROADS[level]);
    game.press("fire");
    const joints = world.joints().length;
    game.until(({ broken }) => broken > 0, 600);
    assert.ok(world.joints().length < joints);
    assert.match(scene.paint().message, /breaks/);
    game.until(({ phase }) => phase === "lost", 900);
    assert.match(scene.paint().message, /gave way/);
    // In the plan, the game reports and shows in red what broke first.
    const isRed = ({ ink, halfHeight }) => ink === "bad" && halfHeight === ROAD_HALF;
    const red = () => scene.paint().marks.filter(isRed);
    game.press("fire");
    assert.match(scene.paint().message, /red broke first/);
    assert.ok(red().length >= 1);
    game.press("fire");
    game.press("fire");
    assert.equal(red().length, 0);
    world.close();
  });

test("strain_of_a_beam_grows_with_what_stands_on_it_and_colours_it", async () => {
  const game = await open();
  const { scene, world } = game;
  for (const line of [ROADS[0], ...PROPS[0]]) game.drag(...line);
  game.press("fire");
  const strain = () => Number.parseInt(figureOf(game, "Strain"), 10);
  const golden = () => {
    const boxes = scene.paint().marks.filter(({ kind, ink }) => kind === "box" && ink === "gold");
    return Math.max(...boxes.map(({ opacity = 0 }) => opacity));
  };
  game.run(30);
  const [unloaded, pale] = [strain(), golden()];
  let [most, brightest] = [0, 0];
  while (scene.state.phase === "drive") {
    game.run();
    [most, brightest] = [Math.max(most, strain()), Math.max(brightest, golden())];
  }
  assert.ok(unloaded > 0 && most > 2 * unloaded, `${unloaded} % and ${most} %`);
  assert.ok(brightest > 2 * pale);
  world.close();
});

test("what_is_too_dear_too_long_or_tied_to_nothing_is_refused", async () => {
  const game = await open();
  const { scene, world } = game;
  const refused = (from, to, why) => {
    const before = [beamsOf(game), figureOf(game, "Money")];
    game.drag(from, to);
    assert.match(scene.paint().message, why);
    assert.deepEqual([beamsOf(game), figureOf(game, "Money")], before);
  };
  refused([2, 1], [3, 1], /^Begin at a ring/);
  refused([0, -1], [3, 1], /longer than 4.5 m/);
  game.drag(...ROADS[0]);
  assert.equal(beamsOf(game), 4);
  assert.equal(figureOf(game, "Money"), "600");
  for (const line of [[[0, 0], [0, 2]], [[0, 2], [4, 2]], [[4, 2], [4, 0]]]) game.drag(...line);
  assert.equal(figureOf(game, "Money"), "200");
  refused([1, 0], [1, 0], /tap where/);
  game.tap([1, 0]);
  game.drag([0, -1], [4, -1]);
  assert.equal(figureOf(game, "Money"), "0");
  refused([2, -1], [2, 0], /^Too dear: that costs 50, and 0 is left/);
  world.close();
});

test("taps_go_on_from_beam_to_beam_and_a_tap_on_a_beam_removes_it", async () => {
  const game = await open();
  for (const place of [[0, 0], [1, 1], [2, 1], [3, 1]]) game.tap(place);
  assert.equal(beamsOf(game), 3);
  game.tap([3, 1]); // a tap on the last point ends the line
  game.tap([1.5, 1]);
  assert.equal(beamsOf(game), 2);
  game.press("left");
  assert.equal(beamsOf(game), 3);
  game.world.close();
});

test("undo_takes_back_step_by_step_and_clear_as_well", async () => {
  const game = await open();
  const counts = [];
  game.drag(...ROADS[0]);
  game.drag([0, -1], [1, 0]);
  game.press("right");
  counts.push(beamsOf(game));
  for (let i = 0; i < 4; i++) {
    game.press("left");
    counts.push(beamsOf(game));
  }
  assert.deepEqual(counts, [0, 5, 4, 0, 0]);
  assert.match(game.scene.paint().message, /nothing to undo/);
  assert.equal(figureOf(game, "Money"), "1000");
  game.world.close();
});

test("back_at_the_plan_the_bridge_is_gone_the_vehicle_back_and_the_plan_kept", async () => {
  const game = await open();
  const { scene, world } = game;
  game.run(60);
  const places = () => scene.hidden.map((slot) => [...world.poses().slice(4 * slot, 4 * slot + 2)]);
  const [start, joints, { bodies }] = [places(), world.joints().length, world.stats()];
  game.drag(...ROADS[0]);
  game.cross();
  assert.equal(scene.state.phase, "lost");
  game.press("fire");
  game.run(60);
  assert.equal(scene.state.phase, "plan");
  assert.equal(beamsOf(game), 4);
  assert.equal(world.joints().length, joints);
  assert.equal(world.stats().bodies, bodies);
  places().forEach(([x, y], i) => {
    assert.ok(Math.hypot(x - start[i][0], y - start[i][1]) < 0.01, `body ${i} is at ${x}, ${y}`);
  });
  world.close();
});

test("bridge_game_goes_the_same_way_from_copies_of_its_state_and_taken_back", async () => {
  const play = async (eachStep) => {
    const game = await open({ eachStep });
    const { scene, world } = game;
    game.drag(...ROADS[0]);
    game.press("fire");
    game.run(60);
    const saved = { bytes: world.snapshot(), state: structuredClone(scene.state) };
    const end = () => {
      game.until(({ phase }) => phase === "lost", 900);
      return { hash: world.hash(), state: structuredClone(scene.state) };
    };
    const first = end();
    game.press("fire"); // going back in time restores the destroyed bridge
    world.restore(saved.bytes);
    scene.state = structuredClone(saved.state);
    assert.deepEqual(end(), first);
    world.close();
    return first.hash;
  };
  const copying = await play((scene) => (scene.state = JSON.parse(JSON.stringify(scene.state))));
  assert.equal(copying, await play(() => {}));
});
