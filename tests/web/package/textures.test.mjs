/** Tests textured ground in the npm package: friction by place, edits, snapshots, refusals. */
import assert from "node:assert/strict";
import { test } from "node:test";
import * as geometry from "../../../web/package/dist/geometry/index.js";
import { thud } from "../support/package.mjs";

const engine = await thud.load();

function near(value, wanted, tolerance = 1e-6) {
  assert.ok(Math.abs(value - wanted) <= tolerance, `${value} is not ${wanted}`);
}

const LINES = {
  flat: { kind: "flat" },
  uniform: { kind: "uniform", x0: -20, spacing: 10, heights: [0, 0, 0, 0, 0] },
  irregular: { kind: "irregular", points: [[-20, 0], [-3, 0], [1, 0], [20, 0]] },
};
const xsOf = ({ kind, points }) =>
  kind === "flat" ? [0, 1] : kind === "uniform" ? [-20, -10, 0, 10, 20] : points.map(([x]) => x);

/** Ground on a body at (100, 0), whose friction is `friction` of x from there. */
function textured(line, friction, options) {
  const world = engine.createWorld(options);
  const ground = world.createTerrain(world.createBody({ position: [100, 0] }), line);
  world.setTexture(ground, { vertices: xsOf(line).map(friction) });
  return { world, ground };
}

for (const [kind, line] of Object.entries(LINES))
  test(`friction_of_${kind}_ground_is_weighted_and_a_box_stops_by_it`, () => {
    // The pair’s is the root of the ground’s and the box’s: v² = 2 g times the integral of it.
    const { world, ground } = textured(line, (x) => 0.5 - 0.02 * x);
    for (const x of [-19, -3, -2.5, 0, 0.999, 1, 7]) near(world.frictionAt(ground, 100 + x), 0.5 - 0.02 * x);
    const box = world.createBody({ kind: "dynamic", position: [90, 0.1], velocity: [8, 0] });
    world.createObb(box, { halfWidth: 0.5, halfHeight: 0.1, friction: 1 });
    for (let i = 0; i < 300; i++) world.step();
    let [x, left, dx] = [-10, 8 * 8, 1e-5];
    for (; left > 0; x += dx) left -= 2 * 10 * dx * Math.sqrt(0.5 - 0.02 * x);
    near(world.bodyStateOf(box).position[0], 100 + x, 0.02);
    world.setTexture(ground, null);
    assert.equal(world.textureOf(ground), null);
    near(world.frictionAt(ground, 95), 0.6);
    world.close();
  });

test("texture_is_told_as_it_was_set_and_lies_still_while_ground_is_dug", () => {
  const { world, ground } = textured(LINES.irregular, () => 0.5);
  const texture = { vertices: [0, 1, 3, 0.5], table: [0.25, 0.5], repeats: true };
  world.setTexture(ground, texture);
  const told = world.textureOf(ground);
  assert.deepEqual([...told.vertices], texture.vertices);
  assert.deepEqual([[...told.table], told.repeats], [texture.table, true]);
  world.setTexture(ground, { vertices: [-20, -3, 1, 20].map((x) => 0.5 + 0.01 * x) });
  world.dig(ground, [102, 0], 2);
  assert.ok(world.textureOf(ground).vertices.length > 10);
  assert.equal(world.textureOf(ground).vertices.length, world.terrainOf(ground).points.length);
  for (let x = -19; x < 19; x += 0.3) near(world.frictionAt(ground, 100 + x), 0.5 + 0.01 * x);
  world.close();
});

test("texture_comes_back_with_a_snapshot_and_another_world_has_to_be_prepared", () => {
  const { world, ground } = textured(LINES.uniform, (x) => 0.5 + 0.01 * x);
  const kept = world.snapshot();
  world.setTexture(ground, null);
  world.restore(kept);
  near(world.frictionAt(ground, 110), 0.6);
  const other = engine.createWorld();
  assert.throws(() => other.restore(kept), /the snapshot has textures/);
  other.useTextures();
  other.restore(kept);
  near(other.frictionAt(ground, 105), 0.55);
  other.close();
  world.close();
});

test("wrong_textures_are_refused_and_change_nothing", () => {
  const { world, ground } = textured(LINES.uniform, () => 0.5);
  const vertices = [0, 1, 2, 3, 4];
  const refused = (texture, told) =>
    assert.throws(() => world.setTexture(ground, texture), (error) => {
      assert.equal(error.code, "invalid");
      assert.match(error.message, told);
      return true;
    });
  refused({ vertices: [1, 2] }, /count is not that of the line's vertices/);
  refused({ vertices: [1, 1, -2, 1, 1] }, /^setTexture: vertices\[2\] must be from 0 to 1e6: -2$/);
  refused({ vertices: [1, 1, 1, 1, NaN] }, /^setTexture: vertices\[4\] must be from 0 to 1e6: NaN$/);
  refused({ vertices: [0, 1, 2, 3, 3e9], table: [1] }, /^setTexture: vertices\[4\] must be from -1e9/);
  refused({ vertices, table: [1, -1] }, /^setTexture: table\[1\] must be from 0 to 1e6: -1$/);
  refused({ vertices, table: [] }, /tableCount is not in 1/);
  refused({ vertices, table: 5 }, /^setTexture: table must be a list$/);
  refused({}, /^setTexture: vertices must be a list$/);
  refused({ vertices, table: [1], repeats: 1 }, /repeats must be true or false: 1$/);
  refused({ vertices, tabel: [1] }, /no option is called "tabel"/);
  refused(undefined, /options are an object: undefined/);
  const circle = world.createCircle(world.createBody(), { radius: 1 });
  for (const act of [
    () => world.setTexture(circle, { vertices }),
    () => world.setTexture(circle, null),
    () => world.textureOf(circle),
    () => world.frictionAt(circle, 0),
    () => world.frictionAt(ground, NaN),
  ])
    assert.throws(act, { code: "invalid" });
  world.destroy(circle);
  assert.throws(() => world.setTexture(circle, { vertices }), { code: "stale" });
  world.setListeners({ prologue: () => assert.fail("nothing touches") });
  near(world.frictionAt(ground, 95), 0.5);
  world.close();
});

test("texture_without_a_world_gives_the_same_friction_and_look_ups_are_counted", () => {
  const texture = { vertices: [0, 0.5, 1, 2], table: [0.1, 0.5, 0.3] };
  const { world, ground } = textured(LINES.irregular, () => 0.5);
  world.setTexture(ground, texture);
  for (let x = -20; x <= 20; x += 0.7)
    near(geometry.frictionAt(engine, LINES.irregular, x, texture), world.frictionAt(ground, 100 + x), 0);
  world.close();
  assert.throws(() => geometry.frictionAt(engine, LINES.irregular, 21, texture), { code: "invalid" });
  const few = { vertices: [0, 1] };
  assert.throws(() => geometry.frictionAt(engine, LINES.irregular, 10, few), { code: "invalid" });
  // Places are spread: on three segments of a third each, about as many on each.
  const thirds = { kind: "uniform", x0: 0, spacing: 1, heights: [0, 0, 0, 0] };
  near(geometry.terrainAtOften(engine, thirds, 0, 3, 3000), 3000, 3);
  assert.equal(geometry.terrainAtOften(engine, thirds, 0, 3, 0), 0);
  assert.throws(() => geometry.terrainAtOften(engine, thirds, 0, 4, 100), { code: "invalid" });
});
