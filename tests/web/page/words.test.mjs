/** Tests the page's texts: instructions for keys or for touch, and plain labels. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { DESKTOP, openVisitor, PHONE, stepBy } from "../support/page.mjs";

const visitor = openVisitor();

/** Matches instructions that need a keyboard. */
const OF_KEYBOARDS = /arrow keys|Space|Enter|\bkeys?\b|\bA D\b/i;

const PLAYED = [
  ["platformer_game", /walk.*jump.*drop through planks/],
  ["platform", /walk.*jump.*drop through planks/],
  ["mountain", /walk.*jump/],
  ["artillery", /turn the barrel.*power.*fire/],
  ["sketch", /push the ball.*lift it/],
];

for (const [scene, deeds] of PLAYED)
  test(`${scene}_tells_how_it_is_played_by_keys_and_on_a_phone_by_its_buttons`, async () => {
    for (const [options, told, untold] of [
      [DESKTOP, /Keys: ← → or A D to .*Space to/, /buttons/i],
      [PHONE, /Buttons: ← → to /, OF_KEYBOARDS],
    ]) {
      const { page, errors, close } = await visitor.open(`?scene=${scene}&paused=1`, options);
      // The notice fades out by itself, but its text remains in the document.
      await page.locator("#notice", { hasText: deeds }).waitFor({ state: "attached" });
      const notice = await page.textContent("#notice");
      assert.match(notice, told);
      assert.doesNotMatch(notice, untold);
      if (options === PHONE) assert.doesNotMatch(await page.innerText("#words"), OF_KEYBOARDS);
      const label = await page.getAttribute("[data-key=left]", "aria-label");
      assert.match(label, /^left: (walk|turn the barrel|push the ball)$/);
      assert.deepEqual(errors, []);
      await close();
    }
  });

test("artillery_on_a_phone_asks_for_no_key", async () => {
  const { page, close } = await visitor.open("?scene=artillery&paused=1", PHONE);
  await stepBy(page, 1);
  await page.keyboard.down("ArrowLeft");
  await stepBy(page, 2);
  await page.locator("#message", { hasText: "turn" }).waitFor();
  assert.doesNotMatch(await page.innerText("#message"), OF_KEYBOARDS);
  await close();
});

test("panel_inside_on_a_phone_asks_for_no_key", async () => {
  const { page, close } = await visitor.open("?scene=cradle&paused=1&panel=inside", PHONE);
  await page.locator(".parts label", { hasText: "Body" }).tap();
  await page.locator("#dock", { hasText: "Tap a body" }).waitFor();
  assert.doesNotMatch(await page.innerText("#dock"), OF_KEYBOARDS);
  await close();
});

test("help_says_how_to_move_jump_fire_and_pause_and_what_a_touch_screen_has", async () => {
  const { page, close } = await visitor.open("?scene=towers&paused=1");
  await stepBy(page, 1);
  await page.keyboard.press("h");
  const help = await page.innerText("#help");
  for (const told of [/A D move/, /Space jumps/, /drops/, /Space fires/, /P pauses/, /touch screen/])
    assert.match(help, told);
  await close();
});

/** [panel, selector of the element, text that it must contain] */
const LABELS = [
  ["versus", "#versus", /Share of 16\.7 ms/],
  ["trade", ".trade", /Overlap limit/],
  ["options", "#dock", /Random seed/],
  ["code", ".code-status", /Runs unchanged/],
];

for (const [panel, within, words] of LABELS)
  test(`labels_of_${panel}_are_plain_words`, async () => {
    const { page, close } = await visitor.open(`?scene=cradle&paused=1&panel=${panel}`);
    await stepBy(page, 1);
    await page.locator(within, { hasText: words }).first().waitFor();
    assert.doesNotMatch(
      await page.innerHTML("#dock"),
      /Beside each other, on|Runs as it comes|Seed of chance|Largest error|>Of 16\.7|accurate/i,
    );
    await close();
  });

test("no_scene_claims_that_sleep_costs_nothing_over_bodies_that_are_awake", async () => {
  const { page, close } = await visitor.open("?scene=asleep&size=20&paused=1");
  await stepBy(page, 1);
  await page.keyboard.press("l");
  await page.waitForSelector("[data-entry=asleep]");
  assert.doesNotMatch(await page.innerText("#scenes"), /costs nothing/);
  assert.doesNotMatch(await page.getAttribute("#hud .awake", "title"), /costs nothing/);
  await close();
});
