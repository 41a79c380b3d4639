/** Tests the game Artillery, step by step as the page's worker runs it. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { directionOf } from "../../../web/public/scenes/artillery/flight.js";
import { CRATER } from "../../../web/public/scenes/artillery/blast.js";
import { buildScene } from "../../../web/tools/scenes.mjs";
import { thud } from "../support/package.mjs";

const engine = await thud.load();
const NO_KEYS = { left: false, right: false, up: false, down: false, fire: false, restart: false };

/** A game and functions to play it. `eachStep` gets the scene after every step. */
async function open({ seed = 0, eachStep = () => {} } = {}) {
  const { scene } = await buildScene(engine, "artillery", { seed });
  const { world } = scene;
  let step = 0;
  const run = (count = 1, held = {}, pointer = null) => {
    for (let i = 0; i < count; i++) {
      scene.update({ step: step++, held: { ...NO_KEYS, ...held }, pointer });
      world.step();
      eachStep(scene);
    }
  };
  const until = (reached, limit) => {
    for (let i = 0; i < limit && !reached(scene.state); i++) run();
    assert.ok(reached(scene.state), `not within ${limit} steps: ${scene.state.message}`);
  };
  const press = (key) => {
    run(1, { [key]: true });
    run(1);
  };
  return { scene, world, run, until, press };
}

/** The first player's turn against another player, without wind. */
async function openAiming(options) {
  const game = await open(options);
  game.run(120);
  game.press("right");
  game.scene.state.wind = 0;
  return game;
}

/** The position of a body, by its slot. */
function place(world, slot) {
  return world.poses().slice(4 * slot, 4 * slot + 2);
}

/** The position of a tank; `hidden` has the shell's slot first, then those of the tanks. */
function tankPlace({ scene, world }, i) {
  return place(world, scene.hidden[1 + i]);
}

/** The shape of the ground, found by a ray at the edge of the field, where nothing else is. */
function groundOf(world) {
  return world.castRay([-59.5, 1000], [0, -2000]).shape;
}

/** Fires, and returns the shell's positions until it lands; the last is where it lands. */
function fly(game) {
  const { scene, world, run } = game;
  run(1, { fire: true });
  const places = [];
  while (scene.state.phase === "fly") {
    places.push(place(world, scene.hidden[0]));
    run();
  }
  return places;
}

test("shot_without_wind_flies_the_parabola", async () => {
  const game = await openAiming();
  const own = game.scene.state.tanks[0];
  own.angle = 70;
  own.speed = 20;
  const places = fly(game);
  assert.ok(places.length > 100);
  const radians = (70 * Math.PI) / 180;
  for (const i of [30, 100]) {
    const [t0, t] = [1 / 60, (i + 1) / 60]; // the first position is that after one step
    const across = 20 * Math.cos(radians) * (t - t0);
    const up = 20 * Math.sin(radians) * (t - t0) - 5 * (t * t - t0 * t0);
    assert.ok(Math.abs(places[i][0] - places[0][0] - across) < 0.05);
    assert.ok(Math.abs(places[i][1] - places[0][1] - up) < 0.05);
  }
  game.world.close();
});

test("wind_carries_the_shell", async () => {
  const game = await openAiming();
  game.scene.state.tanks[0].angle = 90;
  game.scene.state.wind = 2;
  const places = fly(game);
  const seconds = (places.length - 2) / 60;
  const carried = places.at(-2)[0] - places[0][0];
  assert.ok(Math.abs(carried - seconds ** 2) < 0.1 * seconds ** 2, `${carried} in ${seconds} s`);
  game.world.close();
});

