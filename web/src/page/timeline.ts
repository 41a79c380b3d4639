/** `Timeline`: the slider that shows a recorded step, back in time or forward again. It has a mark
 * every few seconds. */
import type { Frame } from "../scene/frame";
import { messageOf } from "../shared/error";
import type { RunningScene } from "../worker/protocol";
import type { App } from "./app";
import { byId, make } from "./dom";
import { notice } from "./messages";

/** Minimum distance between two marks in CSS pixels. Chosen. */
const APART = 24;
/** Seconds between two marks: the first of these that keeps them APART, or else the last.
 * Chosen. */
const SECONDS = [1, 5, 10, 30, 60];
/** Width of the slider's thumb in CSS pixels, about as browsers draw it: its centre stays half of
 * this away from the slider's ends. */
const THUMB = 16;

export class Timeline {
  readonly #app: App;
  readonly #slider = make("input", {
    type: "range",
    id: "time",
    min: 0,
    max: 0,
    value: 0,
    step: 1,
    "aria-label": "Time: go back and on again",
  });
  readonly #label = make("span", { id: "time-label", "aria-hidden": "true" }, "0.0 s");
  readonly #marks = make("div", { class: "marks", "aria-hidden": "true" });
  readonly #hint = make("span", { class: "panel hint", "aria-hidden": "true", hidden: true });
  #secondsAStep = 1 / 60;
  /** The step that the visitor wants and that has not been requested yet; null: none. */
  #wanted: number | null = null;
  /** A requested step has not come yet. */
  #seeking = false;

  constructor(app: App) {
    this.#app = app;
    const slider = this.#slider;
    const track = make("div", { class: "track" }, slider, this.#marks, this.#hint);
    byId("timeline").append(track, this.#label);
    slider.addEventListener("input", () => {
      if (!app.state.paused) app.setPaused(true);
      this.#wanted = Number(slider.value);
      this.#show(this.#wanted);
      void this.#seek();
    });
    slider.addEventListener("pointermove", (event) => this.#point(event));
    slider.addEventListener("pointerleave", () => (this.#hint.hidden = true));
    app.listen({
      run: (scene) => this.#begin(scene),
      frame: (frame) => this.#follow(frame),
    });
  }

  /** The first and the last step that the slider reaches. */
  get #ends(): [first: number, last: number] {
    return [Number(this.#slider.min), Number(this.#slider.max)];
  }

  /** A scene begins at step 0. */
  #begin(scene: RunningScene): void {
    this.#secondsAStep = scene.timeStep;
    this.#wanted = null;
    this.#slider.min = this.#slider.max = this.#slider.value = "0";
    this.#show(0);
    this.#showMarks();
  }

  /** Follows a new frame: the range of recorded steps, and the step unless the visitor seeks. */
  #follow({ step, history }: Frame): void {
    const [first, last] = this.#ends;
    if (first !== history.first || last !== history.last) {
      this.#slider.min = String(history.first);
      this.#slider.max = String(history.last);
      this.#showMarks();
    }
    if (this.#seeking || this.#wanted !== null) return;
    this.#slider.value = String(step);
    this.#show(step);
  }

  /** Requests the wanted step, one at a time: of steps wanted meanwhile only the last is next. */
  async #seek(): Promise<void> {
    if (this.#seeking) return;
    this.#seeking = true;
    while (this.#wanted !== null) {
      const step = this.#wanted;
      this.#wanted = null;
      try {
        await this.#app.seek(step);
      } catch (error) {
        notice(messageOf(error));
      }
    }
    this.#seeking = false;
  }

  #textOf(step: number): string {
    return `${(step * this.#secondsAStep).toFixed(1)} s`;
  }

  /** Shows the time of a step beside the slider, and to screen readers. */
  #show(step: number): void {
    this.#label.textContent = this.#textOf(step);
    // A screen reader reads each change of the focused slider: no change while the scene runs.
    if (document.activeElement === this.#slider && !this.#app.state.paused) return;
    const seconds = this.#textOf(step).replace(" s", " seconds");
    this.#slider.setAttribute("aria-valuetext", `${seconds}, step ${step}`);
  }

  /** Shows the time and the step under the mouse in a hint above the slider. */
  #point({ offsetX, pointerType }: PointerEvent): void {
    const [first, last] = this.#ends;
    this.#hint.hidden = pointerType !== "mouse" || last === first;
    const part = (offsetX - THUMB / 2) / Math.max(1, this.#slider.clientWidth - THUMB);
    const step = Math.round(first + Math.min(1, Math.max(0, part)) * (last - first));
    this.#hint.textContent = `${this.#textOf(step)}, step ${step}`;
    this.#hint.style.left = `${offsetX}px`;
  }

  /** Places the marks for the present range of steps. */
  #showMarks(): void {
    const { clientWidth } = this.#slider;
    const [first, last] = this.#ends;
    const [from, to] = [first * this.#secondsAStep, last * this.#secondsAStep];
    const most = clientWidth / APART;
    const every = SECONDS.find((seconds) => (to - from) / seconds <= most) ?? SECONDS.at(-1)!;
    const places: number[] = [];
    for (let time = Math.ceil(from / every) * every; time <= to; time += every) {
      const part = (time / this.#secondsAStep - first) / Math.max(1, last - first);
      places.push(THUMB / 2 + part * (clientWidth - THUMB));
    }
    const marks = this.#marks;
    while (marks.children.length > places.length) marks.lastElementChild!.remove();
    while (marks.children.length < places.length) marks.append(make("i"));
    places.forEach((x, i) => ((marks.children[i] as HTMLElement).style.left = `${x}px`));
  }
}
