/** Tests that every scene, level and game of the page runs 300 steps without an error. */
import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import { test } from "node:test";
import { figure, openVisitor, stepBy } from "../support/page.mjs";
import { until } from "../support/wait.mjs";

const visitor = openVisitor();

/** A small window, which is cheap to draw; the tests do not look at the picture. */
const SMALL = { viewport: { width: 640, height: 480 } };
/**
 * Smaller sizes for scenes with thousands of bodies: the behaviour of the page does not depend on
 * the number. Building the page runs as many steps at the usual sizes (web/tools/hashes.mjs).
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
/** Scenes that have shapes but no bodies, or only one. */
const BODILESS = ["geometry", "lab_approximate", "lab_capsule", "lab_minkowski", "lab_prices", "lab_swept", "lab_volumes"];
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
    await until(() => figure(page, "bodies"), (bodies) => bodies > 1 || BODILESS.includes(name), "bodies told");
    assert.ok(await page.isHidden("#failure"));
    assert.deepEqual(errors, []);
    await close();
  });
