/**
 * Tests `approximate` and capsules of thud/geometry: by figures worked out by hand, by points of
 * random polygons, and what they refuse. The engine's own tests are tests/engine/geometry.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { geometry, thud } from "../support/package.mjs";

const engine = await thud.load();
const near = (actual, expected, tolerance = 1e-9) =>
  assert.ok(Math.abs(actual - expected) <= tolerance, `${actual}, not ${expected}`);
const AN_L = [[0, 0], [3, 0], [3, 1], [1, 1], [1, 3], [0, 3]];
const capsule = (from, to, radius) => ({ kind: "capsule", from, to, radius });
const circle = (x, y, radius = 1) => ({ kind: "circle", center: [x, y], radius });

/** Random numbers, the same in every run. */
function source(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

/** A polygon around the origin whose corners are at random distances. */
function polygon(random) {
  const count = 3 + Math.floor(random() * 20);
  return Array.from({ length: count }, (_, i) => {
    const [far, angle] = [0.3 + 0.7 * random(), (2 * Math.PI * i) / count];
    return [far * Math.cos(angle), far * Math.sin(angle)];
  });
}

/** The distance of a point from a shape; 0 inside. */
function distance(shape, [x, y]) {
  const [dx, dy] = [x - shape.center[0], y - shape.center[1]];
  if (shape.kind === "circle") return Math.max(Math.hypot(dx, dy) - shape.radius, 0);
  const [c, s] = [Math.cos(shape.angle), Math.sin(shape.angle)];
  const u = Math.max(Math.abs(c * dx + s * dy) - shape.halfWidth, 0);
  const v = Math.max(Math.abs(c * dy - s * dx) - shape.halfHeight, 0);
  return Math.hypot(u, v);
}

test("an L is two boxes and misses nothing", () => {
  const found = geometry.approximate(engine, AN_L, { shapes: 5 });
  assert.equal(found.shapes.length, 2);
  for (const name of ["missed", "extra", "overlap", "distance"]) near(found[name], 0);
  for (const shape of found.shapes) assert.deepEqual([shape.kind, shape.angle], ["obb", 0]);
  const areas = found.shapes.map(({ halfWidth, halfHeight }) => 4 * halfWidth * halfHeight);
  near(areas[0], 3);
  near(areas[1], 2);
  const one = geometry.approximate(engine, AN_L, { shapes: 1 });
  near(one.missed, 0.4);
  assert.ok(one.distance >= 2 && one.distance <= 2.125, "the end of the other leg is 2 away");
});

test("a body is made of the parts of an approximation, and lies where the points are", () => {
  const world = engine.createWorld({ gravity: [0, 0] });
  const { parts, shapes } = geometry.approximate(engine, AN_L, { shapes: 5 });
  const body = world.createBody({ kind: "dynamic", shapes: parts });
  assert.equal(world.shapesOf(body).length, shapes.length);
  const inside = ([x, y]) => world.overlap({ kind: "circle", center: [x, y], radius: 0.01 }).length > 0;
  assert.deepEqual([[2.9, 0.5], [0.5, 2.9], [1.5, 1.5], [3.1, 0.5]].map(inside), [true, true, false, false]);
  near(world.bodyStateOf(body).mass, 5, 1e-5);
  world.close();
});

test("a turned rectangle is a box at its angle", () => {
  const [c, s] = [Math.cos(0.3), Math.sin(0.3)];
  const points = [[0, 0], [3, 0], [3, 1], [0, 1]].map(([x, y]) => [c * x - s * y, s * x + c * y]);
  const [box, ...more] = geometry.approximate(engine, points, { shapes: 3, kinds: "boxes" }).shapes;
  assert.deepEqual(more, []);
  near(box.angle, 0.3);
  near(box.halfWidth, 1.5);
  near(box.halfHeight, 0.5);
});

test("a square is the circle of which half is inside", () => {
  const square = [[-1, -1], [1, -1], [1, 1], [-1, 1]];
  const found = geometry.approximate(engine, square, { shapes: 1, kinds: "circles" });
  const r = 1 / Math.cos(Math.PI / 8);
  near(found.shapes[0].radius, r, 0.02);
  assert.ok(found.distance >= Math.SQRT2 - r - 0.02 && found.distance < 0.4);
});

test("points of random polygons are within the bound, which falls with the number of shapes", () => {
  const random = source(7);
  for (let i = 0; i < 12; i++) {
    const points = polygon(random);
    let before = { missed: 9, extra: 9, distance: 9 };
    for (const shapes of [1, 2, 4, 8]) {
      const found = geometry.approximate(engine, points, { shapes });
      assert.ok(found.shapes.length <= shapes);
      assert.ok(found.missed + found.extra <= before.missed + before.extra);
      assert.ok(found.distance <= before.distance);
      before = found;
      for (const [k, [x, y]] of points.entries()) {
        const [nextX, nextY] = points[(k + 1) % points.length];
        for (let t = 0; t < 1; t += 0.02) {
          const at = [x + t * (nextX - x), y + t * (nextY - y)];
          const nearest = Math.min(...found.shapes.map((shape) => distance(shape, at)));
          assert.ok(nearest <= found.distance, `${nearest} at ${at}`);
        }
      }
    }
    const good = geometry.approximate(engine, points, { shapes: 8, distance: before.distance });
    assert.ok(good.shapes.length <= before.shapes.length && good.distance <= before.distance);
  }
});

test("what is no polygon and wrong options are refused with the reason", () => {
  const refused = (points, options, message) =>
    assert.throws(() => geometry.approximate(engine, points, options), { code: "invalid", message });
  refused([[0, 0], [1, 1], [1, 0], [0, 1]], { shapes: 1 }, /approximate: edges .* cross/);
  refused([[0, 0], [1, 0]], { shapes: 1 }, /too few/);
  refused([[0, 0], [1, 0], [NaN, 1]], { shapes: 1 }, /not finite/);
  refused([[0, 0], [1, 0], [2, 0.001]], { shapes: 1 }, /no area/);
  for (const shapes of [0, 65, 1.5, NaN, "3", undefined])
    refused(AN_L, { shapes }, /shapes is .*, no whole number from 1 to 64/);
  refused(AN_L, { shapes: 1, kinds: "box" }, /kinds "box" is none of both, circles, boxes/);
  refused(AN_L, { shapes: 1, distance: -1 }, /distance is -1, out of range/);
  refused(AN_L, { shapes: 1, error: 1 }, /no option is called "error"/);
});

test("capsules are as far from shapes and each other as worked out by hand", () => {
  const level = capsule([0, 0], [4, 0], 1);
  const above = geometry.capsuleClosest(engine, level, circle(2, 3, 0.5));
  near(above.distance, 1.5);
  near(above.pointA[1], 1);
  near(above.pointB[1], 2.5);
  assert.equal(above.overlaps, false);
  const beyond = geometry.capsuleClosest(engine, level, circle(7, 4));
  near(beyond.distance, 3);
  near(beyond.normal[0], 0.6);
  const crossing = geometry.capsuleClosest(
    engine, capsule([-2, 0], [2, 0], 0.5), capsule([0, -1], [0, 3], 0.25),
  );
  near(crossing.distance, -1.75);
  assert.equal(crossing.overlaps, true);
  const box = { kind: "aabb", center: [0, 5], halfWidth: 1, halfHeight: 1 };
  near(geometry.capsuleClosest(engine, level, box).distance, 3);
  const hill = { kind: "irregular", points: [[-5, 0], [0, 3], [5, 0]] };
  near(geometry.capsuleClosestOnTerrain(engine, hill, capsule([-2, 5], [2, 5], 0.5)).distance, 1.5);
});

test("capsules meet when worked out by hand, and where their circle does", () => {
  const time = (...rest) => geometry.capsuleTimeOfImpact(engine, ...rest);
  const level = capsule([0, 0], [4, 0], 1);
  near(time(level, [0, 10], circle(2, 8), [0, 0]), 0.6);
  near(time(level, [0, 10], circle(2, 8), [0, 0], 1), 0.5);
  const bar = capsule([8, 1], [10, 1], 0.5);
  near(time(capsule([0, 0], [0, 4], 0.5), [4, 0], bar, [-4, 0]), 0.875);
  assert.equal(time(level, [0, -1], bar, [0, 1]), null);
  const flat = { kind: "flat", slope: 0 };
  const leaning = capsule([0, 2], [3, 4], 0.5);
  near(geometry.capsuleTimeOfImpactOnTerrain(engine, flat, leaning, [7, -6]), 0.25);
  assert.equal(geometry.capsuleTimeOfImpactOnTerrain(engine, flat, leaning, [7, -1]), null);
  const random = source(3);
  const number = () => 6 * random() - 3;
  for (let i = 0; i < 200; i++) {
    const [moving, way, rest] = [circle(number(), number()), [number(), number()], circle(number(), number(), 0.5)];
    const way0 = { way: [0, 0] };
    const hit = geometry.timeOfImpact(engine, moving, { way }, rest, way0) !== null;
    const swept = geometry.capsuleClosest(engine, geometry.capsuleOf(engine, moving, way), rest);
    assert.equal(swept.overlaps, hit);
  }
});

test("what is no capsule is refused", () => {
  const refused = (one) =>
    assert.throws(() => geometry.capsuleClosest(engine, one, circle(0, 0)), { code: "invalid" });
  refused(capsule([0, 0], [1, 0], 0));
  refused(capsule([0, NaN], [1, 0], 1));
  refused({ ...capsule([0, 0], [1, 0], 1), width: 1 });
  const good = capsule([0, 0], [1, 0], 1);
  const wrong = [good, [0, 0], circle(0, 0), [0, 0], -1];
  assert.throws(() => geometry.capsuleTimeOfImpact(engine, ...wrong), { code: "invalid" });
  for (const way of [[NaN, 0], [4e15, 0]])
    assert.throws(() => geometry.capsuleOf(engine, circle(0, 0), way), { code: "invalid" });
  const line = { kind: "flat", slope: 1e9 };
  assert.throws(() => geometry.capsuleClosestOnTerrain(engine, line, good), { code: "invalid" });
});
