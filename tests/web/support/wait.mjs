/** Waiting for what is wanted, with a message: however slow a machine is, or how quick. */
import assert from "node:assert/strict";
import { drawn, PATIENCE } from "./page.mjs";

/** A page that stands still between two tries has not failed. */
const LEAST_TRIES = 20;
/** Milliseconds between two tries. */
const PAUSE = 50;

/** Asks until the answer is as wanted, and returns it. */
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

/** Pixels of the overlay, faint ones too, of the picture that is drawn. */
export function overlay(page) {
  return drawn(page, "overlay", 17);
}

/** Waits until the overlay's number of pixels is as wanted. */
export function untilOverlay(page, wanted, what) {
  return until(() => overlay(page), ({ count }) => wanted(count), what);
}

/** Waits until nothing glides or fades into its place any more. */
export function untilStill(page) {
  return page.waitForFunction(() =>
    document
      .getAnimations()
      .every(({ effect, playState }) =>
        playState !== "running" || effect.getComputedTiming().endTime === Infinity),
  );
}

/** Waits until the figures over the scene are told; the scene's words come with the same picture. */
export function untilFigures(page) {
  return page.waitForFunction(() =>
    /\d/.test(document.querySelector("[data-value=bodies]")?.textContent),
  );
}

/** Waits until the picture is that of a step, and of no other. */
export function untilStep(page, step) {
  return page.waitForFunction(
    (wanted) => document.querySelector("#hud").dataset.steps === String(wanted),
    step,
  );
}
