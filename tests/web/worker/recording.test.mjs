/**
 * Tests what the page records: scenes of every kind go through their steps once more in the engine
 * that records and end with the same hash, and their recordings play; forks are recorded, too.
 */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { importTypeScript, openSession } from "../../../web/tools/scenes.mjs";
import { root, thud } from "../support/package.mjs";

const { record } = await importTypeScript("src/worker/record.ts");
const { setUp } = await importTypeScript("src/worker/stage.ts");
const { USUAL } = await importTypeScript("src/page/url.ts");
// Of one import, since a playback is known by its class.
const { play } = await importTypeScript("src/worker/playback.ts");
const { Player } = await import(`${root}web/package/dist/recording.js`);

const file = readFileSync(`${root}web/package/dist/thud-recorded.wasm`);
const wasm = `data:application/wasm;base64,${file.toString("base64")}`;
const recorded = await thud.load(file);
const engine = await thud.load();

const STEPS = 40;

function makeSteps(session, count = STEPS) {
  for (let i = 0; i < count; i++) session.makeStep();
}

/** Plays a recording to its end. Returns how far it is, and the hash of its world. */
function played(bytes) {
  const player = new Player(recorded, bytes);
  while (player.step());
  const { progress } = player;
  const hash = player.world.hash();
  player.close();
  return { ...progress, hash };
}

// A character, rules, ground with a texture, rollback, explosions, water.
for (const name of ["platformer_game", "meetings", "textured", "lab_latency", "explosion", "boats"])
  test(`recording_of_${name}_ends_with_the_hash_of_what_ran`, async () => {
    // The handles that the code of a scene keeps have the number of their world.
    for (let i = 0; i < 3; i++) engine.createWorld().close();
    const session = await openSession(engine, name);
    makeSteps(session);
    const build = (within) => openSession(within, name);
    const { bytes, steps } = await record(session, wasm, build, () => {});
    assert.equal(steps, STEPS);
    const { end, hash } = played(bytes);
    assert.ok(end >= STEPS, `${end} steps`); // of a rollback those are recorded, too, that are repeated
    assert.equal(hash, session.world.hash());
    session.close();
  });

test("what_the_visitor_did_is_recorded_and_what_is_older_than_the_history_is_not", async () => {
  const session = await openSession(engine, "bounce");
  makeSteps(session, 1900);
  // The scene itself has no joint; this pull is one.
  const [body] = session.world.bodies().filter((id) => session.world.bodyStateOf(id).kind === "dynamic");
  const [x, y] = session.world.positionOf(body);
  session.do({ kind: "grab", slot: body.index, anchor: [0, 0], x: x + 1, y: y + 1 });
  assert.ok(session.pull, "a body is held");
  makeSteps(session, 30);
  session.do({ kind: "spawn", shape: "box", x, y: y + 8, size: 0.5 });
  const { first } = session.history;
  assert.ok(first > 0);
  const parts = [];
  const build = (within) => openSession(within, "bounce");
  const { bytes, steps } = await record(session, wasm, build, (part) => parts.push(part));
  assert.equal(steps, 1930 - first);
  assert.ok(parts.every((part) => part > 0 && part <= 1), String(parts));
  assert.deepEqual([played(bytes).hash, played(bytes).end], [session.world.hash(), steps]);
  session.close();
});

test("scene_that_does_not_repeat_itself_is_refused_and_runs_on", async () => {
  const module = {
    default: ({ createWorld }) => {
      const world = createWorld();
      const ball = world.createBody({ kind: "dynamic", position: [0, 5] });
      world.createCircle(ball, { radius: 1 });
      return { world, update: () => world.applyCenterImpulse(ball, [Math.random(), 0]) };
    },
  };
  const build = (within) => setUp(1, module, within, { name: "own", seed: 0, choices: USUAL }, () => "");
  const session = await build(engine);
  makeSteps(session);
  await assert.rejects(record(session, wasm, build, () => {}), /does not repeat itself/);
  makeSteps(session);
  assert.equal(session.step, 2 * STEPS);
  session.close();
});

test("fork_of_a_recording_goes_on_from_its_step_and_is_recorded", async () => {
  const session = await openSession(engine, "ragdolls");
  makeSteps(session);
  const build = (within) => openSession(within, "ragdolls");
  const { bytes } = await record(session, wasm, build, () => {});
  makeSteps(session, 10);
  const recording = { name: "ragdolls", bytes, wasm, fork: STEPS };
  const fork = await play(recording, 1);
  makeSteps(fork, 10);
  assert.equal(fork.world.hash(), session.world.hash(), "as the scene goes on without a hand");
  fork.do({ kind: "explode", x: 0, y: 2, radius: 8, speed: 20 });
  makeSteps(fork, 10);
  const again = await record(fork, wasm, () => play(recording, 1), () => {});
  assert.equal(played(again.bytes).hash, fork.world.hash());
  fork.close();
  session.close();
});

test("playback_steps_seeks_and_reviews_within_its_steps_alone", async () => {
  const session = await openSession(engine, "bounce");
  const hashes = [session.world.hash()];
  for (let i = 0; i < STEPS; i++) {
    session.makeStep();
    hashes.push(session.world.hash());
  }
  const build = (within) => openSession(within, "bounce");
  const { bytes } = await record(session, wasm, build, () => {});
  session.close();
  const recording = { name: "bounce", bytes, wasm, fork: null };
  await assert.rejects(play(recording, 0), /cannot be built anew/);
  const shown = await play(recording, 1);
  assert.deepEqual([shown.history.first, shown.history.last, shown.end], [0, STEPS, STEPS]);
  makeSteps(shown, 3);
  assert.equal(shown.hash.hash, hashes[3]);
  assert.ok(shown.seek(30) && !shown.seek(STEPS + 1) && !shown.seek(-1));
  assert.equal(shown.hash.hash, hashes[30]);
  assert.deepEqual(shown.rerun(12), { from: 18, step: 30, hash: hashes[30], again: hashes[30] });
  assert.deepEqual(shown.review(7, () => shown.world.hash()), hashes.slice(6, 8));
  assert.equal(shown.hash.hash, hashes[30], "the present step is back");
  shown.do({ kind: "spawn", shape: "box", x: 0, y: 8, size: 0.5 });
  assert.equal(shown.hash.hash, hashes[30]);
  assert.match(shown.paint.message, /plays as it was made/);
  shown.close();
});
