/**
 * Tests that a scene's time follows the clock at any display rate, and that the page otherwise says
 * why it does not.
 */
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { boxes } from "./support/code.mjs";
import { display } from "./support/contexts.mjs";
import { BROWSERS, DESKTOP, openVisitor, untilRunning, untilTold } from "./support/page.mjs";
import { until } from "./support/wait.mjs";

/**
 * Milliseconds of a step that is too slow, and the pause between two frames of a display that does
 * not wait for the page, so that a slow machine is not slowed down further.
 */
const SLOW_STEP = 200;
const PAUSE = 30;
/** Milliseconds: less than a frame of 16.7 ms, but nearly all of it. */
const BUSY_STEP = 13;

const GAMES = [
  [20, "artillery", 3, 1],
  [30, "platformer_game", 3, 1],
];
/** Frames per second, scene, seconds, and speed of the scene. */
const RATES = {
  firefox: GAMES,
  chromium: [...GAMES, [30, "cradle", 3, 2], [60, "cradle", 2, 0.5], [144, "cradle", 0.8, 1]],
};

/** Seconds of the display and of the scene. */
function times(page) {
  return page.evaluate(() => ({
    clock: window.clock / 1000,
    scene: Number(document.querySelector("#hud").dataset.steps) / 60,
  }));
}

for (const browser of BROWSERS)
  describe(browser, () => {
    const visitor = openVisitor({ browser });

    for (const [hertz, scene, seconds, speed] of RATES[browser])
      test(`${scene}_at_${speed}_times_keeps_the_time_at_${hertz}_pictures_a_second`, async () => {
        const search = `?scene=${scene}&speed=${speed}`;
        const { page, errors, close } = await visitor.open(search, DESKTOP, display(hertz));
        await untilRunning(page);
        const start = await times(page);
        const end = await until(
          () => times(page),
          ({ clock }) => clock >= start.clock + seconds,
          "the display goes on",
        );
        const part = (end.scene - start.scene) / (end.clock - start.clock) / speed;
        // Both ends may be off by one frame, or by one step, of which slow motion has fewer.
        const most = 2 / (seconds * Math.min(60, hertz, 60 * speed));
        assert.ok(Math.abs(part - 1) <= most + 1e-9, `${part}`);
        assert.equal(await page.locator("#slow").count(), 0, "nothing is said of slow motion");
        assert.deepEqual(errors, []);
        await close();
      });
  });

describe("slow motion", () => {
  const visitor = openVisitor();

  /** The text that the page shows while a scene is too slow. */
  async function toldOf(page) {
    await page.waitForSelector("#slow:not([hidden])");
    return page.innerText("#slow");
  }

  /**
   * Opens a scene whose steps take this many milliseconds, on a display with `hertz` frames per
   * second.
   */
  function openSlow(milliseconds, hertz) {
    const update = `for (const t = performance.now(); performance.now() < t + ${milliseconds};);`;
    const body = boxes(3, { update });
    return visitor.open("?scene=sketch", DESKTOP, async (opened) => {
      await opened.route("**/scenes/sketch.js", (route) =>
        route.fulfill({ contentType: "text/javascript", body }),
      );
      await display(hertz, PAUSE)(opened);
    });
  }

  test("scene_whose_own_code_takes_too_long_runs_on_and_says_so_until_it_is_paused", async () => {
    const { page, close } = await openSlow(SLOW_STEP, 60);
    const told = await toldOf(page);
    assert.match(told, /^Slow motion, 0\.\d+×: a step takes \d+(\.\d)? ms, 16\.7 ms would keep up\./);
    assert.match(told, /scene’s own code/);
    await untilTold(page, "cannot keep up with the clock");
    const { scene } = await times(page);
    await until(() => times(page), (now) => now.scene > scene + 0.05, "it goes on");
    await page.click("#pause");
    await page.waitForSelector("#slow", { state: "hidden" });
    await page.click("#pause");
    await page.waitForSelector("#slow:not([hidden])");
    await page.click("#scenes-button");
    await page.click('[data-entry="cradle"]');
    await page.waitForFunction(() => document.title.startsWith("Rows of elastic"));
    assert.ok(await page.isHidden("#slow"));
    await close();
  });

  test("only_a_step_that_takes_longer_than_the_clock_lets_it_is_told_what_would_keep_up", async () => {
    const { page, close } = await openSlow(BUSY_STEP, 4);
    const told = await toldOf(page);
    const [, took, word, clock] = told.match(/a step takes ([\d.]+) ms(,| of the) ([\d.]+) ms/) ?? [];
    assert.equal(clock, "16.7", told);
    const longer = word === ",";
    assert.ok(longer ? Number(took) >= 16.7 : Number(took) <= 16.7, told);
    await close();
  });

  test("browser_that_draws_four_pictures_a_second_is_told_as_the_reason", async () => {
    const { page, close } = await visitor.open("?scene=cradle", DESKTOP, display(4));
    assert.match(await toldOf(page), /draws \d pictures a second\. A smaller window/);
    const wanted = /^Slow motion, 0\.4\d*×: the browser draws 4 pictures a second/;
    await until(() => page.innerText("#slow"), (line) => wanted.test(line), "of its time");
    await close();
  });

  test("tab_that_was_out_of_sight_for_a_minute_is_not_slow", async () => {
    const { page, close } = await visitor.open("?scene=cradle", DESKTOP, display(60));
    await untilRunning(page);
    const before = await times(page);
    await page.evaluate(() => (window.clock += 60_000));
    const after = await until(() => times(page), ({ clock }) => clock > before.clock + 61, "on");
    assert.ok(after.scene < before.scene + 3, "nothing is made up for");
    assert.equal(await page.locator("#slow").count(), 0);
    await close();
  });
});
