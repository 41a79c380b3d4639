/** Tests castRayEach and castShapeEach of the npm package, which call a function for each hit. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { thud } from "../support/package.mjs";

const engine = await thud.load();
const CIRCLE = { kind: "circle", radius: 0.5 };

/** Four boxes in a row; their left faces are 2, 6, 10 and 14 from the origin. */
function row() {
  const world = engine.createWorld();
  const box = { halfWidth: 1, halfHeight: 1 };
  const boxes = [3, 7, 11, 15].map((x) => world.createAabb(world.createBody({ position: [x, 0] }), box));
  return { world, boxes };
}

/**
 * The boxes, by their place in the row, for which a ray of length 20 calls `answer`; its return
 * value is the answer to the hit.
 */
function told({ world, boxes }, answer, filter) {
  const hits = [];
  world.castRayEach([0, 0], [20, 0], (hit) => (hits.push(hit), answer(hit, hits.length)), filter);
  return hits.map((hit) => boxes.findIndex(({ index }) => index === hit.shape.index));
}

test("hit_by_hit_casts_tell_what_casts_of_all_do", () => {
  const { world } = row();
  const rays = [], circles = [];
  world.castRayEach([0, 0], [20, 0], (hit) => void rays.push(hit));
  world.castShapeEach(CIRCLE, [0, 0], [20, 0], (hit) => void circles.push(hit));
  assert.equal(rays.length, 4);
  assert.deepEqual(rays, world.castRayAll([0, 0], [20, 0]));
  assert.deepEqual(circles, world.castShapeAll(CIRCLE, [0, 0], [20, 0]));
  world.close();
});

test("answers_accept_ignore_clip_and_end", () => {
  const made = row();
  assert.deepEqual(told(made, () => undefined), [0, 1, 2, 3]);
  assert.deepEqual(told(made, () => 1), [0, 1, 2, 3]);
  assert.deepEqual(told(made, () => -1), [0, 1, 2, 3]);
  assert.deepEqual(told(made, () => 0), [0]);
  assert.deepEqual(told(made, ({ fraction }) => fraction), [0]);
  assert.deepEqual(told(made, () => 0.5), [0, 1]);
  assert.deepEqual(told(made, (_, count) => (count === 1 ? 0.6 : 1)), [0, 1, 2]);
  assert.deepEqual(told(made, () => "0.5"), [0, 1]);
  assert.deepEqual(told(made, () => NaN), [0, 1, 2, 3]);
  const { world, boxes } = made;
  assert.deepEqual(told(made, () => 1, { ignore: world.bodyOf(boxes[1]) }), [0, 2, 3]);
  world.close();
});

test("what_a_listener_throws_ends_the_cast_and_leaves_the_world_whole", () => {
  const made = row(), { world } = made, hash = world.hash();
  let calls = 0;
  const mine = new thud.ThudError("invalid", "mine");
  const thrower = () => {
    calls++;
    throw mine;
  };
  assert.throws(() => told(made, thrower), (error) => error === mine);
  assert.throws(() => world.castShapeEach(CIRCLE, [0, 0], [20, 0], thrower), (error) => error === mine);
  assert.throws(() => told(made, () => Symbol("no number")), TypeError);
  assert.equal(calls, 2);
  assert.equal(world.hash(), hash);
  assert.deepEqual(told(made, () => 1), [0, 1, 2, 3]);
  world.step();
  world.close();
});

test("refusals_of_hit_by_hit_casts_name_the_argument", () => {
  const { world } = row();
  const never = () => assert.fail("nothing is told");
  assert.throws(() => world.castRayEach([NaN, 0], [1, 0], never), /castRayEach: origin must be two numbers/);
  const none = { kind: "circle", radius: 0 };
  assert.throws(() => world.castShapeEach(none, [0, 0], [1, 0], never), /castShapeEach: radius must be above 0/);
  assert.throws(() => world.castRayEach([0, 0], [1, 0], never, { masks: 1 }), /"masks"/);
  world.close();
});

test("inside_a_hit_the_world_is_asked_and_not_stepped_restored_or_closed", () => {
  const made = row(), { world, boxes } = made, snapshot = world.snapshot();
  const refused = [
    () => world.step(),
    () => world.restore(snapshot),
    () => world.setGravity([0, 1]),
    () => world.setFriction(boxes[1], 0.25),
    () => world.close(),
  ];
  const inner = [];
  const all = told(made, () => {
    for (const act of refused) assert.throws(act, { code: "locked" });
    inner.push(told(made, () => 0.5).length, world.castRay([0, 0], [20, 0]).shape.index);
  });
  assert.deepEqual(all, [0, 1, 2, 3]);
  assert.deepEqual(inner, [2, boxes[0].index, 2, boxes[0].index, 2, boxes[0].index, 2, boxes[0].index]);
  // An exception that an inner cast's listener throws leaves the outer cast as well.
  const thrower = () => {
    throw new RangeError("mine");
  };
  assert.throws(() => told(made, () => told(made, thrower)), /mine/);
  world.close();
  assert.throws(() => world.close(), { code: "stale" });
});

test("what_is_destroyed_inside_a_hit_waits_and_is_told_of_no_more", () => {
  const made = row(), { world, boxes } = made;
  const answer = (hit) => {
    if (hit.shape.index === boxes[0].index) world.destroy(boxes[2]);
  };
  assert.deepEqual(told(made, answer), [0, 1, 3]);
  world.step();
  assert.deepEqual(told(made, () => 1), [0, 1, 3]);
  world.close();
});

test("memory_that_grows_inside_a_hit_moves_no_other", () => {
  const made = row(), { world } = made, expected = world.castRayAll([0, 0], [20, 0]);
  const hits = [];
  world.castRayEach([0, 0], [20, 0], (hit) => {
    const other = engine.createWorld(), before = engine.buffer;
    while (engine.buffer === before) other.createCircle(other.createBody(), { radius: 1 });
    other.close();
    hits.push(hit);
  });
  assert.deepEqual(hits, expected);
  world.close();
});
