/**
 * Tests a level that the visitor opens from a file: it is read or refused, is kept in the address,
 * and the browser's Back leaves it.
 */
import assert from "node:assert/strict";
import { randomBytes } from "node:crypto";
import { describe, test } from "node:test";
import {
  BROWSERS,
  DESKTOP,
  failureText,
  leftOut,
  openLevel,
  openVisitor,
  stepBy,
  untilBodies,
  untilRunning,
} from "../support/page.mjs";
import { ballLevel } from "../support/package.mjs";
import { drawnFrames } from "../support/versus.mjs";
import { until } from "../support/wait.mjs";

/** A level that is too large for an address: its random data do not compress. */
function largeLevel() {
  const level = JSON.parse(ballLevel());
  const value = randomBytes(40_000).toString("base64");
  level.properties = [...(level.properties ?? []), { name: "note", type: "string", value }];
  return JSON.stringify(level);
}

function untilTitle(page, wanted) {
  return until(() => page.title(), (title) => wanted.test(title), String(wanted));
}

/** Shares the scene; returns the link in the clipboard and the notice. */
async function share(page) {
  await page.keyboard.press("o");
  await page.click("#share");
  await page.waitForFunction(() => /link is in the clipboard/.test(document.querySelector("#notice").textContent));
  return { told: await page.innerText("#notice"), link: await page.evaluate(() => window.copied) };
}

const clipboard = (page) =>
  page.addInitScript(() =>
    Object.defineProperty(navigator, "clipboard", {
      value: { writeText: async (text) => void (window.copied = text) },
    }),
  );

function steps(page) {
  return page.evaluate(() => Number(document.querySelector("#hud").dataset.steps));
}

