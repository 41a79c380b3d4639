/**
 * Tests that the games of examples/games, which the page runs as scenes, can be gone back in: what
 * their robots play comes out alike when steps of the past are run again.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { GAME_FILES } from "../../../web/tools/scene-texts.mjs";
import { importScene, openSession } from "../../../web/tools/scenes.mjs";
import { thud } from "../support/package.mjs";

const engine = await thud.load();
const NO_KEYS = { left: false, right: false, up: false, down: false, fire: false, restart: false };
const STEPS = 400;

for (const name of GAME_FILES.keys())
  test(`${name}_goes_back_and_comes_again_to_the_same_picture_and_bits`, async () => {
    const { robot } = await importScene(name);
    const session = await openSession(engine, name);
    const before = JSON.stringify(session.paint);
    for (let step = 0; step < STEPS; step++) {
      const { held = {}, pointer = null } = robot(session.scene);
      session.do({ kind: "keys", held: { ...NO_KEYS, ...held } });
      if (pointer) session.do({ kind: "pointer", ...pointer });
      session.makeStep();
    }
    const [paint, hash] = [JSON.stringify(session.paint), session.world.hash()];
    assert.notEqual(paint, before);
    for (const step of [0, 170, STEPS]) assert.equal(session.seek(step), true);
    assert.equal(session.world.hash(), hash);
    assert.equal(JSON.stringify(session.paint), paint);
    session.do({ kind: "keys", held: { ...NO_KEYS, restart: true } });
    session.makeStep();
    session.do({ kind: "keys", held: NO_KEYS });
    session.makeStep();
    const { figures } = session.paint;
    assert.deepEqual(figures.map(({ label }) => label), JSON.parse(before).figures.map(({ label }) => label));
    assert.equal(session.scene.state.over, false);
    session.close();
  });
