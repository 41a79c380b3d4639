/**
 * Tests the scene lab_latency: air hockey by two peers over a slow line. Its errors, by method and
 * delay, are in the order that theory expects; rollbacks end where the truth is once the delay has
 * passed; and going back in time gives the same pictures.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { buildScene, openSession, runScene } from "../../../web/tools/scenes.mjs";
import { MEASURED } from "../../../web/public/scenes/lab_latency/measured.js";
import { newest } from "../../../web/public/scenes/lab_latency/line.js";
import { METHODS, Peers, peerState } from "../../../web/public/scenes/lab_latency/peers.js";
import { chance } from "../../../web/public/scenes/lab_latency/players.js";
import {
  build,
  inputOf,
  judge,
  MIDDLE,
  OPTIONS,
  steer,
} from "../../../web/public/scenes/lab_latency/rink.js";
import { thud } from "../support/package.mjs";

const engine = await thud.load();

/** The mean error of each method over a number of steps. */
async function errorsAt(delay, seed, steps) {
  const { scene, close } = await buildScene(engine, "lab_latency", { seed });
  const { state } = scene;
  state.delay = delay;
  runScene(scene, steps);
  const bin = delay / 50;
  const errors = state.sums.map((sums) => sums[bin] / state.counts[bin]);
  close();
  return errors;
}

/** Steps and seed; a minute of seed 0 is what the scene’s figure shows. */
for (const [steps, seed] of [[3600, 0], [900, 1]])
  test(`better_methods_are_nearer_to_the_truth_at_every_delay_seed_${seed}`, async () => {
    for (const [i, delay] of MEASURED.delays.entries()) {
      const errors = await errorsAt(delay, seed, steps);
      if (delay === 0) assert.deepEqual(errors, [0, 0, 0, 0]);
      const [last, reckoned, swept, rollback] = errors;
      const told = `${delay} ms: ${errors.map((error) => error.toFixed(4))}`;
      if (delay > 0) assert.ok(last > reckoned && reckoned > swept && swept > rollback, told);
      if (seed > 0) continue;
      METHODS.forEach((name, method) =>
        assert.ok(Math.abs(errors[method] - MEASURED[name][i]) <= 1e-3, `${name} at ${told}`),
      );
    }
  });

test("line_delays_jitters_and_loses_as_it_is_set", () => {
  const line = { delay: 100, jitter: 0, loss: 0, seed: 4 };
  const ages = (settings) =>
    Array.from({ length: 2000 }, (_, i) => i + 200 - newest(i + 200, 0, 0, { ...line, ...settings }));
  const mean = (list) => list.reduce((sum, value) => sum + value, 0) / list.length;
  assert.ok(ages({}).every((age) => age === 6));
  // The newest packet is lost in 30 of 100 steps, the one before it as well in 9, and so on.
  const lossy = ages({ loss: 30 });
  const fresh = lossy.filter((age) => age === 6).length / lossy.length;
  assert.ok(Math.abs(fresh - 0.7) < 0.03, String(fresh));
  assert.ok(Math.abs(mean(lossy) - 6 - 0.3 / 0.7) < 0.05, String(mean(lossy)));
  // Of packets that are up to 10 steps later still, the newest that has come is no older than 16.
  const jittery = ages({ jitter: 1000 / 6 });
  assert.ok(Math.min(...jittery) === 6 && Math.max(...jittery) <= 16 && mean(jittery) > 7);
  // What a peer has once, it keeps.
  assert.equal(newest(300, 1, 299, line), 299);
});

test("rollbacks_follow_again_after_the_visitor_has_thrown_the_puck", async () => {
  const { scene, close } = await buildScene(engine, "lab_latency");
  const { world, state } = scene;
  state.delay = 0;
  runScene(scene, 100);
  world.setVelocity(world.bodyAt(2), [4, -9]);
  runScene(scene, 100, 100);
  assert.ok(state.offs[3][200] > 0.1, `${state.offs[3][200]}`);
  runScene(scene, 100, 200);
  assert.equal(state.offs[3][300], 0);
  close();
});

