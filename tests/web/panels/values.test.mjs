/**
 * Tests the panel Values in the scene geometry: two shapes are dragged and set by keys, and the
 * panel shows their geometry, in each browser.
 */
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import {
  BROWSERS,
  choose,
  DESKTOP,
  leftOut,
  openVisitor,
  PHONE,
  runAxeInBothThemes,
  stepBy,
  untilTold,
} from "../support/page.mjs";
import { until, untilOverlay, untilStill } from "../support/wait.mjs";

/** Options for a browser: Firefox has no emulation of touch and phones, but any window size. */
function sized(browser, options) {
  const { isMobile, hasTouch, ...rest } = options;
  return browser === "firefox" ? rest : options;
}

/** The value with that name in the list under a ticked box. */
function reading(page, control, name) {
  return page.evaluate(([list, wanted]) => {
    const terms = [...document.querySelectorAll(`[data-readings="${list}"] dt`)];
    return terms.find(({ textContent }) => textContent === wanted)?.nextSibling.textContent;
  }, [control, name]);
}

function untilRead(page, control, name, wanted) {
  return until(() => reading(page, control, name), (value) => wanted.test(value), name);
}

/** The camera's scale, pixels per world unit. */
const SCALE = 26;

async function openRoom(visitor, browser, options) {
  const search = `?scene=geometry&paused=1&view=0,0,${SCALE}`;
  const opened = await visitor.open(search, sized(browser, options));
  await opened.page.waitForSelector("[data-readings=closest] dd");
  // What shows the scene's message comes with the list of scenes, and takes room from the view.
  await opened.page.waitForSelector("#message:not([hidden])");
  await untilStill(opened.page);
  return opened;
}

/**
 * A function from the world to the page: the camera's centre is the middle of the area that the
 * controls leave free.
 */
async function placesOf(page) {
  const [x, y] = await page.evaluate(() => {
    const box = (id) => document.getElementById(id).getBoundingClientRect();
    const top = Math.max(...["top", "hint", "message"].map((id) => box(id).bottom)) + 8;
    const dock = box("dock");
    const beside = dock.width < 0.6 * innerWidth;
    const right = beside ? dock.left - 8 : innerWidth - 16;
    const bottom = beside ? box("bottom").top - 8 : dock.top - 8;
    return [(16 + right) / 2, (top + bottom) / 2];
  });
  return ([wx, wy]) => [x + SCALE * wx, y - SCALE * wy];
}

