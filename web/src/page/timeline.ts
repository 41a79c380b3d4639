/** The slider that goes back in time, and on again. */
import type { App } from "./app";
import { byId, make } from "./dom";
import { messageOf, notice } from "./messages";

export function addTimeline(app: App): void {
  const slider = make("input", {
    type: "range",
    id: "time",
    min: 0,
    max: 0,
    value: 0,
    step: 1,
    "aria-label": "Time: go back and on again",
  });
  const label = make("output", { for: "time", id: "time-label" }, "0.0 s");
  byId("timeline").append(slider, label);

  let secondsAStep = 1 / 60;
  /** The step that the visitor wants; the one before may still be under way. */
  let wanted: number | null = null;
  let seeking = false;

  const show = (step: number) => {
    const seconds = (step * secondsAStep).toFixed(1);
    label.textContent = `${seconds} s`;
    slider.setAttribute("aria-valuetext", `${seconds} seconds, step ${step}`);
  };

  const seek = async () => {
    if (seeking) return;
    seeking = true;
    while (wanted !== null) {
      const step = wanted;
      wanted = null;
      try {
        await app.seek(step);
      } catch (error) {
        notice(messageOf(error));
      }
    }
    seeking = false;
  };

  slider.addEventListener("input", () => {
    if (!app.state.paused) app.setPaused(true);
    wanted = Number(slider.value);
    show(wanted);
    void seek();
  });

  app.listen({
    run(scene) {
      secondsAStep = scene.timeStep;
      wanted = null;
      slider.min = slider.max = slider.value = "0";
      show(0);
    },
    frame({ step, history }) {
      slider.min = String(history.first);
      slider.max = String(history.last);
      if (seeking || wanted !== null) return;
      slider.value = String(step);
      show(step);
    },
  });
}
