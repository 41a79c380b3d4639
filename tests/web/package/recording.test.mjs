/**
 * Tests recordings in the npm package: they play to the same hashes, in C as well, and recordings of
 * C play here; differences are named, damage is refused.
 */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { skip, thudRun } from "../support/native.mjs";
import { root, thud } from "../support/package.mjs";

const { Player, Recorder } = await import(`${root}web/package/dist/recording.js`);
const engine = await thud.load(new URL(`file://${root}web/package/dist/thud-recorded.wasm`));

const STEPS = 90;

function refusedWith(code, pattern, act) {
  assert.throws(act, (error) => error.code === code && pattern.test(error.message));
}

/** A floor, boxes, a ball, and listeners that answer in different ways. */
function heap() {
  const world = engine.createWorld();
  world.createAabb(world.createBody(), { halfWidth: 20, halfHeight: 1 });
  for (let i = 0; i < 12; i++) {
    const body = world.createBody({ kind: "dynamic", position: [i % 4, 2 + i / 3] });
    world.createObb(body, { halfWidth: 0.5, halfHeight: 0.4 });
  }
  const ball = world.createBody({ kind: "dynamic", position: [-3, 2] });
  world.createCircle(ball, { radius: 0.5 });
  let asked = 0;
  world.setListeners({ prologue: () => ++asked % 7 !== 3 });
  return { world, ball };
}

/** Plays a game with calls in each step; returns the hash after each. */
function play({ world, ball }, steps = STEPS) {
  const hashes = [world.hash()];
  for (let i = 0; i < steps; i++) {
    world.applyCenterImpulse(ball, [i % 3 ? 0.25 : -0.1, 0.5]);
    if (i % 20 === 4) {
      const body = world.createBody({ kind: "dynamic", position: [i / 20, 6] });
      world.createCircle(body, { radius: 0.3 });
    }
    world.step();
    hashes.push(world.hash());
  }
  return hashes;
}

test("recording_plays_to_the_same_hashes_without_its_listeners", () => {
  const game = heap();
  const recorder = new Recorder(game.world, { hashSteps: 1, keyframeSteps: 25, bodyHashes: true });
  const hashes = play(game);
  const player = new Player(engine, recorder.bytes());
  recorder.end();
  refusedWith("stale", /ended/, () => recorder.bytes());
  game.world.close();
  for (let step = 1; player.step(); step++) assert.equal(player.world.hash(), hashes[step]);
  for (const step of [70, 3, 50, 0, STEPS]) {
    player.seek(step);
    assert.equal(player.world.hash(), hashes[step]);
  }
  const { first, end, steps, difference } = player.progress;
  assert.deepEqual({ first, end, steps, difference }, { first: 0, end: STEPS, steps: STEPS, difference: null });
  refusedWith("invalid", /no such step/, () => player.seek(STEPS + 1));
  player.close();
  refusedWith("stale", /closed/, () => player.step());
});

test("ring_keeps_the_last_steps_and_the_world_may_be_closed_first", () => {
  const game = heap();
  const recorder = new Recorder(game.world, { ringSteps: 20 });
  const hash = play(game).at(-1);
  game.world.close();
  const player = new Player(engine, recorder.bytes());
  recorder.end();
  const { first, end } = player.progress;
  assert.ok(end === STEPS && end - first >= 20 && end - first <= 25, `${first} to ${end}`);
  player.seek(end);
  assert.equal(player.world.hash(), hash);
  player.close();
});

test("chunks_come_with_their_steps", () => {
  const { world } = heap();
  const recorder = new Recorder(world);
  world.step();
  recorder.chunk("grüße", new Uint8Array([1, 2, 3]));
  recorder.chunk("", new Uint8Array(0));
  world.step();
  const player = new Player(engine, recorder.bytes());
  player.step();
  assert.deepEqual(player.chunks, []);
  player.step();
  assert.deepEqual(player.chunks, [
    { name: "grüße", bytes: new Uint8Array([1, 2, 3]) },
    { name: "", bytes: new Uint8Array(0) },
  ]);
  player.close();
  recorder.end();
  world.close();
});

