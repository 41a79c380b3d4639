/**
 * Tests the page in a browser, by mouse, touch and keyboard: running, dragging, camera, tools,
 * scenes, settings, overlays, layout on a phone, and accessibility by axe.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  DESKTOP,
  drawn,
  near,
  openLevel,
  openVisitor,
  PHONE,
  pressed,
  runAxeInBothThemes,
  stepBy,
  untilBodies,
  untilRunning,
} from "../support/page.mjs";
import { ballLevel } from "../support/package.mjs";
import { until, untilOverlay } from "../support/wait.mjs";

const visitor = openVisitor();

/** Waits until the ball is drawn within `tolerance` pixels of `x`; returns its place. */
function drawnNear(page, x, tolerance, what) {
  return until(() => drawn(page), (ball) => Math.abs(ball.x - x) <= tolerance, `${what}, not ${x}`);
}

/** Opens the page with the level of one ball, paused after its first step. */
async function openBall(options = DESKTOP) {
  const opened = await visitor.open("?scene=cradle&paused=1", options);
  await openLevel(opened.page, "ball.tmj", ballLevel());
  await opened.page.waitForFunction(() => document.title.startsWith("ball"));
  await stepBy(opened.page, 1);
  return opened;
}

test("page_loads_without_errors_and_bodies_move", async () => {
  const { page, errors, close } = await openBall();
  const start = await drawn(page);
  await page.click("#pause");
  await page.waitForFunction(() => Number(document.querySelector("#hud").dataset.steps) > 30);
  const later = await drawn(page);
  assert.ok(later.y > start.y + 10, `from ${start.y} to ${later.y}`);
  near(later.x, start.x, 2, "x");
  assert.deepEqual(errors, []);
  await close();
});

test("dragging_with_the_mouse_moves_a_body", async () => {
  const { page, errors, close } = await openBall();
  const start = await drawn(page);
  await page.mouse.move(start.x, start.y);
  await page.mouse.down();
  await page.waitForSelector("#overlay[data-mode=pull]");
  await page.mouse.move(start.x + 200, start.y - 60, { steps: 4 });
  await stepBy(page, 90);
  const held = await drawn(page);
  near(held.x, start.x + 200, 12, "x while held");
  near(held.y, start.y - 60, 12, "y while held");
  await page.mouse.up();
  await stepBy(page, 60);
  assert.ok((await drawn(page)).y > held.y + 40, "it falls when let go");
  assert.deepEqual(errors, []);
  await close();
});

test("dragging_with_a_finger_moves_a_body_on_a_phone", async () => {
  const { page, errors, close } = await openBall(PHONE);
  const start = await drawn(page);
  const touch = await page.context().newCDPSession(page);
  const send = (type, x, y) =>
    touch.send("Input.dispatchTouchEvent", {
      type,
      touchPoints: type === "touchEnd" ? [] : [{ x, y }],
    });
  await send("touchStart", start.x, start.y);
  await page.waitForSelector("#overlay[data-mode=pull]");
  // The browser acknowledges a touch move before it dispatches the event, which it does with the
  // next frame.
  await page.evaluate(() =>
    addEventListener("pointermove", () => (window.moved = true), { once: true }),
  );
  await send("touchMove", start.x + 60, start.y - 40);
  await page.waitForFunction(() => window.moved);
  await stepBy(page, 90);
  near((await drawn(page)).x, start.x + 60, 10, "x");
  await send("touchEnd");
  assert.deepEqual(errors, []);
  await close();
});

test("dragging_the_background_and_the_wheel_move_and_zoom_the_view", async () => {
  const { page, close } = await openBall();
  const start = await drawn(page);
  await page.mouse.move(300, 300);
  await page.mouse.down();
  await page.mouse.move(350, 330);
  await page.mouse.up();
  const moved = await drawnNear(page, start.x + 50, 2, "x");
  near(moved.y, start.y + 30, 2, "y");
  await page.mouse.wheel(0, -300);
  await until(() => drawn(page), ({ count }) => count > 1.5 * moved.count, "no larger");
  await close();
});

