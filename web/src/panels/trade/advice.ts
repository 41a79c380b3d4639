/**
 * The advice below a measured series: the cheapest setting of thud that keeps to an error, what the
 * scene used, and what has the least room as the scene grows. Every sentence is of the figures that
 * were measured; thud-run gives the same kind of advice (`thud-run --advise`).
 */
import type { App } from "../../page/app";
import { make } from "../../page/dom";
import { MAX_ERRORS } from "../../page/url";
import type { Series, SeriesRow } from "../../worker/measure";
import { labelOf, type ThudSetting } from "../../worker/measure-settings";
import type { SceneUses } from "../../worker/measure-uses";
import { slider } from "./controls";
import { countText, errorText, timeText } from "./text";

/** The errors to choose from, length scales, and the one that is chosen at first. */
export const ERRORS = MAX_ERRORS.filter((error) => error > 0);
const USUAL_ERROR = 0.005;

/** A row of thud. */
export type ThudRow = SeriesRow & { setting: ThudSetting };

export interface Cheapest {
  /** The cheapest row that keeps to the error within the budget; null: none does. */
  best: ThudRow | null;
  /** The row that comes nearest: of those within the budget, or of all, the most accurate. */
  nearest: ThudRow;
}

const isThud = (row: SeriesRow): row is ThudRow => row.setting.engine === "thud";

/** What is advised for an error in length scales and a budget of so many ms a step. */
export function cheapest(series: Series, maxError: number, budget: number): Cheapest {
  const rows = series.rows.filter(isThud);
  const least = (of: readonly ThudRow[], value: (row: ThudRow) => number) =>
    of.reduce<ThudRow | null>((best, row) => (!best || value(row) < value(best) ? row : best), null);
  const fitting = rows.filter(({ typical }) => typical <= budget);
  const meeting = fitting.filter(({ worst, steps }) => worst <= maxError && steps >= series.steps);
  return {
    best: least(meeting, ({ typical }) => typical),
    nearest: least(fitting.length > 0 ? fitting : rows, ({ worst }) => worst)!,
  };
}

/** How much of what there is a row uses, as shares; above 1 it is too much. */
export interface Room {
  what: "time" | "error" | "speed";
  share: number;
}

/** The shares of time, error and speed that a row uses, the largest first. */
export function roomOf(row: SeriesRow, uses: SceneUses | null, maxError: number, budget: number): Room[] {
  const rooms: Room[] = [
    { what: "time", share: row.typical / budget },
    { what: "error", share: row.worst / maxError },
  ];
  if (uses) rooms.push({ what: "speed", share: uses.speed });
  return rooms.sort((a, b) => b.share - a.share);
}

/** "soft 8 is the cheapest that keeps to 0.005: 0.12 ms a step, overlap 0.0021." */
export function cheapestText({ best, nearest }: Cheapest, maxError: number, budget: number): string {
  const row = best ?? nearest;
  const label = labelOf(row.setting);
  const figures = `${timeText(row.typical)} a step, overlap ${errorText(row.worst)}`;
  return best
    ? `${label} is the cheapest that keeps to ${maxError} length scales: ${figures}.`
    : `No setting keeps to ${maxError} length scales within ${timeText(budget)} a step; ` +
        `${label} comes nearest: ${figures}.`;
}

const NAMES = { time: "time", error: "overlap", speed: "speed" } as const;

/** "Least room: overlap, 42 % of what it may be; then time, 3 %." */
export function roomText(rooms: readonly Room[]): string {
  const percent = (share: number) => `${countText(Math.round(100 * share))} %`;
  const [first, ...rest] = rooms;
  const others = rest.map(({ what, share }) => `${NAMES[what]} ${percent(share)}`).join(", ");
  return first.share > 1
    ? `Beyond its room already: ${NAMES[first.what]}, ${percent(first.share)}; ${others}.`
    : `As it grows, ${NAMES[first.what]} has the least room: it uses ${percent(first.share)} of it; ${others}.`;
}

/** What the scene has and used, a sentence each. */
export function usesTexts(uses: SceneUses): string[] {
  const { bodies, turned, turnedBoxes, bounced, slept, shapes, sensors, joints, steps } = uses;
  const [circles, aabbs, obbs, terrains] = shapes.map(countText);
  return [
    `${circles} circles, ${aabbs} upright boxes (AABBs), ${obbs} oriented boxes (OBBs), ${terrains} ` +
      `grounds; ${countText(sensors)} of them sensors; ${countText(joints)} joints.`,
    `Of ${countText(bodies)} moving bodies ${countText(turned)} turned (${countText(turnedBoxes)} with ` +
      `an oriented box), ${countText(bounced)} bounced, ${countText(slept)} fell asleep, in ` +
      `${countText(steps)} steps.`,
    `Detection held bodies back ${countText(uses.held)} times and resolved ${countText(uses.impacts)} ` +
      `impacts within a step; ${countText(uses.directSteps)} steps solved an island directly.`,
    `The fastest moved ${errorText(uses.speed)} of the thinnest shape’s thickness in a step` +
      (uses.speed >= 1 ? ": without detection it may pass through." : "."),
  ];
}

/** The element that shows the advice for a result. */
export function createAdvice(app: App, series: Series): HTMLElement {
  // A step may take as long as it lasts: then the scene runs in time.
  const budget = 1000 * series.timeStep;
  const answer = make("p", { class: "advised", role: "status" });
  const room = make("p", { class: "explained", id: "advice-room" });
  const take = make("button", { class: "wide", id: "advice-take" });
  let found: Cheapest;
  const show = (place: number) => {
    const maxError = ERRORS[place];
    found = cheapest(series, maxError, budget);
    const row = found.best ?? found.nearest;
    answer.textContent = cheapestText(found, maxError, budget);
    room.textContent = roomText(roomOf(row, series.uses, maxError, budget));
    take.textContent = `Run ${labelOf(row.setting)}`;
  };
  take.addEventListener("click", () => {
    const { quality, substeps } = (found.best ?? found.nearest).setting;
    app.choose({ quality, substeps, maxError: 0 });
  });
  const limit = slider(
    "advice-error",
    "Largest error",
    "overlap in any step",
    ERRORS.length - 1,
    (place) => `${ERRORS[place]} length scales`,
    show,
  );
  // The advice follows the slider as it moves.
  limit.input.addEventListener("input", () => show(Number(limit.input.value)));
  const first = ERRORS.findIndex((error) => error === USUAL_ERROR);
  limit.show(first);
  show(first);
  const { uses } = series;
  const used = uses
    ? [
        make("h5", {}, "What the scene used, at the settings above"),
        make("ul", { class: "explained", id: "advice-uses" }, ...usesTexts(uses).map((text) => make("li", {}, text))),
      ]
    : [];
  return make(
    "div",
    { class: "advice", role: "group", "aria-labelledby": "advice-heading" },
    make("h4", { id: "advice-heading" }, "Advice"),
    limit.element,
    answer,
    make("div", { class: "actions" }, take),
    ...used,
    make("h5", {}, "Where it breaks first"),
    room,
    make(
      "p",
      { class: "explained" },
      `Time: of the ${timeText(budget)} that a step lasts. Overlap: of the largest error. Speed: of ` +
        "the thinnest shape’s thickness. How many bodies it holds, Heavier measures below. The " +
        "advice is for the detection and the broadphase that were measured.",
    ),
  );
}
