/** Tests the games with keys and with touch: what a player holds must take effect. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { DESKTOP, figure, openVisitor, PHONE, stepBy, untilRunning } from "../support/page.mjs";
import { figureOf, fingers } from "../support/games.mjs";
import { until } from "../support/wait.mjs";

const visitor = openVisitor();

/** Opens a game, paused after its first step. */
async function openGame(name, options = DESKTOP) {
  const opened = await visitor.open(`?scene=${name}&paused=1`, options);
  await stepBy(opened.page, 1);
  await opened.page.waitForSelector("#message:not([hidden])");
  return opened;
}

async function coins(page) {
  return Number.parseInt(await figureOf(page, "Coins"), 10);
}

function message(page) {
  return page.textContent("#message");
}

// Two coins are on the way to a block that is two metres high, and one is above it.

test("platformer_right_key_takes_the_coins_on_the_ground_and_space_leaps_to_the_next", async () => {
  const { page, errors, close } = await openGame("platformer_game");
  assert.equal(await coins(page), 0);
  await page.keyboard.down("ArrowRight");
  await stepBy(page, 150);
  assert.equal(await coins(page), 2);
  // Jump onto the block, and to the coin.
  for (let i = 0; i < 3; i++) {
    await page.keyboard.down("Space");
    await stepBy(page, 30);
    await page.keyboard.up("Space");
    await stepBy(page, 20);
  }
  assert.ok((await coins(page)) > 2, "no jump");
  assert.ok(await page.locator("#pause[aria-pressed=true]").isVisible(), "Space is the game's");
  await page.keyboard.up("ArrowRight");
  await page.keyboard.down("Enter");
  await stepBy(page, 2);
  assert.equal(await coins(page), 0, "Enter begins anew");
  assert.deepEqual(errors, []);
  await close();
});

test("platformer_let_go_of_a_key_stops_and_restart_begins_anew", async () => {
  const { page, errors, close } = await openGame("platformer_game");
  await page.keyboard.down("d");
  await page.keyboard.up("d");
  await stepBy(page, 150);
  assert.equal(await coins(page), 0);
  await page.keyboard.down("d");
  await stepBy(page, 150);
  assert.equal(await coins(page), 2);
  await page.keyboard.up("d");
  await page.click("#restart");
  await page.waitForFunction(() => document.querySelector("#hud").dataset.steps === "0");
  await page.keyboard.down("Space");
  await stepBy(page, 5);
  await page.keyboard.up("Space");
  assert.equal(await coins(page), 0);
  const steps = await page.evaluate(() => Number(document.querySelector("#hud").dataset.steps));
  assert.ok(steps >= 5, "Space pressed the button again");
  assert.deepEqual(errors, []);
  await close();
});

test("platformer_is_played_with_two_thumbs_on_a_phone", async () => {
  const { page, errors, close } = await openGame("platformer_game", PHONE);
  const { hold, letGo } = await fingers(page);
  await hold("right");
  await stepBy(page, 150);
  assert.equal(await coins(page), 2);
  await letGo();
  for (let i = 0; i < 3; i++) {
    await hold("right", "up");
    await stepBy(page, 30);
    await letGo();
    await stepBy(page, 20);
  }
  assert.ok((await coins(page)) > 2, "no jump");
  assert.deepEqual(errors, []);
  await close();
});

test("pad_is_for_games_alone_and_hidden_where_there_is_a_keyboard", async () => {
  for (const [options, shown] of [[PHONE, true], [DESKTOP, false]]) {
    const { page, close } = await openGame("platformer_game", options);
    assert.equal(await page.locator("[data-key=right]").isVisible(), shown);
    await page.click("#scenes-button");
    await page.click('[data-entry="cradle"]');
    await page.waitForFunction(() => document.title.startsWith("Rows of elastic"));
    assert.equal(await page.locator("[data-key=right]").isVisible(), false);
    assert.equal(await page.locator("button[data-tool=hand]").isVisible(), true);
    await close();
  }
});

/** Makes steps until the game shows this message. */
async function untilSaid(page, wanted) {
  for (let i = 0; i < 40 && !wanted.test(await message(page)); i++) await stepBy(page, 30);
  assert.match(await message(page), wanted);
}

test("artillery_by_keys_a_shot_is_aimed_fired_and_answered", async () => {
  const { page, errors, close } = await openGame("artillery");
  await page.keyboard.down("ArrowLeft");
  await stepBy(page, 2);
  await page.keyboard.up("ArrowLeft");
  await untilSaid(page, /^Your turn/);
  assert.equal(await figureOf(page, "Computer"), "100");
  await page.keyboard.down("Space");
  await stepBy(page, 2);
  await page.keyboard.up("Space");
  await untilSaid(page, /A miss|Hit|out of the field/);
  await untilSaid(page, /computer aims/);
  await untilSaid(page, /^Your turn/);
  assert.match(await page.textContent("#status"), /Your turn/, "said to screen readers");
  assert.deepEqual(errors, []);
  await close();
});

test("artillery_by_touch_two_players_are_chosen_and_the_button_fires", async () => {
  const { page, errors, close } = await openGame("artillery", PHONE);
  const { hold, letGo } = await fingers(page);
  await hold("right");
  await stepBy(page, 2);
  await letGo();
  await untilSaid(page, /^Left’s turn/);
  await hold("fire");
  await stepBy(page, 2);
  await letGo();
  await untilSaid(page, /A miss|Hit|out of the field/);
  await untilSaid(page, /^Right’s turn/);
  assert.deepEqual(errors, []);
  await close();
});

