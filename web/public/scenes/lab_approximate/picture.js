// What is drawn: the polygon with the pieces over it, and below it the errors over their count.

import { dot, line, solid, text } from "../geometry/picture.js";
import { MOST } from "./search.js";

export function paintApproximation(state, { points, found, known, reason }) {
  const marks = [];
  const outline = [...points, points[0]];
  // What stays red is the area that no piece covers.
  if (!reason) marks.push(line(outline, "bad", { filled: true, opacity: 0.75 }));
  for (const shape of found?.shapes ?? [])
    marks.push({ ...solid(shape), ink: "rival", filled: true, opacity: 0.65 });
  for (const shape of found?.shapes ?? []) marks.push({ ...solid(shape), ink: "ink", opacity: 0.7 });
  marks.push(line(outline, reason ? "bad" : "ink", { width: 2.5 }));
  points.forEach((point, i) => {
    const radius = state.near === i || state.grip === i ? 0.26 : 0.16;
    marks.push(dot(point, "gold", radius), { ...dot(point, "ink", radius), filled: false });
  });
  if (state.curve && !reason) paintCurve(marks, state, found, known);
  return { marks };
}

/** The chart’s edges, and the decades of its logarithmic axis. */
const [LEFT, RIGHT, BOTTOM, TOP] = [-4.9, 5.3, -5, -2.2];
const [LEAST, GREATEST] = [-3, 1];

export const xOf = (count) => LEFT + ((RIGHT - LEFT) * (count - 1)) / (MOST - 1);
export function yOf(error) {
  const power = Math.min(GREATEST, Math.max(LEAST, Math.log10(Math.max(error, 1e-9))));
  return BOTTOM + ((TOP - BOTTOM) * (power - LEAST)) / (GREATEST - LEAST);
}

/** The errors: their names, colours, and values in a result. */
const ERRORS = [
  ["area missed + outside, share", "gold", ({ missed, extra }) => missed + extra],
  ["distance missed, at most", "accent", ({ distance }) => distance],
];

function paintCurve(marks, { count }, found, known) {
  for (let power = LEAST; power <= GREATEST; power++) {
    const y = yOf(10 ** power);
    marks.push(line([[LEFT, y], [RIGHT, y]], "soft", { width: 1, opacity: 0.5 }));
    marks.push({ ...text([LEFT - 0.75, y], String(10 ** power), "ink"), size: 12 });
  }
  for (const n of [1, 6, 12, 18, 24])
    marks.push({ ...text([xOf(n), BOTTOM - 0.5], String(n), "ink"), size: 12 });
  marks.push(line([[xOf(count), BOTTOM], [xOf(count), TOP]], "ink", { width: 1, dashed: true }));
  const counts = [...known.keys()].sort((a, b) => a - b);
  ERRORS.forEach(([name, ink, value], i) => {
    const points = counts.map((n) => [xOf(n), yOf(value(known.get(n)))]);
    if (points.length > 1) marks.push(line(points, ink, { width: 3 }));
    marks.push(dot([xOf(count), yOf(value(found))], ink, 0.14));
    marks.push({ ...text([RIGHT - 2.4, TOP + 0.25 - 0.7 * i], name, ink), size: 12 });
  });
}