test("keys_pause_step_reset_move_and_zoom", async () => {
  const { page, errors, close } = await openBall();
  await page.focus("#overlay");
  const untilSteps = (wanted) =>
    page.waitForFunction((n) => document.querySelector("#hud").dataset.steps === String(n), wanted);
  await page.keyboard.press(".");
  await untilSteps(2);
  await page.keyboard.press("Space");
  assert.equal(await pressed(page, "pause"), false);
  await page.waitForFunction(() => Number(document.querySelector("#hud").dataset.steps) > 10);
  await page.keyboard.press("Space");
  assert.equal(await pressed(page, "pause"), true);
  await page.keyboard.press("r");
  await untilSteps(0);
  const start = await drawn(page);
  await page.keyboard.press("ArrowLeft");
  const moved = await drawnNear(page, start.x + 60, 2, "x after the arrow key");
  near(moved.y, start.y, 1, "it stands still");
  await page.keyboard.press("+");
  await until(() => drawn(page), ({ count }) => count > 1.3 * start.count, "no larger");
  await page.keyboard.press("0");
  await drawnNear(page, start.x, 1, "x after 0");
  await untilSteps(0);
  assert.deepEqual(errors, []);
  await close();
});

test("space_after_a_press_on_a_panel_s_button_pauses_and_leaves_the_panel_as_it_is", async () => {
  const { page, errors, close } = await openBall();
  const spacePauses = async (paused) => {
    await page.keyboard.press("Space");
    assert.equal(await pressed(page, "pause"), paused);
  };
  await page.click('[data-panel="versus"]');
  await page.waitForSelector("#versus");
  await spacePauses(false);
  await spacePauses(true);
  assert.equal(await page.isVisible("#dock"), true);
  await page.click("#dock .close");
  await spacePauses(false);
  assert.equal(await page.isVisible("#dock"), false);
  await page.click('[data-tool="circle"]');
  await spacePauses(true);
  await page.click("#time");
  await spacePauses(false);
  assert.deepEqual(errors, []);
  await close();
});

test("keys_open_help_and_lists_and_escape_closes_them", async () => {
  const { page, close } = await openBall();
  for (const [key, open] of [["h", "dialog#help[open]"], ["l", "dialog#scenes[open]"], ["o", "#dock"]]) {
    await page.keyboard.press(key);
    await page.waitForSelector(open);
    await page.keyboard.press("Escape");
    await page.waitForSelector(open, { state: "hidden" });
  }
  assert.ok((await page.locator("#keys kbd").count()) > 20);
  await close();
});

test("circle_and_box_tools_add_bodies_where_the_visitor_clicks", async () => {
  const { page, errors, close } = await openBall();
  // The ground and the ball.
  await untilBodies(page, 2);
  await page.keyboard.press("c");
  await page.mouse.click(400, 300);
  await untilBodies(page, 3);
  await page.keyboard.press("b");
  await page.mouse.click(900, 300);
  await untilBodies(page, 4);
  assert.deepEqual(errors, []);
  await close();
});

test("choosing_a_scene_from_the_list_runs_it_and_writes_the_url", async () => {
  const { page, errors, close } = await visitor.open("?scene=cradle");
  await untilRunning(page);
  await page.evaluate(() => {
    const { dataset } = document.querySelector("#hud");
    const note = () => (window.stepsAtFirst = dataset.steps ?? "no picture");
    new MutationObserver(note).observe(document.querySelector("title"), { childList: true });
  });
  await page.click("#scenes-button");
  await page.click('[data-entry="tall_stack"]');
  await page.waitForFunction(() => location.search.includes("scene=tall_stack"));
  assert.equal(await page.evaluate(() => window.stepsAtFirst), "no picture");
  await untilBodies(page, 31);
  assert.match(await page.title(), /Tall stack/);
  await page.reload();
  await page.waitForFunction(() => document.title.startsWith("Tall stack"));
  assert.deepEqual(errors, []);
  await close();
});

test("speed_and_quality_are_kept_in_the_url", async () => {
  const { page, close } = await visitor.open("?scene=cradle");
  await untilRunning(page);
  await page.keyboard.press("o");
  await page.click('label:has([name=speed][value="0.25"])');
  await page.keyboard.press("/");
  await page.waitForFunction(() => location.search.includes("quality"));
  const search = new URLSearchParams(await page.evaluate(() => location.search));
  assert.deepEqual([search.get("speed"), search.get("quality")], ["0.25", "high"]);
  await page.reload();
  await untilRunning(page);
  await page.waitForSelector("[name=speed]", { state: "attached" });
  assert.ok(await page.isChecked('[name=speed][value="0.25"]'));
  await close();
});