test("calls_of_a_step_are_told_and_keyframes_found", () => {
  const game = heap();
  const recorder = new Recorder(game.world, { keyframeSteps: 10 });
  play(game, 25);
  assert.throws(() => game.world.setVelocity(game.ball, [Number.MAX_VALUE, 0]));
  game.world.step();
  const bytes = recorder.bytes();
  const player = new Player(engine, bytes, { calls: true });
  player.step();
  const [impulse, step] = player.calls;
  assert.deepEqual(impulse, {
    name: "thud_body_apply_center_impulse",
    refused: null,
    values: [
      { number: game.ball.index, handle: true },
      { number: Math.fround(-0.1), handle: false },
      { number: 0.5, handle: false },
    ],
    returned: null,
    found: null,
  });
  assert.equal(step.name, "thud_world_step");
  player.seek(4);
  assert.deepEqual(player.calls, []);
  player.step();
  const made = player.calls.find(({ returned }) => returned !== null);
  assert.equal(made.returned, player.world.bodies().at(-1).index);
  assert.deepEqual([0, 9, 10, 26].map((at) => player.keyframeBefore(at)), [0, 0, 10, 20]);
  refusedWith("invalid", /no such step/, () => player.keyframeBefore(27));
  player.close();
  const quiet = new Player(engine, bytes);
  quiet.step();
  assert.deepEqual(quiet.calls, []);
  quiet.close();
  refusedWith("invalid", /call/, () => new Player(engine, bytes, { call: true }));
  recorder.end();
  game.world.close();
});

test("queries_are_told_with_what_they_found", () => {
  for (const queries of [false, true]) {
    const { world, ball } = heap();
    const recorder = new Recorder(world, { queries });
    const hit = world.castRay([-50, 0.1], [100, 0]);
    assert.notEqual(hit, null);
    assert.equal(world.castRay([-50, 500], [1, 0]), null);
    world.overlap({ kind: "bounds", lower: [-50, -50], upper: [50, 50] });
    world.step();
    const bytes = recorder.bytes();
    const player = new Player(engine, bytes, { calls: true });
    player.step();
    assert.equal(player.world.hash(), world.hash());
    const told = player.calls.filter(({ found }) => found !== null);
    assert.equal(told.length, queries ? 3 : 0);
    if (queries) {
      const [ray, miss, box] = told;
      assert.equal(ray.name, "thud_world_cast_ray");
      assert.deepEqual(ray.values.slice(0, 4).map(({ number }) => number), [-50, 0.1, 100, 0]);
      const [{ shape, ...where }] = ray.found;
      const { shape: own, ...wanted } = hit;
      assert.deepEqual(where, wanted);
      assert.equal(shape.index, own.index);
      assert.ok(player.world.isValid(shape));
      assert.deepEqual(miss.found, []);
      assert.equal(box.name, "thud_world_overlap_aabb");
      assert.ok(box.found.some(({ shape: found }) => player.world.bodyOf(found).index === ball.index));
    }
    player.close();
    recorder.end();
    world.close();
  }
  refusedWith("invalid", /query/, () => new Recorder(heap().world, { query: true }));
});

test("renderers_are_told_of_bodies_that_come_and_ground_that_changes", () => {
  const { world, ball } = heap();
  const recorder = new Recorder(world);
  for (let step = 0; step < 8; step++) {
    if (step === 2) world.createCircle(world.createBody({ position: [9, 9] }), { radius: 1 });
    if (step === 5) world.setVelocity(ball, [1, 0]);
    if (step === 6) world.setKind(ball, "kinematic");
    world.step();
  }
  const player = new Player(engine, recorder.bytes());
  const changes = [];
  for (let before = player.world.revision; player.step(); before = player.world.revision)
    changes.push(player.world.revision.shapes - before.shapes);
  // A step more than the one of the call, since edits inside a callback wait for the next step.
  assert.deepEqual(changes.map((count) => count > 0), [
    false, false, true, true, false, false, true, true,
  ]);
  const { shapes } = player.world.revision;
  player.seek(1);
  assert.ok(player.world.revision.shapes > shapes);
  player.close();
  recorder.end();
  const before = world.revision.shapes;
  world.setKind(ball, "dynamic");
  assert.ok(world.revision.shapes > before);
  world.close();
});

