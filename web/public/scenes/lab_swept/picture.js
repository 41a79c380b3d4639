// What is drawn: the strips that the circles sweep, their places at impact and where they are
// nearest, and the flight as a parabola, as straight ways and as the engine’s ball makes it.

import { along } from "../geometry/look.js";
import { dot, INKS, line, paintHandles, solid, text } from "../geometry/picture.js";
import { placeAt, RADIUS } from "./flight.js";

/** Corners of the parabola as it is drawn. */
const FINE = 64;

export function paintSwept(state, met, flown) {
  const marks = [];
  const { shapes, ways } = met;
  shapes.forEach((shape, i) => paintStrip(marks, shape, ways[i], INKS[i]));
  if (state.nearest) paintNearest(marks, met);
  if (state.equation) paintImpact(marks, met);
  shapes.forEach((shape, i) => paintHandles(marks, state, shape, ways[i], i));
  paintFlight(marks, state, flown);
  return { marks };
}

/** A circle swept along its way is a capsule: both ends, and two lines beside the way. */
function paintStrip(marks, shape, way, ink) {
  const end = along(shape, way, 1);
  marks.push({ ...solid(shape), ink, filled: true, opacity: 0.38 }, { ...solid(shape), ink });
  marks.push({ ...solid(end), ink, opacity: 0.5 });
  const length = Math.hypot(...way);
  if (length === 0) return;
  const [u, v] = [(-way[1] / length) * shape.radius, (way[0] / length) * shape.radius];
  for (const side of [1, -1]) {
    const beside = ({ center: [x, y] }) => [x + side * u, y + side * v];
    marks.push(line([beside(shape), beside(end)], ink, { opacity: 0.5 }));
  }
}

function paintImpact(marks, { shapes, ways, approach: { time } }) {
  if (time === null) return;
  const there = shapes.map((shape, i) => along(shape, ways[i], time));
  for (const shape of there) marks.push({ ...solid(shape), ink: "bad" });
  const [a, b] = there;
  const [dx, dy] = [b.center[0] - a.center[0], b.center[1] - a.center[1]];
  const part = a.radius / (a.radius + b.radius);
  marks.push(dot([a.center[0] + part * dx, a.center[1] + part * dy], "bad", 0.13));
}

function paintNearest(marks, { shapes, ways, reach, approach: { minDistance, minDistanceTime } }) {
  const ends = shapes.map((shape, i) => along(shape, ways[i], minDistanceTime).center);
  const ink = minDistance > reach ? "good" : "gold";
  marks.push(line(ends, ink, { dashed: true, width: 3 }), ...ends.map((end) => dot(end, ink)));
  const [x, y] = [0, 1].map((k) => 0.5 * (ends[0][k] + ends[1][k]));
  marks.push(text([x, y - 0.35], minDistance.toFixed(2), ink));
}

function paintFlight(marks, state, { corners, chord, curve, trace, gravity, seconds, gap }) {
  const fine = Array.from({ length: FINE + 1 }, (_, i) => placeAt(gravity, (i * seconds) / FINE));
  marks.push(line(fine, "good", { width: 2 }), line(corners, "rival", { width: 2, dashed: true }));
  for (const corner of corners) marks.push(dot(corner, "rival", 0.06));
  for (const [x, y] of trace) marks.push({ kind: "circle", x, y, radius: RADIUS, ink: "player" });
  if (trace.length > 0) marks.push({ ...dot(trace.at(-1), "player", RADIUS) });
  if (!state.sagitta) return;
  marks.push(line([chord, curve], "gold", { width: 4 }));
  marks.push(text([curve[0], Math.max(curve[1], chord[1]) + 0.35], `g dt²/8 = ${gap.toFixed(4)}`, "gold"));
}
