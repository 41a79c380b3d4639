/**
 * Tests the page's layout on many screen sizes, and the figures and texts that describe the scene.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  DESKTOP,
  drawn,
  figure,
  openVisitor,
  PHONE,
  stepBy,
  untilRunning,
} from "../support/page.mjs";
import { until, untilFigures, untilStill } from "../support/wait.mjs";

const visitor = openVisitor();

const phone = (width, height) => ({ ...PHONE, viewport: { width, height } });
const SIZES = [
  ["desktop", DESKTOP],
  ["laptop", { viewport: { width: 1024, height: 768 } }],
  ["phone", PHONE],
  ["small_phone", phone(360, 640)],
  ["lying_phone", phone(844, 390)],
];
/** The elements that a visitor reads or touches. */
const PARTS =
  "#scenes-button, #hud, #rail > *, #figures, #message, #hint, #pad button, " +
  "#controls button, #time, #time-label";

/** Name and box of each visible one. */
function boxes(page) {
  return page.evaluate((parts) =>
    [...document.querySelectorAll(parts)]
      .filter((element) => element.checkVisibility())
      .map((element) => {
        const { left, top, right, bottom } = element.getBoundingClientRect();
        const name = element.id || element.dataset.key || element.dataset.tool || element.innerText;
        return { name, touch: element.tagName === "BUTTON", left, top, right, bottom };
      }), PARTS);
}

for (const [size, options] of SIZES)
  for (const scene of ["brick_wall", "platformer_game", "artillery", "bridge_builder"])
    test(`controls_of_${scene}_on_a_${size}_lie_in_sight_and_on_none_other`, async () => {
      const { page, errors, close } = await visitor.open(`?scene=${scene}&paused=1`, options);
      await stepBy(page, 1);
      await untilFigures(page);
      // A game's figures and message come with the list of scenes.
      await page.waitForSelector("[data-entry]", { state: "attached" });
      await untilStill(page);
      const { width, height } = options.viewport;
      const all = await boxes(page);
      assert.ok(all.length > 12, "controls are missing");
      for (const [i, a] of all.entries()) {
        const inside = a.left >= 0 && a.top >= 0 && a.right <= width && a.bottom <= height;
        assert.ok(inside, `out of sight: ${JSON.stringify(a)}`);
        const low = options.hasTouch && a.touch && Math.min(a.bottom - a.top, a.right - a.left) < 40;
        assert.ok(!low, `too small for a finger: ${JSON.stringify(a)}`);
        for (const b of all.slice(i + 1)) {
          const x = Math.min(a.right, b.right) - Math.max(a.left, b.left);
          const y = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
          assert.ok(x <= 0.5 || y <= 0.5, `${JSON.stringify(a)} and ${JSON.stringify(b)}`);
        }
      }
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width);
      assert.deepEqual(errors, []);
      await close();
    });

test("first_scene_on_a_phone_held_upright_leaves_less_than_a_fifth_of_it_empty", async () => {
  const { page, close } = await visitor.open("?paused=1", PHONE);
  await stepBy(page, 1);
  await page.waitForSelector("#hint:not([hidden])");
  const empty = () =>
    page.evaluate(() => {
      const canvas = document.getElementById("bodies");
      const { width, height } = canvas;
      const copy = Object.assign(document.createElement("canvas"), { width, height });
      const context = copy.getContext("2d", { willReadFrequently: true });
      context.drawImage(canvas, 0, 0);
      const { data } = context.getImageData(0, 0, width, height);
      const first = data.findIndex((value, i) => i % 4 === 3 && value >= 128);
      const top = (Math.floor(first / 4 / width) * innerHeight) / height;
      return (top - document.getElementById("hint").getBoundingClientRect().bottom) / innerHeight;
    });
  await until(empty, (part) => part > 0 && part < 0.2, "a part of the window");
  await close();
});

for (const scene of ["brick_wall", "artillery", "bridge_builder"])
  test(`title_of_${scene}_is_whole_where_a_laptops_window_is_enlarged_twice`, async () => {
    const options = { viewport: { width: 640, height: 400 }, deviceScaleFactor: 2 };
    const { page, close } = await visitor.open(`?scene=${scene}&paused=1`, options);
    await stepBy(page, 1);
    const [shown, whole] = await page.evaluate(() => {
      const { clientWidth, clientHeight, scrollWidth, scrollHeight } =
        document.getElementById("scene-title");
      return [[clientWidth, clientHeight], [scrollWidth, scrollHeight]];
    });
    assert.ok(whole[0] <= shown[0] && whole[1] <= shown[1] + 1, `${shown} shows of ${whole}`);
    await close();
  });

