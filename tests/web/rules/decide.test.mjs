/** Tests epilogues of bodies and categories, and prologues that decide velocities, in the package. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { thud } from "../support/package.mjs";

const engine = await thud.load();
const { LISTENED_ROW: AT } = thud;
const DETECTIONS = ["overlap", "continuous", "bisect", "swept"];
const FLOOR = 2, BALL = 4;

function steps(world, count) {
  for (let i = 0; i < count; i++) world.step();
}

/** A ball at this height above a floor whose top is at y = 0, without gravity. */
function court(height, options = {}) {
  const world = engine.createWorld({ gravity: [0, 0], sleeping: false, ...options });
  const floor = world.createBody({ position: [0, -1] });
  world.createAabb(floor, { halfWidth: 20, halfHeight: 1, category: FLOOR });
  const ball = world.createBody({ kind: "dynamic", position: [0, height], velocity: [1, -4] });
  world.createCircle(ball, { radius: 0.5, category: BALL });
  return { world, floor, ball };
}

/** Calls `answer` with the number of each row in which the ball comes down. */
function whereItFalls(world, ball, answer) {
  return (rows, count) => {
    for (let i = 0; i < count; i++)
      if (rows[i * AT.length + AT.bodyB] === ball.index + 1 && world.velocityOf(ball).velocity[1] < 0)
        answer(i, rows);
  };
}

for (const detection of DETECTIONS)
  test(`velocities_that_a_prologue_decides_hold_and_are_told_under_${detection}`, () => {
    const { world, ball } = court(1.53, { detection });
    const told = [];
    let decided = 0, answers = 0;
    world.setListeners({
      prologue: whereItFalls(world, ball, (row) => {
        answers++;
        world.decide(row, { b: { velocity: [3, 7], angularVelocity: 2 } });
      }),
      epilogue(rows, count) {
        for (let i = 0; i < count; i++) told.push(rows[i * AT.length + AT.normalImpulse]);
      },
    });
    for (let i = 0; i < 40 && told.length === 0; i++) {
      world.step();
      decided += world.stepError().energyDecided;
    }
    const { velocity, angularVelocity } = world.velocityOf(ball);
    assert.deepEqual([...velocity, angularVelocity], [3, 7, 2]);
    const { mass, inertia } = world.bodyStateOf(ball);
    assert.ok(answers > 0 && Math.abs(told[0] - mass * 11) < 1e-4);
    const wanted = 0.5 * mass * (9 + 49 - 1 - 16) + 0.5 * inertia * 4;
    assert.ok(Math.abs(decided - wanted) < 1e-4 * wanted, `${decided} of ${wanted}`);
    steps(world, 10);
    assert.equal(world.velocityOf(ball).velocity[1], 7);
    assert.equal(world.stepError().energyDecided, 0);
    world.close();
  });

test("what_cannot_be_decided_is_refused_by_name_and_leaves_the_collision", () => {
  const plain = court(0.6), { world, floor, ball } = court(0.6);
  const refused = [];
  const tries = [
    [0, { a: { velocity: [0, 1] } }], // the floor is static
    [0, { b: { velocity: [0, NaN] } }],
    [0, { b: { velocity: [0, 1], angularVelocity: Infinity } }],
    [0, { b: {} }],
    [0, {}],
    [1, { b: { velocity: [0, 1] } }],
    [0.5, { b: { velocity: [0, 1] } }],
    [0, { c: { velocity: [0, 1] } }],
    [0, { b: { speed: 1 } }],
    [0, { b: { velocity: [0, 1, 2] } }],
  ];
  world.setListeners({
    prologue(rows, count) {
      assert.equal(rows[AT.bodyA], floor.index + 1);
      assert.equal(count, 1);
      for (const [row, response] of tries)
        try {
          world.decide(row, response);
        } catch (error) {
          refused.push(error.code);
        }
    },
  });
  plain.world.setListeners({ prologue() {} });
  for (let i = 0; i < 10; i++) {
    world.step();
    plain.world.step();
    assert.equal(world.hash(), plain.world.hash());
  }
  assert.deepEqual(refused.slice(0, tries.length), [
    ...["invalid", "invalid", "invalid", "invalid", "null"],
    ...["invalid", "invalid", "invalid", "invalid", "invalid"],
  ]);
  assert.throws(() => world.decide(0, { b: { velocity: [0, 1] } }), { code: "invalid" });
  // What the prologue throws comes out of the step, and the world goes on.
  world.setTransform(ball, [0, 0.5]);
  world.setListeners({ prologue: () => world.decide(0, { b: { velocity: [0, NaN] } }) });
  assert.throws(() => world.step(), /decide.*velocity/);
  world.setListeners(null);
  steps(world, 3);
  world.close();
  plain.world.close();
});

test("a_prologue_decides_in_its_own_world_only", () => {
  const outer = court(0.5), inner = court(0.5);
  let tried = 0;
  inner.world.setListeners({
    prologue: () => assert.throws(() => outer.world.decide(0, { b: { velocity: [0, 1] } }), { code: "invalid" }),
  });
  outer.world.setListeners({
    prologue() {
      inner.world.step();
      outer.world.decide(0, { b: { velocity: [0, 9] } });
      tried++;
    },
  });
  outer.world.step();
  assert.equal(tried, 1);
  assert.equal(outer.world.velocityOf(outer.ball).velocity[1], 9);
  outer.world.close();
  inner.world.close();
});

for (const detection of DETECTIONS)
  test(`objects_are_told_of_their_contacts_under_${detection}`, () => {
    const { world, floor, ball } = court(0.5, { detection, gravity: [0, -10] });
    const calls = [];
    const note = (who) => (row, side) => {
      assert.equal(row.length, AT.length);
      calls.push([who, side, row[side ? AT.bodyB : AT.bodyA], row[AT.normalImpulse]]);
    };
    world.setListeners({ epilogue: (rows, count) => calls.push(["world", count]) });
    world.setBodyEpilogue(ball, note("ball"));
    world.setBodyEpilogue(floor, note("floor"));
    world.setCategoryEpilogue(BALL | 8, note("balls"));
    world.setCategoryEpilogue(0xffffffff, note("all"));
    world.step();
    assert.deepEqual(calls.map(([who, side]) => [who, side]), [
      ["world", 1],
      ...[["floor", 0], ["all", 0], ["ball", 1], ["balls", 1], ["all", 1]],
    ]);
    assert.ok(calls.slice(1).every(([, side, body, impulse]) =>
      body === (side ? ball : floor).index + 1 && impulse > 0));
    world.setListeners(null);
    world.setCategoryEpilogue(0xffffffff, null);
    world.setBodyEpilogue(floor, null);
    world.setBodyEpilogue(ball, note("again"));
    calls.length = 0;
    world.step();
    assert.deepEqual(calls.map(([who, side]) => [who, side]), [["again", 1], ["balls", 1]]);
    world.destroy(ball);
    calls.length = 0;
    steps(world, 2);
    const next = world.createBody({ kind: "dynamic", position: [0, 0.5] });
    world.createCircle(next, { radius: 0.5 });
    steps(world, 2);
    assert.equal(next.index, ball.index);
    assert.deepEqual(calls, []);
    assert.throws(() => world.setBodyEpilogue(ball, note("gone")), { code: "stale" });
    assert.throws(() => world.setCategoryEpilogue(0, note("none")), { code: "invalid" });
    assert.throws(() => world.setCategoryEpilogue("2", note("text")), { code: "invalid" });
    world.setBodyEpilogue(next, () => world.setBodyEpilogue(next, null));
    assert.throws(() => world.step(), { code: "locked" });
    world.close();
  });
