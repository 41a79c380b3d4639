/** What detection could not do since the scene began: time that bodies lost, speeds beyond it. */
import type { App } from "../../page/app";
import { make } from "../../page/dom";
import { countText } from "./text";

/** Milliseconds between two changes of the text. */
const REFRESH = 500;

export function createDetectionCount(app: App): HTMLElement {
  const line = make("p", { class: "explained", id: "detection-count" });
  let limit = Infinity;
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
      // A step that is shown again, or gone back to, is not counted twice.
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
            // Where the answer comes later than the text, no frame may follow that tells it.
            if (!timer) show();
          },
          () => {},
        );
    },
  });
  show();
  return line;
}

function times(count: number): string {
  return count === 1 ? "once" : `${countText(count)} times`;
}
