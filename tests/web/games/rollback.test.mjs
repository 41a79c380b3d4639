/**
 * Tests Rollback: peers that get inputs late, early, out of order and twice end in the same state
 * as one that knew all inputs in time.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
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
function createPeer(options = {}) {
  const world = engine.createWorld();
  const floor = { kind: "aabb", halfWidth: 20, halfHeight: 1, offset: [0, -1] };
  world.createBody({ shapes: [floor] });
  const bodies = Array.from({ length: 6 }, (_, i) => {
    const shapes = [{ kind: "circle", radius: 0.5, category: i < 2 ? 2 : 4 }];
    return world.createBody({ kind: "dynamic", position: [i - 3, 0.6 + 0.1 * i], shapes });
  });
  const shape = { kind: "circle", radius: 0.4 };
  const hero = new Mover(world, { shape, position: [-8, 1], pushForce: 10 });
  const step = (inputs, state) => {
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
