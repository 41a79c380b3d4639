/**
 * Tests the scene with textured ground: the texture and friction under a foot follow from the
 * engine's weights of the ground's points.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { coordinatesOf, TEXTURE, textureAt } from "../../../web/public/scenes/textured/texture.js";
import { buildScene, openSession, runScene } from "../../../web/tools/scenes.mjs";
import { thud } from "../support/package.mjs";

const engine = await thud.load();
const near = (actual, expected, tolerance = 1e-9) =>
  assert.ok(Math.abs(actual - expected) < tolerance, `${actual}, not ${expected}`);

test("texture_goes_along_the_line_by_the_engine_s_weights", () => {
  const world = engine.createWorld();
  const points = [[0, 0], [3, 4], [4, 4]];
  const shape = world.createTerrain(world.createBody(), { kind: "irregular", points });
  const band = { shape, row: 2, points, coordinates: coordinatesOf(points, 2) };
  const { u, v, row, weights, y } = textureAt(world, band, 1.5);
  near(u, 2.5);
  near(y, 2);
  assert.deepEqual([v, row, TEXTURE[row].name], [2.5, 2, "Ice"]);
  assert.deepEqual(weights, [0.5, 0.5]);
  near(textureAt(world, band, 3.25).u, 5.25);
  // A foot at the end of a band may touch slightly beyond it.
  near(textureAt(world, band, 4.01).u, 6);
  world.close();
});

/** The texts that the scene writes below the ground, with their places. */
function signsOf(scene) {
  return scene.paint().marks.flatMap(({ x, y, text }) => {
    const [, name, friction] = text?.match(/^(\w+), friction ([\d.]+)$/) ?? [];
    return name ? [{ x, y, name, friction: Number(friction) }] : [];
  });
}

test("ground_has_the_friction_that_is_written_below_it", async () => {
  const { scene } = await buildScene(engine, "textured");
  const signs = signsOf(scene);
  assert.deepEqual(new Set(signs.map(({ name }) => name)), new Set(TEXTURE.map(({ name }) => name)));
  for (const { x, y, name, friction } of signs) {
    const ground = scene.world.castRayAll([x, y + 3], [0, -6]).at(-1); // below any walker
    assert.equal(scene.world.frictionAt(ground.shape, x), Math.fround(friction), name);
  }
  // Where two bands meet it is the mean of both.
  signs.sort((a, b) => a.x - b.x);
  for (let i = 1; i < signs.length; i++) {
    const x = Math.round((signs[i - 1].x + signs[i].x) / 2 / 6) * 6;
    const ground = scene.world.castRayAll([x + 0.001, 6], [0, -12]).at(-1);
    near(scene.world.frictionAt(ground.shape, x), (signs[i - 1].friction + signs[i].friction) / 2, 1e-6);
  }
  scene.world.close();
});

test("prints_are_long_on_ice_and_short_on_rock", async () => {
  const { scene } = await buildScene(engine, "textured");
  const slid = new Map();
  const signs = signsOf(scene);
  const nameAt = (x) =>
    signs.reduce((a, b) => (Math.abs(b.x - x) < Math.abs(a.x - x) ? b : a)).name;
  for (let step = 0; step < 1200; step += 10) {
    runScene(scene, 10, step);
    for (const { from, to } of scene.state.prints) {
      const name = nameAt(from[0]);
      slid.set(name, Math.max(slid.get(name) ?? 0, Math.hypot(to[0] - from[0], to[1] - from[1])));
    }
  }
  assert.ok(slid.get("Ice") > 0.3, `${slid.get("Ice")} m on ice`);
  assert.ok(slid.get("Rock") < 0.6 * slid.get("Ice"), `${slid.get("Rock")} m on rock`);
  scene.world.close();
});

test("feet_are_marked_and_prints_come_again_in_the_past", async () => {
  const session = await openSession(engine, "textured");
  for (let i = 0; i < 90; i++) session.makeStep();
  const { marks, figures } = session.paint;
  assert.deepEqual(
    figures.map(({ label }) => label),
    ["Under a foot", "Weights of the vertices", "Texture", "It slid"],
  );
  const [first, second] = figures[1].value.split(" + ").map(Number);
  near(first + second, 1);
  const names = marks.filter(({ kind, size }) => kind === "text" && size === 12);
  assert.ok(names.length > 0 && names.every(({ text }) => TEXTURE.some(({ name }) => name === text)));
  const prints = structuredClone(session.scene.state.prints);
  assert.ok(prints.length > 2);
  session.seek(30);
  assert.ok(session.scene.state.prints.length < prints.length);
  session.seek(90);
  assert.deepEqual(session.scene.state.prints, prints);
  session.close();
});
