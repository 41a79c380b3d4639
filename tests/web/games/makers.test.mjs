/**
 * Tests the short functions for shapes and bodies: they give the same as options that are written
 * out.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { thud } from "../support/package.mjs";

const { aabb, circle, Mover, obb, walls } = thud;
const engine = await thud.load();

test("shapes_in_few_words_are_plain_objects", () => {
  const rest = { offset: [1, 2], restitution: 0.5 };
  assert.deepEqual(circle(0.5), { kind: "circle", radius: 0.5 });
  assert.deepEqual(circle(0.5, rest), { kind: "circle", radius: 0.5, ...rest });
  assert.deepEqual(aabb(2, 1, rest), { kind: "aabb", halfWidth: 2, halfHeight: 1, ...rest });
  assert.deepEqual(obb(2, 1), { kind: "obb", halfWidth: 2, halfHeight: 1, angle: 0 });
  assert.equal(obb(2, 1, { angle: 0.3 }).angle, 0.3);
  assert.deepEqual(rest, { offset: [1, 2], restitution: 0.5 });
});

test("bodies_queries_and_movers_take_them", () => {
  const world = engine.createWorld();
  const ball = world.createBody({ kind: "dynamic", shapes: [circle(0.5), obb(1, 0.2), aabb(1, 1)] });
  const kinds = world.shapesOf(ball).map((shape) => world.shapeStateOf(shape).kind);
  assert.deepEqual(kinds, ["aabb", "obb", "circle"]);
  for (const shape of [circle(1), aabb(1, 1), obb(1, 1)]) {
    assert.equal(world.castShape(shape, [-5, 0], [9, 0])?.shape.kind, "shape");
    new Mover(world, { shape, position: [0, 9] }).close();
  }
  assert.equal(world.createCircle(ball, circle(2)).kind, "shape");
  assert.throws(() => world.createBody({ shapes: [circle()] }), { message: /radius/ });
  assert.throws(() => world.createBody({ shapes: [aabb(1, 1, { ofset: [0, 0] })] }), { message: /ofset/ });
});

test("walls_keep_in_what_is_in_their_rectangle", () => {
  const world = engine.createWorld({ gravity: [0, 0] });
  world.createBody({ shapes: walls(4, 2, 0.5, { offset: [10, 5], restitution: 1 }) });
  const hits = [[1, 0], [-1, 0], [0, 1], [0, -1]].map(
    (way) => world.castRay([10, 5], way.map((x) => 9 * x)).point,
  );
  assert.deepEqual(hits, [[14, 5], [6, 5], [10, 7], [10, 3]]);
  for (const [x, y] of [[13.9, 7.1], [14.1, 6.9], [5.9, 2.9], [14.4, 2.6]])
    assert.equal(world.overlap({ kind: "circle", center: [x, y], radius: 0.01 }).length > 0, true);
  assert.equal(world.overlap({ kind: "bounds", lower: [6.01, 3.01], upper: [13.99, 6.99] }).length, 0);
  assert.equal(walls(4, 2, 1)[0].offset[0], 0);
  for (const thickness of [0, -1, NaN, undefined])
    assert.throws(() => walls(1, 1, thickness), { code: "invalid", message: /thickness/ });
});

test("bodies_are_made_alike_at_every_position", () => {
  const [one, two] = [engine.createWorld(), engine.createWorld()];
  const options = { kind: "dynamic", userData: 7, shapes: [circle(0.5), aabb(1, 0.2)] };
  const positions = [[0, 3], [5, 1], [-5, 2]];
  const made = one.createBodies(options, positions);
  assert.deepEqual(made, one.bodies());
  assert.deepEqual(made.map((body) => one.positionOf(body)), positions);
  for (const position of positions) two.createBody({ ...options, position });
  assert.equal(one.hash(), two.hash());
  assert.deepEqual(one.createBodies(options, []), []);
  assert.equal("position" in options, false);
});

test("where_one_body_is_refused_none_is_left", () => {
  const world = engine.createWorld();
  const options = { shapes: [circle(0.5)] };
  assert.throws(() => world.createBodies(options, [[0, 0], [1, 1], [NaN, 0]]), {
    name: "ThudError",
    code: "invalid",
    message: /^createBodies: positions\[2\]: createBody: position must be /,
  });
  assert.throws(() => world.createBodies(options, [null]), { message: /positions\[0\]/ });
  assert.throws(() => world.createBodies({ shapes: [circle(-1)] }, [[0, 0]]), { message: /radius/ });
  assert.deepEqual(world.bodies(), []);
});

test("bits_may_be_those_of_a_negative_number", () => {
  const world = engine.createWorld();
  const [shape] = world.shapesOf(world.createBody({ shapes: [circle(1, { category: 1 << 31, mask: ~4 })] }));
  const told = () => [world.shapeStateOf(shape).category, world.shapeStateOf(shape).mask];
  assert.deepEqual(told(), [0x80000000, 0xfffffffb]);
  world.setFilter(shape, { category: -1, mask: ~0xff });
  assert.deepEqual(told(), [0xffffffff, 0xffffff00]);
  assert.equal(world.castRay([-9, 0], [18, 0], { mask: ~1, category: ~0 })?.fraction, 8 / 18);
});
