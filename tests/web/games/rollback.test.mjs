/**
 * Tests Rollback: peers that get inputs late, early, out of order and twice end in the same state
 * as one that knew all inputs in time.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { packGame, readState, unpackGame, writeState } from "../../../web/package/dist/net/rollback-bytes.js";
import { readReport, writeReport } from "../../../web/package/dist/net/rollback-report.js";
import { thud } from "../support/package.mjs";

const { Mover, Rollback } = thud;
const engine = await thud.load();
const IDLE = 0;
const STEPS = 240;

function randomBy(seed) {
  let state = seed;
  return (below) => {
    state = (state * 16807) % 2147483647;
    return Math.floor((below * state) / 2147483647);
  };
}

/** A peer: two bodies that inputs push among others, a mover that runs, and a count of contacts. */
function createPeer(options = {}, worldOptions = {}) {
  const world = engine.createWorld(worldOptions);
  const floor = { kind: "aabb", halfWidth: 20, halfHeight: 1, offset: [0, -1] };
  world.createBody({ shapes: [floor] });
  for (let i = 0; i < 6; i++) {
    const shapes = [{ kind: "circle", radius: 0.5, category: i < 2 ? 2 : 4 }];
    world.createBody({ kind: "dynamic", position: [i - 3, 0.6 + 0.1 * i], shapes });
  }
  const shape = { kind: "circle", radius: 0.4 };
  const hero = new Mover(world, { shape, position: [-8, 1], pushForce: 10 });
  const step = (inputs, state) => {
    // Who joins a game has the handles of the peer that it was joined at.
    const [, ...bodies] = world.bodies();
    inputs.forEach((held, player) => world.applyCenterForce(bodies[player], [15 * held, 0]));
    world.step();
    hero.move([3 * inputs[0], -3], 1 / 60);
    state.met += [...world.eventPairs(2, 4)].length;
  };
  const rollback = new Rollback(world, {
    idle: [IDLE, IDLE],
    step,
    state: { met: 0 },
    movers: [hero],
    ...options,
  });
  return { world, hero, rollback };
}

/** The input of each of two players in each step; it changes in one of nine steps on average. */
function inputsOf(seed) {
  const random = randomBy(seed);
  return [0, 1].map(() => {
    let held = IDLE;
    return Array.from({ length: STEPS }, () => {
      if (random(9) === 0) held = random(3) - 1;
      return held;
    });
  });
}

// The state in which a peer ends, for comparison.
function ended({ world, hero, rollback }) {
  return [rollback.steps, world.hash(), rollback.state, hero.state().position];
}

// Runs a peer that has all inputs in time; returns its end state.
function playKnowing(inputs) {
  const peer = createPeer();
  for (let step = 0; step < STEPS; step++) {
    inputs.forEach((held, player) => peer.rollback.input(player, step, held[step]));
    assert.equal(peer.rollback.advance(), true);
  }
  assert.equal(peer.rollback.replayed, 0);
  return peer;
}

for (const seed of [1, 2, 3])
  test(`late_inputs_end_as_known_ones_${seed}`, () => {
    const random = randomBy(seed + 100);
    const inputs = inputsOf(seed);
    const wanted = playKnowing(inputs);
    const { rollback, ...peer } = createPeer();
    const packets = [];
    for (let step = 0; step < STEPS; step++) {
      rollback.input(0, step, inputs[0][step]);
      packets.push([step + random(20), step]);
      // Some inputs arrive twice, and some before their step.
      if (random(5) === 0) packets.push([step + 20 + random(20), step]);
      if (step + 5 < STEPS && random(9) === 0) packets.push([step, step + 5]);
      for (const [due, of] of packets) if (due === step) rollback.input(1, of, inputs[1][of]);
      assert.equal(rollback.advance(), true);
      assert.ok(rollback.confirmed <= rollback.steps);
    }
    for (const [due, of] of packets) if (due >= STEPS) rollback.input(1, of, inputs[1][of]);
    assert.equal(rollback.confirmed, STEPS);
    assert.equal(rollback.hashAt(STEPS), wanted.world.hash());
    assert.equal(rollback.hashAt(STEPS - 30), wanted.rollback.hashAt(STEPS - 30));
    assert.deepEqual(ended({ rollback, ...peer }), ended(wanted));
    assert.ok(rollback.state.met > 0);
    assert.ok(rollback.replayed > 100, `${rollback.replayed} steps`);
  });

test("right_predictions_play_nothing_again", () => {
  const { rollback } = createPeer();
  rollback.input(1, 0, 1);
  for (let step = 0; step < 10; step++) rollback.advance();
  for (let step = 1; step < 10; step++) rollback.input(1, step, 1);
  assert.equal(rollback.settle(), 0);
  rollback.input(0, 4, 1);
  assert.equal(rollback.settle(), 6);
  assert.equal(rollback.replayed, 6);
});