test("world_of_a_player_is_closed_with_it_and_by_it_alone", () => {
  const { world } = heap();
  const recorder = new Recorder(world);
  world.step();
  const bytes = recorder.bytes();
  const sizes = [];
  for (let i = 0; i < 60; i++) {
    const player = new Player(engine, bytes);
    player.step();
    player.world.movedBodies();
    if (i === 0) refusedWith("invalid", /belongs to its player/, () => player.world.close());
    player.close();
    if (i === 0) refusedWith("stale", /destroyed/, () => player.world.hash());
    if (i % 20 === 19) sizes.push(engine.buffer.byteLength);
  }
  assert.equal(sizes[1], sizes[2], "the memory does not grow");
  refusedWith("invalid", /Uint8Array/, () => recorder.chunk("text", "text"));
  recorder.end();
  world.close();
});

test("difference_is_named_and_damage_refused", () => {
  const game = heap();
  const recorder = new Recorder(game.world, { hashSteps: 5, bodyHashes: true });
  play(game, 20);
  const bytes = recorder.bytes();
  const player = new Player(engine, bytes);
  player.seek(12);
  const moved = player.world.bodies()[3];
  player.world.setVelocity(moved, [1, 2]);
  refusedWith("invalid", /differs from the recording/, () => player.seek(20));
  const { difference } = player.progress;
  assert.deepEqual([difference.after, difference.at], [10, 15]);
  assert.ok(difference.body !== null);
  player.seek(0);
  assert.equal(player.progress.difference, null);
  player.close();
  for (const damaged of [bytes.slice(0, -1), bytes.map((byte, i) => (i === 400 ? byte ^ 1 : byte)), bytes.slice(0, 5)])
    refusedWith("invalid", /damaged|no recording/, () => new Player(engine, damaged));
  recorder.end();
  game.world.close();
});

test("wrong_options_and_engines_are_refused", async () => {
  const plain = (await thud.load()).createWorld();
  refusedWith("invalid", /thud-recorded.wasm/, () => new Recorder(plain));
  plain.close();
  const { world } = heap();
  refusedWith("invalid", /steps must be a whole number/, () => new Recorder(world, { hashSteps: -1 }));
  refusedWith("invalid", /ringStep/, () => new Recorder(world, { ringStep: 5 }));
  refusedWith("invalid", /Uint8Array/, () => new Player(engine, "bytes"));
  const recorder = new Recorder(world);
  refusedWith("invalid", /is being recorded/, () => new Recorder(world));
  recorder.end();
  world.close();
});

test("recordings_of_c_play_here_and_those_of_here_in_c", { skip }, () => {
  const folder = mkdtempSync(join(tmpdir(), "thud-"));
  const file = join(folder, "run.rec");
  const run = (...words) => JSON.parse(execFileSync(thudRun, [...words, "--json"], { encoding: "utf8", cwd: root }));
  try {
    for (const scene of ["cradle", "chain", "explosion"]) {
      const { hash } = run(scene, "--steps", "60", "--record", file);
      const player = new Player(engine, new Uint8Array(readFileSync(file)));
      while (player.step());
      assert.equal(player.world.hash(), hash);
      assert.ok(player.progress.hashes > 10, scene); // none while all sleeps
      player.close();
    }
    const game = heap();
    const recorder = new Recorder(game.world);
    const hash = play(game).at(-1);
    writeFileSync(file, recorder.bytes());
    assert.equal(run("--replay", file).hash, hash);
    recorder.end();
    game.world.close();
  } finally {
    rmSync(folder, { recursive: true });
  }
});
