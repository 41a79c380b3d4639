/**
 * Tests the section “Detection, priced” of the panel Trade: its errors against worlds that are run
 * here, its sentence against its table, and that it can be cancelled.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { createMotion, errorOf } from "../../../web/public/scenes/lab_prices/motions.js";
import { thud } from "../support/package.mjs";
import { BROWSERS, DESKTOP, leftOut, near, openVisitor, PHONE, runAxe, runAxeInBothThemes, untilRunning } from "../support/page.mjs";

const START = "text=Measure the detections";

/** The table: { motion, detection, rate, time, error } of each row, as they are written. */
function rowsOf(page) {
  return page.evaluate(() =>
    [...document.querySelectorAll("[data-price]")].map((row) => {
      const [motion, detection, rate] = row.dataset.price.split(",");
      const cells = [...row.cells].map((cell) => cell.textContent);
      return { motion, detection, rate: Number(rate), told: cells.slice(0, 2), time: Number(cells[2]), error: Number(cells[3]) };
    }),
  );
}

for (const browser of BROWSERS)
  for (const [size, options] of [["desktop", DESKTOP], ["phone", PHONE]])
    test(`detections_are_priced_in_${browser}_on_a_${size}`, { skip: leftOut(browser) }, async () => {
      const engine = await thud.load();
      const { page, errors, close } = await openVisitor({ browser }).open("?scene=lab_prices", options);
      // The scene opens the panel, and the section is the first there.
      await page.click(START);
      await page.waitForSelector("#prices-result canvas");
      const rows = await rowsOf(page);
      assert.equal(rows.length, 2 * 4 * 5);
      for (const { motion, detection, rate, told, time, error } of rows) {
        assert.deepEqual(told, [detection, String(rate)]);
        assert.ok(time > 0 && time < 1e4, `${time} ms`);
        const made = createMotion(engine, motion, detection, rate);
        for (let i = 0; i < 2 * rate; i++) made.world.step();
        near(error, 1000 * errorOf(made, motion, 2), 0.0051, `${motion}, ${detection} at ${rate}`);
        made.world.close();
      }
      const sentences = await page.locator("#prices-result .priced").allTextContents();
      for (const [i, motion] of ["shuttle", "hop"].entries()) {
        const own = rows.filter((row) => row.motion === motion);
        const best = Math.min(...own.map(({ error }) => error));
        const [, name, rate, off] =
          /^([A-Z][a-z]+) at (\d+) steps a second has the least error, ([\d.]+) mm for/.exec(sentences[i]);
        const named = own.find((row) => row.detection === name.toLowerCase() && row.rate === Number(rate));
        assert.deepEqual([named.error, Number(off)], [best, best], sentences[i]);
        const match = / ([a-z]+) at (\d+) steps a second is the cheapest/.exec(sentences[i]);
        if (!match) continue;
        const cheapest = own.find(({ detection, rate }) => detection === match[1] && rate === Number(match[2]));
        for (const row of own) if (row.error < 2 * best - 0.01) assert.ok(row.time >= cheapest.time, JSON.stringify(row));
      }
      // Bisection ends below the time of the hit, at a multiple of its tolerance.
      const calls = await page.$$eval("[data-call]", (found) =>
        found.map((row) => [Number(row.dataset.call), ...[...row.cells].map((cell) => cell.textContent)]),
      );
      assert.ok(calls.length > 6);
      for (const [halvings, name, , time, error] of calls) {
        assert.equal(name, halvings > 0 ? "bisect" : "swept");
        assert.ok(Number(time) > 0, `${time} µs`);
        let sum = 0;
        for (let i = 0; i < 64; i++) {
          const part = (0.5 + 0.618 * i) % 1;
          sum += (part - Math.floor(part * 2 ** halvings) / 2 ** halvings) * ((3 + 0.11 * i) / 60);
        }
        const mean = (1000 * sum) / 64;
        if (halvings > 0) near(Number(error) / mean, 1, 0.006, `error of ${halvings} halvings`);
        else assert.ok(Number(error) < 1e-9, `${error} mm of swept`);
      }
      // Firefox does not emulate the dark theme here.
      const axe = browser === "chromium" ? runAxeInBothThemes : runAxe;
      assert.deepEqual(await axe(page, "#dock"), []);
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth > innerWidth), false);
      assert.deepEqual(errors, []);
      await close();
    });

test("pricing_is_cancelled_by_keyboard_and_leaves_nothing", async () => {
  const { page, errors, close } = await openVisitor().open("?scene=lab_prices&panel=trade", DESKTOP);
  await page.focus(START);
  await page.keyboard.press("Enter");
  await page.waitForSelector('.work:has-text("steps a second")');
  await page.keyboard.press("Enter");
  await page.waitForSelector('.work:has-text("Cancelled.")');
  assert.deepEqual(await rowsOf(page), []);
  assert.deepEqual(errors, []);
  await close();
});

test("section_on_detections_is_alone_in_its_scene_and_the_last_of_the_panel_elsewhere", async () => {
  const { page, close } = await openVisitor().open("?scene=pyramid&size=8&panel=trade", DESKTOP);
  await untilRunning(page);
  const heads = () => page.locator("#dock .trade-part > h3:visible").allTextContents();
  await page.waitForSelector("#prices-heading", { state: "attached" });
  // The list of scenes comes after the first picture, and may come after the panel.
  await page.waitForSelector("[data-entry]", { state: "attached" });
  assert.deepEqual(await heads(), ["Measure", "Heavier", "Detection, priced"]);
  await page.evaluate(() => document.querySelector('[data-entry="lab_prices"]').click());
  await page.waitForFunction(() => document.title.startsWith("Detection, priced"));
  assert.deepEqual(await heads(), ["Detection, priced"]);
  assert.equal(await page.isVisible("#dock .live-plane"), false);
  await close();
});
