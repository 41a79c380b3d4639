/**
 * A plot of error over time by uPlot, with a line for each detection. It is imported when something
 * was measured; for screen readers the table beside it has the same figures.
 */
import UPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { DARK, LIGHT, type Theme } from "../../draw/palette";
import { make } from "../../page/dom";
import { isDark, onTheme } from "../../page/theme";
import type { Ink } from "../../scene/scene";

/** A point of the plot, on the line of its detection; the error in millimetres. */
export interface PricePoint {
  detection: string;
  time: number;
  error: number;
}

/** Height of the plot in CSS pixels. Chosen. */
const HEIGHT = 220;
/** The lower end of the axis of errors, mm: smaller errors, which are of rounding, are drawn there. */
const LEAST = 1e-7;

/** By detection the ink of its line, and its dashes, so that lines differ without colours, too. */
const LINES: Readonly<Record<string, { ink: Ink; dash?: number[] }>> = {
  overlap: { ink: "bad", dash: [8, 4] },
  continuous: { ink: "gold", dash: [2, 3] },
  bisect: { ink: "rival", dash: [10, 3, 2, 3] },
  swept: { ink: "good" },
};

const themeNow = (): Theme => (isDark() ? DARK : LIGHT);

/** The plot with its legend. `unit`: of the times, in words. */
export function createPlot(prices: readonly PricePoint[], about: string, unit: string): HTMLElement {
  const names = [...new Set(prices.map(({ detection }) => detection))];
  const tables = names.map((name) => {
    const own = prices.filter(({ detection }) => detection === name);
    const sorted = [...own].sort((a, b) => a.time - b.time);
    return [sorted.map(({ time }) => time), sorted.map(({ error }) => Math.max(LEAST, error))] as UPlot.AlignedData;
  });
  const keys = names.map((name) => ({ name, swatch: make("i", { "aria-hidden": "true" }) }));
  const paintKeys = () => {
    for (const { name, swatch } of keys) swatch.style.background = themeNow().inks[LINES[name].ink];
  };
  const figure = make("div", { role: "img", "aria-label": about });
  const element = make(
    "figure",
    { class: "prices-plot" },
    make("small", {}, "error, mm"),
    figure,
    make("small", { class: "end" }, unit),
    make("ul", { class: "legend" }, ...keys.map(({ name, swatch }) => make("li", {}, swatch, name))),
  );
  let chart: UPlot | null = null;
  // A plot needs its width, which it has once it is on the page.
  new ResizeObserver(() => {
    const width = figure.clientWidth;
    if (width === 0 || chart?.width === width) return;
    if (chart) chart.setSize({ width, height: HEIGHT });
    else chart = new UPlot(optionsOf(names, width), UPlot.join(tables), figure);
  }).observe(figure);
  onTheme(() => {
    paintKeys();
    chart?.redraw(false);
  });
  paintKeys();
  return element;
}

function optionsOf(names: readonly string[], width: number): UPlot.Options {
  const axis: UPlot.Axis = {
    stroke: () => themeNow().inks.soft,
    font: "11px system-ui, sans-serif",
    grid: { stroke: () => themeNow().gridStrong, width: 1 },
    ticks: { show: false },
    values: (_, ticks) => ticks.map((value) => (value === null ? "" : tickText(value))),
  };
  const range: UPlot.Range.Function = (_, low, high) => [low / 1.3, high * 1.3];
  return {
    width,
    height: HEIGHT,
    legend: { show: false },
    cursor: { show: false },
    padding: [6, 12, 0, 0],
    scales: { x: { time: false, distr: 3, range }, y: { distr: 3, range } },
    axes: [
      { ...axis, size: 22 },
      { ...axis, size: 44 },
    ],
    series: [
      {},
      ...names.map((name): UPlot.Series => ({
        label: name,
        stroke: () => themeNow().inks[LINES[name].ink],
        width: 2,
        dash: LINES[name].dash,
        spanGaps: true,
        points: { show: true, size: 7 },
      })),
    ],
  };
}

function tickText(value: number): string {
  return value < 1e-3 ? value.toExponential(0) : String(Number(value.toPrecision(1)));
}
