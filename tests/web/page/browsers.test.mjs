/**
 * Tests the main features of the page in each browser, because browsers differ in content security
 * policies, modules in workers and clocks. Everything else is tested in one browser.
 */
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { createStaticServer } from "../../../web/tools/static-server.mjs";
import { copyOfPage, serve, untilOffline } from "../support/built-page.mjs";
import { boxes, type } from "../support/code.mjs";
import { drawLightly } from "../support/contexts.mjs";
import {
  browserOf,
  BROWSERS,
  choose,
  DESKTOP,
  drawn,
  near,
  openLevel,
  openVisitor,
  PATIENCE,
  PHONE,
  stepBy,
  untilBodies,
  untilRunning,
} from "../support/page.mjs";
import { ballLevel } from "../support/package.mjs";
import { until, untilOverlay } from "../support/wait.mjs";
import { table, untilMeasured } from "../support/versus.mjs";

/** Milliseconds; a measurement runs all settings of a scene. */
const LONG = { timeout: 300_000 };

for (const browser of BROWSERS)
  describe(browser, () => {
    const visitor = openVisitor({ browser });

    for (const [name, options] of [["desktop", DESKTOP], ["phone", PHONE]])
      test(`scenes_and_levels_run_and_are_drawn_on_a_${name}`, async () => {
        const { page, errors, close } = await visitor.open("", sized(browser, options));
        await untilRunning(page);
        await until(() => drawn(page), ({ count }) => count > 1000, "bodies are drawn");
        for (const [entry, title] of [["tumbler", /^Tumbler/], ["quarry", /^Quarry/]]) {
          await page.click("#scenes-button");
          await page.click(`[data-entry="${entry}"]`);
          await untilTitle(page, title);
          await untilRunning(page);
        }
        assert.deepEqual(errors, []);
        await close();
      });

    test("platformer_is_played_by_keys", async () => {
      const { page, errors, close } = await openGame(visitor, "platformer_game");
      assert.match(await figureOf(page, "Coins"), /^0/);
      await page.keyboard.down("ArrowRight");
      await stepBy(page, 150);
      await page.keyboard.up("ArrowRight");
      assert.match(await figureOf(page, "Coins"), /^2/);
      assert.deepEqual(errors, []);
      await close();
    });

    test("textured_ground_tells_what_a_foot_stands_on", async () => {
      const { page, errors, close } = await visitor.open("?scene=textured&paused=1");
      await stepBy(page, 60);
      assert.match(await figureOf(page, "Under a foot"), /^(Rock|Grass|Ice|Sand), friction/);
      const weights = (await figureOf(page, "Weights of the vertices")).split(" + ").map(Number);
      near(weights[0] + weights[1], 1, 0.011, "both weights");
      assert.match(await figureOf(page, "Texture"), /^u \d\.\d\d, v [0-3]\.5$/);
      assert.deepEqual(errors, []);
      await close();
    });

    test("artillery_is_played_by_keys_and_answered", async () => {
      const { page, errors, close } = await openGame(visitor, "artillery");
      await hold(page, "ArrowLeft");
      await untilSaid(page, /^Your turn/);
      await hold(page, "Space");
      await untilSaid(page, /A miss|Hit|out of the field/);
      await untilSaid(page, /computer aims/);
      assert.deepEqual(errors, []);
      await close();
    });

    test("ball_on_a_rod_is_pulled_by_the_mouse_as_far_as_the_rod_lets_it", async () => {
      const { page, errors, close } = await visitor.open("?scene=cradle&paused=1");
      const rod = {
        ...{ id: 3, type: "distance", x: 320, y: 32 },
        polyline: [{ x: 0, y: 0 }, { x: 0, y: 128 }],
        properties: [{ name: "b", type: "object", value: 2 }],
      };
      await openLevel(page, "ball.tmj", ballLevel([rod]));
      await untilTitle(page, /^ball/);
      await stepBy(page, 1);
      await untilOverlay(page, (count) => count > 100, "the rod is drawn");
      const start = await drawn(page);
      await page.mouse.move(start.x, start.y);
      await page.mouse.down();
      await page.waitForSelector("#overlay[data-mode=pull]");
      await page.mouse.move(start.x + 400, start.y, { steps: 4 });
      await stepBy(page, 120);
      const held = await drawn(page);
      const pixels = Math.sqrt(start.count / Math.PI);
      // The rod is as far to the side as up, and points to the mouse.
      const length = 4 * pixels;
      const reach = Math.hypot(400, length);
      near(held.x - start.x, (400 * length) / reach, 0.15 * length, "x");
      near(start.y - held.y, length - length ** 2 / reach, 0.15 * length, "y");
      await page.mouse.up();
      assert.deepEqual(errors, []);
      await close();
    });

    test("versus_runs_box2d_and_measures_both", async () => {
      const { page, errors, close } = await visitor.open("?scene=cradle&panel=versus");
      await untilMeasured(page);
      const rows = await table(page);
      const steps = Object.values(rows)[0];
      assert.equal(steps.filter((text) => / [mµ]s$/.test(text)).length, 2, String(steps));
      assert.deepEqual(errors, []);
      await close();
    });

    test("trade_measures_every_setting_and_box2d", LONG, async () => {
      const { page, errors, close } = await visitor.open("?scene=cradle&paused=1&panel=trade");
      await page.click("[aria-labelledby=measure-heading] .go");
      await page.waitForSelector("text=Copy as text", { timeout: LONG.timeout });
      const rows = await page.locator(".trade").innerText();
      assert.match(rows, /Box2D/);
      assert.deepEqual(errors, []);
      await close();
    });

    test("inside_draws_overlays_and_finds_the_same_bits_as_everywhere", async () => {
      const { page, errors, close } = await visitor.open(
        "?scene=tall_stack&paused=1&panel=inside",
      );
      await page.waitForSelector("[name=inside]", { state: "attached" });
      await choose(page, "inside", "show");
      await stepBy(page, 5);
      await page.check("[name=overlay-contacts]");
      await untilOverlay(page, (count) => count > 20, "contacts");
      await choose(page, "inside", "bits");
      await page.click("#check");
      await page.waitForSelector("#verdict[data-verdict=same]");
      assert.deepEqual(errors, []);
      await close();
    });

    test("code_is_edited_and_run_and_an_error_is_told_at_its_line", async () => {
      const { page, errors, close } = await visitor.open("?scene=sketch&panel=code");
      await page.waitForSelector(".code-editor .cm-line:not(:empty)");
      await type(page, boxes(7));
      await page.keyboard.press("Control+Enter");
      await untilBodies(page, 7);
      await type(page, boxes(7, { update: "throw new Error('on purpose')" }));
      await page.click(".code-run");
      await page.locator(".code-trouble", { hasText: "on purpose" }).waitFor();
      await page.waitForSelector(".cm-lint-marker-error");
      // A text that imports a neighbouring module.
      await type(page, IMPORTING);
      await page.click(".code-run");
      await untilBodies(page, 1);
      await page.waitForSelector('#message:text-is("platformer: ok")');
      assert.deepEqual(errors, []);
      await close();
    });

    test("own_level_runs", async () => {
      const { page, errors, close } = await visitor.open("?scene=cradle");
      await untilRunning(page);
      await openLevel(page, "ball.tmj", ballLevel());
      await untilTitle(page, /^ball/);
      await untilBodies(page, 2);
      assert.deepEqual(errors, []);
      await close();
    });

    test("without_network_after_one_visit_games_and_versus_run", async (t) => {
      const { url, cut } = await serve(t, createStaticServer(copyOfPage(t)));
      const context = await (await browserOf(browser)).newContext();
      t.after(() => context.close());
      context.setDefaultTimeout(PATIENCE);
      await drawLightly(context);
      const page = await context.newPage();
      await page.goto(url);
      await untilOffline(page);
      await cut();
      for (const name of ["platformer_game", "artillery"]) {
        await page.goto(`${url}?scene=${name}`);
        await untilRunning(page);
      }
      await page.goto(`${url}?scene=cradle&panel=versus`);
      await untilMeasured(page);
    });
  });

