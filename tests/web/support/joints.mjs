/** Short functions that build worlds for the tests of joints. */
import assert from "node:assert/strict";
import { thud } from "./package.mjs";

const engine = await thud.load();

export function near(value, wanted, tolerance, what = "") {
  assert.ok(Math.abs(value - wanted) <= tolerance, `${what} ${value}, not ${wanted} ± ${tolerance}`);
}

// A world without sleeping, and functions that add static hooks, balls and boxes to it or run it.
export function yard(t, options = {}) {
  const world = engine.createWorld({ sleeping: false, ...options });
  t.after(() => world.close());
  const hook = (position, more = {}) => world.createBody({ position, ...more });
  const ball = (position, radius = 0.1, more = {}) => {
    const body = world.createBody({ kind: "dynamic", position, ...more });
    world.createCircle(body, { radius });
    return body;
  };
  const box = (position, halfWidth, halfHeight, more = {}) => {
    const body = world.createBody({ kind: "dynamic", position, ...more });
    world.createObb(body, { halfWidth, halfHeight });
    return body;
  };
  const run = (steps) => {
    for (let i = 0; i < steps; i++) world.step();
  };
  return { world, hook, ball, box, run };
}
