/**
 * `Plots`: curves of both engines over simulated time, drawn by uPlot: time per step, deepest
 * overlap and change of energy. For screen readers the table has the same figures as text.
 */
import UPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { cssColour, DARK, LIGHT, type Theme } from "../../draw/palette";
import { make } from "../../page/dom";
import { isDark, onTheme } from "../../page/theme";
import { BUDGET } from "../../shared/step-times";
import { type Course, ENGINES, type Engine, type Tally } from "./tally";

/** Height of a plot in CSS pixels. Chosen. */
const HEIGHT = 118;
/** Lower ends of the logarithmic axes, in milliseconds and in length scales: smaller values, such
 * as 0, are drawn there. Chosen. */
const LEAST_TIME = 0.01;
const LEAST_DEPTH = 1e-5;

/** One of the plots. */
interface Plot {
  title: string;
  /** The description for screen readers. */
  about: string;
  course: Course;
  /** The lower end of a logarithmic axis; undefined: the axis is linear. */
  least?: () => number;
  /** The value of a horizontal line. */
  budget?: number;
}

/** The colour of an engine's curve, as a CSS colour. */
export function engineColour(engine: Engine, theme: Theme): string {
  return engine === "thud" ? theme.inks.accent : cssColour(theme.box2d);
}

/** The colours of the page's present theme. */
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

  /** Creates the plots. Called when the panel is first shown, since a plot needs its width. */
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

  /** Draws the curves as they are now. */
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

  /** Fits the plots to the element's width. */
  #resize(): void {
    if (this.element.clientWidth === 0) return;
    for (const { chart } of this.#shown)
      if (chart.width !== this.#width) chart.setSize({ width: this.#width, height: HEIGHT });
  }
}

/** The options of uPlot for a plot. */
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

/** The range of a logarithmic axis: whole powers of ten around the values and the budget. */
function logRange(low: number, high: number, budget?: number): [number, number] {
  const least = Number.isFinite(low) ? low : LEAST_TIME;
  const most = Math.max(Number.isFinite(high) ? high : 1, budget ?? 0, least * 10);
  return [10 ** Math.floor(Math.log10(least)), 10 ** Math.ceil(Math.log10(most))];
}

/** The range of a linear axis: the values' own, and 8 % more on either side. */
function linearRange(low: number, high: number): [number, number] {
  if (!Number.isFinite(low) || !Number.isFinite(high)) return [0, 1];
  const room = 0.08 * (high - low) || 0.1 * Math.abs(high) || 1;
  return [low - room, high + room];
}

const COMPACT = new Intl.NumberFormat("en", { notation: "compact", maximumSignificantDigits: 3 });

/** The label of a tick; uPlot passes null for ticks of a logarithmic axis that get no label. */
function label(value: number | null): string {
  if (value === null) return "";
  if (value !== 0 && Math.abs(value) < 0.001) return value.toExponential(0);
  return COMPACT.format(value);
}

/** Draws the line of the budget, dashed, with its label. */
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