test("artillery_with_another_tool_than_the_hand_takes_that", async () => {
  const { page, errors, close } = await openGame("artillery");
  const bodies = await until(() => figure(page, "bodies"), (told) => told > 0, "bodies told");
  await page.keyboard.press("c");
  await page.mouse.click(500, 300);
  await stepBy(page, 2);
  await page.waitForFunction(
    (wanted) => document.querySelector('[data-value="bodies"]').textContent === String(wanted),
    bodies + 1,
  );
  assert.match(await message(page), /two players/, "nothing is chosen by that");
  assert.deepEqual(errors, []);
  await close();
});

/**
 * The place of a world point on the canvas; the bridge builder's view is 18 by 15.5 m around (4,
 * 1.2).
 */
async function onScreen(page, x, y) {
  const { top, bottom, width } = await page.evaluate(() => {
    const boxOf = (id) => document.getElementById(id).getBoundingClientRect();
    return { top: boxOf("top").bottom + 8, bottom: boxOf("bottom").top - 8, width: innerWidth };
  });
  const scale = Math.min((width - 32) / 18, (bottom - top) / 15.5);
  return { x: width / 2 + scale * (x - 4), y: (top + bottom) / 2 - scale * (y - 1.2) };
}

test("bridge_builder_by_touch_a_road_is_drawn_driven_on_and_breaks", async () => {
  const { page, errors, close } = await openGame("bridge_builder", PHONE);
  assert.doesNotMatch(await page.innerText("#words"), /Buttons:/, "they say it themselves");
  const touch = await page.context().newCDPSession(page);
  const finger = async (type, ...place) => {
    const touchPoints = place.length > 0 ? [await onScreen(page, ...place)] : [];
    await touch.send("Input.dispatchTouchEvent", { type, touchPoints });
    await stepBy(page, 1);
  };
  await finger("touchStart", 0, 0);
  await finger("touchMove", 8, 0);
  await finger("touchEnd");
  assert.equal(await figureOf(page, "Money"), "600");
  const { hold, letGo } = await fingers(page);
  await hold("fire");
  await stepBy(page, 2);
  await letGo();
  await page.locator("[data-key=fire][data-word=Stop]").waitFor();
  assert.equal(await page.locator("[data-key=left]").isVisible(), false, "nothing to undo now");
  await untilSaid(page, /gave way/);
  assert.deepEqual(errors, []);
  await close();
});

test("buttons_with_words_are_there_for_the_mouse_and_take_no_space_bar", async () => {
  const { page, errors, close } = await openGame("bridge_builder");
  await page.mouse.move(...Object.values(await onScreen(page, 0, 0)));
  await page.mouse.down();
  await stepBy(page, 1);
  await page.mouse.move(...Object.values(await onScreen(page, 8, 0)));
  await stepBy(page, 1);
  await page.mouse.up();
  await stepBy(page, 1);
  assert.equal(await figureOf(page, "Money"), "600");
  const undo = page.getByRole("button", { name: "Undo" });
  await undo.hover();
  await page.mouse.down();
  await stepBy(page, 1);
  await page.mouse.up();
  assert.equal(await figureOf(page, "Money"), "1000");
  await page.keyboard.down("Space");
  await stepBy(page, 2);
  await page.keyboard.up("Space");
  await page.getByRole("button", { name: "Stop" }).waitFor();
  assert.deepEqual(errors, []);
  await close();
});

test("level_with_a_walker_on_a_phone_has_pad_and_tools_a_game_the_pad_and_the_hand", async () => {
  const { page, errors, close } = await visitor.open("?scene=platform", PHONE);
  await untilRunning(page);
  assert.equal(await page.locator("[data-key=right]").isVisible(), true);
  await page.tap("button[data-tool=circle]");
  await page.tap("#scenes-button");
  await page.tap('[data-entry="artillery"]');
  await page.waitForFunction(() => document.title.startsWith("Artillery"));
  const hand = page.locator("button[data-tool=hand]");
  assert.equal(await hand.isVisible(), false);
  assert.equal(await hand.getAttribute("aria-pressed"), "true");
  assert.deepEqual(errors, []);
  await close();
});

test("view_follows_the_figure_of_the_platformer_and_stands_while_it_stands", async () => {
  const { page, errors, close } = await openGame("platformer_game", PHONE);
  // The view moves smoothly: it has arrived when the picture has not changed for ten frames and for
  // 1.5 s.
  const backdrop = () =>
    page.evaluate(async () => {
      const see = () => document.querySelector("#backdrop").toDataURL();
      let [last, since, pictures] = [see(), performance.now(), 0];
      while (pictures < 10 || performance.now() - since < 1500) {
        const time = await new Promise(requestAnimationFrame);
        const now = see();
        if (now === last) pictures++;
        else [last, since, pictures] = [now, time, 0];
      }
      return last;
    });
  await stepBy(page, 60);
  const before = await backdrop();
  await stepBy(page, 10);
  assert.equal((await backdrop()) === before, true, "it moves by itself");
  await page.keyboard.down("d");
  await stepBy(page, 150);
  assert.equal((await backdrop()) === before, false, "it stays behind");
  assert.deepEqual(errors, []);
  await close();
});
