/**
 * Tests the benchmark of thud and Box2D as WebAssembly: both have the same bodies, and every figure
 * is finite.
 */
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { root } from "../support/package.mjs";

const bench = `${root}web/tools/bench-wasm.mjs`;

test("quick_race_in_node_has_the_same_bodies_on_both_sides_and_finite_times", () => {
  const file = join(tmpdir(), `thud-bench-${process.pid}.json`);
  const output = execFileSync(process.execPath, [bench, "--node", "--quick", "--json", file], {
    encoding: "utf8",
  });
  const results = JSON.parse(readFileSync(file, "utf8"));
  rmSync(file);
  assert.ok(results.length >= 10);
  for (const r of results) {
    assert.equal(r.bodies, r.box2d_bodies, r.scene);
    assert.match(output, new RegExp(`node +${r.scene} `));
    for (const engine of [r.thud, r.box2d]) {
      const { median, p99, max } = engine;
      assert.ok(median > 0 && median <= p99 && p99 <= max, r.scene);
      assert.ok(Number.isFinite(engine.max), r.scene);
    }
  }
});

test("options_that_make_no_sense_are_refused_with_the_usage", () => {
  for (const words of [["--faster"], ["--scene", "no_such"], ["--scene", "gas:0"], ["--json"]]) {
    const done = spawnSync(process.execPath, [bench, ...words], { encoding: "utf8" });
    assert.equal(done.status, 2, words.join(" "));
    assert.match(done.stderr, /usage: node bench-wasm/);
  }
});