test("shell_leaves_a_crater_where_it_hit", async () => {
  const game = await openAiming();
  game.scene.state.tanks[0].angle = 75;
  const { world } = game;
  const shape = groundOf(world);
  const { x0, spacing, heights } = world.terrainOf(shape);
  const [x, y] = fly(game).at(-1);
  const vertex = Math.round((x - x0) / spacing);
  // The shell may have hit a crate, one metre above the ground.
  const left = world.groundAt(shape, x0 + vertex * spacing).height;
  assert.ok(left < heights[vertex] - 0.5);
  assert.ok(Math.abs(left - (y - CRATER)) < 0.1, `${left} is left under ${y}`);
  game.world.close();
});

test("direct_hit_takes_health_from_the_tank_alone_that_it_meets", async () => {
  const game = await openAiming();
  const { tanks } = game.scene.state;
  tanks[0].angle = 90; // straight up, so that it falls back onto the tank that fired
  fly(game);
  assert.ok(game.scene.state.tanks[0].health < 60);
  assert.equal(game.scene.state.tanks[1].health, 100);
  assert.match(game.scene.state.message, /Left: −\d+/);
  game.world.close();
});

test("tank_falls_into_a_crater_under_it", async () => {
  const game = await openAiming();
  game.scene.state.tanks[0].angle = 90;
  const [, before] = tankPlace(game, 0);
  fly(game);
  game.until(({ phase }) => phase === "aim", 600);
  assert.ok(tankPlace(game, 0)[1] < before - 0.5);
  game.world.close();
});

test("hard_landing_of_a_tank_hurts_it_and_a_soft_one_does_not", async () => {
  for (const [height, hurts] of [[8, true], [0.5, false]]) {
    const game = await openAiming();
    const { world, scene } = game;
    const [x, y] = tankPlace(game, 0);
    const [shape] = world.overlap({ kind: "circle", center: [x, y], radius: 0.1 });
    world.setTransform(world.shapeStateOf(shape).body, [x, y + height]);
    game.run(150);
    assert.equal(scene.state.tanks[0].health < 100, hurts);
    world.close();
  }
});

test("turns_alternate_and_each_has_its_wind", async () => {
  const game = await openAiming();
  const turns = [];
  const winds = new Set();
  for (let i = 0; i < 4; i++) {
    turns.push(game.scene.state.turn);
    winds.add(game.scene.state.wind);
    game.scene.state.tanks[game.scene.state.turn].angle = game.scene.state.turn === 0 ? 130 : 50;
    fly(game);
    game.until(({ phase }) => phase !== "settle", 400);
  }
  assert.deepEqual(turns, [0, 1, 0, 1]);
  assert.equal(winds.size, 4);
  game.world.close();
});

test("keys_turn_the_barrel_and_change_the_power", async () => {
  const game = await openAiming();
  const { angle, speed } = game.scene.state.tanks[0];
  game.press("left");
  game.press("up");
  const after = game.scene.state.tanks[0];
  assert.equal(after.angle, angle + 1);
  assert.ok(after.speed > speed);
  game.run(60, { right: true });
  assert.ok(game.scene.state.tanks[0].angle < angle - 15);
  game.world.close();
});

test("key_that_chose_the_players_does_not_turn_the_barrel", async () => {
  const game = await open();
  const { angle } = game.scene.state.tanks[0];
  game.run(10, { left: true });
  assert.equal(game.scene.state.phase, "aim");
  assert.equal(game.scene.state.tanks[0].angle, angle);
  game.world.close();
});

test("drawing_back_aims_and_letting_go_fires", async () => {
  const game = await openAiming();
  const at = (x, y, down) => ({ x, y, down });
  game.run(1, {}, at(3, 5, true));
  game.run(5, {}, at(-3, -1, true));
  assert.equal(Math.round(game.scene.state.tanks[0].angle), 45);
  assert.ok(Math.abs(game.scene.state.tanks[0].speed - (28 * Math.hypot(6, 6)) / 12) < 1e-9);
  assert.equal(game.scene.state.phase, "aim");
  game.run(1, {}, at(-3, -1, false));
  assert.equal(game.scene.state.phase, "fly");
  game.world.close();
});

