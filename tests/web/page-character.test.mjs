/** The page's character: walks and jumps by keys and by touch, and the view follows it. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { DESKTOP, drawn, near, openVisitor, PHONE, pressed, stepBy } from "./page-support.mjs";

let visitor;
before(async () => {
  visitor = await openVisitor();
});
after(() => visitor.close());

/** The level, paused, with the character on its feet; it is all that the overlay shows. */
async function openPlatform(options = DESKTOP) {
  const opened = await visitor.open("?level=platform&paused=1", options);
  await opened.page.waitForFunction(() => document.title.startsWith("Platforms"));
  await stepBy(opened.page, 60);
  return { ...opened, start: await settled(opened.page) };
}

/** Where the character is drawn, once frames have caught up with the steps. */
async function settled(page) {
  await page.waitForTimeout(300);
  return drawn(page, "overlay");
}

test("arrow_walks_space_jumps_and_neither_moves_the_view_nor_pauses", async () => {
  const { page, errors, close, start } = await openPlatform();
  const bodies = await drawn(page);
  await page.keyboard.down("ArrowRight");
  await stepBy(page, 20);
  const walked = await settled(page);
  assert.ok(walked.x > start.x + 40, `x from ${start.x} to ${walked.x}`);
  near(walked.y, start.y, 2, "height while walking");
  await page.keyboard.up("ArrowRight");
  await page.keyboard.down("Space");
  await stepBy(page, 15);
  const jumped = await settled(page);
  assert.ok(jumped.y < walked.y - 60, `y from ${walked.y} to ${jumped.y}`);
  await page.keyboard.up("Space");
  await stepBy(page, 60);
  near((await settled(page)).y, start.y, 2, "height after landing");
  assert.equal(await pressed(page, "pause"), true);
  near((await drawn(page)).count, bodies.count, 0.1 * bodies.count, "what is in sight");
  assert.deepEqual(errors, []);
  await close();
});

test("space_jumps_also_after_a_click_on_a_button", async () => {
  const { page, errors, close, start } = await openPlatform();
  await page.click("#reset");
  await page.waitForFunction(() => document.querySelector("#hud").dataset.steps === "0");
  await stepBy(page, 60);
  near((await settled(page)).y, start.y, 2, "height after the reset");
  await page.keyboard.down("Space");
  await stepBy(page, 5); // a ball comes down on it later
  await page.keyboard.up("Space");
  assert.ok((await settled(page)).y < start.y - 10, "it jumps");
  assert.ok(await page.evaluate(() => Number(document.querySelector("#hud").dataset.steps)) > 60);
  assert.deepEqual(errors, []);
  await close();
});

test("view_follows_a_character_that_walks", async () => {
  const { page, errors, close, start } = await openPlatform();
  await page.keyboard.press("p");
  assert.equal(await pressed(page, "pause"), false);
  const before = await drawn(page);
  await page.keyboard.down("d");
  await page.waitForTimeout(2500);
  await page.keyboard.up("d");
  await page.waitForTimeout(2500);
  const after = await drawn(page, "overlay");
  near(after.x, start.x, 60, "x on the screen");
  assert.notDeepEqual(await drawn(page), before);
  assert.deepEqual(errors, []);
  await close();
});

test("touch_buttons_steer_on_a_phone_and_are_hidden_without_a_character", async () => {
  const { page, errors, close, start } = await openPlatform(PHONE);
  const touch = await page.context().newCDPSession(page);
  const hold = async (key) => {
    const box = await page.locator(`[data-key=${key}]`).boundingBox();
    assert.ok(box.width >= 44 && box.x >= 0 && box.x + box.width <= 390, JSON.stringify(box));
    const touchPoints = [{ x: box.x + box.width / 2, y: box.y + box.height / 2 }];
    await touch.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints });
  };
  const letGo = () => touch.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  await hold("left");
  await stepBy(page, 20);
  await letGo();
  const walked = await settled(page);
  assert.ok(walked.x < start.x - 30, `x from ${start.x} to ${walked.x}`);
  await hold("jump");
  await stepBy(page, 15);
  await letGo();
  assert.ok((await settled(page)).y < walked.y - 40, "it jumps");
  await page.click("#scenes-button");
  await page.click('[data-entry="scene/cradle"]');
  await page.waitForFunction(() => document.title.startsWith("Newton"));
  assert.equal(await page.locator("#pad").isVisible(), false);
  assert.deepEqual(errors, []);
  await close();
});
