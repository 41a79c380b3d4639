/**
 * The part Step of the panel Inside: the time of each stage of a step, in the last step and as a
 * median over the last steps, a chart of the last steps, and counts of what the step did.
 */
import type { Stats } from "thud";
import { cssColour, rampColour } from "../../draw/palette";
import type { App } from "../../page/app";
import { make } from "../../page/dom";
import { percentile } from "../../shared/step-times";
import type { Frame } from "../../scene/frame";
import { bytesText, degreesText, fillList, numberText, type Row } from "./values";

/** Last steps in the chart and in the medians. Chosen. */
const KEPT = 120;
/** Milliseconds between two updates, so that figures can be read. Chosen. */
const REFRESH = 250;
/** The chart's upper end is LEAST_SCALE milliseconds, times this factor as often as the slowest
 * step needs. Chosen. */
const SCALE_STEP = 2;
const LEAST_SCALE = 0.25;

/** Milliseconds of each stage of a step, in the order in which the step runs them. */
type Times = readonly number[];

export class StepPart {
  readonly element: HTMLElement;
  /** Whether this part is shown; while it is not, times are only collected. */
  seen = false;
  readonly #app: App;
  readonly #canvas = make("canvas", { role: "img", class: "areas" });
  readonly #scale = make("small");
  readonly #rows = make("tbody");
  /** A bar of the last step's stages, and one of their medians. */
  readonly #bars = [make("div"), make("div")];
  readonly #numbers = make("dl", { class: "facts", id: "step-numbers" });
  /** Names of the stages. */
  #names: readonly string[] = [];
  /** Times of the last KEPT frames' last steps, oldest first. */
  #times: Times[] = [];
  /** Number of the step whose times were taken last. */
  #steps: number | null = null;
  #frame: Frame | null = null;
  /** When this part was last updated, on the clock of performance.now(). */
  #shownAt = 0;
  /** Speed above which bisection may miss a collision (World.bisectionLimit), world units per s. */
  #limit = Infinity;
  /** Ends listening to the app. */
  #stop: (() => void) | null = null;

  constructor(app: App) {
    this.#app = app;
    const head = ["Stage", "Last", "Median", "Share"].map((text) =>
      make("th", { scope: "col" }, text),
    );
    const clock = crossOriginIsolated
      ? "Milliseconds, on a clock that ticks every 0.005 ms."
      : "Milliseconds. This page is not cross-origin isolated, so its clock ticks every 0.1 ms " +
        "only: short stages read 0.";
    this.element = make(
      "section",
      { class: "part", "aria-label": "Step" },
      this.#timeButtons(),
      make("h3", {}, "Stages of the step"),
      make("div", { class: "chart" }, this.#canvas, this.#scale),
      make("div", { class: "bars", "aria-hidden": "true" }, ...this.#bars),
      make(
        "table",
        { id: "stages" },
        make("caption", { class: "quiet" }, clock),
        make("thead", {}, make("tr", {}, ...head)),
        this.#rows,
      ),
      make("h3", {}, "What the step did"),
      this.#numbers,
    );
  }

  /** The panel is opened. */
  watch(): void {
    this.#stop = this.#app.listen({
      run: () => {
        this.#times = [];
        this.#steps = null;
      },
      frame: (frame) => this.#take(frame),
    });
  }

  /** The panel is closed. */
  rest(): void {
    this.#stop?.();
  }