test("drawing_back_and_returning_fires_nothing", async () => {
  const game = await openAiming();
  game.run(1, {}, { x: 3, y: 5, down: true });
  game.run(1, {}, { x: -3, y: 5, down: true });
  game.run(1, {}, { x: 3, y: 5, down: true });
  game.run(2, {}, { x: 3, y: 5, down: false });
  assert.equal(game.scene.state.phase, "aim");
  game.world.close();
});

for (const seed of [0, 1, 2, 3, 4, 5, 6, 7])
  test(`computer_wins_within_12_shots_against_who_shoots_away_seed_${seed}`, async () => {
    const game = await open({ seed });
    const { scene } = game;
    game.run(60);
    game.press("left");
    assert.equal(scene.state.computer, true);
    for (let shots = 0; shots < 12 && scene.state.phase !== "over"; shots++) {
      game.until(({ phase, turn }) => phase === "over" || (phase === "aim" && turn === 0), 3000);
      if (scene.state.phase === "over") break;
      scene.state.tanks[0].angle = 135; // away from the computer
      fly(game);
    }
    game.until(({ phase }) => phase === "over", 3000);
    assert.equal(scene.state.tanks[0].health, 0);
    assert.ok(scene.state.tanks[1].health > 0);
    assert.match(scene.state.message, /^Computer wins/);
    game.world.close();
  });

test("restart_after_the_end_brings_ground_tanks_and_health_back", async () => {
  const game = await open();
  const { scene, world } = game;
  game.run(2);
  const start = [0, 1].map((i) => tankPlace(game, i));
  const ground = world.terrainOf(groundOf(world));
  game.run(120);
  game.press("right");
  for (let i = 0; i < 8 && scene.state.phase !== "over"; i++) {
    if (scene.state.turn === 0) scene.state.wind = 0;
    scene.state.tanks[scene.state.turn].angle = scene.state.turn === 0 ? 90 : 50;
    fly(game);
    game.until(({ phase }) => phase !== "settle", 400);
  }
  assert.equal(scene.state.phase, "over");
  assert.match(scene.state.message, /^Right wins/);
  assert.notDeepEqual(world.terrainOf(groundOf(world)), ground);
  game.press("restart");
  assert.equal(scene.state.phase, "choose");
  assert.deepEqual(scene.state.tanks.map(({ health }) => health), [100, 100]);
  assert.deepEqual(world.terrainOf(groundOf(world)), ground);
  start.forEach(([x, y], i) => {
    const [newX, newY] = tankPlace(game, i);
    assert.ok(Math.hypot(newX - x, newY - y) < 0.001, `tank ${i} is at ${newX}, ${newY}`);
  });
  game.world.close();
});

test("game_goes_the_same_way_from_copies_of_its_state", async () => {
  const play = async (eachStep) => {
    const game = await open({ seed: 3, eachStep });
    game.run(60);
    game.press("left");
    game.run(20, { up: true });
    fly(game);
    game.until(({ phase, turn, waited }) => phase === "aim" && turn === 0 && waited > 5, 3000);
    const end = { hash: game.world.hash(), state: structuredClone(game.scene.state) };
    game.world.close();
    return end;
  };
  const copying = await play((scene) => (scene.state = JSON.parse(JSON.stringify(scene.state))));
  assert.deepEqual(copying, await play(() => {}));
});

test("game_taken_back_in_mid_flight_goes_the_same_way_again", async () => {
  const game = await open({ seed: 3 });
  const { scene, world } = game;
  game.run(60);
  game.press("left");
  game.run(20, { up: true });
  game.run(20, { fire: true });
  assert.equal(scene.state.phase, "fly");
  const saved = { bytes: world.snapshot(), state: structuredClone(scene.state) };
  const playOn = () => {
    game.until(({ phase, turn, waited }) => phase === "aim" && turn === 0 && waited > 5, 3000);
    return { hash: world.hash(), state: structuredClone(scene.state) };
  };
  const first = playOn();
  world.restore(saved.bytes);
  scene.state = structuredClone(saved.state);
  assert.notEqual(world.hash(), first.hash);
  assert.deepEqual(playOn(), first);
  world.close();
});

