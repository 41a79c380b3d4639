/**
 * Tests the code panel: it shows the running scene's code, runs changed code, reports errors at
 * their line, and keeps the text.
 */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import {
  boxes,
  openCode,
  run,
  troubleOf,
  type,
  untilMarked,
  untilStatus,
  untilText,
} from "../support/code.mjs";
import {
  DESKTOP,
  failureText,
  impatiently,
  openVisitor,
  PHONE,
  runAxeInBothThemes,
  untilBodies,
  untilRunning,
  untilTold,
} from "../support/page.mjs";
import { root } from "../support/package.mjs";

const SIZES = { desktop: DESKTOP, phone: PHONE };
const SKETCH = readFileSync(`${root}web/public/scenes/sketch.js`, "utf8");

const visitor = openVisitor();

for (const [name, options] of Object.entries(SIZES)) {
  test(`number_changed_and_run_changes_the_world_on_${name}`, async () => {
    const { page, errors, close } = await openCode(visitor, "?scene=sketch&panel=code", options);
    await untilStatus(page, "Runs unchanged");
    await untilBodies(page, 14);
    await page.locator(".cm-line", { hasText: "export const size" }).click();
    await page.keyboard.press("End");
    await page.keyboard.press("Control+a");
    await page.keyboard.insertText(SKETCH.replace("usual: 12", "usual: 20"));
    await untilStatus(page, "Changed, not run yet");
    await run(page);
    await untilStatus(page, "Your code runs");
    await untilBodies(page, 22);
    assert.deepEqual(errors, []);
    await close();
  });

  test(`syntax_error_is_told_at_its_line_and_the_scene_goes_on_on_${name}`, async () => {
    const { page, errors, close } = await openCode(visitor, "?scene=sketch&panel=code", options);
    await type(page, "const a = 1;\nconst b = = 2;\nexport default function () {}\n");
    await run(page);
    assert.match(await troubleOf(page), /Line 2[\s\S]*Unexpected token/);
    await untilMarked(page, 2);
    await untilStatus(page, "Does not run");
    const steps = () => page.evaluate(() => Number(document.querySelector("#hud").dataset.steps));
    const then = await steps();
    await page.waitForFunction(
      (n) => Number(document.querySelector("#hud").dataset.steps) > n,
      then,
    );
    assert.ok(await page.isHidden("#failure"));
    assert.deepEqual(errors, []);
    await close();
  });

  test(`axe_finds_no_serious_violation_in_the_code_panel_on_${name}`, async () => {
    const search = "?scene=artillery&panel=code&paused=1";
    const { page, close } = await openCode(visitor, search, options);
    // So many lines that the editor scrolls: a region that scrolls must be reached by Tab.
    await type(page, `export default 1 +;\n${"// A line.\n".repeat(100)}`);
    await run(page);
    await troubleOf(page);
    await page.click(".code-help summary");
    assert.deepEqual(await runAxeInBothThemes(page, "#dock"), []);
    await close();
  });
}

test("buttons_of_the_code_panel_are_large_enough_on_a_phone", async () => {
  const { page, close } = await openCode(visitor, "?scene=sketch&panel=code&paused=1", PHONE);
  for (const button of await page.locator(".code button:visible, .code summary").all()) {
    const { height } = await button.boundingBox();
    assert.ok(height >= 40, `${await button.innerText()}: ${height}`);
  }
  const dock = await page.locator("#dock").boundingBox();
  assert.ok(dock.height <= 0.46 * 844 + 1, "the scene stays visible");
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  await close();
});

test("error_while_building_is_told_at_its_line", async () => {
  const { page, close } = await openCode(visitor, "?scene=sketch&panel=code");
  await type(page, boxes(3).replace("  return {", "  world.nothing.here();\n  return {"));
  await run(page);
  assert.match(await troubleOf(page), /Line 7[\s\S]*undefined/);
  await untilMarked(page, 7);
  await untilBodies(page, 14);
  await close();
});

test("error_in_update_is_told_at_its_line_and_the_next_run_goes_on", async () => {
  const { page, close } = await openCode(visitor, "?scene=sketch&panel=code");
  await type(page, boxes(3, { update: "world.nothing.here();" }));
  await run(page);
  assert.match(await troubleOf(page), /Line 11[\s\S]*undefined/);
  await untilMarked(page, 11);
  await type(page, boxes(4));
  await run(page);
  await untilBodies(page, 4);
  await untilRunning(page);
  assert.ok(await page.isHidden(".code-trouble"));
  await close();
});

