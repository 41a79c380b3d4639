/** Tests rules between categories, listeners and the pair filter in the npm package. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { thud } from "../support/package.mjs";

const engine = await thud.load();
const { LISTENED_ROW: AT, IMPULSE_ROW } = thud;
const GROUND = 1, PLANK = 2, PLAYER = 4;

function steps(world, count) {
  for (let i = 0; i < count; i++) world.step();
}

function box(world, kind, category, position, halfWidth, halfHeight) {
  const body = world.createBody({ kind, position });
  const shape = world.createObb(body, { halfWidth, halfHeight, category });
  return { body, shape };
}

/** A player on the ground under a plank; the plank's top is at y = 2.1. */
function yard(options = {}) {
  const world = engine.createWorld(options);
  const ground = box(world, "static", GROUND, [0, -1], 20, 1);
  const plank = box(world, "static", PLANK, [0, 2], 3, 0.1);
  const player = box(world, "dynamic", PLAYER, [0, 0.4], 0.4, 0.4);
  return { world, ground, plank, player };
}

test("one_way_planks_are_jumped_through_in_every_detection", () => {
  for (const detection of ["overlap", "bisect", "swept", "continuous"]) {
    const { world, player } = yard({ detection });
    world.setRule(PLANK, PLAYER, { kind: "oneWay" });
    steps(world, 5);
    world.setVelocity(player.body, [0, 9]);
    steps(world, 150);
    assert.ok(Math.abs(world.positionOf(player.body)[1] - 2.5) < 0.02, detection);
    world.close();
  }
});

test("rules_are_read_back_taken_away_and_refused_by_name", () => {
  const { world, player } = yard();
  assert.equal(world.rule(GROUND, PLAYER), null);
  world.setRule(GROUND, PLAYER, { friction: 0, surfaceSpeed: 2, eventImpulse: 3 });
  const rule = world.rule(PLAYER, GROUND);
  assert.deepEqual(
    [rule.kind, rule.friction, rule.restitution, rule.surfaceSpeed, rule.eventImpulse],
    ["collide", 0, undefined, 2, 3],
  );
  assert.ok(rule.reversed);
  world.setRule(GROUND, PLAYER, { kind: "ignore" });
  steps(world, 60);
  assert.ok(world.positionOf(player.body)[1] < -1);
  world.setRule(PLAYER, GROUND, null);
  assert.equal(world.rule(GROUND, PLAYER), null);
  assert.throws(() => world.setRule(0, PLAYER, {}), { code: "invalid" });
  assert.throws(() => world.setRule(1, 1, { kind: "oneWay" }), { code: "invalid" });
  assert.throws(() => world.setRule(1, 2, { friction: -1 }), { code: "invalid" });
  assert.throws(() => world.setRule(1, 2, { kind: "none" }), /collide, ignore, oneWay/);
  assert.throws(() => world.setRule(1, 2, { bounce: 1 }), /no option is called "bounce"/);
  world.close();
});

test("impulses_above_a_rules_are_told_as_copies_and_as_a_view", () => {
  const { world, ground, player } = yard();
  world.setRule(PLAYER, GROUND, { eventImpulse: 2 });
  steps(world, 30);
  assert.deepEqual(world.impulseEvents(), []);
  assert.equal(world.impulseEventView().length, 0);
  world.setVelocity(player.body, [0, -8]);
  world.step();
  const [event] = world.impulseEvents(), view = world.impulseEventView();
  assert.deepEqual([event.a, event.b], [ground.shape, player.shape]);
  assert.ok(event.impulse > 0.64 * 8 && event.impulse < 0.64 * 9);
  assert.equal(view.length, world.impulseEvents().length * IMPULSE_ROW.length);
  assert.equal(view[IMPULSE_ROW.impulse], event.impulse);
  assert.equal(view[IMPULSE_ROW.shapeB], player.shape.index + 1);
  world.close();
});

