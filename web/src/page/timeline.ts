/** The slider that goes back in time, and on again, with a mark at every few seconds. */
import { messageOf } from "../shared/error";
import type { App } from "./app";
import { byId, make } from "./dom";
import { notice } from "./messages";

/** CSS pixels that a mark has at least; marks stand so many seconds apart that it is so. */
const APART = 24;
const SECONDS = [1, 5, 10, 30, 60];
/** Of the slider's thumb: its middle does not reach the slider's ends. */
const THUMB = 16;

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
  const marks = make("div", { class: "marks", "aria-hidden": "true" });
  const hint = make("span", { class: "panel hint", "aria-hidden": "true", hidden: true });
  byId("timeline").append(make("div", { class: "track" }, slider, marks, hint), label);

  let secondsAStep = 1 / 60;
  /** The step that the visitor wants; the one before may still be under way. */
  let wanted: number | null = null;
  let seeking = false;

  const textOf = (step: number) => `${(step * secondsAStep).toFixed(1)} s`;

  const show = (step: number) => {
    label.textContent = textOf(step);
    const seconds = textOf(step).replace(" s", " seconds");
    slider.setAttribute("aria-valuetext", `${seconds}, step ${step}`);
  };

  /** Where a step stands on the slider, in CSS pixels from its left end. */
  const placeOf = (step: number) => {
    const part = (step - Number(slider.min)) / Math.max(1, Number(slider.max) - Number(slider.min));
    return THUMB / 2 + part * (slider.clientWidth - THUMB);
  };

  const stepAt = (x: number) => {
    const part = (x - THUMB / 2) / Math.max(1, slider.clientWidth - THUMB);
    const [first, last] = [Number(slider.min), Number(slider.max)];
    return Math.round(first + Math.min(1, Math.max(0, part)) * (last - first));
  };

  const showMarks = () => {
    const [first, last] = [Number(slider.min) * secondsAStep, Number(slider.max) * secondsAStep];
    const most = slider.clientWidth / APART;
    const every = SECONDS.find((seconds) => (last - first) / seconds <= most) ?? SECONDS.at(-1)!;
    const places: number[] = [];
    for (let time = Math.ceil(first / every) * every; time <= last; time += every)
      places.push(placeOf(time / secondsAStep));
    while (marks.children.length > places.length) marks.lastElementChild!.remove();
    while (marks.children.length < places.length) marks.append(make("i"));
    places.forEach((x, i) => ((marks.children[i] as HTMLElement).style.left = `${x}px`));
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
  slider.addEventListener("pointermove", ({ offsetX, pointerType }) => {
    hint.hidden = pointerType !== "mouse" || slider.max === slider.min;
    const step = stepAt(offsetX);
    hint.textContent = `${textOf(step)}, step ${step}`;
    hint.style.left = `${offsetX}px`;
  });
  slider.addEventListener("pointerleave", () => (hint.hidden = true));

  app.listen({
    run(scene) {
      secondsAStep = scene.timeStep;
      wanted = null;
      slider.min = slider.max = slider.value = "0";
      show(0);
      showMarks();
    },
    frame({ step, history }) {
      const { first, last } = history;
      if (slider.min !== String(first) || slider.max !== String(last)) {
        slider.min = String(first);
        slider.max = String(last);
        showMarks();
      }
      if (seeking || wanted !== null) return;
      slider.value = String(step);
      show(step);
    },
  });
}