test("rollbacks_of_both_peers_end_where_the_truth_is_once_the_delay_has_passed", () => {
  const world = engine.createWorld(OPTIONS);
  const bodies = build(world);
  const worlds = [];
  const createWorld = () => {
    worlds.push(engine.createWorld(OPTIONS));
    return worlds.at(-1);
  };
  const peers = new Peers(world, bodies, createWorld, thud.Rollback);
  const state = { ...peerState(), delay: 130, jitter: 90, loss: 30, seed: 5, score: [0, 0] };
  const hashes = [world.hash()];
  peers.begin(state);
  for (let step = 0; step < 600; step++) {
    // Both make for places at random, changed every few steps.
    const wish = (side) => [8 * chance(step >> 4, side), 4 * chance(step >> 3, 9 + side)];
    const inputs = [inputOf(wish(0)), inputOf(wish(1))];
    inputs.forEach((input, player) => (state.inputs[player][step % 256] = input));
    steer(world, bodies, inputs);
    world.step();
    judge(world, bodies, state);
    peers.stepped(state);
    hashes.push(world.hash());
    for (const peer of [0, 1])
      assert.equal(peers.hashAt(peer, state.known[peer]), hashes[state.known[peer]], `step ${step}`);
  }
  assert.ok(state.replayed > 1000, "predictions were wrong");
  assert.ok(Math.min(...state.known) > 570, `packets ${state.known}`);
  // Nothing is lost or late any more: the rival's input of the last step is known, too.
  assert.ok(state.offs[3].some((error) => error > 0.01), "wrong predictions show");
  Object.assign(state, { delay: 0, jitter: 0, loss: 0 });
  for (let step = 600; step < 602; step++) {
    for (const inputs of state.inputs) inputs[step % 256] = inputOf([0, 0]);
    steer(world, bodies, [inputOf([0, 0]), inputOf([0, 0])]);
    world.step();
    judge(world, bodies, state);
    peers.stepped(state);
    METHODS.forEach((name, method) => assert.equal(state.offs[method][step + 1 - 600], 0, name));
  }
  for (const one of [world, ...worlds]) one.close();
});

test("readings_are_the_errors_of_what_each_method_draws", async () => {
  const { scene, close } = await buildScene(engine, "lab_latency", { seed: 3 });
  const { world, state } = scene;
  Object.assign(state, { delay: 100, method: "last" });
  const places = [world.positionOf(world.bodyAt(2))];
  const speeds = [world.velocityOf(world.bodyAt(2)).velocity];
  const [last, reckoned] = [[], []];
  let [largest, before] = [0, [0, 0]];
  for (let step = 0; step < 400; step++) {
    runScene(scene, 1, step);
    places.push(world.positionOf(world.bodyAt(2)));
    speeds.push(world.velocityOf(world.bodyAt(2)).velocity);
    const now = places.length - 1, then = Math.max(0, now - 6);
    const age = (now - then) / 60, share = (1 - Math.exp(-0.1 * age)) / 0.1;
    const off = [0, 1].map((k) => places[then][k] - places[now][k]);
    const flown = [0, 1].map((k) => off[k] + speeds[then][k] * share);
    last.push(Math.hypot(...off));
    reckoned.push(Math.hypot(...flown));
    if (step > 0) largest = Math.max(largest, Math.hypot(off[0] - before[0], off[1] - before[1]));
    before = off;
  }
  const mean = (errors) => errors.reduce((sum, error) => sum + error, 0) / errors.length;
  const rows = Object.fromEntries(scene.paint().readings.errors);
  const is = (name, wanted) => assert.ok(Math.abs(Number(rows[name]) - wanted) <= 0.006, `${name} ${rows[name]}, not ${wanted}`);
  is("Last known place", mean(last));
  is("Dead reckoning", mean(reckoned));
  is("Largest correction", largest);
  is("Drawn now", mean(last));
  assert.equal(scene.paint().readings.truth[0][1], "6 steps old");
  assert.equal(Number(rows["Steps run again"]), state.replayed);
  // The puck is drawn where it was, with a ring where it is.
  const [drawn, ring] = scene.paint().marks.filter(({ kind, radius }) => kind === "circle" && radius === 0.3);
  assert.deepEqual([drawn.x, drawn.y], places.at(-7));
  assert.deepEqual([ring.x, ring.y], places.at(-1));
  close();
});

test("going_back_in_time_gives_the_same_game_and_the_same_pictures", async () => {
  const session = await openSession(engine, "lab_latency", { seed: 2 });
  for (const [name, value] of Object.entries({ delay: 230, jitter: 120, loss: 20, method: "rollback" }))
    session.do({ kind: "set", name, value });
  const told = [];
  for (let step = 0; step < 420; step++) {
    session.makeStep();
    told.push(JSON.stringify(session.paint));
  }
  for (const step of [150, 300, 420]) {
    assert.ok(session.seek(step));
    assert.equal(JSON.stringify(session.paint), told[step - 1], `step ${step}`);
  }
  session.close();
});

test("visitor_drives_the_left_mallet_by_keys_and_by_pointer", async () => {
  const { scene, close } = await buildScene(engine, "lab_latency");
  const { world } = scene;
  const held = { left: false, right: true, up: true, down: false, fire: false, restart: false };
  const run = (steps, input) => {
    for (let step = 0; step < steps; step++) {
      scene.update({ step, ...input });
      world.step();
      scene.stepped();
    }
    return world.positionOf(world.bodyAt(3));
  };
  const [x, y] = run(60, { held, pointer: null });
  assert.ok(scene.state.play);
  assert.ok(x > MIDDLE - 1 && y > 1.5, `${x}, ${y}`);
  const none = Object.fromEntries(Object.keys(held).map((key) => [key, false]));
  const [toX, toY] = run(90, { held: none, pointer: { x: MIDDLE - 3, y: -2, down: false } });
  assert.ok(Math.hypot(toX - MIDDLE + 3, toY + 2) < 0.1, `${toX}, ${toY}`);
  close();
});
