/**
 * The section “Detection, priced” of the panel Trade: measures in the laboratory's worker the
 * time and the error of each detection, from 60 to 960 steps a second, and draws one over the other.
 */
import { make } from "../../page/dom";
import { say } from "../../page/messages";
import type { CallPrice } from "../../worker/measure-calls";
import type { Price } from "../../worker/measure-prices";
import type { Laboratory } from "./laboratory";
import { plainTime, timeText } from "./text";
import { Work } from "./work";

/** The motions, each with what it is. */
const MOTIONS: Readonly<Record<string, string>> = {
  shuttle: "between two walls, without gravity",
  hop: "on a floor",
};

const ABOUT =
  "Has a detection that looks ahead less error for the same time than one that looks more often? " +
  "64 balls bounce for two seconds without loss, where a closed form says where each is. The error is " +
  "their mean distance from there; the time is that of the steps for a simulated second, the least of " +
  "five rounds. The scene Detection, priced shows them at it.";
const READ =
  "Each line is a detection, from 60 steps a second on the left to 960 on the right; both axes are " +
  "logarithmic. The nearer a line is to the lower left corner, the less error it has for its time. A " +
  "line that falls gains from more steps, a level one does not.";

const CALLS =
  "Without a world: when does a ball hit a wall within a step? Bisection halves the step until the " +
  "interval is as short as the tolerance, a test for each halving: from left to right it halves more " +
  "often, and its error is the way that is left. Swept solves for the time, to rounding.";

const pointOf = ({ detection, time, error }: Price | CallPrice) => ({ detection, time, error: 1000 * error });

export function createPrices(laboratory: Laboratory): HTMLElement {
  const shown = make("div", { class: "result", id: "prices-result" });
  const work = new Work("Measure the detections", laboratory, async (work) => {
    const prices = await laboratory.ask(
      "prices",
      {},
      ({ done, doing }) => work.report(done, doing),
      () => work.report(null, "A step takes seconds: cancel, or wait."),
    );
    if (!prices) return "Cancelled.";
    const { createPlot } = await import("./prices-plot");
    const parts = Object.keys(MOTIONS).flatMap((motion) => {
      const own = prices.worlds.filter((price) => price.motion === motion);
      const plot = createPlot(own.map(pointOf), `Error over time of ${motion}`, "ms for a simulated second");
      return [
        make("h4", {}, `${capital(motion)}: ${MOTIONS[motion]}`),
        plot,
        make("p", { class: "priced" }, answerOf(own)),
        tableOf(own, motion),
      ];
    });
    const { calls } = prices;
    parts.push(
      make("h4", {}, "One call: bisection to several tolerances"),
      make("p", { class: "explained" }, CALLS),
      createPlot(calls.map(pointOf), "Error over time of a call", "µs a call"),
      callsTable(calls),
    );
    shown.replaceChildren(make("p", { class: "explained" }, READ), ...parts);
    say("The detections are measured.");
    return "";
  });
  return make(
    "section",
    { class: "trade-part", "aria-labelledby": "prices-heading" },
    make("h3", { id: "prices-heading" }, "Detection, priced"),
    make("p", { class: "explained" }, ABOUT),
    work.element,
    shown,
  );
}

const capital = (word: string) => word[0].toUpperCase() + word.slice(1);
const errorText = (error: number) => `${(1000 * error).toFixed(2)} mm`;

/** The setting with the least error, and the cheapest whose error is at most twice as large. */
export function answerOf(prices: readonly Price[]): string {
  const best = prices.reduce((one, other) => (other.error < one.error ? other : one));
  const enough = prices.filter(({ error }) => error <= 2 * best.error);
  const cheapest = enough.reduce((one, other) => (other.time < one.time ? other : one));
  const name = ({ detection, rate }: Price) => `${detection} at ${rate} steps a second`;
  const first = `${capital(name(best))} has the least error, ${errorText(best.error)} for ${timeText(best.time)}.`;
  if (cheapest === best) return `${first} Nothing cheaper comes within twice that error.`;
  return (
    `${first} Within twice that error ${name(cheapest)} is the cheapest: ` +
    `${errorText(cheapest.error)} for ${timeText(cheapest.time)}.`
  );
}

function tableOf(prices: readonly Price[], motion: string): HTMLElement {
  const rows = prices.map(({ detection, rate, time, error }) =>
    rowOf(detection, [String(rate), plainTime(time), (1000 * error).toFixed(2)], {
      "data-price": [motion, detection, rate].join(),
    }),
  );
  const caption = `Milliseconds for a simulated second of ${motion}, and the error after two.`;
  return foldedTable(["detection", "steps/s", "ms", "error, mm"], caption, rows);
}

function callsTable(calls: readonly CallPrice[]): HTMLElement {
  const rows = calls.map(({ detection, halvings, time, error }) =>
    rowOf(detection, [halvings > 0 ? `2^−${halvings}` : "–", time.toFixed(2), (1000 * error).toExponential(2)], {
      "data-call": halvings,
    }),
  );
  const caption = "The tolerance as a part of the step, microseconds of a call, and the mean error.";
  return foldedTable(["detection", "tolerance", "µs", "error, mm"], caption, rows);
}

function rowOf(name: string, cells: readonly string[], attributes: Record<string, string | number>): HTMLElement {
  const rest = cells.map((text) => make("td", {}, text));
  return make("tr", attributes, make("th", { scope: "row" }, name), ...rest);
}

/** The figures as a table, folded. */
function foldedTable(heads: readonly string[], caption: string, rows: readonly HTMLElement[]): HTMLElement {
  return make(
    "details",
    { class: "tried" },
    make("summary", {}, "As a table"),
    make(
      "table",
      {},
      make("caption", {}, caption),
      make("thead", {}, make("tr", {}, ...heads.map((text) => make("th", { scope: "col" }, text)))),
      make("tbody", {}, ...rows),
    ),
  );
}