test("who_knows_nothing_for_depth_steps_waits", () => {
  const { rollback, world } = createPeer({ depth: 4 });
  for (let step = 0; step < 4; step++) assert.equal(rollback.advance(), true);
  const hash = world.hash();
  assert.equal(rollback.advance(), false);
  assert.equal(rollback.steps, 4);
  assert.equal(world.hash(), hash);
  rollback.input(0, 0, 1);
  rollback.input(1, 0, -1);
  assert.equal(rollback.advance(), true);
  assert.equal(rollback.replayed, 4);
  assert.equal(rollback.advance(), false);
});

test("step_that_throws_is_played_again_from_its_beginning", () => {
  const fail = { at: -1 };
  const make = () => {
    const { world } = createPeer();
    const step = ([held], state) => {
      world.setVelocity(world.bodies()[1], [held, 0]);
      state.count++;
      if (state.count === fail.at) throw new Error("failed");
      world.step();
    };
    return { world, rollback: new Rollback(world, { idle: [0], step, state: { count: 0 } }) };
  };
  const [one, two] = [make(), make()];
  for (const { rollback } of [one, two]) for (let i = 0; i < 9; i++) rollback.advance();
  fail.at = 10;
  assert.throws(() => one.rollback.advance(), /failed/);
  assert.equal(one.rollback.steps, 9);
  fail.at = 6;
  one.rollback.input(0, 3, 2);
  assert.throws(() => one.rollback.settle(), /failed/);
  fail.at = -1;
  two.rollback.input(0, 3, 2);
  for (const { rollback } of [one, two]) rollback.advance();
  assert.equal(one.world.hash(), two.world.hash());
  assert.deepEqual(one.rollback.state, { count: 10 });
});

test("wrong_calls_throw_and_change_nothing", () => {
  const { world, rollback } = createPeer({ depth: 8 });
  for (let step = 0; step < 3; step++) rollback.advance();
  rollback.input(0, 1, 1);
  const hash = rollback.hashAt(3);
  for (const call of [
    () => rollback.input(2, 0, 1),
    () => rollback.input(-1, 0, 1),
    () => rollback.input(0, -1, 1),
    () => rollback.input(0, 1.5, 1),
    () => rollback.input(0, 12, 1),
    () => rollback.input(0, 1, -1),
    () => rollback.hashAt(4),
    () => rollback.hashAt(-1),
    () => new Rollback(world, { idle: [], step() {} }),
    () => new Rollback(world, { idle: [0] }),
    () => new Rollback(world, { idle: [0], step() {}, depth: 0 }),
    () => new Rollback(world, { idle: [0], step() {}, depth: 1001 }),
    () => new Rollback(world, { idle: [0], step() {}, deep: 9 }),
  ])
    assert.throws(call, { name: "ThudError", code: "invalid" });
  assert.equal(rollback.hashAt(3), hash);
});

test("reports_tell_any_input", () => {
  const told = (idle) => {
    const { world } = createPeer();
    const rollback = new Rollback(world, { idle: [idle], step: () => world.step() });
    for (let i = 0; i < 3; i++) {
      rollback.input(0, i, idle);
      rollback.advance();
    }
    return readReport(rollback.report(2), 1).inputs[0];
  };
  assert.deepEqual([0, 7, -1, 5n].map(told), [0n, 7n, 2n ** 64n - 1n, 5n]);
  const others = ["left", "right", 0.5, NaN, Infinity, null, undefined].map(told);
  assert.equal(new Set(others).size, others.length);
});

// ---- several peers ----

const DEPTH = 20;

// Gives inputs of both players before a step, of one late.
function playLate({ rollback }, inputs, late) {
  const now = rollback.steps;
  rollback.input(0, now, inputs[0][now]);
  if (now >= late) rollback.input(1, now - late, inputs[1][now - late]);
  assert.equal(rollback.advance(), true);
}

function tellAll({ rollback }, inputs) {
  inputs.forEach((held, player) => {
    for (let step = Math.max(0, rollback.steps - DEPTH); step < rollback.steps; step++)
      rollback.input(player, step, held[step]);
  });
}

