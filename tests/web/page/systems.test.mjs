/**
 * Tests the choice and the display of detections, broadphases and Minkowski sums, on a desktop and
 * on a phone.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { DESKTOP, near, openVisitor, PHONE, stepBy } from "../support/page.mjs";
import { overlay, until, untilOverlay, untilStep, untilStill } from "../support/wait.mjs";

const SIZES = [["desktop", DESKTOP], ["phone", PHONE]];

const visitor = openVisitor();

/**
 * The number of the overlay's pixels that are close to a colour, and their mean place on the page.
 */
function coloured(page, [red, green, blue]) {
  return page.evaluate(
    ([r, g, b]) => {
      const { width, height } = document.getElementById("overlay");
      const copy = Object.assign(document.createElement("canvas"), { width, height });
      const context = copy.getContext("2d", { willReadFrequently: true });
      context.drawImage(document.getElementById("overlay"), 0, 0);
      const { data } = context.getImageData(0, 0, width, height);
      let [count, x, y] = [0, 0, 0];
      for (let i = 0; i < data.length; i += 4) {
        const off = Math.abs(data[i] - r) + Math.abs(data[i + 1] - g) + Math.abs(data[i + 2] - b);
        if (data[i + 3] < 200 || off > 30) continue;
        count++;
        x += (i / 4) % width;
        y += Math.floor(i / 4 / width);
      }
      const ratio = width / innerWidth;
      return { count, x: x / count / ratio, y: y / count / ratio };
    },
    [red, green, blue],
  );
}

/** Waits until the overlay has more than `least` pixels close to a colour. */
function untilColoured(page, colour, least, what) {
  return until(() => coloured(page, colour), ({ count }) => count > least, what);
}

/** Colours of palette.ts: motions on a light page, sums and overlapping sums on a dark one. */
const MOTION = [194, 37, 92];
const SUM = [124, 245, 196];
const OVERLAPPING = [255, 143, 163];

/** A setting in the address; null if it has its usual value. */
function chosen(page, set) {
  return page.evaluate((name) => new URLSearchParams(location.search).get(name), set);
}

/** Presses the key for the next detection or broadphase until the address has the wanted value. */
async function choose(page, set, value) {
  for (let i = 0; i < 5; i++) {
    const before = await chosen(page, set);
    if (before === value) return;
    await page.keyboard.press(set === "detection" ? "e" : "f");
    await page.waitForFunction(
      ([name, old]) => new URLSearchParams(location.search).get(name) !== old,
      [set, before],
    );
  }
  assert.equal(await chosen(page, set), value);
}

/**
 * Chooses a value and waits for step 0: the choice restarts the scene. The scene must be at a later
 * step before.
 */
async function chooseAnew(page, set, value) {
  await choose(page, set, value);
  await untilStep(page, 0);
}

for (const [size, options] of SIZES)
  test(`detection_and_broadphase_are_chosen_and_kept_in_the_url_on_a_${size}`, async () => {
    const { page, errors, close } = await visitor.open("?scene=cradle&paused=1", options);
    await stepBy(page, 20);
    await chooseAnew(page, "detection", "swept");
    await choose(page, "broadphase", "sweep");
    const both = async () => [await chosen(page, "detection"), await chosen(page, "broadphase")];
    assert.deepEqual(await both(), ["swept", "sweep"]);
    await page.reload();
    await stepBy(page, 5);
    await chooseAnew(page, "detection", "bisect");
    assert.deepEqual(await both(), ["bisect", "sweep"]);
    assert.deepEqual(errors, []);
    await close();
  });

for (const [size, options] of SIZES)
  test(`scene_of_broadphases_shows_cells_or_intervals_on_a_${size}`, async () => {
    const { page, errors, close } = await visitor.open("?scene=broadphases&paused=1", options);
    await stepBy(page, 10);
    await untilOverlay(page, (count) => count > 300, "cells");
    await chooseAnew(page, "broadphase", "sweep");
    await stepBy(page, 10);
    const { y } = await untilOverlay(page, (count) => count > 300, "intervals");
    assert.ok(y > 0.6 * options.viewport.height, `the intervals' middle is at ${y}`);
    await chooseAnew(page, "broadphase", "all");
    await stepBy(page, 10);
    await untilOverlay(page, (count) => count === 0, "nothing");
    assert.deepEqual(errors, []);
    await close();
  });

test("keys_toggle_pairs_and_motions_and_go_through_detections", async () => {
  const { page, errors, close } = await visitor.open("?scene=tall_stack&paused=1");
  await stepBy(page, 5);
  await page.keyboard.press("9");
  await untilOverlay(page, (count) => count > 20, "pairs");
  await page.keyboard.press("9");
  await untilOverlay(page, (count) => count === 0, "pairs after all");
  await page.keyboard.press("m");
  // A picture requested after an overlay was switched shows the change.
  await stepBy(page, 1);
  assert.equal((await overlay(page)).count, 0, "a stack at rest has motions");
  for (const name of ["overlap", "continuous", "bisect", "swept"]) {
    await page.keyboard.press("e");
    await page.waitForFunction((wanted) => location.search.includes(`detection=${wanted}`), name);
  }
  assert.deepEqual(errors, []);
  await close();
});

for (const [size, options] of SIZES)
  test(`four_ways_of_detection_show_swept_volumes_on_a_${size}`, async () => {
    const { page, errors, close } = await visitor.open("?scene=detection&paused=1", options);
    await stepBy(page, 30);
    await untilColoured(page, MOTION, 150, "pixels of motions");
    await page.keyboard.press("m");
    await until(() => coloured(page, MOTION), ({ count }) => count === 0, "motions after all");
    assert.deepEqual(errors, []);
    await close();
  });

for (const [size, options] of SIZES)
  test(`minkowski_sum_tells_that_dragged_shapes_overlap_on_a_${size}`, async () => {
    const search = "?scene=minkowski&paused=1";
    const { page, errors, close } = await visitor.open(search, { ...options, colorScheme: "dark" });
    await stepBy(page, 1);
    await untilStill(page);
    await untilColoured(page, SUM, 1000, "pixels of the sums");
    assert.equal((await coloured(page, OVERLAPPING)).count, 0);
    // The view is 17 m high and centred at (0.4, 0), or as wide as the moving bodies; the first
    // shape of the upper pair is at (-0.8, 4), the second at (2.3, 6).
    const [top, bottom] = await page.evaluate(() => [
      // The hint for first visits takes up space below the top bar.
      Math.max(
        ...["#top", "#hint"].map((id) => document.querySelector(id).getBoundingClientRect().bottom),
      ) + 8,
      innerHeight - document.querySelector("#bottom").getBoundingClientRect().top + 8,
    ]);
    const { width, height } = options.viewport;
    const scale = Math.min((height - top - bottom) / 17, (width - 32) / (2.2 * 1.9));
    const at = (x, y) => [
      width / 2 + (x - 0.4) * scale,
      (height + top - bottom) / 2 - y * scale,
    ];
    const [from, to] = [at(2.3, 6), at(-0.2, 4.5)];
    await page.mouse.move(...from);
    await page.mouse.down();
    await page.waitForSelector("#overlay[data-mode=pull]");
    await page.mouse.move(...to, { steps: 5 });
    await stepBy(page, 90);
    const over = await untilColoured(page, OVERLAPPING, 500, "pixels of the sum that tells it");
    await page.mouse.up();
    near(over.x, to[0], 60, "the sum's middle");
    assert.deepEqual(errors, []);
    await close();
  });
