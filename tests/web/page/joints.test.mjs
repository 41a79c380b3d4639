/**
 * Tests joints on the page: they are drawn with their forces, and scenes without joints do not load
 * the code for it.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { choose, openVisitor, PHONE, stepBy } from "../support/page.mjs";
import { table, untilBox2D, untilMeasured } from "../support/versus.mjs";
import { overlay, until, untilOverlay } from "../support/wait.mjs";

const visitor = openVisitor();

const DRAWING = /\/joint(s|-frames)-[\w-]+\.js$/;

test("scene_without_joints_brings_nothing_of_them", async () => {
  const urls = [];
  const prepare = (page) => page.on("request", (request) => urls.push(request.url()));
  const { page, errors, close } = await visitor.open("?scene=tall_stack&paused=1", undefined, prepare);
  await stepBy(page, 5);
  await untilOverlay(page, (count) => count === 0, "nothing over the bodies");
  assert.equal(await page.isVisible("#hud .gap"), false);
  const asked = urls.filter((url) => DRAWING.test(url));
  assert.deepEqual(asked, []);
  assert.deepEqual(errors, []);
  await close();
});

test("joints_are_drawn_on_a_phone_and_their_widest_gap_told_until_another_scene_runs", async () => {
  const { page, errors, close } = await visitor.open("?scene=crane&paused=1", PHONE);
  await stepBy(page, 5);
  await untilOverlay(page, (count) => count > 100, "ropes");
  await page.waitForSelector("#hud .gap:not([hidden]) dd:not(:text-is('–'))");
  await page.click("#scenes-button");
  await page.click('[data-entry="tall_stack"]');
  await page.waitForFunction(() => /^Tall/.test(document.title));
  await stepBy(page, 2);
  await untilOverlay(page, (count) => count === 0, "no joints of the scene before");
  assert.equal(await page.isVisible("#hud .gap"), false);
  assert.deepEqual(errors, []);
  await close();
});

test("overlay_of_joints_adds_forces_and_the_panel_tells_gaps", async () => {
  const { page, errors, close } = await visitor.open("?scene=bridge&paused=1&panel=inside");
  await page.waitForSelector("[name=inside]", { state: "attached" });
  await stepBy(page, 20);
  const { count: plain } = await untilOverlay(page, (count) => count > 20, "pins");
  await page.keyboard.press(";");
  assert.ok(await page.isChecked("[name=overlay-joints]"));
  await untilOverlay(page, (count) => count > plain + 300, "forces");
  await page.uncheck("[name=overlay-joints]");
  await untilOverlay(page, (count) => count === plain, "as before");
  await choose(page, "inside", "step");
  const facts = () =>
    page.$$eval("#step-numbers > div", (rows) =>
      Object.fromEntries(rows.map((row) => [...row.children].map((cell) => cell.textContent))),
    );
  const told = await until(facts, (one) => one.joints !== undefined, "joints are counted");
  assert.equal(told.joints, "34");
  assert.ok(Number(told["gap of joints, mean"]) <= Number(told["widest gap of a joint"]));
  assert.match(told["joint turned the furthest"], /°$/);
  assert.deepEqual(errors, []);
  await close();
});

test("versus_shows_the_gaps_of_both_and_the_joints_of_both", async () => {
  const { page, errors, close } = await visitor.open("?scene=chain&panel=versus&paused=1");
  await untilBox2D(page);
  // The first thirty steps of both engines are not measured.
  await stepBy(page, 45);
  await untilMeasured(page);
  const rows = await until(
    () => table(page),
    (one) => Number(one["Joint gap, worst"][1]) > 0,
    "gaps are measured",
  );
  const [ours, theirs] = rows["Joint gap, worst"].map(Number);
  assert.ok(ours < theirs, `thud ${ours}, Box2D ${theirs}`);
  assert.ok(await page.isVisible('#versus-table th:text-is("Joint gap now")'));
  await untilOverlay(page, (count) => count > 20, "joints of both");
  assert.deepEqual(errors, []);
  await close();
});
