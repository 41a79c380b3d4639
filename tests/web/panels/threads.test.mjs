/** Tests the choice of threads in the panel Options. */
import assert from "node:assert/strict";
import { availableParallelism } from "node:os";
import { test } from "node:test";
import { buildScene, runScene, USUAL_OPTIONS } from "../../../web/tools/scenes.mjs";
import { listed, show } from "../support/inside.mjs";
import { choose, openVisitor, stepBy } from "../support/page.mjs";
import { thud } from "../support/package.mjs";
import { until } from "../support/wait.mjs";

/** Large enough that threads share its steps. */
const SIZE = 40;
const STEPS = 10;

/** In Chromium alone: see startsNoWorker of packed.mjs. */
const visitor = openVisitor();
const skip = availableParallelism() < 2 && "one processor";

test("scene_runs_on_as_many_threads_as_are_chosen_with_the_same_bits", { skip }, async () => {
  const { page, errors, close } = await visitor.open(`?scene=pyramid&size=${SIZE}&paused=1&panel=options`);
  const scripts = () => page.workers().filter((worker) => /\/thread-[^/]*\.js$/.test(worker.url())).length;
  await page.waitForSelector('[name=threads][value="1"]:checked', { state: "attached" });
  assert.equal(scripts(), 0);
  await choose(page, "threads", "2");
  await until(async () => scripts(), (count) => count === 1, "a thread is started");
  // The scene is built anew with the thread; steps that are asked for before are not made.
  const steps = () => page.evaluate(() => Number(document.querySelector("#hud").dataset.steps ?? 0));
  await until(
    async () => {
      await page.keyboard.press(".");
      return steps();
    },
    (count) => count > 0,
    "a step with the thread",
  );
  await stepBy(page, STEPS);
  assert.ok(await page.isChecked('[name=threads][value="2"]'));
  await page.click("[data-panel=inside]");
  await show(page, "bits");
  await page.waitForSelector("#hash-now > div");
  const now = await until(
    () => listed(page, "#hash-now"),
    ({ step }) => Number(step) > STEPS,
    "the hash of the last step",
  );
  const { scene, close: end } = await buildScene(await thud.load(), "pyramid", {
    size: SIZE,
    choices: USUAL_OPTIONS,
  });
  runScene(scene, Number(now.step));
  assert.ok(Object.values(now).includes(scene.world.hash()));
  end();
  assert.deepEqual(errors, []);
  await close();
});