/** The colours of both tanks in the dark and the light theme (web/src/draw/palette.ts). */
const TANKS = [[255, 157, 92], [108, 196, 255], [181, 72, 12], [31, 99, 184]];

/** The lowest CSS pixel, from the top, in which one of the colours is drawn on the overlay. */
function lowestOf(colours) {
  const canvas = document.getElementById("overlay");
  const { width, height } = canvas;
  const copy = Object.assign(document.createElement("canvas"), { width, height });
  const context = copy.getContext("2d", { willReadFrequently: true });
  context.drawImage(canvas, 0, 0);
  const { data } = context.getImageData(0, 0, width, height);
  for (let i = data.length - 4; i > 0; i -= 4)
    if (colours.some((colour) => colour.every((value, k) => data[i + k] === value)))
      return (Math.floor(i / 4 / width) * innerHeight) / height;
  return 0;
}

test("how_artillery_is_played_is_told_below_both_tanks_where_a_window_is_low", async () => {
  for (const seed of [1, 3, 5]) {
    const small = { viewport: { width: 640, height: 400 } };
    const { page, close } = await visitor.open(`?scene=artillery&seed=${seed}&paused=1`, small);
    await stepBy(page, 1);
    await page.waitForSelector("#notice:not([hidden])");
    const { y } = await page.locator("#notice").boundingBox();
    const low = () => page.evaluate(lowestOf, TANKS);
    await until(low, (tanks) => tanks > 200 && tanks <= y, `tanks above ${y}`);
    await close();
  }
});

test("nothing_moves_when_the_engine_comes", async () => {
  let release;
  const held = new Promise((resolve) => (release = resolve));
  const { page, close } = await visitor.open("?scene=pyramid&size=5&paused=1", DESKTOP, (opened) =>
    opened.route("**/*.wasm", async (route) => {
      await held;
      await route.continue();
    }));
  await page.waitForSelector("main[aria-busy] #hud dt", { state: "attached" });
  const places = () => page.evaluate(() =>
    ["hud", "rail", "controls"].map((id) => {
      const { left, top, width, height } = document.getElementById(id).getBoundingClientRect();
      return [id, left, top, width, height].map((part) => (isNaN(part) ? part : Math.round(part)));
    }));
  const waiting = await places();
  release();
  await page.waitForSelector("main:not([aria-busy])", { state: "attached" });
  await stepBy(page, 3);
  const [[, left, top, , height], ...others] = await places();
  assert.deepEqual([left, top, height], [waiting[0][1], waiting[0][2], waiting[0][4]]);
  assert.deepEqual(others, waiting.slice(1));
  await close();
});

test("hint_is_shown_once_and_goes_for_good_when_a_body_is_dragged", async () => {
  const { page, errors, close } = await visitor.open("?scene=pyramid&size=1&paused=1");
  await stepBy(page, 1);
  await page.waitForSelector("#hint:not([hidden])");
  assert.match(await page.innerText("#hint"), /drag/i);
  assert.equal(await page.locator("#notice").isVisible(), false, "two lines at once");
  const { x, y } = await drawn(page);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 20, y - 40, { steps: 3 });
  await page.waitForSelector("#hint", { state: "hidden" });
  await page.mouse.up();
  await page.reload();
  await stepBy(page, 1);
  assert.equal(await page.locator("#hint").isVisible(), false);
  assert.deepEqual(errors, []);
  await close();
});

test("hint_goes_for_good_when_another_scene_is_chosen", async () => {
  const { page, close } = await visitor.open("?scene=tall_stack");
  await untilRunning(page);
  assert.equal(await page.locator("#hint").isVisible(), true);
  await page.click("#scenes-button");
  await page.click('[data-entry="pyramid"]');
  await page.waitForSelector("#hint", { state: "hidden" });
  await page.reload();
  await untilRunning(page);
  assert.equal(await page.locator("#hint").isVisible(), false);
  await close();
});

/** The cradle's figures appear with the first frame, and move the hint down on a phone; Latency
 * begins with a message. */
const TOLD = [
  ["hint", "tall_stack", "desktop", DESKTOP],
  ["hint", "tall_stack", "phone", PHONE],
  ["hint", "newtons_cradle", "phone", PHONE],
  ["message", "lab_latency", "phone", PHONE],
];
for (const [told, scene, size, options] of TOLD)
  test(`${told}_covers_nothing_of_${scene}_on_a_${size}`, async () => {
    const { page, close } = await visitor.open(`?scene=${scene}&paused=1`, options);
    await stepBy(page, 1);
    await page.waitForSelector(`#${told}:not([hidden])`);
    await untilStill(page);
    const line = await page.locator(`#${told}`).boundingBox();
    const highest = () =>
      page.evaluate(() => {
        const canvas = document.getElementById("bodies");
        const { width, height } = canvas;
        const copy = Object.assign(document.createElement("canvas"), { width, height });
        const context = copy.getContext("2d", { willReadFrequently: true });
        context.drawImage(canvas, 0, 0);
        const { data } = context.getImageData(0, 0, width, height);
        const first = data.findIndex((value, i) => i % 4 === 3 && value >= 128);
        return Math.floor(first / 4 / width) * (innerHeight / height);
      });
    // The view begins 8 pixels below the line.
    const top = line.y + line.height + 8;
    await until(highest, (y) => y >= top, `below ${top}`);
    await close();
  });

