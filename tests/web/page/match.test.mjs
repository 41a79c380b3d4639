/**
 * Tests matches between browsers: over WebRTC, with packets that are late and lost, all players’
 * worlds stay the same.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { openVisitor } from "../support/page.mjs";
import { until } from "../support/wait.mjs";

/** The step up to which a match is played. */
const LAST = 240;

/** Sets a slider as a visitor does. */
function slide(page, id, value) {
  return page.locator(id).fill(String(value));
}

/** The last step of which all is known, with its hash, and the figures of the panel by their names. */
function figures(page) {
  return page.evaluate(() => {
    const list = document.querySelector("#match-figures");
    const texts = (tag) => [...list.querySelectorAll(tag)].map(({ textContent }) => textContent);
    const values = texts("dd");
    const rows = Object.fromEntries(texts("dt").map((name, i) => [name, values[i]]));
    return { step: Number(list.dataset.step ?? -1), hash: list.dataset.hash, rows };
  });
}

/** Opens two pages and connects them by a link and its answer, which are copied by hand. */
async function connect(first, second) {
  const host = await openVisitor({ browser: first }).open("?scene=sumo&panel=match");
  await host.page.click("#match-invite");
  const link = await host.page.inputValue("#match-link");
  const { search, hash } = new URL(link);
  const guest = await openVisitor({ browser: second }).open(search + hash);
  await guest.page.click("#match-join");
  await host.page.fill("#match-answer", await guest.page.inputValue("#match-link"));
  await host.page.waitForSelector("#match-start:visible");
  await guest.page.waitForSelector("#match-leave:visible");
  return [host, guest];
}

test("chromium_and_firefox_play_a_match_over_a_bad_line_and_stay_the_same", async () => {
  const both = await connect("chromium", "firefox");
  const pages = both.map(({ page }) => page);
  for (const page of pages) {
    await slide(page, "#match-delay", 60);
    await slide(page, "#match-loss", 10);
  }
  await pages[0].click("#match-start");
  // Each drives to and fro by itself; what is final is compared step by step.
  const seen = pages.map(() => new Map());
  let held = false;
  await until(
    async () => {
      held = !held;
      for (const page of pages) {
        await page.locator("#overlay").focus();
        await (held ? page.keyboard.down("ArrowRight") : page.keyboard.up("ArrowRight"));
      }
      const told = await Promise.all(pages.map(figures));
      told.forEach(({ step, hash }, i) => seen[i].set(step, hash));
      return told;
    },
    (told) => told.every(({ step }) => step >= LAST),
    `a match of ${LAST} steps`,
  );
  const common = [...seen[0].keys()].filter((step) => step > 0 && seen[1].has(step));
  assert.ok(common.length > 0, "no step whose hash both have told");
  for (const step of common) assert.equal(seen[0].get(step), seen[1].get(step), `step ${step}`);
  for (const { page, errors } of both) {
    const { rows } = await figures(page);
    assert.ok(Number(rows["Equal states"]) > 5, JSON.stringify(rows));
    assert.ok(Number(rows["Rollbacks"]) > 0, "nothing was late");
    assert.ok(Number.parseInt(rows["There and back"], 10) >= 100, JSON.stringify(rows));
    assert.equal(rows["Refused packets"], "0");
    assert.equal(await page.textContent(".match .bad"), "");
    assert.deepEqual(errors, []);
  }
  for (const { close } of both) await close();
});