test("a_prologue_is_called_once_a_step_and_its_answers_hold", () => {
  const { world, player } = yard();
  let calls = 0, told = 0, most = 0;
  world.setListeners({
    prologue(rows, count) {
      calls++;
      for (let at = 0; at < count * AT.length; at += AT.length) {
        assert.equal(rows[at + AT.bodyB], player.body.index + 1);
        assert.ok(Math.abs(rows[at + AT.friction] - 0.6) < 1e-6);
        rows[at + AT.friction] = 0;
      }
    },
    epilogue(rows, count) {
      told += count;
      for (let i = 0; i < count; i++)
        most = Math.max(most, rows[i * AT.length + AT.normalImpulse]);
    },
  });
  world.setVelocity(player.body, [3, 0]);
  steps(world, 60);
  assert.equal(calls, 60);
  assert.equal(told, 60);
  assert.ok(most > 0.64 * 10 / 60 * 0.9);
  assert.ok(Math.abs(world.velocityOf(player.body).velocity[0] - 3) < 1e-3);
  world.setListeners({ prologue: (rows, count) => {
    for (let i = 0; i < count; i++) rows[i * AT.length + AT.collide] = 0;
  } });
  steps(world, 60);
  assert.ok(world.positionOf(player.body)[1] < -2);
  const parts = [];
  for (const without of [[], ["bodies"], ["point"], ["bodies", "point"]]) {
    const twin = yard();
    twin.world.setListeners({ epilogue: (rows) => { parts.push([rows[AT.bodyB], rows[AT.point]]) }, without });
    twin.world.setTransform(twin.player.body, [1, 0.4]);
    steps(twin.world, 1);
    twin.world.close();
  }
  const [[body, x]] = parts;
  assert.ok(body > 0 && Math.abs(x - 1) < 0.5);
  assert.deepEqual(parts, [[body, x], [0, x], [body, 0], [0, 0]]);
  world.setListeners(null);
  assert.throws(() => world.setListeners({ without: ["normal"] }), /"normal"/);
  assert.throws(() => world.setListeners({ preSolve() {} }), /no option is called "preSolve"/);
  world.close();
});

test("what_a_callback_throws_comes_out_of_the_step_and_leaves_the_world_whole", () => {
  const { world, player } = yard(), twin = yard();
  world.setListeners({ epilogue() { throw new RangeError("mine"); } });
  assert.throws(() => world.step(), /mine/);
  world.setListeners(null);
  twin.world.step();
  for (let i = 0; i < 30; i++) {
    assert.equal(world.hash(), twin.world.hash());
    world.step();
    twin.world.step();
  }
  world.setListeners({ prologue: () => world.step() });
  assert.throws(() => world.step(), { code: "locked" });
  world.setListeners({ prologue: () => world.applyImpulse(player.body, [0, 1], [0, 0.4]) });
  world.step();
  world.close();
  twin.world.close();
});

test("a_pair_filter_keeps_apart_and_is_forgotten_with_its_world", () => {
  const { world, player, ground } = yard();
  const asked = [];
  world.setPairFilter((a, b) => {
    asked.push(a, b);
    return ![a.index, b.index].includes(player.shape.index);
  });
  world.setPairFilter(() => {
    throw new RangeError("mine");
  });
  assert.throws(() => (steps(world, 60), world.setFilter(player.shape, { mask: 7 })), /mine/);
  world.setPairFilter((a, b) => {
    asked.push(a, b);
    return ![a.index, b.index].includes(player.shape.index);
  });
  steps(world, 60);
  assert.ok(asked.some((shape) => shape.index === ground.shape.index));
  assert.ok(world.positionOf(player.body)[1] < -2);
  world.setTransform(player.body, [0, 1], 0);
  world.setVelocity(player.body, [0, 0]);
  world.setPairFilter(null);
  steps(world, 60);
  assert.ok(Math.abs(world.positionOf(player.body)[1] - 0.4) < 0.02);
  const before = asked.length;
  world.close();
  const next = yard();
  next.world.setListeners({ prologue() {} });
  steps(next.world, 5);
  assert.equal(asked.length, before);
  next.world.close();
});

test("worlds_with_listeners_step_each_other_and_listen_apart", () => {
  const outer = yard(), inner = yard(), calls = { outer: 0, inner: 0 };
  inner.world.setListeners({ prologue: () => calls.inner++ });
  outer.world.setListeners({
    prologue(rows, count) {
      inner.world.step();
      calls.outer += count;
      assert.equal(rows[AT.collide], 1);
    },
  });
  steps(outer.world, 10);
  assert.deepEqual(calls, { outer: 10, inner: 10 });
  outer.world.close();
  inner.world.close();
});
