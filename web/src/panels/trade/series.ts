/**
 * The section Measure of the panel Trade: measures the scene at a series of settings in the
 * laboratory's worker, and shows the result as a plot and a table; or a result from a link.
 */
import type { App } from "../../page/app";
import { make } from "../../page/dom";
import { notice, say } from "../../page/messages";
import { messageOf } from "../../shared/error";
import type { SeriesRow } from "../../worker/measure";
import { labelOf } from "../../worker/measure-settings";
import { missesText } from "../misses";
import { createAdvice } from "./advice";
import type { Laboratory } from "./laboratory";
import { Plane, type PlanePoint } from "./plane";
import { Work } from "./work";
import {
  cellsOf,
  COLUMNS,
  describeResult,
  readResult,
  type Result,
  resultLink,
  resultText,
  titleOf,
  whereMeasured,
} from "./result";

/** Builds the section, with the link's result if there is one. */
export function createSeries(app: App, laboratory: Laboratory): HTMLElement {
  const shown = make("div", { class: "result" });
  const work = new Work("Measure this scene", laboratory, async (work) => {
    const series = await laboratory.ask(
      "measure",
      laboratory.request,
      ({ done, doing }) => work.report(done, doing),
      () => work.report(null, "A step takes seconds: cancel, or wait."),
    );
    if (!series) return "Cancelled.";
    app.state.result = null;
    shown.replaceChildren(...view(app, describeResult(app, series), false));
    say("The measurement is done.");
    return series.withoutBox2D ? `Without Box2D. ${series.withoutBox2D}` : "";
  });
  const element = make(
    "section",
    { class: "trade-part", "aria-labelledby": "measure-heading" },
    make("h3", { id: "measure-heading" }, "Measure"),
    make(
      "p",
      { class: "explained" },
      "The first two seconds of this scene at fourteen settings of thud and Box2D, one after the " +
        "other, in a worker of its own. Times are of the engine’s step alone, after the first " +
        "half second; no body may sleep meanwhile. Overlap is measured for both by the same code. " +
        "Then comes advice: the cheapest setting for the error you allow, and what the scene requires.",
    ),
    work.element,
    shown,
  );
  const { result: packed } = app.state;
  if (packed)
    void readResult(packed).then((result) => {
      const damaged = make("p", { class: "explained" }, "The result in this link is damaged.");
      shown.replaceChildren(...(result ? view(app, result, true) : [damaged]));
      // The result is below the panel's controls, but is what the link is meant to show.
      requestAnimationFrame(() => shown.scrollIntoView({ block: "start" }));
    });
  return element;
}

/** The elements that show a result. `elsewhere`: it came with a link. */
function view(app: App, result: Result, elsewhere: boolean): HTMLElement[] {
  const plane = new Plane();
  const misses = missesText(result.misses);
  // If Box2D lacks parts of the scene, its points would not be comparable: only thud's are drawn.
  const rows = result.rows.filter(({ setting }) => misses === "" || setting.engine === "thud");
  plane.show(rows.map(pointOf), "");
  const where = elsewhere
    ? make(
        "p",
        { class: "elsewhere" },
        `Measured elsewhere: ${whereMeasured(result)}. ` +
          "The figures came with the link; nobody has checked them.",
      )
    : make("p", { class: "explained" }, `On this device: ${whereMeasured(result)}.`);
  const title = make("h4", {}, titleOf(result));
  const first = misses === "" ? [] : [make("p", { class: "misses" }, misses)];
  const advice = createAdvice(app, result);
  return [title, ...first, where, plane.element, tableOf(result), actions(app, result), advice];
}

/** The row whose points are joined by a line in the plot. thud's qualities are one, its soft
 * settings another, which differ only in their substeps, as do Box2D's settings and its stiff
 * ones. */
function rowOf({ setting }: SeriesRow): string {
  if (setting.engine === "box2d") return setting.contactHertz ? "stiff" : "box2d";
  return setting.substeps > 0 ? "soft" : "qualities";
}

/** A row of the result as a point of the plot. */
function pointOf(row: SeriesRow): PlanePoint {
  const label = labelOf(row.setting);
  const { engine } = row.setting;
  return { key: label, engine, label, time: row.typical, error: row.worst, row: rowOf(row) };
}

/** The table of a result, in an element that scrolls. */
function tableOf(result: Result): HTMLElement {
  const heads = COLUMNS.map((text) => make("th", { scope: "col" }, text));
  const body = result.rows.map((row) => {
    const [name, ...figures] = cellsOf(row, result);
    const cells = figures.map((text) => make("td", {}, text));
    return make("tr", { class: row.setting.engine }, make("th", { scope: "row" }, name), ...cells);
  });
  const caption =
    `${result.bodies} bodies, ${result.steps} steps. ms: median of a step; p99: 99 of 100 were ` +
    "quicker; worst and mean: overlap in length scales. Soft: thud’s substeps without its direct " +
    "solver. Stiff: Box2D’s contacts, as stiff as it allows.";
  return make(
    "div",
    // The table may be wider than a phone; with the focus it can be scrolled by keys.
    { class: "table", tabindex: 0, role: "region", "aria-label": "Measured figures" },
    make(
      "table",
      {},
      make("caption", {}, caption),
      make("thead", {}, make("tr", {}, ...heads)),
      make("tbody", {}, ...body),
    ),
  );
}

/** Buttons that copy the result as text, download it as JSON, and copy a link to it. */
function actions(app: App, result: Result): HTMLElement {
  const button = (id: string, label: string, act: () => void) => {
    const element = make("button", { class: "wide", id }, label);
    element.addEventListener("click", act);
    return element;
  };
  const copy = (text: string, done: string) =>
    navigator.clipboard.writeText(text).then(
      () => notice(done),
      () => notice("The clipboard is not allowed here."),
    );
  const link = make("a", { class: "wide", id: "result-link" }, "Link to this result");
  void resultLink(app, result).then((address) => (link.href = address));
  link.addEventListener("click", (event) => {
    event.preventDefault();
    void copy(link.href, "The link to this result is in the clipboard.");
  });
  return make(
    "div",
    { class: "actions" },
    button(
      "result-copy",
      "Copy as text",
      () => void copy(resultText(result), "The table is in the clipboard."),
    ),
    button("result-download", "Download JSON", () => download(result)),
    link,
  );
}

/** Downloads a result as a JSON file. */
function download(result: Result): void {
  try {
    const blob = new Blob([JSON.stringify(result, null, 2)], { type: "application/json" });
    const url = URL.createObjectURL(blob);
    make("a", { href: url, download: "thud-trade.json" }).click();
    setTimeout(() => URL.revokeObjectURL(url), 1000);
  } catch (error) {
    notice(`The file cannot be saved: ${messageOf(error)}`);
  }
}
