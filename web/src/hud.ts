/** Figures over the scene: bodies, contacts, time per step with its recent course, frames. */
import type { Stats, StepError } from "thud";

/** Steps that the course shows. */
const COURSE = 120;
/** Milliseconds that a step may take at 60 Hz. */
const BUDGET = 1000 / 60;
/** Texts change this often, so that they can be read. */
const REFRESH = 0.25;

export class Hud {
  readonly #root: HTMLElement;
  readonly #timings: HTMLElement;
  readonly #course: CanvasRenderingContext2D | null;
  readonly #values: Record<"bodies" | "awake" | "contacts" | "deepest" | "ms" | "fps", HTMLElement>;
  #times: number[] = [];
  #steps = 0;
  #sinceRefresh = REFRESH;
  #frames = 0;
  #frameSeconds = 0;
  #stages = new Map<string, number>();

  constructor(root: HTMLElement, timings: HTMLElement) {
    this.#root = root;
    this.#timings = timings;
    const find = (name: string) => root.querySelector<HTMLElement>(`[data-value="${name}"]`)!;
    this.#values = {
      bodies: find("bodies"),
      awake: find("awake"),
      contacts: find("contacts"),
      deepest: find("deepest"),
      ms: find("ms"),
      fps: find("fps"),
    };
    this.#course = root.querySelector("canvas")!.getContext("2d");
  }

  reset(): void {
    this.#times = [];
    this.#steps = 0;
    this.#stages.clear();
    this.#sinceRefresh = REFRESH;
  }

  frame(seconds: number, stats: Stats, error: StepError): void {
    this.#frames++;
    this.#frameSeconds += seconds;
    this.#sinceRefresh += seconds;
    if (stats.steps !== this.#steps) {
      this.#steps = stats.steps;
      this.#times.push(stats.stepSeconds * 1000);
      if (this.#times.length > COURSE) this.#times.shift();
      for (const [name, time] of Object.entries(stats.stageSeconds)) {
        const last = this.#stages.get(name) ?? time;
        this.#stages.set(name, last + (time - last) * 0.1);
      }
    }
    if (this.#sinceRefresh < REFRESH) return;
    const ms = this.#times.length > 0 ? median(this.#times.slice(-30)) : 0;
    this.#values.bodies.textContent = stats.bodies.toLocaleString("en");
    this.#values.awake.textContent = stats.awakeBodies.toLocaleString("en");
    this.#values.contacts.textContent = stats.contacts.toLocaleString("en");
    this.#values.deepest.textContent = error.penetrationMax.toFixed(4);
    this.#values.ms.textContent = ms.toFixed(ms < 10 ? 2 : 1);
    this.#values.fps.textContent = String(Math.round(this.#frames / this.#frameSeconds));
    this.#root.dataset.steps = String(stats.steps);
    this.#root.dataset.over = String(ms > BUDGET);
    this.#frames = 0;
    this.#frameSeconds = 0;
    this.#sinceRefresh = 0;
    this.#drawCourse();
    if (!this.#timings.hidden) this.#showStages();
  }

  /** Bars of the last steps; the line is the budget, at three quarters of the height or higher. */
  #drawCourse(): void {
    const context = this.#course;
    if (!context) return;
    const { canvas } = context;
    const ratio = Math.min(3, devicePixelRatio);
    const { clientWidth, clientHeight } = canvas;
    if (clientWidth === 0) return;
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
    context.fillStyle = style.getPropertyValue("--budget");
    context.fillRect(0, clientHeight * (1 - BUDGET / most), clientWidth, 1);
  }

  #showStages(): void {
    const most = Math.max(1e-9, ...this.#stages.values());
    const rows = [...this.#stages].map(([name, seconds]) => {
      const row = document.createElement("div");
      const label = document.createElement("span");
      const bar = document.createElement("meter");
      const value = document.createElement("span");
      label.textContent = name;
      bar.max = most;
      bar.value = seconds;
      bar.setAttribute("aria-label", name);
      value.textContent = `${(seconds * 1000).toFixed(3)} ms`;
      row.append(label, bar, value);
      return row;
    });
    this.#timings.querySelector(".rows")!.replaceChildren(...rows);
  }
}

function median(values: number[]): number {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[sorted.length >> 1];
}