test("another_seed_plays_on_another_stretch", async () => {
  const grounds = new Set();
  for (const seed of [0, 1, 2, 3]) {
    const { world } = await open({ seed });
    grounds.add(world.terrainOf(groundOf(world)).heights.join());
    world.close();
  }
  assert.equal(grounds.size, 4);
});

test("picture_shows_both_tanks_the_path_and_the_figures", async () => {
  const game = await openAiming();
  const { marks, figures, message, follow } = game.scene.paint();
  assert.deepEqual(figures.map(({ label }) => label), ["Left", "Right", "Wind", "Angle", "Power"]);
  assert.match(message, /^Left’s turn/);
  assert.deepEqual(follow, [game.scene.view.x, game.scene.view.y]);
  for (const i of [0, 1])
    assert.ok(Math.abs(tankPlace(game, i)[0]) < 0.5 * game.scene.view.width - 2);
  assert.ok(marks.filter(({ kind, ink }) => kind === "circle" && ink === "player").length >= 12);
  game.world.close();
});

/** A game over a network, each step with the inputs of both players. */
async function openMatch(own) {
  const { scene } = await buildScene(engine, "artillery");
  scene.match.begin(own);
  const { input } = scene.match;
  const step = (left, right, count = 1) => {
    for (let i = 0; i < count; i++)
      scene.match.step([left, right].map((held) => held && input({ ...NO_KEYS, ...held })));
  };
  return { scene, step };
}

test("over_a_network_each_player_has_one_tank_and_its_own_screen", async () => {
  const [left, right] = [await openMatch(0), await openMatch(1)];
  const both = (...inputs) => [left, right].forEach(({ step }) => step(...inputs));
  const messages = () => [left, right].map(({ scene }) => scene.paint().message);
  assert.match(messages()[0], /left tank.*Your turn/);
  assert.match(messages()[1], /Left aims/);
  const angle = (i) => left.scene.state.tanks[i].angle;
  both({}, {});
  both({ left: true }, {});
  both({}, { left: true }, 30);
  assert.deepEqual([angle(0), angle(1)], [61, 120], "only who has the turn aims");
  both({}, { fire: true });
  assert.equal(left.scene.state.phase, "aim");
  both({ fire: true }, { fire: true });
  assert.equal(left.scene.state.phase, "fly");
  for (let i = 0; i < 2000 && left.scene.state.phase !== "aim"; i++) both({}, { fire: true });
  assert.equal(left.scene.state.turn, 1);
  both({}, { fire: true }, 10);
  assert.equal(left.scene.state.phase, "aim", "a key that is still held is no shot");
  assert.match(messages()[1], /right tank.*Your turn/);
  both({}, null);
  assert.match(messages()[0], /Waiting for the other/);
  left.scene.state.tanks[0].health = right.scene.state.tanks[0].health = 0;
  both({}, {}, 2);
  assert.equal(left.scene.state.phase, "over");
  both({ fire: true }, {});
  assert.deepEqual([left.scene.state.phase, left.scene.state.tanks[0].health], ["aim", 100]);
  assert.equal(left.scene.world.hash(), right.scene.world.hash());
  assert.deepEqual(left.scene.state, right.scene.state);
  for (const { scene } of [left, right]) scene.world.close();
});

test("a_barrel_points_where_its_angle_says", () => {
  for (let degrees = 0; degrees <= 180; degrees += 0.25) {
    const radians = (degrees * Math.PI) / 180;
    const [x, y] = directionOf(degrees);
    assert.ok(Math.abs(x - Math.cos(radians)) + Math.abs(y - Math.sin(radians)) < 1e-12, `${degrees}`);
  }
});
