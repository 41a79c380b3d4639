/** Waits for conditions, and fails with a message. */
import assert from "node:assert/strict";
import { drawn, PATIENCE } from "./page.mjs";

/**
 * The minimum number of tries, even after the timeout: a page that is stalled between two tries has
 * not failed.
 */
const LEAST_TRIES = 20;
/** Milliseconds between two tries. */
const PAUSE = 50;

/** Calls `ask` until `wanted` holds for its answer, and returns the answer. */
export async function until(ask, wanted, what) {
  const end = Date.now() + PATIENCE;
  for (let tries = 0; ; tries++) {
    const answer = await ask();
    if (wanted(answer)) return answer;
    const left = tries < LEAST_TRIES || Date.now() < end;
    assert.ok(left, `${what}: ${JSON.stringify(answer)}`);
    await new Promise((done) => setTimeout(done, PAUSE));
  }
}

/** The overlay's pixels, including faint ones: their number and mean place. */
export function overlay(page) {
  return drawn(page, "overlay", 17);
}

/** Waits until the overlay has a wanted number of pixels. */
export function untilOverlay(page, wanted, what) {
  return until(() => overlay(page), ({ count }) => wanted(count), what);
}

/** Waits until no finite animation is running. */
export function untilStill(page) {
  return page.waitForFunction(() =>
    document
      .getAnimations()
      .every(({ effect, playState }) =>
        playState !== "running" || effect.getComputedTiming().endTime === Infinity),
  );
}

/**
 * Waits until the figures over the scene are shown; the scene's texts come with the same picture.
 */
export function untilFigures(page) {
  return page.waitForFunction(() =>
    /\d/.test(document.querySelector("[data-value=bodies]")?.textContent),
  );
}

/** Waits until the picture shows that step. */
export function untilStep(page, step) {
  return page.waitForFunction(
    (wanted) => document.querySelector("#hud").dataset.steps === String(wanted),
    step,
  );
}
