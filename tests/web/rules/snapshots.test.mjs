/** Tests that snapshots of the npm package include the rules between categories. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { thud } from "../support/package.mjs";

const engine = await thud.load();
const [GROUND, PLANK, PLAYER, CRATE] = [1, 2, 4, 8];

/** Players and crates above a conveyor belt and a plank. */
function yard(options = {}) {
  const world = engine.createWorld(options);
  const box = { halfWidth: 0.4, halfHeight: 0.4 };
  world.createObb(world.createBody({ position: [0, -1] }), { halfWidth: 20, halfHeight: 1, category: GROUND });
  world.createObb(world.createBody({ position: [0, 2] }), { halfWidth: 4, halfHeight: 0.1, category: PLANK });
  for (let i = 0; i < 12; i++) {
    const position = [(i % 4) - 1.5, 1 + i], velocity = [0, i % 5];
    const body = world.createBody({ kind: "dynamic", position, velocity });
    world.createObb(body, { ...box, category: i % 2 ? PLAYER : CRATE });
  }
  return world;
}

function setRules(world) {
  world.setRule(PLANK, PLAYER, { kind: "oneWay" });
  world.setRule(CRATE, PLANK, { kind: "ignore" });
  world.setRule(GROUND, PLAYER | CRATE, { surfaceSpeed: 2, eventImpulse: 1 });
}

function changeRules(world) {
  world.setRule(PLANK, PLAYER, null);
  world.setRule(CRATE | PLAYER, CRATE | PLAYER, { kind: "ignore" });
  world.setRule(GROUND, CRATE, { friction: 0 });
}

function rulesOf(world) {
  const kinds = [GROUND, PLANK, PLAYER, CRATE];
  return kinds.flatMap((a) => kinds.map((b) => world.rule(a, b)));
}

// Makes steps; returns the hash and the impulses after each.
function walk(world, steps) {
  return Array.from({ length: steps }, () => {
    world.step();
    return [world.hash(), world.impulseEvents()];
  });
}

for (const quality of ["draft", "default", "exact"])
  test(`world_restored_at_${quality}_goes_by_the_rules_of_then`, () => {
    const world = yard({ quality });
    setRules(world);
    walk(world, 40);
    const [snapshot, rules] = [world.snapshot(), rulesOf(world)];
    const first = walk(world, 120);
    changeRules(world);
    walk(world, 20);
    world.restore(snapshot);
    assert.deepEqual(rulesOf(world), rules);
    assert.deepEqual(walk(world, 120), first);
    assert.ok(first.some(([, impulses]) => impulses.length > 0));
    world.close();
  });

test("saved_game_with_rules_is_loaded_into_a_new_world_that_uses_them", () => {
  const world = yard();
  const without = world.snapshot();
  setRules(world);
  walk(world, 10);
  const saved = world.snapshot();
  assert.ok(saved.length > without.length);
  const fresh = engine.createWorld();
  fresh.restore(without);
  const hash = fresh.hash();
  assert.throws(() => fresh.restore(saved), { code: "invalid", message: /has rules/ });
  assert.equal(fresh.hash(), hash);
  fresh.useRules();
  fresh.restore(saved);
  assert.deepEqual(rulesOf(fresh), rulesOf(world));
  assert.deepEqual(walk(fresh, 90), walk(world, 90));
  fresh.restore(without);
  assert.deepEqual(rulesOf(fresh), Array(16).fill(null));
  fresh.close();
  world.close();
});

test("what_if_tries_other_rules_and_leaves_those_that_were", () => {
  const world = yard();
  setRules(world);
  walk(world, 30);
  const [rules, snapshot] = [rulesOf(world), world.snapshot()];
  const tried = world.whatIf(() => {
    changeRules(world);
    walk(world, 60);
    return rulesOf(world);
  });
  assert.notDeepEqual(tried, rules);
  assert.deepEqual(rulesOf(world), rules);
  assert.deepEqual(world.snapshot(), snapshot);
  world.close();
});

test("rules_that_an_input_sets_are_played_again_when_it_comes_late", () => {
  const play = (late) => {
    const world = yard();
    setRules(world);
    const step = ([ice]) => {
      if (ice === 1) changeRules(world);
      if (ice === 2) setRules(world);
      world.step();
    };
    const rollback = new thud.Rollback(world, { idle: [0], step });
    for (let i = 0; i < 30; i++) {
      if (!late && i === 10) rollback.input(0, 10, 1);
      if (!late && i === 11) rollback.input(0, 11, 2);
      if (!late && i === 12) rollback.input(0, 12, 0);
      if (late && i === 14) for (const [at, ice] of [[10, 1], [11, 2], [12, 0]]) rollback.input(0, at, ice);
      rollback.advance();
    }
    const end = [world.hash(), rulesOf(world), rollback.replayed];
    world.close();
    return end;
  };
  const [hash, rules, replayed] = play(true);
  assert.ok(replayed > 0);
  assert.deepEqual([hash, rules], play(false).slice(0, 2));
});
