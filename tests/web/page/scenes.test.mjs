/** Every scene, level and game of the page runs 300 steps. */
import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import { after, before, test } from "node:test";
import { figure, openVisitor, stepBy } from "../support/page.mjs";
import { until } from "../support/wait.mjs";

let visitor;
before(async () => {
  visitor = await openVisitor();
});
after(() => visitor.close());

/** Nothing is asked of the picture, which a larger window makes dear to draw. */
const SMALL = { viewport: { width: 640, height: 480 } };
/**
 * Sizes of scenes that have thousands of bodies: what the page does with them does not depend on the
 * number. As many steps of the usual size are made when the page is built (web/tools/hashes.mjs).
 */
const FEWER = {
  asleep: 1000,
  avalanche: 500,
  circle_pit: 1000,
  gas: 1000,
  hourglass: 500,
  mixed_terrain: 400,
  one_spot: 400,
  pyramid: 30,
  sizes: 400,
  smash: 600,
  tumbler: 200,
  tumbler_half: 200,
};
const OWN_LEVEL = "own_level";
/** Has shapes without a world. */
const BODILESS = "geometry";
const names = readdirSync(new URL("../../../web/public/scenes", import.meta.url))
  .filter((file) => file.endsWith(".js"))
  .map((file) => file.replace(/\.js$/, ""))
  .filter((name) => name !== OWN_LEVEL);

for (const name of names)
  test(`scene_${name}_runs_300_steps_in_the_page`, async () => {
    const size = name in FEWER ? `&size=${FEWER[name]}` : "";
    const { page, errors, close } = await visitor.open(`?scene=${name}&paused=1${size}`, SMALL);
    await page.waitForFunction(() => document.title !== "thud");
    for (let i = 0; i < 3; i++) await stepBy(page, 100);
    const steps = await page.evaluate(() => document.querySelector("#hud").dataset.steps);
    assert.equal(steps, "300");
    await until(() => figure(page, "bodies"), (bodies) => bodies > 1 || name === BODILESS, "bodies told");
    assert.ok(await page.isHidden("#failure"));
    assert.deepEqual(errors, []);
    await close();
  });
