// What the panel reads out of two shapes, under what is ticked there, and the line over the picture.

import { HALVINGS, VOLUMES } from "./look.js";

export const number = (value) => value.toFixed(2).replace("-0.00", "0.00");
const place = ([x, y]) => `${number(x)}, ${number(y)}`;
export const percent = (part) => `${Math.round(100 * part)} %`;
export const yesNo = (value) => (value ? "yes" : "no");

export function tell(state, seen, costs) {
  const readings = {
    overlap: overlapRows(seen, costs),
    closest: closestRows(seen),
    ways: wayRows(seen),
    sum: sumRows(seen),
  };
  for (const kind of VOLUMES) readings[kind] = boundRows(seen, kind, costs);
  return { readings, message: message(seen) };
}

/** Without numbers, which change all the time while something is dragged: it is said aloud. */
function message({ closest, impact }) {
  if (closest.overlaps) return "The shapes overlap.";
  return `The shapes are apart, and ${impact === null ? "pass each other" : "will meet"}.`;
}

function overlapRows({ closest, collision }, costs) {
  const halved =
    collision.time !== null
      ? `from ${number(collision.time)} of the ways on`
      : closest.overlaps
        ? "from the start"
        : "not at the end";
  return [
    ["Direct test", closest.overlaps ? "they overlap" : "apart"],
    [`By ${HALVINGS} halvings`, halved],
    ["Can halving miss them?", collision.bisectable ? "no" : "yes, they are fast"],
    ["Exact tests in 1 µs", rate(costs.exact)],
  ];
}

function closestRows({ closest: { overlaps, distance, normal, pointA, pointB } }) {
  return [
    [overlaps ? "Depth" : "Distance", number(Math.abs(distance))],
    ["Normal, A to B", place(normal)],
    ["On A", place(pointA)],
    ["On B", place(pointB)],
  ];
}

function wayRows({ impact, least }) {
  return [
    ["Time of impact", impact === null ? "never" : number(impact)],
    ["Smallest separation", number(least.distance)],
    ["It comes at", number(least.time)],
    ["Found", least.closed ? "in closed form" : "by a search"],
  ];
}

function sumRows({ sum, crossing, shapes: [a, b] }) {
  return [
    ["B is in the sum", yesNo(sum.overlaps)],
    ["Its way enters at", crossing ? number(crossing.fraction) : "never"],
    ["Normal there", crossing ? place(crossing.normal) : "none"],
    ["B seen from A", place([b.center[0] - a.center[0], b.center[1] - a.center[1]])],
  ];
}

/** How much of a bounding volume its shape fills, and what a test of two of them takes. */
function boundRows({ shapes, bounds }, kind, costs) {
  const { first, second, overlap } = bounds[kind];
  return [
    ["A fills", percent(areaOf(shapes[0]) / areaOf(first))],
    ["B fills", percent(areaOf(shapes[1]) / areaOf(second))],
    ["The bounds overlap", yesNo(overlap)],
    ["Such tests in 1 µs", rate(costs[kind])],
  ];
}

const rate = (value) => (value ? value.toPrecision(2) : "being measured");

export function areaOf({ kind, radius, halfWidth, halfHeight }) {
  return kind === "circle" ? Math.PI * radius * radius : 4 * halfWidth * halfHeight;
}