test("budget_spreads_what_is_run_again", () => {
  const inputs = inputsOf(4);
  const wanted = playKnowing(inputs);
  const peer = createPeer({ depth: DEPTH, budget: 3 });
  const { rollback, world } = peer;
  let held = 0;
  let told = 0;
  while (rollback.steps < STEPS) {
    const now = rollback.steps;
    rollback.input(0, now, inputs[0][now]);
    if (now % 12 === 11) for (; told < now; told++) rollback.input(1, told, inputs[1][told]);
    const { replayed } = rollback;
    const made = rollback.advance();
    assert.ok(rollback.replayed - replayed <= 3);
    assert.equal(rollback.steps, now + (made ? 1 : 0));
    assert.equal(made, rollback.settled === rollback.steps);
    const final = Math.min(rollback.confirmed, rollback.settled);
    if (final > STEPS - 60) assert.equal(rollback.hashAt(final), wanted.rollback.hashAt(final));
    if (!made) held++;
  }
  tellAll(peer, inputs);
  assert.equal(rollback.settle() > 0 || rollback.settled === STEPS, true);
  assert.equal(world.hash(), wanted.world.hash());
  assert.ok(held > 10, `${held} frames were held back`);
});

test("clocks_are_compared_through_any_delay", () => {
  for (const delay of [0, 3, 6]) {
    const peers = [createPeer({ depth: DEPTH }), createPeer({ depth: DEPTH })];
    const told = [0, 0];
    for (let now = 0; now < 120; now++) {
      peers.forEach(({ rollback }, i) => {
        if (now < 5 * i) return; // the second begins five frames later
        rollback.input(i, rollback.steps, IDLE);
        const heard = i === 0 ? now - 5 - delay : now - delay;
        for (; told[i] <= heard; told[i]++) rollback.input(1 - i, told[i], IDLE);
        assert.equal(rollback.advance(), true);
      });
      const leads = peers.map(({ rollback }, i) => rollback.leadOver(1 - i));
      if (now > 20) peers.forEach(({ rollback }, i) => rollback.hearLead(1 - i, leads[1 - i]));
    }
    const [first, second] = peers.map(({ rollback }) => rollback.ahead);
    assert.ok(Math.abs(first - 5) < 0.5 && Math.abs(second + 5) < 0.5, `${first} and ${second}`);
  }
});

test("who_joins_has_the_same_game_and_absent_players_are_idle", () => {
  const [GONE, BACK] = [50, 90];
  const inputs = inputsOf(5);
  inputs[1].fill(IDLE, GONE, BACK);
  const wanted = playKnowing(inputs);
  const host = createPeer({ depth: DEPTH });
  while (host.rollback.steps < 40) playLate(host, inputs, 6);
  for (let step = 34; step < GONE; step++) host.rollback.input(1, step, inputs[1][step]);
  host.rollback.leave(1, GONE);
  while (host.rollback.steps < 60) {
    const now = host.rollback.steps;
    if (now > 45) host.rollback.input(0, now - 5, inputs[0][now - 5]);
    else host.rollback.input(0, now, inputs[0][now]);
    assert.equal(host.rollback.advance(), true);
  }
  // All that is late here is the other player's own.
  const guest = createPeer({ depth: DEPTH });
  guest.rollback.restore(host.rollback.snapshot());
  assert.equal(guest.rollback.steps, host.rollback.confirmed);
  assert.ok(guest.rollback.steps > GONE && guest.rollback.steps < 60);
  for (const peer of [host, guest]) {
    const { rollback } = peer;
    for (let step = rollback.confirmed; step < rollback.steps; step++) rollback.input(0, step, inputs[0][step]);
    while (rollback.steps < STEPS) {
      const now = rollback.steps;
      if (now === BACK - 10) rollback.enter(1, BACK);
      rollback.input(0, now, inputs[0][now]);
      if (now >= BACK + 4) rollback.input(1, now - 4, inputs[1][now - 4]);
      assert.equal(rollback.advance(), true);
    }
    tellAll(peer, inputs);
    assert.equal(rollback.hashAt(STEPS), wanted.world.hash());
    assert.deepEqual(ended(peer).slice(2), ended(wanted).slice(2));
  }
});

// How the second of two peers differs from the first, by their reports.
function differenceOf([one, two]) {
  const before = one.world.hash();
  const { step, isDetailed } = one.rollback.compare(two.rollback.report());
  assert.equal(isDetailed, false);
  const found = one.rollback.compare(two.rollback.report(step));
  assert.equal(found.step, step);
  assert.equal(found.isDetailed, step >= 0);
  assert.equal(one.world.hash(), before);
  return found;
}

