/** The two engines' courses over time. What they show is in the table in words and figures too. */
import UPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { cssColour, DARK, LIGHT, type Theme } from "../../draw/palette";
import { make } from "../../page/dom";
import { isDark, onTheme } from "../../page/theme";
import { BUDGET } from "../../shared/step-times";
import { type Course, ENGINES, type Engine, type Tally } from "./tally";

/** CSS pixels. */
const HEIGHT = 118;
/** What is less stands at the lower edge: a logarithm has no zero. Milliseconds, length scales. */
const LEAST_TIME = 0.01;
const LEAST_DEPTH = 1e-5;

interface Plot {
  title: string;
  about: string;
  course: Course;
  /** A logarithmic axis that begins here; undefined is a linear one. */
  least?: () => number;
  /** A line across. */
  budget?: number;
}

export function engineColour(engine: Engine, theme: Theme): string {
  return engine === "thud" ? theme.inks.accent : cssColour(theme.box2d);
}

export function themeNow(): Theme {
  return isDark() ? DARK : LIGHT;
}

export class Plots {
  readonly element = make("div", { class: "plots" });
  readonly #shown: { plot: Plot; chart: UPlot; figure: HTMLElement }[] = [];
  readonly #kinds: Plot[];
  #lengthScale = 1;

  constructor({ times, penetrations, energies }: Tally) {
    this.#kinds = [
      {
        title: "Step, ms",
        about: "Milliseconds of each step of both engines over time, with the budget of 16.7",
        course: times,
        least: () => LEAST_TIME,
        budget: BUDGET,
      },
      {
        title: "Deepest overlap",
        about: "The deepest overlap in both engines over time, on a logarithmic scale",
        course: penetrations,
        least: () => LEAST_DEPTH * this.#lengthScale,
      },
      {
        title: "Energy since start",
        about: "Change of energy in both engines over time",
        course: energies,
      },
    ];
    new ResizeObserver(() => this.#resize()).observe(this.element);
    onTheme(() => this.#shown.forEach(({ chart }) => chart.redraw(false)));
  }

  /** When it is first seen: a plot needs its width. */
  begin(lengthScale: number): void {
    this.#lengthScale = lengthScale;
    if (this.#shown.length > 0) return;
    for (const plot of this.#kinds) {
      const figure = make("div", { role: "img", "aria-label": plot.about });
      this.element.append(make("h3", {}, plot.title), figure);
      const chart = new UPlot(optionsOf(plot, this.#width), [[], [], []], figure);
      this.#shown.push({ plot, chart, figure });
    }
  }

  show(): void {
    for (const { plot, chart } of this.#shown) {
      const { seconds, values } = plot.course;
      const least = plot.least?.();
      const lists = values.map((list) =>
        least === undefined ? [...list] : list.map((value) => Math.max(least, value)),
      );
      chart.setData([[...seconds], ...lists] as UPlot.AlignedData);
    }
  }

  get #width(): number {
    return Math.max(120, this.element.clientWidth);
  }

  #resize(): void {
    if (this.element.clientWidth === 0) return;
    for (const { chart } of this.#shown)
      if (chart.width !== this.#width) chart.setSize({ width: this.#width, height: HEIGHT });
  }
}

function optionsOf(plot: Plot, width: number): UPlot.Options {
  const { least, budget } = plot;
  const axis: UPlot.Axis = {
    stroke: () => themeNow().inks.soft,
    font: "11px system-ui, sans-serif",
    grid: { stroke: () => themeNow().gridStrong, width: 1 },
    ticks: { show: false },
  };
  return {
    width,
    height: HEIGHT,
    legend: { show: false },
    cursor: { show: false },
    padding: [6, 16, 0, 0],
    scales: {
      x: { time: false },
      y: least
        ? { distr: 3, range: (_, low, high) => logRange(low, high, budget) }
        : { range: (_, low, high) => linearRange(low, high) },
    },
    axes: [
      { ...axis, size: 22, values: (_, seconds) => seconds.map((value) => `${value} s`) },
      { ...axis, size: 48, values: (_, ticks) => ticks.map(label) },
    ],
    series: [
      {},
      ...ENGINES.map((engine): UPlot.Series => ({
        label: engine,
        stroke: () => engineColour(engine, themeNow()),
        width: 1.5,
        points: { show: false },
      })),
    ],
    hooks: budget ? { draw: [(chart) => drawBudget(chart, budget)] } : {},
  };
}

/** Whole powers of ten around the values and the budget. */
function logRange(low: number, high: number, budget?: number): [number, number] {
  const least = Number.isFinite(low) ? low : LEAST_TIME;
  const most = Math.max(Number.isFinite(high) ? high : 1, budget ?? 0, least * 10);
  return [10 ** Math.floor(Math.log10(least)), 10 ** Math.ceil(Math.log10(most))];
}

function linearRange(low: number, high: number): [number, number] {
  if (!Number.isFinite(low) || !Number.isFinite(high)) return [0, 1];
  const room = 0.08 * (high - low) || 0.1 * Math.abs(high) || 1;
  return [low - room, high + room];
}

const COMPACT = new Intl.NumberFormat("en", { notation: "compact", maximumSignificantDigits: 3 });

/** Of a tick; uPlot leaves those out of a logarithmic axis that have no room. */
function label(value: number | null): string {
  if (value === null) return "";
  if (value !== 0 && Math.abs(value) < 0.001) return value.toExponential(0);
  return COMPACT.format(value);
}

function drawBudget(chart: UPlot, budget: number): void {
  const { ctx, bbox } = chart;
  const y = Math.round(chart.valToPos(budget, "y", true));
  ctx.save();
  ctx.strokeStyle = ctx.fillStyle = themeNow().inks.bad;
  ctx.lineWidth = devicePixelRatio;
  ctx.setLineDash([6 * devicePixelRatio, 4 * devicePixelRatio]);
  ctx.beginPath();
  ctx.moveTo(bbox.left, y);
  ctx.lineTo(bbox.left + bbox.width, y);
  ctx.stroke();
  ctx.font = `${11 * devicePixelRatio}px system-ui, sans-serif`;
  ctx.textAlign = "right";
  ctx.textBaseline = "bottom";
  ctx.fillText("16.7 ms", bbox.left + bbox.width, y - 2 * devicePixelRatio);
  ctx.restore();
}
