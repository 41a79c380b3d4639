/** The slider that goes back in time, and on again, with a mark at every few seconds. */
import type { Frame } from "../scene/frame";
import { messageOf } from "../shared/error";
import type { RunningScene } from "../worker/protocol";
import type { App } from "./app";
import { byId, make } from "./dom";
import { notice } from "./messages";

/** CSS pixels that a mark has at least; marks stand so many seconds apart that it is so. */
const APART = 24;
const SECONDS = [1, 5, 10, 30, 60];
/** Of the slider's thumb: its middle does not reach the slider's ends. */
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
  /** The step that the visitor wants; the one before may still be under way. */
  #wanted: number | null = null;
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

  #begin(scene: RunningScene): void {
    this.#secondsAStep = scene.timeStep;
    this.#wanted = null;
    this.#slider.min = this.#slider.max = this.#slider.value = "0";
    this.#show(0);
    this.#showMarks();
  }

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

  #show(step: number): void {
    this.#label.textContent = this.#textOf(step);
    // A slider in focus is read out at each change: not while time runs by itself.
    if (document.activeElement === this.#slider && !this.#app.state.paused) return;
    const seconds = this.#textOf(step).replace(" s", " seconds");
    this.#slider.setAttribute("aria-valuetext", `${seconds}, step ${step}`);
  }

  /** Tells the time under a mouse. */
  #point({ offsetX, pointerType }: PointerEvent): void {
    const [first, last] = this.#ends;
    this.#hint.hidden = pointerType !== "mouse" || last === first;
    const part = (offsetX - THUMB / 2) / Math.max(1, this.#slider.clientWidth - THUMB);
    const step = Math.round(first + Math.min(1, Math.max(0, part)) * (last - first));
    this.#hint.textContent = `${this.#textOf(step)}, step ${step}`;
    this.#hint.style.left = `${offsetX}px`;
  }

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
