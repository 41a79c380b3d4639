/**
 * Tests the panel Versus when Box2D or WebGL fails or loads late: the page reports it, and the
 * scene goes on.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  choose,
  DESKTOP,
  near,
  openLevel,
  openVisitor,
  PHONE,
  stepBy,
  untilRunning,
} from "../support/page.mjs";
import { ballLevel } from "../support/package.mjs";
import {
  BOX2D,
  drawnFrames,
  openBoth,
  untilBox2D,
  untilMeasured,
  untilTwo,
} from "../support/versus.mjs";

const visitor = openVisitor();

// The property of a level's object that makes its body dynamic.
const MOVES = [{ name: "body", type: "string", value: "dynamic" }];

test("box2d_that_does_not_come_is_told_and_the_scene_goes_on", async () => {
  let blocked = true;
  // A scene that does not fall asleep before Box2D is loaded: nothing is measured while it sleeps.
  const { page, close } = await visitor.open("?scene=tumbler&size=60", DESKTOP, async (page) => {
    await page.context().route(BOX2D, (route) => (blocked ? route.abort() : route.continue()));
  });
  await untilRunning(page);
  await page.click('[data-panel="versus"]');
  await page.waitForSelector("#versus .trouble:not([hidden])");
  assert.match(await page.textContent("#versus .trouble"), /Box2D could not be loaded.*thud alone/);
  const steps = await page.evaluate(() => Number(document.querySelector("#hud").dataset.steps));
  await page.waitForFunction(
    (before) => Number(document.querySelector("#hud").dataset.steps) > before + 5,
    steps,
  );
  blocked = false;
  await page.click('#versus button:text-is("Try again")');
  await untilMeasured(page);
  assert.ok(await page.isHidden("#versus .trouble"));
  await close();
});

/** Holds back Box2D's files until the returned function is called. */
async function holdBox2D(page) {
  let letGo;
  const held = new Promise((resolve) => (letGo = resolve));
  await page.context().route(BOX2D, async (route) => {
    await held;
    await route.continue().catch(() => {});
  });
  return letGo;
}

const stepsMade = (page) => page.$eval("#hud", ({ dataset }) => Number(dataset.steps ?? 0));

test("link_to_the_panel_waits_for_box2d_and_both_begin_at_the_start", async () => {
  let letGo;
  const { page, errors, close } = await visitor.open(
    "?scene=tall_stack&panel=versus",
    DESKTOP,
    async (page) => {
      letGo = await holdBox2D(page);
      // Long timeouts of the page do not expire, however slow the machine is.
      await page.addInitScript(() => {
        const { setTimeout } = window;
        window.setTimeout = (act, after) => setTimeout(act, after >= 5000 ? 1e6 : after);
      });
    },
  );
  await page.locator("#versus .verdict", { hasText: "Loading Box2D" }).waitFor();
  await drawnFrames(page, 20);
  assert.equal(await stepsMade(page), 0);
  letGo();
  await untilMeasured(page);
  assert.ok(await page.isHidden("#versus .quiet"), "Box2D began later");
  assert.deepEqual(errors, []);
  await close();
});

test("link_to_the_panel_runs_without_box2d_when_that_takes_long", async () => {
  let letGo;
  const { page, errors, close } = await visitor.open(
    "?scene=tall_stack&panel=versus",
    DESKTOP,
    async (page) => {
      letGo = await holdBox2D(page);
      // The page's timeout of five seconds is shortened to a tenth.
      await page.addInitScript(() => {
        const { setTimeout } = window;
        window.setTimeout = (act, after) => setTimeout(act, after === 5000 ? 500 : after);
      });
    },
  );
  await untilRunning(page);
  await page.locator("#versus .verdict", { hasText: /Loading Box2D.*alone/ }).waitFor();
  letGo();
  await page.locator("#versus .quiet", { hasText: /Box2D began at .* s/ }).waitFor();
  assert.deepEqual(errors, []);
  await close();
});

test("closing_the_panel_as_the_worker_ends_leaves_no_error_behind", async () => {
  const { page, errors, close } = await visitor.open(
    "?scene=tall_stack&paused=1&panel=versus",
    DESKTOP,
    (page) =>
      page.addInitScript(() => {
        const Original = Worker;
        window.Worker = function (...settings) {
          window.made = new Original(...settings);
          return window.made;
        };
      }),
  );
  await untilBox2D(page);
  await page.evaluate(() => {
    // The worker does not receive the request to end, as if it were busy with an endless step.
    window.made.postMessage = () => {};
    document.querySelector("#dock .close").click();
    window.made.dispatchEvent(new ErrorEvent("error", { message: "out of breath" }));
  });
  await page.locator("#notice", { hasText: "out of breath" }).waitFor({ state: "attached" });
  await drawnFrames(page, 3);
  assert.deepEqual(errors, []);
  await close();
});

test("world_too_wide_for_box2d_is_told_of", async () => {
  const { page, errors, close } = await visitor.open("?scene=cradle&paused=1&panel=versus");
  // Pixels: 32 of them are a metre.
  const away = { id: 3, x: 32e7, y: 0, width: 64, height: 64, ellipse: true };
  const level = ballLevel([{ ...away, properties: MOVES }]);
  await openLevel(page, "wide.tmj", level);
  await page.waitForFunction(() => document.title.startsWith("wide"));
  await stepBy(page, 1);
  await page.waitForSelector("#versus .trouble:not([hidden])");
  const text = await page.textContent("#versus .trouble");
  assert.match(text, /100 km.*\d km from their middle.*thud alone/);
  assert.deepEqual(errors, []);
  await close();
});

/** A small window, because the tests render WebGL on the processor. */
const SMALL_DESKTOP = { viewport: { width: 1024, height: 640 } };

for (const [size, options] of [["desktop", SMALL_DESKTOP], ["phone", PHONE]])
  test(`lost_webgl_leaves_both_views_to_canvas_2d_until_it_comes_back_on_${size}`, async () => {
    const withWebgl = openVisitor({ webgl: true });
    const { page, close } = await openBoth(withWebgl, options);
    const renderer = (name) => page.waitForSelector(`#bodies[data-renderer="${name}"]`);
    await renderer("webgl2");
    await choose(page, "split", "side");
    const start = await untilTwo(page);
    await page.evaluate(() => {
      const gl = document.getElementById("bodies").getContext("webgl2");
      window.lost = gl.getExtension("WEBGL_lose_context");
      window.lost.loseContext();
    });
    await renderer("canvas2d");
    await page.locator("#notice", { hasText: "took WebGL away" }).waitFor({ state: "attached" });
    await stepBy(page, 60);
    const fallen = await untilTwo(page);
    for (const [i, { y, count }] of fallen.entries()) {
      assert.ok(y > start[i].y + 20, `body ${i} fell by ${y - start[i].y} pixels`);
      near(count, start[i].count, 0.1 * start[i].count, "as large as before");
    }
    await page.evaluate(() => window.lost.restoreContext());
    await renderer("webgl2");
    const again = await untilTwo(page);
    for (const [i, { x, y }] of again.entries()) {
      near(x, fallen[i].x, 1, "where it was");
      near(y, fallen[i].y, 1, "where it was");
    }
    await close();
  });
