/** Tests the advice of the panel Trade: what a scene used, counted in Node, and what is advised. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { importTypeScript, openSession } from "../../../web/tools/scenes.mjs";
import { thud } from "../support/package.mjs";

globalThis.self = globalThis;
globalThis.crossOriginIsolated = true;

const { countUses } = await importTypeScript("src/worker/measure-uses.ts");
const { cheapest, cheapestText, roomOf, roomText, usesTexts } = await importTypeScript(
  "src/panels/trade/advice.ts",
);
const engine = await thud.load();

/** What a scene uses in so many seconds at some choices of the visitor. */
async function usesOf(name, seconds, given = {}) {
  const open = () => openSession(engine, name, given);
  return countUses({ engine, box2d: null, open }, {}, seconds, 60_000);
}

test("a_pit_of_circles_has_no_oriented_box_no_joint_and_no_bounce", async () => {
  const uses = await usesOf("circle_pit", 3, { size: 40 });
  assert.deepEqual(uses.shapes, [40, 3, 0, 0]);
  assert.deepEqual([uses.bodies, uses.joints, uses.turnedBoxes, uses.bounced], [40, 0, 0, 0]);
  assert.ok(uses.turned > 0);
  assert.equal(uses.steps, 180);
});

test("a_column_of_boxes_stands_and_falls_asleep", async () => {
  const uses = await usesOf("tall_stack", 2, { size: 12 });
  assert.deepEqual([uses.bodies, uses.turned, uses.bounced, uses.held], [12, 0, 0, 0]);
  assert.equal(uses.slept, 12);
  assert.deepEqual(uses.shapes.slice(0, 3), [0, 1, 12]);
});

test("a_gas_without_friction_only_bounces", async () => {
  const uses = await usesOf("gas", 3, { size: 100 });
  assert.deepEqual([uses.bounced, uses.turned, uses.slept], [100, 0, 0]);
});

test("bullets_are_held_back_and_are_faster_than_walls_are_thick", async () => {
  const uses = await usesOf("bullets", 0.5, { size: 5 });
  assert.ok(uses.held > 0, `${uses.held}`);
  assert.ok(uses.speed > 1, `${uses.speed}`);
  assert.match(usesTexts(uses).at(-1), /without detection it may pass through/);
});

test("joints_are_counted", async () => {
  assert.equal((await usesOf("chain", 0.1)).joints, 101);
});

const row = (quality, typical, worst, steps = 120, substeps = 0) => ({
  setting: { engine: "thud", quality, substeps },
  typical,
  p99: typical,
  worst,
  mean: worst,
  own: worst,
  steps,
});
const BOX2D = { ...row("", 0.001, 0), setting: { engine: "box2d", substeps: 4 } };
const SERIES = {
  timeStep: 1 / 60,
  bodies: 9,
  steps: 120,
  rows: [
    row("draft", 1, 0.04),
    row("default", 2, 0.004),
    row("high", 3, 0.0005),
    row("exact", 40, 0),
    row("draft", 1.5, 0.003, 90, 8),
    BOX2D,
  ],
  uses: null,
  misses: [],
  withoutBox2D: "",
};

test("the_cheapest_row_of_thud_that_keeps_to_the_error_in_all_steps_is_advised", () => {
  const advised = (maxError, budget = 100) => cheapest(SERIES, maxError, budget).best?.setting.quality;
  assert.equal(advised(0.05), "draft");
  // Soft 8 would be cheaper, but did not make all of its steps.
  assert.equal(advised(0.005), "default");
  assert.equal(advised(0.004), "default");
  assert.equal(advised(0.001), "high");
  assert.equal(advised(0), "exact");
});

test("what_no_row_keeps_to_is_said_with_the_nearest_within_the_budget", () => {
  const none = cheapest(SERIES, 0.0001, 10);
  assert.equal(none.best, null);
  assert.equal(none.nearest.setting.quality, "high");
  assert.equal(
    cheapestText(none, 0.0001, 10),
    "No setting keeps to 0.0001 length scales within 10.0 ms a step; high comes nearest: " +
      "3.00 ms a step, overlap 0.0005.",
  );
  assert.equal(cheapest(SERIES, 1, 0.5).nearest.setting.quality, "exact");
  assert.match(cheapestText(cheapest(SERIES, 0.005, 10), 0.005, 10), /^default is the cheapest .*: 2\.00 ms/);
});

test("room_is_told_from_the_largest_share_on", () => {
  const rooms = roomOf(row("default", 2, 0.004), { speed: 0.3 }, 0.005, 10);
  assert.deepEqual(rooms.map(({ what }) => what), ["error", "speed", "time"]);
  assert.ok(Math.abs(rooms[0].share - 0.8) < 1e-12 && Math.abs(rooms[2].share - 0.2) < 1e-12);
  assert.equal(
    roomText(rooms),
    "As it grows, overlap has the least room: it uses 80 % of it; speed 30 %, time 20 %.",
  );
  const over = roomOf(row("default", 2, 0.01), null, 0.005, 10);
  assert.equal(roomText(over), "Beyond its room already: overlap, 200 %; time 20 %.");
});
