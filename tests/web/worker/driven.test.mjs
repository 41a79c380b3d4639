/** Tests the scenes with joints that are played with keys: crane, bridge and cars. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { buildScene, runScene } from "../../../web/tools/scenes.mjs";
import { thud } from "../support/package.mjs";

const engine = await thud.load();
const NO_KEYS = { left: false, right: false, up: false, down: false, fire: false, restart: false };

function hold(scene, keys, steps) {
  for (let step = 0; step < steps; step++) {
    scene.update({ step, held: { ...NO_KEYS, ...keys }, pointer: null });
    scene.world.step();
  }
}

/** The dynamic bodies of the world, in the order of creation. */
function moving({ world }) {
  const { count, handles } = world.shapeTable();
  const bodies = new Map();
  for (let i = 0; i < count; i++) {
    const [index1, generation] = handles.slice(4 * i + 2, 4 * i + 4);
    bodies.set(index1, { kind: "body", index: index1 - 1, generation });
  }
  return [...bodies.values()]
    .sort((a, b) => a.index - b.index)
    .map((body) => world.bodyStateOf(body))
    .filter(({ kind }) => kind === "dynamic");
}

test("crane_lays_its_lintel_lets_go_and_takes_hold_again", async () => {
  const { scene } = await buildScene(engine, "crane");
  const hook = () => moving(scene).at(-2).position;
  const lintel = () => moving(scene).at(-1).position;
  runScene(scene, 1200);
  const [, laid] = lintel();
  assert.ok(Math.abs(laid - 5.1) < 0.02, `${laid}`);

  hold(scene, { fire: true }, 5);
  assert.deepEqual(scene.state.straps, []);
  hold(scene, { up: true }, 150);
  assert.ok(hook()[1] > 8.5);
  assert.ok(Math.abs(lintel()[1] - laid) < 0.02);

  hold(scene, { fire: true }, 5); // nothing is within reach
  assert.deepEqual(scene.state.straps, []);
  hold(scene, { down: true }, 130);
  hold(scene, { fire: true }, 5);
  assert.equal(scene.state.straps.length, 1);
  hold(scene, { up: true }, 150);
  assert.ok(lintel()[1] > laid + 1);

  const [x] = hook();
  hold(scene, { left: true }, 120);
  hold(scene, {}, 120);
  assert.ok(hook()[0] < x - 1);
});

test("crane_that_went_back_in_time_does_the_same_again", async () => {
  const { scene } = await buildScene(engine, "crane");
  runScene(scene, 60);
  hold(scene, { fire: true }, 2);
  const kept = { world: scene.world.snapshot(), state: structuredClone(scene.state) };
  const play = () => {
    hold(scene, { up: true, left: true }, 60);
    hold(scene, { fire: true }, 60);
    return scene.world.hash();
  };
  const first = play();
  scene.world.restore(kept.world);
  scene.state = kept.state;
  assert.equal(play(), first);
});

for (const name of ["bridge", "cars"])
  test(`${name}_drives_back_while_left_is_held_and_on_with_right`, async () => {
    const { scene } = await buildScene(engine, name);
    const speeds = () => moving(scene).map(({ velocity }) => velocity[0]);
    runScene(scene, 40);
    assert.ok(Math.max(...speeds()) > 1);
    hold(scene, { left: true }, 240);
    assert.ok(Math.min(...speeds()) < -2);
    hold(scene, { right: true }, 240);
    assert.ok(Math.max(...speeds()) > 2);
  });