  /** Buttons for pause and single step: on a phone the panel covers those of the page. */
  #timeButtons(): HTMLElement {
    const app = this.#app;
    const pause = make("button", { class: "wide" });
    const step = make("button", { class: "wide" }, "One step");
    pause.addEventListener("click", () => app.setPaused(!app.state.paused));
    step.addEventListener("click", () => app.stepOnce());
    const label = () => (pause.textContent = app.state.paused ? "Go on" : "Pause");
    app.listen({ state: label });
    label();
    return make("div", { class: "pair" }, pause, step);
  }

  /** Takes the times of a new frame's step. */
  #take(frame: Frame): void {
    const { stats } = frame;
    if (stats.steps !== this.#steps) {
      this.#steps = stats.steps;
      this.#name(Object.keys(stats.stageSeconds));
      this.#times.push(Object.values(stats.stageSeconds).map((seconds) => 1000 * seconds));
      if (this.#times.length > KEPT) this.#times.shift();
    }
    this.#frame = frame;
    const now = performance.now();
    if (!this.seen || (now - this.#shownAt < REFRESH && !this.#app.state.paused)) return;
    this.#shownAt = now;
    this.#show(stats);
    void this.#askLimit(stats);
  }

  /** Asks the worker for `#limit`. */
  async #askLimit(stats: Stats): Promise<void> {
    const limit = await this.#app.client.ask("bisectionLimit", {}).catch(() => Infinity);
    if (limit === this.#limit) return;
    this.#limit = limit;
    this.#show(stats);
  }

  /** Builds a row of the table for each stage, with its colour, and one for all of them. */
  #name(names: readonly string[]): void {
    if (names.length === this.#names.length) return;
    this.#names = names;
    this.#rows.replaceChildren(
      ...[...names, "all"].map((name, i) => {
        const swatch = make("i", { "aria-hidden": "true" });
        if (i < names.length) swatch.style.background = this.#colour(i);
        const cells = [0, 1, 2].map(() => make("td"));
        return make("tr", {}, make("th", { scope: "row" }, swatch, name), ...cells);
      }),
    );
  }

  /** Fills the two bars; the longer one has the full width. */
  #stackBars(times: readonly Times[]): void {
    const most = Math.max(...times.map(sum), Number.MIN_VALUE);
    this.#bars.forEach((bar, i) => {
      const parts = times[i].map((time, stage) => {
        const part = make("i");
        part.style.background = this.#colour(stage);
        part.style.flex = `${time / most}`;
        return part;
      });
      const rest = make("i");
      rest.style.flex = `${1 - sum(times[i]) / most}`;
      bar.replaceChildren(make("small", {}, ["last", "median"][i]), ...parts, rest);
    });
  }

  /** The colour of a stage, from a ramp of colours over the stages. */
  #colour(stage: number): string {
    return cssColour(rampColour(stage / Math.max(1, this.#names.length - 1)));
  }

  /** Updates the tables, the chart and the bars. */
  #show(stats: Stats): void {
    const last = this.#times.at(-1) ?? [];
    const ofStage = (stage: number) => this.#times.map((times) => times[stage]);
    const medians = this.#names.map((_, stage) => percentile(ofStage(stage), 0.5));
    const [all, median] = [sum(last), percentile(this.#times.map(sum), 0.5)];
    const share = sum(medians);
    [...this.#rows.rows].forEach((row, i) => {
      const ofAll = i === this.#names.length;
      const values = [
        (ofAll ? all : last[i]).toFixed(3),
        (ofAll ? median : medians[i]).toFixed(3),
        ofAll || share === 0 ? "" : `${Math.round((100 * medians[i]) / share)} %`,
      ];
      values.forEach((value, k) => (row.cells[k + 1].textContent = value));
    });
    this.#draw();
    this.#stackBars([last, medians]);
    const { error } = this.#frame!;
    fillList(this.#numbers, [
      ["step", String(this.#frame!.step)],
      ["substeps", String(stats.substeps)],
      ["bodies awake", `${count(stats.awakeBodies)} of ${count(stats.bodies)}`],
      ["pairs with overlapping bounds", count(stats.pairs)],
      ["pairs in contact", count(stats.contacts)],
      ["colours of the solver", count(stats.colours)],
      ["blocks of contacts", count(stats.blocks)],
      ["islands solved directly", islandsText(stats)],
      ["motions tested exactly", `${count(stats.motionExact)} of ${count(stats.motionPairs)}`],
      ["collisions within the step", count(stats.impacts)],
      ["bodies held back", heldText(stats)],
      ["bodies too fast for bisection", count(stats.unbisectable)],
      ["bisection’s speed limit", Number.isFinite(this.#limit) ? numberText(this.#limit) : "none"],
      ["deepest overlap", numberText(error.penetrationMax)],
      ["overlapping points", count(error.overlaps)],
      ...jointRows(this.#frame!),
      ["memory of the world", bytesText(stats.bytes)],
      ["allocations in the step", count(stats.stepAllocations)],
    ]);
  }

  /** Draws the chart: the last steps from left to right, in each its stages from the bottom up. */
  #draw(): void {
    const canvas = this.#canvas;
    const context = canvas.getContext("2d");
    const { clientWidth: width, clientHeight: height } = canvas;
    if (!context || width === 0) return;
    const ratio = Math.min(3, devicePixelRatio);
    canvas.width = width * ratio;
    canvas.height = height * ratio;
    context.scale(ratio, ratio);
    let top = LEAST_SCALE;
    while (top < Math.max(0, ...this.#times.map(sum))) top *= SCALE_STEP;
    this.#scale.textContent = `${top} ms`;
    canvas.setAttribute("aria-label", this.#words());
    const column = width / KEPT;
    this.#times.forEach((times, step) => {
      const x = (KEPT - this.#times.length + step) * column;
      let y = height;
      times.forEach((time, stage) => {
        const part = (time / top) * height;
        context.fillStyle = this.#colour(stage);
        context.fillRect(x, y - part, column + 0.3, part);
        y -= part;
      });
    });
  }

  /** The chart's description for screen readers. */
  #words(): string {
    const median = percentile(this.#times.map(sum), 0.5);
    return (
      `Times of the last ${this.#times.length} steps by stage; ` +
      `the median is ${median.toFixed(3)} milliseconds.`
    );
  }
}

function sum(times: Times): number {
  return times.reduce((a, b) => a + b, 0);
}

function jointRows({ gaps }: Frame): Row[] {
  if (!gaps) return [];
  return [
    ["joints", count(gaps.joints)],
    ["widest gap of a joint", numberText(gaps.worst)],
    ["gap of joints, mean", numberText(gaps.mean)],
    ["joint turned the furthest", degreesText(gaps.angle)],
  ];
}

function islandsText({ directIslands, directBodies }: Stats): string {
  return directIslands === 0 ? "0" : `${count(directIslands)} (${count(directBodies)} bodies)`;
}

function heldText({ heldBodies, heldSeconds }: Stats): string {
  return heldBodies === 0 ? "0" : `${count(heldBodies)} (${numberText(heldSeconds)} s lost)`;
}

function count(value: number): string {
  return value.toLocaleString("en");
}
