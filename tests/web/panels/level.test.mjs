/**
 * Tests levels that the visitor opens from files: maps in every format with the files they refer
 * to, and the reported problems.
 */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { figure, openVisitor, untilRunning } from "../support/page.mjs";
import { level, root } from "../support/package.mjs";
import { until } from "../support/wait.mjs";

const folder = `${root}tests/levels/maps/`;
const beside = ["tiles/ground.tsx", "tiles/things.tsj", "templates/crate.tx", "templates/plank.tj"];
const open = (path) => readFileSync(folder + path);

const visitor = openVisitor();

async function bodiesOf(file) {
  return (await level.readLevel(file, open(file), { open, skip: true })).bodies.length;
}

async function choose(page, files) {
  await page.waitForSelector("[data-entry]", { state: "attached" });
  await page.setInputFiles("#level-file", files.map((file) => folder + file));
}

async function untilBodies(page, wanted) {
  await until(() => figure(page, "bodies"), (bodies) => bodies === wanted, `${wanted} bodies`);
}

for (const file of ["props.tmx", "zstd.tmj", "infinite.tmx"])
  test(`level_${file}_chosen_with_the_files_that_it_refers_to_is_whole`, async () => {
    const { page, errors, close } = await visitor.open("?scene=cradle");
    await untilRunning(page);
    await choose(page, [file, ...beside]);
    await untilBodies(page, await bodiesOf(file));
    assert.deepEqual(errors, []);
    await close();
  });

test("map_that_is_dropped_with_its_files_runs", async () => {
  const { page, errors, close } = await visitor.open("?scene=cradle");
  await untilRunning(page);
  const files = ["shapes.tmx", ...beside].map((path) => ({
    name: path.slice(path.indexOf("/") + 1),
    text: open(path).toString("utf8"),
  }));
  await page.waitForSelector("[data-entry]", { state: "attached" });
  await page.evaluate((given) => {
    const dataTransfer = new DataTransfer();
    for (const { name, text } of given) dataTransfer.items.add(new File([text], name));
    document.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true }));
  }, files);
  await untilBodies(page, await bodiesOf("shapes.tmx"));
  assert.deepEqual(errors, []);
  await close();
});

test("all_that_a_level_does_without_is_listed_and_stays_at_hand", async () => {
  const { page, errors, close } = await visitor.open("?scene=cradle");
  await untilRunning(page);
  await choose(page, ["wrong.tmj", ...beside]);
  await page.click("#notice button");
  const { problems } = await level.readLevel("wrong", open("wrong.tmj"), { open, skip: true });
  const lines = () => page.$$eval("#notes[open] li", (items) => items.map((item) => item.textContent));
  assert.deepEqual(
    (await lines()).map((line) => line.replace(/^[^:]*: /, "")).sort(),
    problems.map(({ text }) => text).sort(),
  );
  await page.click("#notes .close");
  // The list is still available after the notice has gone.
  await page.click("#scenes-button");
  await page.click("#notes-button");
  assert.equal((await lines()).length, problems.length);
  await page.click("#notes .close");
  // Another scene has no problems to report.
  await page.click("#scenes-button");
  await page.click('[data-entry="towers"]');
  await page.waitForFunction(() => document.querySelector("#notes-button").hidden);
  assert.deepEqual(errors, []);
  await close();
});

test("files_without_a_map_are_told_and_the_scene_goes_on", async () => {
  const { page, errors, close } = await visitor.open("?scene=cradle");
  await untilRunning(page);
  await choose(page, beside);
  await page.waitForFunction(() => /no map/.test(document.querySelector("#notice").textContent));
  assert.match(await page.title(), /elastic balls/);
  assert.deepEqual(errors, []);
  await close();
});