const IMPORTING = `import platformer from "./platformer_game.js";
export default function ({ createWorld }) {
  const world = createWorld();
  world.createCircle(world.createBody({ kind: "dynamic" }), { radius: 0.5 });
  const message = "platformer: " + (typeof platformer === "function" ? "ok" : "missing");
  return { world, paint: () => ({ message }) };
}
`;

/** Firefox cannot emulate touch and mobile layout, but any size of its window. */
function sized(browser, options) {
  const { isMobile, hasTouch, ...rest } = options;
  return browser === "firefox" ? rest : options;
}

function untilTitle(page, wanted) {
  return until(() => page.title(), (title) => wanted.test(title), String(wanted));
}

/** Opens a game, paused after its first step. */
async function openGame(visitor, name) {
  const opened = await visitor.open(`?scene=${name}&paused=1`);
  await stepBy(opened.page, 1);
  await opened.page.waitForSelector("#message:not([hidden])");
  return opened;
}

async function hold(page, key) {
  await page.keyboard.down(key);
  await stepBy(page, 2);
  await page.keyboard.up(key);
}

/** Makes steps until the game shows this message. */
async function untilSaid(page, wanted) {
  const message = () => page.textContent("#message");
  for (let i = 0; i < 40 && !wanted.test(await message()); i++) await stepBy(page, 30);
  assert.match(await message(), wanted);
}

function figureOf(page, label) {
  return page.evaluate((wanted) => {
    const terms = [...document.querySelectorAll("#figures dt")];
    return terms.find(({ textContent }) => textContent === wanted)?.nextSibling.textContent;
  }, label);
}
