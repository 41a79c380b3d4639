/** What tests of the laboratory's scenes share: their readings, and a scene with a state of its own. */
import assert from "node:assert/strict";
import { buildScene } from "../../../web/tools/scenes.mjs";

/** The text of a row below a control. */
export const rowOf = (paint, control, name) =>
  paint.readings[control].find(([label]) => label === name)?.[1];
export const numberOf = (...asked) => Number.parseFloat(rowOf(...asked));
export const near = (actual, expected, tolerance, what) =>
  assert.ok(Math.abs(actual - expected) <= tolerance, `${what}: ${actual}, not ${expected}`);

/** Builds a scene whose controls have these values, until the test `t` ends. */
export async function openLab(engine, t, name, state = {}) {
  const built = await buildScene(engine, name);
  t.after(built.close);
  Object.assign(built.scene.state, state);
  return built.scene;
}
