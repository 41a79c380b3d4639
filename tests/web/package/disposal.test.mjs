/**
 * Tests that worlds and movers of the npm package are freed by `close` and `using`, and that a
 * warning is written if they are garbage collected without it.
 */
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { test } from "node:test";
import { root, thud } from "../support/package.mjs";

const engine = await thud.load();

test("disposal_closes_once_what_is_open", () => {
  const world = engine.createWorld();
  const mover = new thud.Mover(world, { shape: { kind: "circle", radius: 1 }, position: [0, 0] });
  for (const made of [mover, world]) {
    made[Symbol.dispose]();
    made[Symbol.dispose]();
    assert.throws(() => made.close(), { code: "stale" });
  }
  const closed = engine.createWorld();
  closed.close();
  closed[Symbol.dispose]();
});

/**
 * The number of warnings of a program that makes worlds, closes some of them, and drops all
 * references.
 */
function warningsOf(made, closed) {
  const program = `
    import { load } from "${root}web/package/dist/node.js";
    const engine = await load();
    (() => {
      for (let i = 0; i < ${made}; i++) {
        const world = engine.createWorld();
        if (i < ${closed}) world.close();
      }
    })();
    for (let i = 0; i < 20; i++) {
      await new Promise((resolve) => setTimeout(resolve, 5));
      gc();
    }`;
  const run = spawnSync(process.execPath, ["--expose-gc", "--input-type=module", "-e", program], {
    encoding: "utf8",
  });
  assert.equal(run.status, 0, run.stderr);
  return run.stderr.split("\n").filter((line) => line.includes("never closed")).length;
}

test("forgotten_worlds_are_told_of_and_closed_ones_are_not", () => {
  assert.equal(warningsOf(5, 5), 0);
  assert.ok(warningsOf(5, 2) >= 1);
});
