/** Every scene and level of the page runs 300 steps. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { figure, openVisitor, stepBy } from "./page-support.mjs";
import { demoWasm, levelFiles, sceneNames, thud } from "./support.mjs";

let visitor;
before(async () => {
  visitor = await openVisitor();
});
after(() => visitor.close());

const searches = [
  ...levelFiles.map((file) => `level=${file.replace(/\.tmj$/, "")}`),
  ...sceneNames(await thud.load(demoWasm)).map((name) => `scene=${name}`),
];

for (const search of searches)
  test(`${search}_runs_300_steps_in_the_page`, { timeout: 180_000 }, async () => {
    const { page, errors, close } = await visitor.open(`?${search}&paused=1`);
    await page.waitForFunction(() => document.title !== "thud");
    for (let i = 0; i < 10; i++) await stepBy(page, 30);
    const steps = await page.evaluate(() => document.querySelector("#hud").dataset.steps);
    assert.equal(steps, "300");
    assert.ok((await figure(page, "bodies")) > 1);
    assert.ok(await page.isHidden("#failure"));
    assert.deepEqual(errors, []);
    await close();
  });