test("error_in_update_is_told_when_the_panel_was_closed", async () => {
  const { page, close } = await openCode(visitor, "?scene=sketch&panel=code");
  // A paused scene makes no step before the panel is closed.
  await page.click("#pause");
  await type(page, boxes(3, { update: "throw new Error('late');" }));
  await run(page);
  await untilStatus(page, "Your code runs");
  await page.click("#dock .close");
  await page.keyboard.press(".");
  assert.match(await troubleOf(page), /Line 11[\s\S]*late/);
  await close();
});

test("import_that_is_not_there_is_told_at_its_line", async () => {
  const { page, close } = await openCode(visitor, "?scene=sketch&panel=code");
  const told = async (line) => {
    await type(page, `// an import\n${line}\n${boxes(1)}`);
    await run(page);
    await page.waitForFunction(() => document.querySelector(".code-trouble p"));
    return troubleOf(page);
  };
  assert.match(await told('import { x } from "./sketch.js";'), /Line 2[\s\S]*'x'/);
  assert.match(await told('import { y } from "thud";'), /Line 2[\s\S]*“thud” exports no “y”/);
  assert.match(await told('import "three";'), /Line 2[\s\S]*“three” is no file of this page/);
  await close();
});

test("loop_without_an_end_leads_back_and_keeps_the_text", async () => {
  const { page, close } = await openCode(visitor, "?scene=sketch&panel=code");
  const text = boxes(3, { update: "for (;;);" });
  await type(page, text);
  await impatiently(page, async () => {
    await run(page);
    assert.match(await failureText(page), /does not answer/);
  });
  // The endless loop sent no frame, so the figures are still those of the scene before; mark them.
  await page.evaluate(() => (document.querySelector("#hud").dataset.steps = "none"));
  await page.click("#failure button");
  await untilRunning(page);
  await untilBodies(page, 14);
  assert.match(await troubleOf(page), /did not answer/);
  await untilText(page, text);
  await type(page, boxes(5));
  await run(page);
  await untilBodies(page, 5);
  await close();
});

test("loop_that_nobody_ends_is_ended_before_it_has_taken_the_tab", async () => {
  const { page, close } = await openCode(visitor, "?scene=sketch&panel=code");
  const text = boxes(3, { update: "const a = []; for (;;) a.push({ a });" });
  await type(page, text);
  await impatiently(page, async () => {
    await run(page);
    assert.match(await failureText(page), /In ten seconds more it is ended/);
  });
  await page.waitForSelector("#failure", { state: "hidden" });
  await untilBodies(page, 14);
  await untilText(page, text);
  await close();
});

test("scene_that_makes_bodies_without_end_is_ended_and_the_page_goes_on", async () => {
  const { page, close } = await openCode(visitor, "?scene=sketch&panel=code");
  const update = "for (let i = 0; i < 50_000; i++) world.createBody({});";
  const text = boxes(3, { update });
  await type(page, text);
  await run(page);
  assert.match(await failureText(page), /too much memory[\s\S]*more than 1 GB/);
  await page.click("#failure button");
  await untilBodies(page, 14);
  await untilRunning(page);
  await untilText(page, text);
  await close();
});

test("changed_code_is_named_as_such_and_tells_its_own_keys", async () => {
  const { page, close } = await openCode(visitor, "?scene=sketch&panel=code");
  const keys = "keys: { left: 'sing', right: 'dance' },";
  const text = boxes(3).replace("    world,", `    world,\n    ${keys}`);
  await type(page, `export const title = "Mine";\n${text}`);
  await run(page);
  await page.waitForFunction(() => document.title === "Mine, edited · thud");
  assert.equal(await page.textContent("#scene-title"), "Mine, edited");
  await page.locator("#notice", { hasText: /to sing.*to dance/ }).waitFor({ state: "attached" });
  await close();
});