test("overlays_of_contacts_bounds_cells_and_islands_draw_and_go", async () => {
  const { page, errors, close } = await visitor.open("?scene=tall_stack&paused=1");
  await stepBy(page, 5);
  for (const [key, name] of [["1", "contacts"], ["2", "normals"], ["3", "bounds"], ["4", "cells"], ["5", "islands"]]) {
    await page.keyboard.press(key);
    await untilOverlay(page, (count) => count > 20, `${name} draws nothing`);
    await page.keyboard.press(key);
    await untilOverlay(page, (count) => count === 0, `${name} stays`);
  }
  assert.deepEqual(errors, []);
  await close();
});

test("overlays_that_are_chosen_are_kept_in_the_url_and_those_of_a_scene_are_not", async () => {
  const search = "?scene=minkowski&paused=1&show=bounds,nonsense";
  const { page, errors, close } = await visitor.open(search);
  await stepBy(page, 1);
  await untilOverlay(page, (count) => count > 20, "nothing is shown");
  await page.keyboard.press("4");
  await page.waitForFunction(() => /[?&]show=bounds,cells(&|$)/.test(location.search));
  await page.keyboard.press("3");
  await page.keyboard.press("4");
  await page.keyboard.press("6");
  await page.waitForFunction(() => !location.search.includes("show"));
  assert.deepEqual(errors, []);
  await close();
});

test("reduced_motion_starts_paused_and_can_be_started", async () => {
  const { page, close } = await visitor.open("?scene=cradle", { ...DESKTOP, reducedMotion: "reduce" });
  await page.waitForFunction(() => document.title.startsWith("Rows of elastic"));
  assert.equal(await pressed(page, "pause"), true);
  await page.click("#pause");
  await untilRunning(page);
  await close();
});

test("controls_fit_a_phone_of_360_pixels", async () => {
  const options = { ...PHONE, viewport: { width: 360, height: 640 } };
  const { page, errors, close } = await visitor.open("?scene=cradle", options);
  await untilRunning(page);
  for (const button of await page.locator("#controls button:visible, #scenes-button").all()) {
    const box = await button.boundingBox();
    assert.ok(box.x >= 0 && box.x + box.width <= 360, JSON.stringify(box));
    assert.ok(box.y >= 0 && box.y + box.height <= 640, JSON.stringify(box));
  }
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 360);
  assert.deepEqual(errors, []);
  await close();
});

for (const [size, options] of [["desktop", DESKTOP], ["phone", PHONE]])
  test(`axe_finds_no_serious_violation_on_a_${size}_in_dark_and_light`, async () => {
    const { page, close } = await visitor.open("?scene=cradle&paused=1", options);
    await stepBy(page, 1);
    const violations = await runAxeInBothThemes(page);
    for (const [key, open, filled] of [
      ["h", "#help", "#keys"],
      ["l", "#scenes", "[data-entry]"],
      ["o", "#dock", "#share"],
    ]) {
      await page.keyboard.press(key);
      await page.waitForSelector(`${open} ${filled}`);
      violations.push(...(await runAxeInBothThemes(page, open)));
      await page.keyboard.press("Escape");
      await page.waitForSelector(open, { state: "hidden" });
    }
    assert.deepEqual(violations, []);
    await close();
  });

test("way_back_to_an_address_shows_the_overlays_of_that_address", async () => {
  const { page, errors, close } = await visitor.open("?scene=cradle&paused=1");
  await page.waitForFunction(() => document.title.startsWith("Rows of elastic"));
  await page.click("#scenes-button");
  await page.click('[data-entry="tall_stack"]');
  await page.waitForFunction(() => location.search.includes("scene=tall_stack"));
  await page.keyboard.press("3");
  await page.waitForFunction(() => location.search.includes("show="));
  await page.goBack();
  await page.waitForFunction(() => document.title.startsWith("Rows of elastic"));
  // What is written of the state from now on would name overlays that were left behind.
  await page.keyboard.press("Space");
  await page.waitForFunction(() => !location.search.includes("paused"));
  assert.doesNotMatch(await page.evaluate(() => location.search), /show=/);
  assert.deepEqual(errors, []);
  await close();
});
