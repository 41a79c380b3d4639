/**
 * `Hud`: the figures over the scene. Time per step, with a chart of the last steps and the budget
 * at 60 Hz; the deepest overlap and the widest joint gap; numbers of bodies and contacts; pictures
 * per second.
 */
import type { Frame, Sample } from "../scene/frame";
import { BUDGET, percentile, START_UP } from "../shared/step-times";
import { byId, make } from "./dom";
import { count, duration, length } from "./format";

/** Steps in the chart. Chosen; the texts below say 120 too. */
const COURSE = 120;
/** Height of the chart, in heights of its text, from which the line of the budget has a label.
 * Chosen. */
const LEAST_FOR_TEXT = 2.4;
const BUDGET_TEXT = "60 Hz: 16.7 ms";
/** Seconds between two changes of the texts, so that they can be read. Chosen. */
const REFRESH = 0.25;

/** The figures: name, label, and description in the legend. */
const VALUES = [
  ["ms", "step", "Time that a step takes: the median of the last 60."],
  [
    "slowest",
    "p99",
    `99 of 100 of the last 120 steps were quicker; a scene’s first ${START_UP} do not count.`,
  ],
  ["deepest", "overlap", "How deep the worst pair of bodies overlaps, in world units."],
  ["gap", "joint gap", "How far the joint that is open the most is open, in world units."],
  ["bodies", "bodies", "All bodies in the world, those that never move included."],
  ["awake", "awake", "Bodies that are simulated. Those that rest sleep, at next to no cost."],
  ["contacts", "contacts", "Pairs of shapes that touch."],
  ["fps", "fps", "Pictures drawn a second."],
] as const;
type ValueName = (typeof VALUES)[number][0];

const COURSE_TITLE =
  "Time of each of the last 120 steps. The line is what a step may take at 60 steps a second.";

export class Hud {
  readonly #root = byId("hud");
  readonly #canvas = this.#root.querySelector("canvas")!;
  readonly #values = new Map<ValueName, HTMLElement>();
  /** Milliseconds of the last COURSE steps, oldest first. */
  #times: number[] = [];
  /** How many of the first times belong to the scene's start, and do not count for p99. */
  #startUp = START_UP;
  #frame: Frame | null = null;
  /** Seconds since the texts changed. */
  #sinceRefresh = REFRESH;
  /** Pictures since the last change of the texts, and the seconds between them. */
  #pictures = 0;
  #seconds = 0;

  constructor() {
    for (const [name, label, title] of VALUES) {
      const value = make("dd", { "data-value": name }, "–");
      this.#values.set(name, value);
      this.#root
        .querySelector("dl")!
        .append(make("div", { title, class: name }, make("dt", {}, label), value));
    }
    this.#showGap();
    this.#canvas.title = COURSE_TITLE;
    byId("legend").append(
      ...VALUES.map(([, label, title]) => legendRow(label, title)),
      legendRow("bars", COURSE_TITLE),
    );
  }

  /** Another scene begins. */
  reset(): void {
    this.#times = [];
    this.#startUp = START_UP;
    this.#sinceRefresh = REFRESH;
    // The attribute data-steps is absent until the first picture of the new scene.
    delete this.#root.dataset.steps;
  }

  /** Adds the times of new steps. */
  add(samples: readonly Sample[]): void {
    for (const { milliseconds } of samples) this.#times.push(milliseconds);
    const old = Math.max(0, this.#times.length - COURSE);
    this.#times.splice(0, old);
    this.#startUp = Math.max(0, this.#startUp - old);
  }

  /** Called for each picture with the frame that it shows and the seconds since the one before. */
  show(frame: Frame, seconds: number): void {
    this.#frame = frame;
    this.#pictures++;
    this.#seconds += seconds;
    this.#sinceRefresh += seconds;
    this.#root.dataset.steps = String(frame.step);
    if (this.#sinceRefresh >= REFRESH && this.#seconds > 0) this.#refresh();
  }

  /** Updates the texts and the chart. */
  #refresh(): void {
    const { stats, error } = this.#frame!;
    const middle = percentile(this.#times.slice(-60), 0.5);
    const counted = this.#times.slice(this.#startUp);
    this.#put("ms", this.#times.length > 0 ? duration(middle) : "–");
    this.#put("slowest", counted.length > 0 ? duration(percentile(counted, 0.99)) : "–");
    this.#put("deepest", length(error.penetrationMax));
    this.#showGap();
    this.#put("bodies", count(stats.bodies));
    this.#put("awake", count(stats.awakeBodies));
    this.#put("contacts", count(stats.contacts));
    this.#put("fps", String(Math.round(this.#pictures / this.#seconds)));
    this.#root.dataset.over = String(middle > BUDGET);
    this.#pictures = this.#seconds = this.#sinceRefresh = 0;
    this.#drawCourse();
  }

  /** Shows the joint gap, or hides it in a world without joints. */
  #showGap(): void {
    const gaps = this.#frame?.gaps;
    this.#values.get("gap")!.parentElement!.hidden = !gaps;
    if (gaps) this.#put("gap", length(gaps.worst));
  }

  #put(name: ValueName, text: string): void {
    this.#values.get(name)!.textContent = text;
  }

  /** Draws a bar for each of the last steps, and a line at the budget. The line is at three
   * quarters of the height, or lower where a bar needs more room. */
  #drawCourse(): void {
    const canvas = this.#canvas;
    const context = canvas.getContext("2d");
    const { clientWidth, clientHeight } = canvas;
    if (!context || clientWidth === 0) return;
    const ratio = Math.min(3, devicePixelRatio);
    canvas.width = clientWidth * ratio;
    canvas.height = clientHeight * ratio;
    context.scale(ratio, ratio);
    const most = Math.max(BUDGET / 0.75, ...this.#times);
    const style = getComputedStyle(canvas);
    context.fillStyle = style.color;
    const width = clientWidth / COURSE;
    this.#times.forEach((time, i) => {
      const height = Math.max(1, (time / most) * clientHeight);
      const x = (COURSE - this.#times.length + i) * width;
      context.fillRect(x, clientHeight - height, Math.max(0.7, width - 0.4), height);
    });
    const line = Math.round(clientHeight * (1 - BUDGET / most));
    context.fillStyle = style.getPropertyValue("--budget");
    context.fillRect(0, line, clientWidth, 1);
    const textHeight = parseFloat(style.fontSize);
    if (clientHeight < LEAST_FOR_TEXT * textHeight) return;
    context.fillStyle = style.getPropertyValue("--legend");
    context.font = `${textHeight}px ${style.fontFamily}`;
    // The label is below the line, or above it if there is too little room below.
    const below = line < clientHeight - 1.2 * textHeight;
    context.textBaseline = below ? "top" : "bottom";
    const y = below ? line + 3 : line - 1;
    // A halo around the label keeps it readable over the bars.
    context.strokeStyle = style.getPropertyValue("--halo");
    context.lineWidth = 4;
    context.lineJoin = "round";
    context.strokeText(BUDGET_TEXT, 0, y);
    context.fillText(BUDGET_TEXT, 0, y);
  }
}

/** A row of the legend in the help. */
function legendRow(label: string, title: string): HTMLElement {
  return make("div", {}, make("dt", {}, label), make("dd", {}, title));
}
