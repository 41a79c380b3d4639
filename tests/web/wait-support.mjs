/** Waiting for pictures: of the overlay, and of a step. */
import { drawn, until } from "./page-support.mjs";

/** Pixels of the overlay, faint ones too, of the picture that is drawn. */
export function overlay(page) {
  return drawn(page, "overlay", 17);
}

/** Waits until the overlay's number of pixels is as wanted. */
export function untilOverlay(page, wanted, what) {
  return until(() => overlay(page), ({ count }) => wanted(count), what);
}

/** Waits until the picture is that of a step, and of no other. */
export function untilStep(page, step) {
  return page.waitForFunction(
    (wanted) => document.querySelector("#hud").dataset.steps === String(wanted),
    step,
  );
}
