/**
 * Tests time on the page: pause, single steps, slow motion, rewinding, and commands after
 * rewinding.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  choose,
  DESKTOP,
  openVisitor,
  PHONE,
  pressed,
  stepBy,
  untilRunning,
} from "../support/page.mjs";
import { untilStep } from "../support/wait.mjs";

const SIZES = [["desktop", DESKTOP], ["phone", PHONE]];
/** Steps: more than ten seconds. */
const LONG = 660;

const visitor = openVisitor();

/** Opens a paused scene with the panel that shows the hash of the state. */
async function openStill(scene, options = DESKTOP) {
  const opened = await visitor.open(`?scene=${scene}&paused=1&panel=inside`, options);
  await opened.page.waitForSelector("[name=inside]", { state: "attached" });
  await choose(opened.page, "inside", "bits");
  return opened;
}

function stepOf(page) {
  return page.evaluate(() => Number(document.querySelector("#hud").dataset.steps));
}

/**
 * The number of pictures drawn until it is `most`, or until the scene has made `steps` more steps.
 */
function countPictures(page, most, steps = Infinity) {
  return page.evaluate(
    ([end, more]) =>
      new Promise((done) => {
        const { dataset } = document.querySelector("#hud");
        const before = Number(dataset.steps);
        let made = 0;
        const next = () => {
          if (made === end || Number(dataset.steps) >= before + more) done(made);
          else requestAnimationFrame(() => next(made++));
        };
        next();
      }),
    [most, steps],
  );
}

/** The hash that the panel shows, once it shows that of `step`. */
async function hashAt(page, step) {
  await page.waitForFunction(
    (wanted) => document.querySelector("#hash-now dd")?.textContent === String(wanted),
    step,
  );
  return page.textContent("#hash-now > div:nth-child(2) dd");
}

/**
 * Moves the slider to a step by an event, because a phone's panel covers the slider. Steps
 * requested before have been made when it returns.
 */
async function scrubTo(page, step) {
  await page.evaluate((value) => {
    const slider = document.getElementById("time");
    slider.value = String(value);
    slider.dispatchEvent(new Event("input", { bubbles: true }));
  }, step);
  await untilStep(page, step);
}

test("pause_stops_time_and_a_step_is_one_step", async () => {
  const { page, errors, close } = await visitor.open("?scene=cradle");
  await untilRunning(page);
  await page.click("#pause");
  assert.ok(await pressed(page, "pause"));
  // Steps that were requested before the pause still arrive, and do so before step 0 is shown.
  await scrubTo(page, 0);
  await countPictures(page, 20);
  assert.equal(await stepOf(page), 0);
  await page.click("#step");
  await untilStep(page, 1);
  await page.keyboard.press(".");
  await untilStep(page, 2);
  await page.keyboard.press("z");
  await untilStep(page, 1);
  assert.deepEqual(errors, []);
  await close();
});

test("slow_motion_takes_many_pictures_for_few_steps", async () => {
  const { page, close } = await visitor.open("?scene=cradle&speed=0.1");
  await untilRunning(page);
  const steps = 12;
  const pictures = await countPictures(page, Infinity, steps);
  // A picture advances time by at most 0.1 s of the display's time: 0.6 steps at a tenth of the
  // speed.
  assert.ok(pictures >= steps / 0.6 - 4, `${pictures} pictures`);
  await close();
});

for (const [size, options] of SIZES)
  test(`rewound_eleven_seconds_and_run_again_it_has_the_same_hash_on_a_${size}`, async () => {
    const { page, errors, close } = await openStill("tall_stack", options);
    await stepBy(page, 20);
    const early = await hashAt(page, 20);
    await stepBy(page, LONG - 20);
    const late = await hashAt(page, LONG);
    assert.notEqual(late, early);
    await scrubTo(page, 20);
    assert.equal(await hashAt(page, 20), early);
    await page.keyboard.press("z");
    await untilStep(page, 19);
    // Step forward from the past: recorded steps are shown first, later steps are computed again.
    await scrubTo(page, 300);
    await stepBy(page, LONG - 300);
    assert.equal(await hashAt(page, LONG), late);
    assert.deepEqual(errors, []);
    await close();
  });

test("slider_is_moved_by_its_own_keys", async () => {
  const { page, errors, close } = await visitor.open("?scene=cradle&paused=1");
  await stepBy(page, 30);
  await page.focus("#time");
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("ArrowLeft");
  await untilStep(page, 28);
  await page.keyboard.press("Home");
  await untilStep(page, 0);
  assert.match(await page.getAttribute("#time", "aria-valuetext"), /0\.0 seconds, step 0/);
  await page.keyboard.press("End");
  await untilStep(page, 30);
  assert.deepEqual(errors, []);
  await close();
});

test("time_under_the_mouse_is_told_over_the_slider", async () => {
  const { page, close } = await visitor.open("?scene=cradle&paused=1");
  await stepBy(page, 120);
  const { x, y, width, height } = await page.locator("#time").boundingBox();
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.waitForSelector("#timeline .hint:not([hidden])");
  assert.equal(await page.textContent("#timeline .hint"), "1.0 s, step 60");
  assert.equal(await page.locator("#timeline .marks i").count(), 3);
  await close();
});

test("deed_after_rewinding_drops_the_old_future", async () => {
  const { page, errors, close } = await openStill("tall_stack");
  await stepBy(page, 120);
  const late = await hashAt(page, 120);
  await scrubTo(page, 60);
  assert.equal(await page.getAttribute("#time", "max"), "120");
  await page.keyboard.press("c");
  await page.focus("#overlay");
  await page.keyboard.press("Enter");
  await page.keyboard.press("Enter");
  await stepBy(page, 1);
  assert.equal(await page.getAttribute("#time", "max"), "61");
  await stepBy(page, 59);
  assert.notEqual(await hashAt(page, 120), late);
  assert.deepEqual(errors, []);
  await close();
});

test("rewind_check_runs_the_visitor_s_own_past_again", async () => {
  const { page, errors, close } = await openStill("tall_stack");
  await stepBy(page, 100);
  await page.keyboard.press("n");
  await page.focus("#overlay");
  await page.keyboard.press("Enter");
  await page.keyboard.press("Enter");
  await stepBy(page, 60);
  const hash = await hashAt(page, 160);
  await page.click("#rewind");
  await page.waitForSelector("#rewound[data-verdict]");
  const text = await page.innerText("#rewound");
  assert.match(text, new RegExp(`Same bits: steps 0 to 160 came out as before, ${hash}`));
  // The check leaves the scene and its past unchanged.
  await stepBy(page, 1);
  await page.keyboard.press("z");
  await untilStep(page, 160);
  assert.equal(await hashAt(page, 160), hash);
  assert.deepEqual(errors, []);
  await close();
});
