/** Queries of the npm package: many rays at once, one shape alone, groups and a body to ignore. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { thud } from "../support/package.mjs";

const engine = await thud.load();

/** Boxes of 2 by 2 in a row, each on a body of its own. */
function row(count, options = {}) {
  const world = engine.createWorld({ gravity: [0, 0] });
  const bodies = Array.from({ length: count }, (_, i) => world.createBody({ position: [4 * i, 0] }));
  const shapes = bodies.map((body) =>
    world.createAabb(body, { halfWidth: 1, halfHeight: 1, ...options }),
  );
  return { world, bodies, shapes };
}

test("many_rays_hit_what_each_alone_hits", () => {
  const { world } = row(8);
  const rays = [];
  for (let i = 0; i < 200; i++) rays.push(0.17 * i, 5, 0.01 * (i - 100), i % 9 === 0 ? -1 : -10);
  const alone = Array.from({ length: 200 }, (_, i) => {
    const [x, y, dx, dy] = rays.slice(4 * i);
    return world.castRay([x, y], [dx, dy]);
  });
  assert.deepEqual(world.castRays(rays), alone);
  assert.deepEqual(world.castRays(Float64Array.from(rays)), alone);
  assert.ok(alone.some((hit) => hit === null) && alone.some((hit) => hit !== null));
  assert.deepEqual(world.castRays([]), []);
  assert.throws(() => world.castRays([0, 5, 0, -10, NaN, 0, 0, 1]), { code: "invalid" });
});

test("query_ignores_a_body_and_heeds_groups_wherever_it_asks", () => {
  const { world, bodies, shapes } = row(3, { group: -3 });
  const [first, second] = shapes;
  const ray = (filter) => world.castRay([-5, 0], [20, 0], filter)?.shape;
  assert.deepEqual(ray(), first);
  assert.deepEqual(ray({ ignore: bodies[0] }), second);
  assert.equal(ray({ group: -3 }), undefined);
  assert.deepEqual(ray({ group: 3 }), first);
  assert.deepEqual(world.castRays([-5, 0, 20, 0], { ignore: bodies[0] })[0].shape, second);
  const circle = { kind: "circle", radius: 0.5 };
  assert.deepEqual(world.castShape(circle, [-5, 0], [20, 0], { ignore: bodies[0] }).shape, second);
  assert.equal(world.castRayAll([-5, 0], [20, 0], { ignore: bodies[1] }).length, 2);
  assert.deepEqual(world.closest([0, 0], 20, { ignore: bodies[0] }).shape, second);
  const everywhere = { kind: "bounds", lower: [-9, -9], upper: [20, 9] };
  assert.equal(world.overlap(everywhere, { ignore: bodies[0] }).length, 2);
  assert.equal(world.overlap(everywhere, { group: -3 }).length, 0);
  world.destroy(bodies[0]);
  assert.deepEqual(ray({ ignore: bodies[0] }), second);
  assert.throws(() => ray({ ignored: bodies[0] }), /no option is called "ignored"/);
});

test("mover_passes_the_body_that_it_ignores", () => {
  const { world, bodies } = row(1);
  const options = { shape: { kind: "circle", radius: 0.5 }, position: [-4, 0], up: [0, 0] };
  const stopped = new thud.Mover(world, options);
  const passing = new thud.Mover(world, { ...options, filter: { ignore: bodies[0] } });
  for (let i = 0; i < 60; i++) [stopped, passing].forEach((mover) => mover.move([8, 0], 1 / 60));
  assert.ok(stopped.state().position[0] < -1.4);
  assert.ok(passing.state().position[0] > 3.9);
});

test("one_shape_is_asked_whatever_its_filter", () => {
  const { world, bodies, shapes } = row(2, { mask: 0, category: 0 });
  const [, second] = shapes;
  const hit = world.castRayAt(second, [-5, 0], [20, 0]);
  assert.deepEqual([hit.shape, hit.point, hit.normal[0]], [second, [3, 0], -1]);
  assert.equal(world.castRayAt(second, [-5, 3], [20, 0]), null);
  assert.equal(world.containsPoint(second, [4.5, 0.5]), true);
  assert.equal(world.containsPoint(second, [0, 0]), false);
  const { point, distance } = world.closestPointOf(second, [8, 0]);
  assert.deepEqual([point, distance], [[5, 0], 3]);
  assert.deepEqual(world.boundsOf(second), { lower: [3, -1], upper: [5, 1] });
  world.destroy(bodies[1]);
  for (const ask of [
    () => world.castRayAt(second, [-5, 0], [20, 0]),
    () => world.containsPoint(second, [0, 0]),
    () => world.closestPointOf(second, [0, 0]),
    () => world.boundsOf(second),
  ])
    assert.throws(ask, { code: "stale" });
});

test("flat_terrain_has_no_bounds_and_a_line_has", () => {
  const world = engine.createWorld();
  const flat = world.createTerrain(world.createBody(), { kind: "flat" });
  assert.throws(() => world.boundsOf(flat), { code: "invalid" });
  const points = [[-2, 1], [0, 3], [4, -1]];
  const line = world.createTerrain(world.createBody({ position: [1, 0] }), { kind: "irregular", points });
  assert.deepEqual(world.boundsOf(line), { lower: [-1, -1], upper: [5, 3] });
});
