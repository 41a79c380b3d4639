/**
 * Tests the laboratory's capsules and approximated polygon in the page: the numbers in the panel
 * against computations from the values of its sliders, by keyboard.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { BROWSERS, choose, DESKTOP, leftOut, near, openVisitor, PHONE, runAxe, rowsOf, stepBy } from "../support/page.mjs";
import { until } from "../support/wait.mjs";

const SCREENS = [["desktop", DESKTOP], ["phone", PHONE]];

/** The values of sliders, by their names. */
const valuesOf = (page, names) =>
  page.evaluate(
    (all) => Object.fromEntries(all.map((name) => [name, document.querySelector(`[name="set-${name}"]`).valueAsNumber])),
    names,
  );

const CAPSULE = ["xA1", "yA1", "xA2", "yA2", "radiusA", "xB1", "yB1", "radiusB"];

/** The distance of capsule A from B, a circle, by the values of the sliders. */
function distanceOf({ xA1, yA1, xA2, yA2, radiusA, xB1, yB1, radiusB }) {
  const [dx, dy] = [xA2 - xA1, yA2 - yA1];
  const part = Math.min(1, Math.max(0, ((xB1 - xA1) * dx + (yB1 - yA1) * dy) / (dx * dx + dy * dy)));
  return Math.hypot(xB1 - xA1 - part * dx, yB1 - yA1 - part * dy) - radiusA - radiusB;
}

/** Waits until the panel has the distance that belongs to its sliders; returns that and its rows. */
async function measured(page) {
  const distance = distanceOf(await valuesOf(page, CAPSULE));
  const rows = await until(
    () => rowsOf(page, "closest"),
    (found) => Math.abs(Number(found["Distance, segment − radius"]) - distance) < 0.001,
    `a distance of ${distance}`,
  );
  return { distance, rows };
}

for (const browser of BROWSERS)
  for (const [size, options] of SCREENS)
    test(`capsule_in_${browser}_on_a_${size}_has_the_distance_of_its_sliders`, { skip: leftOut(browser) }, async () => {
      const { page, errors, close } = await openVisitor({ browser }).open("?scene=lab_capsule&paused=1", options);
      await stepBy(page, 2);
      await choose(page, "set-kindB", "circle");
      const apart = await measured(page);
      assert.equal(apart.rows["They overlap"], "no");
      await page.click('details:has([name="set-radiusA"]) > summary');
      await page.focus('[name="set-radiusA"]');
      const before = (await valuesOf(page, ["radiusA"])).radiusA;
      await page.keyboard.press("End");
      near((await valuesOf(page, ["radiusA"])).radiusA, 2, 1e-9, `the radius, once ${before}`);
      await page.focus('[name="set-xA2"]');
      await page.keyboard.press("End");
      const { distance, rows } = await measured(page);
      assert.equal(rows["They overlap"], distance <= 0 ? "yes" : "no");
      assert.ok(distance < 0, "the thick capsule overlaps the circle");
      assert.match((await rowsOf(page, "way"))["The circle hits B"], /^at 0\.\d+ of its way$/);
      assert.deepEqual(await runAxe(page, "#dock"), []);
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth > innerWidth), false);
      assert.deepEqual(errors, []);
      await close();
    });

for (const browser of BROWSERS)
  for (const [size, options] of SCREENS)
    test(`approximation_in_${browser}_on_a_${size}_misses_less_with_more_pieces`, { skip: leftOut(browser) }, async () => {
      const { page, errors, close } = await openVisitor({ browser }).open("?scene=lab_approximate&paused=1", options);
      await stepBy(page, 2);
      await choose(page, "set-kinds", "circles");
      const withPieces = async (key) => {
        await page.focus('[name="set-count"]');
        await page.keyboard.press(key);
        const { count } = await valuesOf(page, ["count"]);
        const rows = await until(
          () => rowsOf(page, "missed"),
          (found) => found.Circles === String(count) && found.Boxes === "0",
          `${count} circles`,
        );
        return { count, rows };
      };
      const few = await withPieces("Home");
      const more = await withPieces("PageUp");
      assert.ok(few.count === 1 && more.count > 1);
      const error = ({ rows }) =>
        Number.parseFloat(rows["Area missed"]) + Number.parseFloat(rows["Area outside of the polygon"]);
      const distance = ({ rows }) => Number(rows["Distance missed, at most"]);
      assert.ok(error(more) < error(few), `${error(more)}, ${error(few)}`);
      assert.ok(distance(more) < distance(few), `${distance(more)}, ${distance(few)}`);
      assert.deepEqual(await runAxe(page, "#dock"), []);
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth > innerWidth), false);
      assert.deepEqual(errors, []);
      await close();
    });