for (const browser of BROWSERS)
  describe(browser, () => {
    /** For tests of what the page's own code decides. */
    const LOGIC = { skip: leftOut(browser) };
    const visitor = openVisitor({ browser });

    test("file_that_cannot_be_read_leaves_the_own_level_before_it_running", LOGIC, async () => {
      const { page, close } = await visitor.open("?scene=cradle");
      await untilRunning(page);
      await openLevel(page, "ball.tmj", ballLevel());
      await untilTitle(page, /^ball/);
      await untilRunning(page);
      for (const text of ["{", '{"type":"map"}']) {
        const before = await steps(page);
        await openLevel(page, "broken.tmj", text);
        assert.match(await failureText(page), /This level cannot be run/);
        await page.click("#failure button");
        await page.waitForSelector("#failure", { state: "hidden" });
        await until(() => steps(page), (now) => now > before, "it goes on, and not anew");
        assert.match(await page.title(), /^ball/);
      }
      await page.keyboard.press("r");
      await untilBodies(page, 2);
      assert.ok(await page.isHidden("#failure"), "it begins anew from its own file");
      await close();
    });

    test("folder_with_too_many_files_says_that_not_all_were_looked_at", LOGIC, async () => {
      const { page, close } = await visitor.open("?scene=cradle&paused=1");
      await page.waitForSelector("[data-entry]", { state: "attached" });
      await page.evaluate(() => {
        const input = document.querySelector("#level-file");
        const chosen = new DataTransfer();
        for (let i = 0; i < 5000; i++) chosen.items.add(new File([""], `${i}.png`));
        chosen.items.add(new File(["{}"], "late.tmj"));
        input.files = chosen.files;
        input.dispatchEvent(new Event("change"));
      });
      const told = /no map .* among the first 5,000 files/;
      await until(() => page.textContent("#notice"), (text) => told.test(text), String(told));
      await close();
    });

    test("error_over_the_page_goes_when_a_level_that_works_is_dropped", LOGIC, async () => {
      const { page, close } = await visitor.open("?scene=cradle");
      await untilRunning(page);
      const isometric = JSON.stringify({ ...JSON.parse(ballLevel()), orientation: "isometric" });
      await openLevel(page, "isometric.tmj", isometric);
      assert.match(await failureText(page), /This level cannot be run/);
      await openLevel(page, "ball.tmj", ballLevel());
      await untilTitle(page, /^ball/);
      await page.waitForSelector("#failure", { state: "hidden" });
      await untilRunning(page);
      await close();
    });

    test("classes_that_mean_nothing_to_thud_get_a_line_each", LOGIC, async () => {
      const { page, close } = await visitor.open("?scene=cradle&paused=1");
      const level = JSON.parse(ballLevel());
      const objects = level.layers.flatMap((layer) => layer.objects ?? []);
      for (const object of objects) object.type = "enemy";
      await openLevel(page, "classes.tmj", JSON.stringify(level));
      await untilTitle(page, /^classes/);
      const line = new RegExp(`class “enemy” of ${objects.length} objects?`);
      await until(() => page.textContent("#notice"), (text) => line.test(text), String(line));
      await close();
    });

    test("link_carries_the_level_and_what_is_chosen", async () => {
      const { page, errors, close } = await visitor.open("?scene=cradle&paused=1", DESKTOP, clipboard);
      await openLevel(page, "my ball.tmj", ballLevel());
      await untilTitle(page, /^my ball/);
      await page.waitForFunction(() => location.hash.includes("level="));
      const { told, link } = await share(page);
      assert.match(told, /: level, choices/);
      await close();
      const other = await visitor.open(link.slice(link.indexOf("?")));
      await untilTitle(other.page, /^my ball/);
      await stepBy(other.page, 1);
      await untilBodies(other.page, 2);
      assert.deepEqual([...errors, ...other.errors], []);
      await other.close();
    });

    test("link_to_a_level_that_is_too_large_says_so_and_here_it_is_found_again", LOGIC, async () => {
      const { page, close } = await visitor.open("?scene=cradle&paused=1", DESKTOP, clipboard);
      await openLevel(page, "large.tmj", largeLevel());
      await untilTitle(page, /^large/);
      await page.waitForFunction(() => location.search.includes("own_level"));
      const { told, link } = await share(page);
      assert.match(told, /not the level, which is over 32 kB even packed/);
      await page.reload();
      await untilTitle(page, /^large/);
      await close();
      const other = await visitor.open(link.slice(link.indexOf("?")));
      assert.match(await failureText(other.page), /level is not in this link/i);
      await other.page.click("#failure button");
      await untilTitle(other.page, /^Brick wall/);
      await other.close();
    });

    test("back_and_forward_go_from_scene_to_scene_with_what_was_chosen_there", async () => {
      const { page, errors, close } = await visitor.open("?scene=cradle&quality=high");
      await untilRunning(page);
      await openLevel(page, "ball.tmj", ballLevel());
      await untilTitle(page, /^ball/);
      await page.waitForFunction(() => location.hash.includes("level="));
      await page.click("#scenes-button");
      await page.click('[data-entry="tumbler"]');
      await untilTitle(page, /^Tumbler/);
      await page.waitForFunction(() => location.search.includes("tumbler"));
      await page.keyboard.press(",");
      await page.waitForFunction(() => !location.search.includes("quality"));
      await page.evaluate(() => (window.stays = true));
      await page.goBack();
      await untilTitle(page, /^ball/);
      await page.goBack();
      await untilTitle(page, /^Rows of elastic/);
      await page.waitForFunction(() => /scene=cradle.*quality=high/.test(location.search));
      await page.goForward();
      await untilTitle(page, /^ball/);
      await untilBodies(page, 2);
      await page.goForward();
      await untilTitle(page, /^Tumbler/);
      await page.waitForFunction(() => !location.search.includes("quality"));
      assert.ok(await page.evaluate(() => window.stays), "nothing is loaded anew");
      assert.deepEqual(errors, []);
      await close();
    });

    test("back_again_while_an_address_is_read_leads_to_the_last_one_and_changes_none", LOGIC, async () => {
      const { page, errors, close } = await visitor.open("?scene=cradle");
      await untilRunning(page);
      await openLevel(page, "ball.tmj", ballLevel());
      await page.waitForFunction(() => location.hash.includes("level="));
      await page.click("#scenes-button");
      await page.click('[data-entry="tumbler"]');
      await page.waitForFunction(() => location.search.includes("tumbler"));
      // Unpacking the level waits until window.letGo is called.
      await page.evaluate(() => {
        const { DecompressionStream: Original } = window;
        const held = new Promise((done) => (window.letGo = done));
        window.DecompressionStream = function (format) {
          const { readable, writable } = new Original(format);
          const transform = (part, unpacked) => held.then(() => unpacked.enqueue(part));
          return { readable: readable.pipeThrough(new TransformStream({ transform })), writable };
        };
      });
      await page.goBack();
      await page.keyboard.press(",");
      assert.match(await page.evaluate(() => location.hash), /level=/, "the address is another’s");
      await page.goBack();
      await untilTitle(page, /^Rows of elastic/);
      await page.evaluate(() => window.letGo());
      await drawnFrames(page, 20);
      assert.match(await page.title(), /^Rows of elastic/);
      await page.waitForFunction(() => location.search.includes("cradle"));
      assert.deepEqual(errors, []);
      await close();
    });

    test("damaged_level_of_a_link_is_told", LOGIC, async () => {
      const { page, close } = await visitor.open("?scene=own_level#level=nonsense");
      assert.match(await failureText(page), /link is damaged/);
      await page.click("#failure button");
      await untilRunning(page);
      await close();
    });
  });
