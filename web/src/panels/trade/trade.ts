/**
 * The panel Trade, in which the visitor trades speed for accuracy. It has a plot of overlap over
 * time per step with a point for each setting tried, the controls of these settings, and the
 * sections Measure (a series of settings) and Heavier (how many bodies run in time).
 */
import "../../style/trade.css";
import type { App } from "../../page/app";
import type { Panel } from "../../page/dock";
import { make } from "../../page/dom";
import { Box2DChoice } from "./box2d";
import { createControls } from "./controls";
import { createHeavier } from "./heavier";
import { Laboratory } from "./laboratory";
import { Plane, type PlanePoint } from "./plane";
import { type TriedPoint, TriedPoints } from "./points";
import { createPrices } from "./prices";
import { createSeries } from "./series";
import { countText, errorText, plainTime } from "./text";

/** Milliseconds between two drawings of the plot, so that figures can be read. Chosen. */
const REFRESH = 300;

/** The scene that shows what the section on detections measures. */
const PRICED = "lab_prices";

const LEAD =
  "Each setting that you try leaves its point. Further left is faster; further down, bodies " +
  "overlap less. Steps in which all bodies sleep do not count.";

export function createPanel(app: App): Panel {
  const tried = new TriedPoints(app);
  const plane = new Plane();
  const box2d = new Box2DChoice(app);
  const table = make("tbody");
  const forget = make("button", { class: "small" }, "Clear");
  let open = false;
  /** When the plot was last drawn, on the clock of performance.now(). */
  let drawn = 0;

  const draw = () => {
    drawn = performance.now();
    const { points, current } = tried;
    plane.show(
      points.map((point) => planePoint(app, point, current)),
      "Run the scene for a moment, with bodies awake.",
    );
    forget.hidden = points.length === 0;
    table.replaceChildren(...points.map(rowOf));
  };
  forget.addEventListener("click", () => {
    tried.forget();
    draw();
  });
  let timer: number | null = null;
  /** Draws now or when REFRESH has passed, so that the last samples are drawn even if the scene is
   * paused then. */
  const drawInTime = () => {
    if (!open || timer !== null) return;
    const rest = Math.max(0, drawn + REFRESH - performance.now());
    timer = window.setTimeout(() => {
      timer = null;
      draw();
    }, rest);
  };
  app.listen({ run: draw, samples: drawInTime });

  const laboratory = new Laboratory(app, () => {
    element.classList.toggle("measuring", laboratory.busy);
    controls.inert = laboratory.busy;
  });
  const controls = createControls(app);
  const sections = [
    make(
      "div",
      {},
      make("p", { class: "lead" }, LEAD),
      make("div", { class: "live-plane" }, plane.element),
      box2d.element,
      make(
        "details",
        { class: "tried" },
        make("summary", {}, "As a table"),
        triedTable(table),
        forget,
      ),
      controls,
    ),
    createSeries(app, laboratory),
    createHeavier(app, laboratory),
  ];
  const prices = createPrices(laboratory);
  const element = make("div", { class: "trade" }, ...sections, prices);
  /** The section on detections stands alone in the scene that it is of, whose own world is empty. */
  const place = () => {
    const priced = app.state.scene === PRICED;
    for (const section of sections) section.hidden = priced;
    if (priced) prices.scrollIntoView();
  };
  app.listen({ run: place });
  place();
  draw();
  return {
    element,
    opened() {
      open = true;
      box2d.opened();
      draw();
    },
    closed() {
      open = false;
      box2d.closed();
      laboratory.cancel();
    },
  };
}

/** A tried point as a point of the plot. Pressing it chooses its setting, unless that runs. */
function planePoint(app: App, point: TriedPoint, current: string): PlanePoint {
  const { key, engine, label, choices, typical, worst } = point;
  const here = key === current;
  const go = choices && !here ? () => app.choose(choices) : undefined;
  return { key, engine, label, time: typical, error: worst, live: here, go };
}

/** The plot's figures as a table. */
function triedTable(body: HTMLElement): HTMLElement {
  const heads = ["setting", "ms", "p99", "worst", "steps"].map((text) =>
    make("th", { scope: "col" }, text),
  );
  const caption =
    "The last four seconds of each setting with bodies awake: milliseconds of a step, median and " +
    "p99 (99 of 100 were quicker; without the scene’s first 30), worst overlap in length scales.";
  return make(
    "table",
    {},
    make("caption", {}, caption),
    make("thead", {}, make("tr", {}, ...heads)),
    body,
  );
}

/** A row of that table. */
function rowOf({ engine, label, typical, p99, worst, steps }: TriedPoint): HTMLElement {
  const slowest = p99 === null ? "–" : plainTime(p99);
  const cells = [plainTime(typical), slowest, errorText(worst), countText(steps)];
  return make(
    "tr",
    { class: engine },
    make("th", { scope: "row" }, label),
    ...cells.map((text) => make("td", {}, text)),
  );
}
