/**
 * Tests that the page keeps running with invalid addresses, invalid or endless scene code, and
 * scenes chosen in quick succession.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { linkOf, openCode, run, troubleOf, type, untilStatus } from "../support/code.mjs";
import {
  failureText,
  figure,
  impatiently,
  openVisitor,
  untilRunning,
  untilTold,
} from "../support/page.mjs";
import { until } from "../support/wait.mjs";

const RUNS = "Your code runs";

const visitor = openVisitor();

test("address_with_values_that_are_none_is_as_if_they_were_not_there", async () => {
  for (const search of [
    "?scene=cradle&size=-5&seed=1e99&quality=%F0%9F%92%A9&substeps=NaN&detection=__proto__",
    "?scene=cradle&view=1e300,0,10&panel=toString&broadphase=constructor",
    "?scene=cradle&view=0,0,1e300&error=-1&speed=1e9&split=x&box2d=3&step=0&hash=zz",
  ]) {
    const { page, errors, close } = await visitor.open(search);
    await untilRunning(page);
    assert.ok(await page.isHidden("#dock"));
    await page.waitForFunction(() => location.search === "?scene=cradle");
    assert.deepEqual(errors, []);
    await close();
  }
});

test("size_beyond_the_scenes_most_is_the_most_and_so_says_the_address", async () => {
  const { page, close } = await visitor.open("?scene=cradle&size=100000");
  await untilRunning(page);
  await page.waitForFunction(() => location.search === "?scene=cradle&size=100");
  await close();
});

test("scene_that_returns_nonsense_is_told_what_is_wrong", async () => {
  const { page, errors, close } = await openCode(visitor, "?scene=sketch&panel=code&paused=1");
  for (const [returned, told] of [
    ["view: { x: NaN, y: 0, height: 3 }", /view has finite numbers/],
    ["state: { act() {} }", /state is plain data/],
    ["keys: 'left'", /keys is a list/],
    ["paint: () => ({ marks: [{ kind: 'blob' }] })", /kind of a mark is one of line/],
    ["paint: () => ({ buttons: { shoot: 'Fire' } })", /buttons has a word for each key/],
  ]) {
    await type(
      page,
      `export default ({ createWorld }) => ({ world: createWorld(), ${returned} });`,
    );
    await run(page);
    assert.match(await troubleOf(page), told);
  }
  assert.deepEqual(errors, []);
  await close();
});

test("error_of_the_scene_before_is_not_told_while_the_next_starts", async () => {
  const { page, errors, close } = await openCode(visitor, "?scene=sketch&panel=code&paused=1");
  await type(
    page,
    `export default ({ createWorld }) =>
      ({ world: createWorld(), paint: () => ({ marks: [{ kind: "blob" }] }) });`,
  );
  await run(page);
  assert.match(await troubleOf(page), /kind of a mark is one of line/);
  await type(
    page,
    `export default async ({ createWorld }) => {
      await new Promise((done) => setTimeout(done, 1500));
      return { world: createWorld() };
    };`,
  );
  await run(page);
  // Each change of size has the scene that still runs painted again, which fails again.
  let painted = 0;
  while ((await page.locator(".code-status").textContent()) !== RUNS) {
    await page.setViewportSize({ width: 1000 + (painted++ % 2), height: 700 });
    assert.ok(await page.isHidden(".code-trouble"));
  }
  assert.ok(painted > 0);
  assert.deepEqual(errors, []);
  await close();
});

test("scene_that_is_slow_and_not_stuck_runs_in_the_end_without_a_click", async () => {
  const code = `export default ({ createWorld }) => {
    for (const end = Date.now() + 2500; Date.now() < end; );
    return { world: createWorld() };
  };`;
  const { page, errors, close } = await visitor.open(linkOf(code));
  // The page itself records that the message was shown: it may be visible for less time than a busy
  // machine needs to look.
  await page.evaluate(() => {
    const failure = document.querySelector("#failure");
    const observer = new MutationObserver(() => (failure.dataset.seen = "true"));
    observer.observe(failure, { attributes: true, attributeFilter: ["hidden"] });
  });
  await impatiently(page, async () => {
    await page.locator(".code-offer button").first().click();
    await page.waitForSelector("#failure[data-seen][hidden]", { state: "attached" });
  });
  await untilStatus(page, RUNS);
  assert.ok(await page.isHidden(".code-trouble"));
  assert.deepEqual(errors, []);
  await close();
});

test("code_that_keeps_ever_more_objects_is_ended_at_a_limit_and_the_page_goes_back", async () => {
  const code = `const kept = [];
  export default ({ createWorld }) => ({
    world: createWorld(),
    update() { kept.push({}); },
  });`;
  // Stands in for the browser's measurement, which takes many seconds: above a gigabyte from the
  // third call on.
  const measured = (page) =>
    page.addInitScript(() => {
      let times = 0;
      performance.measureUserAgentSpecificMemory = async () => ({
        bytes: ++times < 3 ? 2 ** 29 : 2 ** 30 + 1,
      });
    });
  const { page, errors, close } = await visitor.open(linkOf(code), undefined, measured);
  await page.locator(".code-offer button").first().click();
  await untilStatus(page, RUNS);
  assert.match(await failureText(page), /too much memory[\s\S]*more than 1 GB/);
  await page.click("#failure button");
  await untilStatus(page, "Changed, not run yet");
  await untilRunning(page);
  assert.ok(await page.isHidden("#failure"));
  assert.deepEqual(errors, []);
  await close();
});

test("of_scenes_chosen_at_once_the_last_runs", async () => {
  // The first scene's level is held back until the second scene runs.
  let send;
  const held = new Promise((done) => (send = done));
  const slow = async (page) => {
    await page.route("**/quarry.tmj", async (route) => {
      await held;
      await route.continue();
    });
  };
  const { page, errors, close } = await visitor.open("?scene=cradle", undefined, slow);
  await untilRunning(page);
  await page.waitForSelector("[data-entry=quarry]", { state: "attached" });
  const asked = page.waitForRequest("**/quarry.tmj");
  const level = page.waitForResponse("**/quarry.tmj");
  await page.evaluate(() => {
    for (const name of ["quarry", "tall_stack"])
      document.querySelector(`[data-entry=${name}]`).click();
  });
  await page.waitForFunction(() => /stack/i.test(document.title));
  await asked;
  send();
  await (await level).finished();
  await page.evaluate(() => document.querySelector("#restart").click());
  await untilTold(page, "from the beginning");
  await page.waitForFunction(() => Number(document.querySelector("#hud").dataset.steps) > 20);
  assert.match(await page.title(), /stack/i);
  await until(() => figure(page, "bodies"), (bodies) => bodies < 40, "bodies");
  assert.deepEqual(errors, []);
  await close();
});
