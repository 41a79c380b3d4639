/**
 * Tests the laboratory's terrain in the page: the numbers in the panel against weights that are
 * worked out here, by keyboard and by pointer, on a desktop and on a phone.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { BROWSERS, choose, DESKTOP, leftOut, near, openVisitor, PHONE, rowsOf, stepBy } from "../support/page.mjs";
import { until } from "../support/wait.mjs";

const valueOf = (page, name) =>
  page.evaluate((control) => document.querySelector(`[name="set-${control}"]`).valueAsNumber, name);

const numbers = (text) => text.split(" and ").map(Number);

/** Waits until the panel has the weights of the place that its slider has, and returns its rows. */
async function weighed(page) {
  await page.waitForSelector("[data-readings=weights] dd", { state: "attached" });
  const x = await valueOf(page, "x");
  const rows = await until(
    () => rowsOf(page, "weights"),
    (found) => {
      const [left, right] = numbers(found["At x"] ?? "");
      const weight = (right - x) / (right - left);
      return Math.abs(numbers(found["Their weights"])[0] - weight) < 0.011;
    },
    `the weights at ${x}`,
  );
  near(numbers(rows["Their weights"])[1], 1 - numbers(rows["Their weights"])[0], 0.011, "their sum");
  return rows;
}

for (const browser of BROWSERS)
  for (const [size, options] of [["desktop", DESKTOP], ["phone", PHONE]])
    test(`terrain_in_${browser}_on_a_${size}_has_the_weights_of_its_place`, { skip: leftOut(browser) }, async () => {
      const visitor = openVisitor({ browser });
      const { page, errors, close } = await visitor.open("?scene=lab_terrain&paused=1", options);
      await stepBy(page, 10);
      const before = await weighed(page);
      const start = await valueOf(page, "x");
      await page.click('details:has([name="set-x"]) > summary');
      await page.focus('[name="set-x"]');
      for (let i = 0; i < 10; i++) await page.keyboard.press("ArrowRight");
      near(await valueOf(page, "x"), start + 0.5, 1e-9, "the slider");
      const after = await weighed(page);
      assert.notEqual(after["Their weights"], before["Their weights"]);
      // Texture coordinates go evenly from vertex to vertex, and friction from end to end.
      const segment = Number(after["Between vertices"].split(" ")[0]);
      const u = (segment + numbers(after["Their weights"])[1]) / 8;
      near(Number(after["Texture coordinate"]), u, 0.011, "u");
      const [first, last] = [await valueOf(page, "left"), await valueOf(page, "right")];
      near(Number(after.Friction), (1 - u) * first + u * last, 0.011, "friction");
      await choose(page, "set-line", "uniform");
      const even = await until(() => rowsOf(page, "weights"), (rows) => rows["At x"] === "0.00 and 2.00", "uniform");
      near(numbers(even["Their weights"])[1], (start + 0.5) / 2, 0.011, "the weight by a division");
      const wide = await page.evaluate(() => document.documentElement.scrollWidth > innerWidth);
      assert.equal(wide, false);
      assert.deepEqual(errors, []);
      await close();
    });

test("vertex_is_dragged_by_the_pointer_and_the_place_by_a_press_beside_it", async () => {
  const { page, errors, close } = await openVisitor().open("?scene=lab_terrain&paused=1", DESKTOP);
  await stepBy(page, 10);
  // The panel, whose sliders tell the place, comes after the scene, and takes room from the view.
  await weighed(page);
  // Above the ground a press moves the place: two of them tell how long a unit is on the screen.
  const placeAt = async (px) => {
    await page.mouse.click(px, 260);
    const old = await valueOf(page, "x");
    await until(() => valueOf(page, "x"), (x) => Number.isFinite(x), "a place");
    await page.waitForTimeout(300);
    return (await valueOf(page, "x")) ?? old;
  };
  const [one, other] = [await placeAt(300), await placeAt(700)];
  const unit = 400 / (other - one);
  assert.ok(unit > 20 && unit < 120, `${one}, ${other}`);
  const vertex = await valueOf(page, "x6");
  const height = await valueOf(page, "y6");
  const px = 300 + (vertex - one) * unit;
  let py = 320;
  for (; py < 700 && (await valueOf(page, "y6")) === height; py += 25) {
    await page.mouse.move(px, py);
    await page.mouse.down();
    await page.mouse.move(px, py - unit, { steps: 4 });
    await page.mouse.up();
    await page.waitForTimeout(150);
  }
  near((await valueOf(page, "y6")) - height, 1, 0.65, "it is raised as far as the pointer went");
  await weighed(page);
  assert.deepEqual(errors, []);
  await close();
});
