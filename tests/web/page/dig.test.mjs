/** Tests digging on the page, with the mouse and with a finger. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { DESKTOP, openVisitor, PHONE, pressed, stepBy, untilRunning } from "../support/page.mjs";
import { until } from "../support/wait.mjs";

const visitor = openVisitor();

/** The top of the ground's line at x in CSS pixels, found as the darkest pixel of the column. */
function groundTop(page, x) {
  return page.evaluate((column) => {
    const canvas = document.getElementById("backdrop");
    const ratio = canvas.width / innerWidth;
    const copy = Object.assign(document.createElement("canvas"), { width: 1, height: canvas.height });
    const context = copy.getContext("2d", { willReadFrequently: true });
    context.drawImage(canvas, -Math.round(column * ratio), 0);
    const { data } = context.getImageData(0, 0, 1, canvas.height);
    const light = Array.from({ length: canvas.height }, (_, y) =>
      data[4 * y] + data[4 * y + 1] + data[4 * y + 2]);
    const darkest = Math.min(...light);
    return light.findIndex((value) => value < darkest + 40) / ratio;
  }, x);
}

/** Waits until the ground's line at x is at least this much lower than before. */
function untilDug(page, x, before, least) {
  return until(() => groundTop(page, x), (now) => now > before + least, `at ${x} as at ${before}`);
}

async function openDigging(options) {
  const light = { ...options, colorScheme: "light" };
  const opened = await visitor.open("?scene=digging&paused=1", light);
  await stepBy(opened.page, 1);
  return opened;
}

test("dig_tool_lowers_the_ground_where_the_mouse_clicks_and_nowhere_else", async () => {
  const { page, errors, close } = await openDigging(DESKTOP);
  const x = 700;
  const [here, beside] = [await groundTop(page, x), await groundTop(page, x + 300)];
  assert.ok(here > 100 && here < 800, `the ground is at ${here}`);
  await page.keyboard.press("g");
  await page.mouse.click(x, here);
  await untilDug(page, x, here, 20);
  assert.equal(await groundTop(page, x + 300), beside);
  assert.deepEqual(errors, []);
  await close();
});

test("dig_tool_follows_a_dragged_mouse_and_reset_brings_the_ground_back", async () => {
  const { page, errors, close } = await openDigging(DESKTOP);
  const [left, right] = [600, 800];
  const tops = [await groundTop(page, left), await groundTop(page, right)];
  await page.click('[data-tool="dig"]');
  await page.mouse.move(left, tops[0]);
  await page.mouse.down();
  await page.mouse.move(right, tops[1], { steps: 20 });
  await page.mouse.up();
  await untilDug(page, left, tops[0], 15);
  await untilDug(page, (left + right) / 2, Math.min(...tops), 15);
  await untilDug(page, right, tops[1], 15);
  await page.keyboard.press("r");
  await until(() => groundTop(page, left), (top) => top === tops[0], `not back at ${tops[0]}`);
  assert.deepEqual(errors, []);
  await close();
});

test("dig_tool_works_by_finger_on_a_phone", async () => {
  const { page, errors, close } = await openDigging(PHONE);
  const here = await groundTop(page, 200);
  await page.tap('[data-tool="dig"]');
  await page.touchscreen.tap(200, here);
  await untilDug(page, 200, here, 8);
  assert.deepEqual(errors, []);
  await close();
});

test("dig_tool_in_a_scene_without_ground_says_so", async () => {
  const { page, errors, close } = await visitor.open("?scene=tall_stack", DESKTOP);
  await untilRunning(page);
  await page.keyboard.press("g");
  await page.mouse.click(700, 400);
  await page.waitForFunction(() => /no ground to dig/.test(document.querySelector("#notice").textContent));
  assert.equal(await pressed(page, "pause"), false);
  assert.deepEqual(errors, []);
  await close();
});
