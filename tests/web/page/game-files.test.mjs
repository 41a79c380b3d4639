/**
 * Tests the games of examples/games on the page: each is played by keys for some steps, one also by
 * pointer and by touch; its source stands beside it and can be changed; it is found and has a link.
 */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { GAME_FILES } from "../../../web/tools/scene-texts.mjs";
import { openCode, run, type, untilStatus, untilText } from "../support/code.mjs";
import { figureOf, fingers } from "../support/games.mjs";
import { BROWSERS, DESKTOP, leftOut, openVisitor, PHONE, runAxeInBothThemes, stepBy } from "../support/page.mjs";
import { until, untilStill } from "../support/wait.mjs";

const visitor = openVisitor();

async function openGame(name, options = DESKTOP) {
  const opened = await visitor.open(`?scene=${name}&paused=1`, options);
  await stepBy(opened.page, 1);
  await opened.page.waitForSelector("#message:not([hidden])");
  return opened;
}

/** The number at the beginning of one of the game's figures. */
const numberOf = async (page, label) => Number.parseFloat(await figureOf(page, label));

const message = (page) => page.textContent("#message");

/** Holds a key for some steps. */
async function hold(page, key, steps) {
  await page.keyboard.down(key);
  await stepBy(page, steps);
  await page.keyboard.up(key);
}

/** How each game is played, and what is seen of it then. */
const PLAYED = {
  async game_brick_breaker(page) {
    await hold(page, "Space", 120);
    assert.ok((await numberOf(page, "Bricks")) < 40);
  },
  async game_car(page) {
    await stepBy(page, 10);
    assert.equal(await figureOf(page, "Time"), "0.0 s");
    await hold(page, "ArrowUp", 90);
    assert.equal(await figureOf(page, "Time"), "1.5 s");
    assert.equal(await message(page), "Through the yellow gate.");
  },
  async game_platformer(page) {
    await hold(page, "ArrowRight", 156);
    assert.equal(await numberOf(page, "Coins"), 0);
    await hold(page, "ArrowUp", 120);
    assert.equal(await numberOf(page, "Coins"), 2);
  },
  async game_pool(page) {
    await hold(page, "Space", 2);
    assert.equal(await message(page), "Your shot.");
    for (let i = 0; i < 10 && !/computer|Once more/.test(await message(page)); i++) await stepBy(page, 60);
    assert.match(await message(page), /The computer tries|The computer’s shot|Once more/);
  },
  async game_rollback(page) {
    await hold(page, "ArrowRight", 40);
    const again = await numberOf(page, "Run again");
    assert.ok(again > 10, `${again} steps were run again`);
  },
  async game_save_load(page) {
    await hold(page, "ArrowUp", 2);
    assert.equal(await message(page), "Saved.");
    await hold(page, "Space", 2);
    assert.equal(await figureOf(page, "Bombs"), "5");
    await hold(page, "ArrowDown", 2);
    assert.equal(await message(page), "Loaded.");
    assert.equal(await figureOf(page, "Bombs"), "6");
  },
};

test("every_game_of_the_folder_is_played_here", () => {
  assert.deepEqual([...GAME_FILES.keys()].sort(), Object.keys(PLAYED).sort());
});

for (const [name, play] of Object.entries(PLAYED))
  test(`${name}_is_played_by_keys_and_begins_anew`, async () => {
    const { page, errors, close } = await openGame(name);
    const before = await page.textContent("#figures");
    await play(page);
    await hold(page, "Enter", 1);
    assert.equal(await page.textContent("#figures"), before);
    assert.ok(await page.isHidden("#failure"));
    assert.deepEqual(errors, []);
    await close();
  });

test("brick_breaker_is_played_by_a_pointer_and_by_two_thumbs", async () => {
  const desk = await openGame("game_brick_breaker");
  await desk.page.mouse.move(720, 500);
  await desk.page.mouse.down();
  await stepBy(desk.page, 120);
  await desk.page.mouse.up();
  assert.ok((await numberOf(desk.page, "Bricks")) < 40);
  assert.deepEqual(desk.errors, []);
  await desk.close();
  const { page, errors, close } = await openGame("game_brick_breaker", PHONE);
  const { hold: press, letGo } = await fingers(page);
  await press("left", "fire");
  await stepBy(page, 120);
  await letGo();
  assert.ok((await numberOf(page, "Bricks")) < 40);
  assert.deepEqual(errors, []);
  await close();
});

for (const browser of BROWSERS)
  test(`source_of_a_game_stands_beside_it_and_what_is_changed_runs_in_${browser}`, async (t) => {
    if (leftOut(browser)) return t.skip(leftOut(browser));
    const by = openVisitor({ browser });
    const { page, errors, close } = await openCode(by, "?scene=game_brick_breaker&paused=1&panel=code");
    const source = readFileSync(GAME_FILES.get("game_brick_breaker"), "utf8");
    await untilText(page, /import \{ aabb, circle, walls \} from "thud";/);
    assert.match(source, /\bballs: 3,/);
    await type(page, source.replace("balls: 3,", "balls: 7,"));
    await run(page);
    await untilStatus(page, "Your code runs");
    await until(() => figureOf(page, "Balls"), (balls) => balls === "7", "the balls of the changed code");
    await page.getByRole("tab", { name: "game_brick_breaker.c" }).click();
    await untilText(page, /brick_breaker\.c: brick breaker/);
    await page.click("#dock .close");
    await page.click("#scenes-button");
    await page.fill("#scene-search", "castle bombs");
    await page.press("#scene-search", "Enter");
    await page.waitForFunction(() => location.search.includes("scene=game_save_load"));
    assert.deepEqual(errors, []);
    await close();
  });

test("castle_with_words_on_its_buttons_has_no_violation_of_axe", async () => {
  for (const options of [DESKTOP, PHONE]) {
    const { page, errors, close } = await openGame("game_save_load", options);
    await untilStill(page);
    await page.getByRole("button", { name: "Save" }).waitFor();
    assert.deepEqual(await runAxeInBothThemes(page), []);
    assert.deepEqual(errors, []);
    await close();
  }
});