for (const [size, options, gliding] of [["desktop", DESKTOP, "hint"], ["phone", PHONE, "dock"]])
  test(`view_on_a_${size}_is_that_of_the_${gliding}_at_rest_while_it_glides_in`, async () => {
    const openGliding = async (seconds) => {
      const { page } = await visitor.open(
        `?scene=tall_stack&paused=1${gliding === "dock" ? "&panel=options" : ""}`,
        options,
        (opened) =>
          opened.addInitScript((duration) => {
            const style = new CSSStyleSheet();
            style.replaceSync(`#hint, #dock { animation-duration: ${duration}s !important; }`);
            document.adoptedStyleSheets.push(style);
          }, seconds),
      );
      await stepBy(page, 1);
      await page.waitForSelector(`#${gliding}:not([hidden])`);
      return page;
    };
    const [slow, resting] = [await openGliding(1000), await openGliding(0)];
    const both = async () => [await drawn(slow), await drawn(resting)];
    await until(both, ([a, b]) => a.count === b.count && a.y === b.y, "two pictures");
    await slow.context().close();
    await resting.context().close();
  });

test("hint_can_be_closed_and_games_show_none", async () => {
  const { page, close } = await visitor.open("?scene=platformer_game");
  await untilRunning(page);
  assert.equal(await page.locator("#hint").isVisible(), false);
  await page.goto(page.url().replace(/\?.*/, "?scene=cradle"));
  await page.click("#hint button");
  assert.equal(await page.locator("#hint").isVisible(), false);
  await page.reload();
  await untilRunning(page);
  assert.equal(await page.locator("#hint").isVisible(), false);
  await close();
});

test("hint_makes_room_for_an_open_panel", async () => {
  const { page, close } = await visitor.open("?scene=cradle");
  await page.waitForSelector("#hint");
  await page.click('[data-panel="options"]');
  await page.waitForSelector("#hint", { state: "hidden" });
  await page.keyboard.press("Escape");
  await page.waitForSelector("#hint");
  await close();
});

test("figures_are_numbers_with_units_and_the_help_explains_each", async () => {
  // The scene is so large that a step takes longer than the clock's resolution on any machine.
  const { page, close } = await visitor.open("?scene=pyramid&size=60&paused=1");
  await stepBy(page, 60);
  const text = (name) => page.textContent(`[data-value="${name}"]`);
  // The first steps are not counted as slowest, and the figures may be those of an earlier frame.
  for (const name of ["ms", "slowest"])
    assert.match(
      await until(() => text(name), (shown) => /\d/.test(shown), `figure of ${name}`),
      /^([1-9]\d* µs|\d\.\d\d ms|\d\d\.\d ms|\d{3} ms|\d+\.\d s)$/,
    );
  assert.match(await text("fps"), /^\d+$/);
  assert.ok((await figure(page, "bodies")) > 5);
  await page.keyboard.press("h");
  const explained = await page.locator("#legend dt").allInnerTexts();
  for (const label of await page.locator("#hud dt").allTextContents())
    assert.ok(explained.includes(label), `${label} is not explained`);
  await close();
});

test("scene_is_described_in_words_that_go_with_it", async () => {
  const { page, close } = await visitor.open("?scene=pyramid&size=10&paused=1");
  await stepBy(page, 30);
  const state = page.locator("#state");
  assert.equal(await page.getAttribute("#overlay", "aria-describedby"), "state");
  await page.waitForFunction(() => /at 0\.5 s/.test(document.querySelector("#state").textContent));
  assert.match(
    await state.textContent(),
    /^Pyramid, paused at 0\.5 s; 56 bodies, 55 awake; (deepest overlap (< )?0\.\d+|no overlap)\.$/,
  );
  assert.equal(await state.getAttribute("aria-live"), null);
  await page.click("#pause");
  const runningAt = async () =>
    Number(/running at ([\d.]+) s/.exec(await state.textContent())?.[1]);
  const seconds = await until(runningAt, (told) => told > 0, "running");
  await until(runningAt, (told) => told > seconds, `later than ${seconds} s`);
  await close();
});
