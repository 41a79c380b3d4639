/**
 * A line in the panel Trade on the limits of detection since the scene began: how often bodies were
 * held back (stopped before the end of a step), and the time that they lost; how often bodies were
 * too fast for bisection.
 */
import type { App } from "../../page/app";
import { make } from "../../page/dom";
import { countText } from "./text";

/** Milliseconds between two changes of the text. Chosen. */
const REFRESH = 500;

/** Creates the line; it is hidden while there is nothing to report. */
export function createDetectionCount(app: App): HTMLElement {
  const line = make("p", { class: "explained", id: "detection-count" });
  /** Bisection's limit of speed, world units per second. */
  let limit = Infinity;
  /**
   * Sums over the last step of each frame, since the page gets the statistics of that step alone:
   * bodies held back, seconds lost, bodies too fast; the last step.
   */
  let [held, seconds, fast, step] = [0, 0, 0, 0];
  let timer = 0;
  const show = () => {
    timer = 0;
    const parts = [];
    if (held > 0)
      parts.push(`${times(held)} a body was held back, ${seconds.toFixed(3)} s lost in all`);
    if (fast > 0)
      parts.push(
        `${times(fast)} a body moved faster than bisection’s limit of ` +
          `${limit.toPrecision(3)} a second, and may have passed something`,
      );
    line.hidden = parts.length === 0;
    line.textContent = `Since the start: ${parts.join("; ")}.`;
  };
  app.listen({
    run() {
      [held, seconds, fast, step] = [0, 0, 0, 0];
      show();
    },
    frame({ stats }) {
      // A step of a frame that is made again, or that the visitor goes back to, counts only once.
      if (stats.steps <= step) return;
      step = stats.steps;
      held += stats.heldBodies;
      seconds += stats.heldSeconds;
      fast += stats.unbisectable;
      if (timer || stats.heldBodies + stats.unbisectable === 0) return;
      timer = window.setTimeout(show, REFRESH);
      if (stats.unbisectable > 0)
        void app.client.ask("bisectionLimit", {}).then(
          (speed) => {
            limit = speed;
            // If the text was shown before the answer came, it is shown again with the limit: no
            // further frame need come.
            if (!timer) show();
          },
          () => {},
        );
    },
  });
  show();
  return line;
}

/** "once" or "12 times". */
function times(count: number): string {
  return count === 1 ? "once" : `${countText(count)} times`;
}