for (const detection of ["overlap", "continuous", "bisect", "swept"])
  test(`changed_body_and_other_inputs_are_named_with_${detection}`, () => {
    const inputs = inputsOf(6);
    const none = { body: null, bodySlot: -1, bodies: 0, player: -1 };
    const pair = () => [1, 2].map(() => createPeer({ depth: DEPTH }, { detection }));
    const playBoth = (peers, steps) => {
      for (const peer of peers) {
        while (peer.rollback.steps < steps) playLate(peer, inputs, 4);
        tellAll(peer, inputs);
        peer.rollback.settle();
      }
    };
    const peers = pair();
    playBoth(peers, 30);
    assert.deepEqual(differenceOf(peers), { step: -1, isDetailed: false, ...none });
    const [, , , body] = peers[1].world.bodies();
    peers[1].world.setVelocity(body, [0.5, 2]);
    playBoth(peers, 36);
    const found = differenceOf(peers);
    assert.deepEqual([found.step, found.bodySlot, found.player], [30, body.index, -1]);
    assert.deepEqual(found.body, peers[0].world.bodies()[3]);

    const others = pair();
    playBoth(others, 30);
    others[1].rollback.input(1, 30, 5);
    const kept = inputs[1][30];
    for (const peer of others) {
      inputs[1][30] = peer === others[1] ? 5 : kept;
      playBoth([peer], 36);
    }
    inputs[1][30] = kept;
    const { step, player } = differenceOf(others);
    assert.deepEqual([step, player], [31, 1]);
  });

test("damaged_bytes_and_wrong_calls_of_peers_throw_and_change_nothing", () => {
  const inputs = inputsOf(7);
  const peer = createPeer({ depth: DEPTH });
  const { rollback, world } = peer;
  while (rollback.steps < 30) playLate(peer, inputs, 4);
  const hash = world.hash();
  const [report, game] = [rollback.report(20), rollback.snapshot()];
  const refused = (call) => assert.throws(call, { name: "ThudError", code: "invalid" });
  const flipped = (bytes, at) => bytes.map((byte, i) => (i === at ? byte ^ (1 << at % 8) : byte));
  for (let at = 0; at < report.length; at++) {
    refused(() => rollback.compare(flipped(report, at)));
    refused(() => rollback.compare(report.slice(0, at)));
  }
  for (let at = 0; at < game.length; at += 1 + (at >> 4)) {
    refused(() => rollback.restore(flipped(game, at)));
    refused(() => rollback.restore(game.slice(0, at)));
  }
  for (const call of [
    () => rollback.compare(game),
    () => rollback.restore(report),
    () => rollback.restore("game"),
    () => rollback.report(rollback.confirmed + 1),
    () => rollback.report(1),
    () => rollback.report(20.5),
    () => rollback.leadOver(2),
    () => rollback.hearLead(2, 0),
    () => rollback.hearLead(1, 1001),
    () => rollback.hearLead(1, NaN),
    () => rollback.leave(2, 30),
    () => rollback.leave(0, 29),
    () => rollback.leave(1, 30 + DEPTH + 1),
    () => rollback.leave(1, 30.5),
    () => rollback.enter(1, 40),
    () => createPeer({ budget: -1 }),
    () => createPeer({ budget: 1001 }),
  ])
    refused(call);
  rollback.leave(1, 30);
  refused(() => rollback.leave(1, 31));
  refused(() => rollback.enter(1, 29));
  refused(() => rollback.enter(1, 30 + DEPTH + 1));
  refused(() => rollback.input(1, 31, 1));
  rollback.enter(1, 32);
  rollback.input(1, 32, 1);
  assert.deepEqual([world.hash(), rollback.steps, rollback.ahead], [hash, 30, 0]);
  const other = createPeer({ depth: DEPTH, movers: [] });
  refused(() => rollback.restore(other.rollback.snapshot()));
  // Forged bytes, whose checksum is right.
  const data = unpackGame(game);
  const own = readState(data.state);
  const moved = peer.hero.state();
  for (const wrong of [
    { movers: [{ ...moved, position: [NaN, 0] }] },
    { movers: [{ ...moved, ground: {} }] },
    { movers: [null] },
    { movers: null },
    { inputs: [1] },
  ])
    refused(() => rollback.restore(packGame({ ...data, state: writeState({ ...own, ...wrong }) })));
  for (const wrong of [
    { players: [data.players[0], { ...data.players[0], gone: -1 }] },
    { step: -1 },
    { players: [...data.players, data.players[0]] },
    { players: [] },
    { world: data.world.slice(1) },
    { state: data.state.slice(1) },
    { state: new Uint8Array() },
  ])
    refused(() => rollback.restore(packGame({ ...data, ...wrong })));
  const told = readReport(report, 2);
  for (const wrong of [
    { players: 3 },
    { bodies: [[2, 1n], [2, 2n]] },
    { bodies: [[2, 1n], [1, 2n]] },
    { bodies: [[2 ** 31, 1n]] },
    { step: -2 },
    { step: -1 },
    { first: -1 },
  ])
    refused(() => rollback.compare(writeReport({ ...told, ...wrong })));
  assert.deepEqual([world.hash(), rollback.steps, peer.hero.state()], [hash, 30, moved]);
});