for (const browser of BROWSERS)
  describe(browser, () => {
    /** For tests of what the page's own code decides. */
    const LOGIC = { skip: leftOut(browser) };
    const visitor = openVisitor({ browser });

    for (const [size, options, where] of [["desktop", DESKTOP, {}], ["phone", PHONE, LOGIC]])
      test(`shapes_are_dragged_and_what_is_between_them_read_on_a_${size}`, where, async () => {
        const { page, errors, close } = await openRoom(visitor, browser, options);
        assert.match(await reading(page, "closest", "Distance"), /^3\.27$/);
        assert.equal(await reading(page, "ways", "Time of impact"), "0.61");
        assert.match(await page.innerText("#message"), /apart, and will meet/);
        const at = await placesOf(page);
        await page.mouse.move(...at([-3.2, -1.6]));
        await page.mouse.down();
        await page.mouse.move(...at([1.5, -1.2]), { steps: 4 });
        await page.mouse.up();
        await untilRead(page, "overlap", "Direct test", /^they overlap$/);
        assert.match(await reading(page, "closest", "Depth"), /^[01]\.\d\d$/);
        assert.equal(await reading(page, "ways", "Time of impact"), "0.00");
        assert.match(await page.innerText("#message"), /overlap/);
        await untilTold(page, "The shapes overlap.");
        assert.deepEqual(errors, []);
        await close();
      });

    test("boxes_and_sliders_are_set_by_keys_and_said", async () => {
      const { page, errors, close } = await openRoom(visitor, browser, DESKTOP);
      assert.equal(await reading(page, "aabb", "A fills"), undefined);
      await page.focus("[name=set-aabb]");
      await page.keyboard.press("Space");
      await untilRead(page, "aabb", "A fills", /^\d\d %$/);
      await until(() => stepBy(page, 1).then(() => reading(page, "aabb", "Such tests in 1 µs")),
        (value) => Number(value) > 0, "the test is measured");
      const before = await reading(page, "aabb", "A fills");
      await page.locator("summary", { hasText: "Shape A" }).press("Enter");
      await page.focus("[name=set-angleA]");
      for (let i = 0; i < 9; i++) await page.keyboard.press("ArrowRight");
      assert.equal(await page.getAttribute("[name=set-angleA]", "aria-valuetext"), "-145");
      await until(() => reading(page, "aabb", "A fills"), (value) => value !== before, "it turned");
      await untilTold(page, "Direct test: apart. Distance: ");
      await choose(page, "set-kindA", "circle");
      await untilRead(page, "closest", "Distance", /^\d\.\d\d$/);
      await choose(page, "set-kindB", "circle");
      await untilRead(page, "ways", "Found", /closed form/);
      await page.uncheck("[name=set-ways]");
      await until(() => reading(page, "ways", "Found"), (value) => value === undefined, "unticked");
      assert.deepEqual(errors, []);
      await close();
    });

    test("sum_and_bounds_are_drawn_where_they_are_ticked", LOGIC, async () => {
      const { page, errors, close } = await openRoom(visitor, browser, DESKTOP);
      // The OBB around a box would be the box itself.
      await choose(page, "set-kindA", "circle");
      await untilRead(page, "closest", "Distance", /^(?!3\.27)\d\.\d\d$/);
      await stepBy(page, 1);
      const { count: plain } = await untilOverlay(page, (count) => count > 500, "two shapes");
      for (const name of ["circle", "aabb", "obb", "sum"]) {
        await page.check(`[name=set-${name}]`);
        await untilOverlay(page, (count) => count > plain + 60, `with ${name}`);
        if (name === "sum") continue;
        await page.uncheck(`[name=set-${name}]`);
        await untilOverlay(page, (count) => count < plain + 60, `without ${name}`);
      }
      assert.equal(await reading(page, "sum", "B is in the sum"), "no");
      assert.equal(
        await reading(page, "sum", "Its way enters at"),
        await reading(page, "ways", "Time of impact"),
      );
      assert.deepEqual(errors, []);
      await close();
    });
  });

describe("chromium alone", () => {
  const visitor = openVisitor();

  for (const [size, options] of [["desktop", DESKTOP], ["phone", PHONE]])
    test(`values_can_be_read_by_everybody_on_a_${size}`, async () => {
      const { page, close } = await openRoom(visitor, "chromium", options);
      await page.check("[name=set-obb]");
      await page.locator("summary", { hasText: "Shape B" }).press("Enter");
      assert.deepEqual(await runAxeInBothThemes(page), []);
      await close();
    });

  test("panel_comes_with_a_scene_that_has_values_and_goes_with_it", async () => {
    const urls = [];
    const prepare = (page) => page.on("request", (request) => urls.push(request.url()));
    const search = "?scene=cradle&paused=1";
    const { page, errors, close } = await visitor.open(search, DESKTOP, prepare);
    await stepBy(page, 1);
    const button = page.locator("button[data-panel=values]");
    assert.equal(await button.isVisible(), false);
    const own = () => urls.filter((url) => /\/values-[\w-]+\.js$|\/geometry\//.test(url));
    assert.deepEqual(own(), []);
    await page.click("#scenes-button");
    await page.click("[data-entry=geometry]");
    await page.waitForSelector("[data-readings=closest] dd");
    assert.equal(await button.getAttribute("aria-expanded"), "true");
    await page.keyboard.press("Escape");
    await page.waitForSelector("#dock", { state: "hidden" });
    await button.click();
    await page.waitForSelector("[data-readings=closest] dd");
    await page.click("#scenes-button");
    await page.click("[data-entry=cradle]");
    await page.waitForSelector("#dock", { state: "hidden" });
    assert.equal(await button.isVisible(), false);
    assert.deepEqual(errors, []);
    await close();
  });
});
