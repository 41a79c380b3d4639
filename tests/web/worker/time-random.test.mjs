/**
 * Tests going back in time in every scene of the page: with random input and random seeks, a step
 * of the past has its first hash again.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { openSession, random, SCENES, THUMBNAILS } from "../../../web/tools/scenes.mjs";
import { thud } from "../support/package.mjs";

const STEPS = 300;
/** The number of steps between two recorded hashes. */
const EVERY = 30;
// The number of random seeks per scene. Chosen.
const SEEKS = 12;
const KEYS = ["left", "right", "up", "down", "fire", "restart"];
/** The largest size of a scene here, so that the test is short. Chosen. */
const MOST = 60;

const engine = await thud.load();

// The slot of a random body; 0 if there is none.
function slotOfBody(world, chance) {
  const { rows, count } = world.shapeTable();
  return count > 0 ? rows[10 * Math.floor(chance(0, count))] : 0;
}

/** A random command of the pointer, a tool or the keys. */
function randomCommand({ world, scene }, chance) {
  const { x = 0, y = 5, height = 20 } = scene.view ?? {};
  const at = { x: x + chance(-0.5, 0.5) * height, y: y + chance(-0.5, 0.5) * height };
  const commands = [
    () => ({ kind: "grab", slot: slotOfBody(world, chance), anchor: [0, 0], ...at }),
    () => ({ kind: "drag", ...at }),
    () => ({ kind: "release" }),
    () => ({ kind: "spawn", shape: chance(0, 1) < 0.5 ? "circle" : "box", size: 0.3, ...at }),
    () => ({ kind: "explode", radius: height / 6, speed: 10, ...at }),
    () => ({ kind: "dig", radius: height / 20, ...at }),
    () => ({ kind: "keys", held: Object.fromEntries(KEYS.map((key) => [key, chance(0, 1) < 0.4])) }),
    () => ({ kind: "choose", quality: chance(0, 1) < 0.5 ? "draft" : "high", substeps: 0, maxError: 0 }),
    () => ({ kind: "pointer", down: chance(0, 1) < 0.5, ...at }),
  ];
  return commands[Math.floor(chance(0, commands.length))]();
}

// {}) => Steps to `end` and records every EVERY-th hash; `commands` is called before each step.
function runTo(session, end, hashes, commands = () => {}) {
  while (session.step < end) {
    if (session.step % EVERY === 0) hashes.set(session.step, session.hash.hash);
    commands();
    session.makeStep();
  }
}

for (const { name } of SCENES)
  test(`scene_${name}_gone_to_random_steps_of_a_wild_past_has_their_hashes`, async () => {
    const size = Math.min(THUMBNAILS[name]?.size ?? MOST, MOST);
    const session = await openSession(engine, name, { size, seed: 3 });
    const chance = random(name.length);
    const hashes = new Map();
    runTo(session, STEPS, hashes, () => {
      while (chance(0, 1) < 0.2) session.do(randomCommand(session, chance));
    });
    for (let i = 0; i < SEEKS; i++) {
      const step = EVERY * Math.floor(chance(0, STEPS / EVERY));
      // A command without a step after it does not become part of the past.
      if (chance(0, 1) < 0.3) session.do(randomCommand(session, chance));
      assert.ok(session.seek(step));
      assert.equal(session.hash.hash, hashes.get(step), `step ${step}`);
    }
    const { hash, again } = session.rerun(STEPS);
    assert.equal(again, hash);
    session.close();
  });

test("quality_chosen_later_holds_when_time_goes_on_from_the_past", async () => {
  const session = await openSession(engine, "towers");
  for (let i = 0; i < 20; i++) session.makeStep();
  session.do({ kind: "choose", quality: "draft", substeps: 0, maxError: 0 });
  session.makeStep();
  session.seek(10);
  session.makeStep();
  const hash = session.hash.hash;
  const other = await openSession(engine, "towers");
  for (let i = 0; i < 10; i++) other.makeStep();
  other.do({ kind: "choose", quality: "draft", substeps: 0, maxError: 0 });
  other.makeStep();
  assert.equal(hash, other.hash.hash);
  session.close();
  other.close();
});

test("body_held_in_the_past_is_let_go_when_time_goes_on_from_there", async () => {
  const session = await openSession(engine, "tall_stack");
  const slot = slotOfBody(session.world, () => session.world.shapeTable().count - 1);
  session.do({ kind: "grab", slot, anchor: [0, 0], x: 5, y: 5 });
  for (let i = 0; i < 20; i++) session.makeStep();
  session.do({ kind: "release" });
  session.makeStep();
  session.seek(10);
  assert.notEqual(session.pull, null);
  session.makeStep();
  assert.equal(session.pull, null);
  session.close();
});

test("keys_held_in_the_past_are_up_when_time_goes_on_from_there", async () => {
  const held = (right) => Object.fromEntries(KEYS.map((key) => [key, right && key === "right"]));
  const session = await openSession(engine, "platformer_game");
  const seen = [];
  const { update } = session.scene;
  session.scene.update = (input) => {
    seen.push(input.held.right);
    update.call(session.scene, input);
  };
  session.do({ kind: "keys", held: held(true) });
  for (let i = 0; i < 20; i++) session.makeStep();
  session.do({ kind: "keys", held: held(false) });
  session.makeStep();
  session.seek(10);
  seen.length = 0;
  session.makeStep();
  assert.deepEqual(seen, [false]);
  session.close();
});