test("text_is_kept_when_another_scene_was_opened_and_the_page_loaded_again", async () => {
  const { page, close } = await openCode(visitor, "?scene=sketch&panel=code");
  const text = boxes(6);
  await type(page, text);
  await page.click("#scenes-button");
  await page.click('[data-entry="cradle"]');
  await page.waitForSelector('[role="tab"]:text-is("cradle.js")');
  await page.reload();
  await page.waitForSelector(".code-editor .cm-line:not(:empty)");
  await page.click("#scenes-button");
  await page.click('[data-entry="sketch"]');
  await page.waitForSelector('[role="tab"]:text-is("sketch.js")');
  await untilText(page, text);
  await close();
});

test("original_comes_back_and_undoing_brings_the_text_again", async () => {
  const { page, close } = await openCode(visitor, "?scene=sketch&panel=code");
  await type(page, boxes(4));
  await run(page);
  await untilBodies(page, 4);
  await page.click(".code-bar button:nth-child(2)");
  await untilBodies(page, 14);
  await untilStatus(page, "Runs unchanged");
  await page.locator(".code-editor .cm-content").focus();
  await page.keyboard.press("Control+z");
  await untilStatus(page, "Changed, not run yet");
  await untilText(page, boxes(4));
  await close();
});

test("camera_and_choices_stay_when_code_runs", async () => {
  const { page, close } = await openCode(
    visitor,
    "?scene=sketch&size=5&quality=high&view=1,2,50&panel=code",
  );
  await untilBodies(page, 7);
  await type(page, SKETCH.replace("2 + i", "3 + i"));
  await run(page);
  await untilStatus(page, "Your code runs");
  await page.waitForFunction(() => location.hash.startsWith("#code="));
  const params = new URLSearchParams(await page.evaluate(() => location.search));
  assert.deepEqual([params.get("size"), params.get("quality")], ["5", "high"]);
  assert.deepEqual(params.get("view").split(",").map(Number), [1, 2, 50]);
  await close();
});

test("imported_files_are_shown_read_only_in_tabs", async () => {
  const { page, close } = await openCode(visitor, "?scene=artillery&panel=code&paused=1");
  await page.click('[role="tab"]:has-text("tanks.js")');
  await untilStatus(page, "Read only");
  // The editor renders only part of a long file and may render another part later; the test types
  // at the start.
  const firstLine = () => page.locator(".code-editor .cm-line").first().textContent();
  const before = await firstLine();
  await page.locator(".code-editor .cm-content").focus();
  await page.keyboard.press("Control+Home");
  await page.keyboard.type("x");
  assert.equal(await firstLine(), before);
  await page.focus('[role="tab"][aria-selected="true"]');
  await page.keyboard.press("Home");
  assert.equal(await page.innerText('[role="tab"][aria-selected="true"]'), "artillery.js");
  await close();
});

test("keyboard_alone_opens_types_runs_and_leaves", async () => {
  const { page, errors, close } = await visitor.open("?scene=sketch");
  await untilRunning(page);
  await page.keyboard.press("k");
  await page.waitForSelector(".code-editor .cm-line:not(:empty)");
  const inEditor = () =>
    page.evaluate(() => document.activeElement?.classList.contains("code-editor") ?? false);
  for (let i = 0; i < 12 && !(await inEditor()); i++) await page.keyboard.press("Tab");
  assert.ok(await inEditor(), "Tab reaches the editor");
  await page.keyboard.press("Control+Home");
  // In the editor letters are not shortcuts, and Tab indents.
  await page.keyboard.type("// pause, reset: p r l");
  // Wait long enough for a completion to be offered, which Enter would accept; comments offer none.
  await page.waitForTimeout(400);
  await page.keyboard.press("Enter");
  await page.keyboard.press("Tab");
  assert.ok(await inEditor());
  await untilText(page, /^\/\/ pause, reset: p r l\n/);
  assert.equal(await page.getAttribute("#pause", "aria-pressed"), "false");
  await page.keyboard.press("Control+Enter");
  await untilStatus(page, "Your code runs");
  await page.keyboard.press("Escape");
  await untilTold(page, "Tab leaves");
  await page.keyboard.press("Tab");
  assert.ok(!(await inEditor()), "Escape, then Tab, leaves the editor");
  await page.keyboard.press("Shift+Tab");
  assert.ok(await inEditor());
  await page.keyboard.press("Escape");
  await page.keyboard.press("Escape");
  await page.waitForSelector("#dock", { state: "hidden" });
  assert.deepEqual(errors, []);
  await close();
});
