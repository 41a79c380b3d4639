// What is drawn: both shapes with their handles, the closest points with the normal, and the circle
// whose way the capsule is, where it hits B.

import { dot, INKS, line, solid, text } from "../geometry/picture.js";
import { handlesOf } from "./hands.js";

/** Corners of each round end, and the length of the arrow that shows the normal. */
const CORNERS = 16;
const ARROW = 1;

export function paintCapsules(state, seen) {
  const marks = [];
  const { a, b, closest } = seen;
  if (state.way) paintWay(marks, seen);
  [a, b].forEach((shape, i) => paintSolid(marks, shape, INKS[i], closest.overlaps));
  marks.push(line([a.from, a.to], INKS[0], { dashed: true, width: 1.5 }));
  if (b.kind === "capsule") marks.push(line([b.from, b.to], INKS[1], { dashed: true, width: 1.5 }));
  if (state.closest) paintClosest(marks, closest);
  for (const { part, at } of handlesOf(state)) {
    const radius = state.near?.part === part ? 0.24 : 0.15;
    if (part === "turn") marks.push(line([b.center, at], INKS[1], { dashed: true, width: 1.5 }));
    marks.push(dot(at, INKS[part.startsWith("A") ? 0 : 1], radius), { ...dot(at, "ink", radius), filled: false });
  }
  marks.push(text(beside(middleOf(a), a), "A", INKS[0]), text(beside(middleOf(b), b), "B", INKS[1]));
  return { marks };
}

function paintSolid(marks, shape, ink, overlaps) {
  const edge = overlaps ? "bad" : ink;
  if (shape.kind !== "capsule") {
    marks.push({ ...solid(shape), ink, filled: true, opacity: 0.38 }, { ...solid(shape), ink: edge });
    return;
  }
  const points = outlineOf(shape);
  marks.push(line(points, ink, { filled: true, opacity: 0.38 }), line(points, edge));
}

/** The edge of a capsule: half a circle around each end, and back to the first corner. */
export function outlineOf({ from, to, radius }) {
  const angle = Math.atan2(to[1] - from[1], to[0] - from[0]);
  const half = ([x, y], first) => Array.from({ length: CORNERS + 1 }, (_, i) => {
    const turned = first + (Math.PI * i) / CORNERS;
    return [x + radius * Math.cos(turned), y + radius * Math.sin(turned)];
  });
  const points = [...half(to, angle - Math.PI / 2), ...half(from, angle + Math.PI / 2)];
  return [...points, points[0]];
}

const middleOf = ({ kind, center, from, to }) =>
  kind === "capsule" ? [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2] : center;

/** Beside the middle, where no segment or knob covers it. */
const beside = ([x, y], { kind }) => (kind === "capsule" ? [x, y - 0.35] : [x - 0.3, y - 0.3]);

function paintClosest(marks, { pointA, pointB, normal, distance, overlaps }) {
  const ink = overlaps ? "bad" : "gold";
  const tip = [pointA[0] + ARROW * normal[0], pointA[1] + ARROW * normal[1]];
  const barb = (side) => [0, 1].map((k) =>
    tip[k] - 0.25 * normal[k] + side * 0.14 * (k === 0 ? -normal[1] : normal[0]));
  marks.push(line([pointA, tip], "ink", { width: 1.5 }), line([barb(1), tip, barb(-1)], "ink", { width: 1.5 }));
  marks.push(line([pointA, pointB], ink, { width: 4 }), dot(pointA, ink), dot(pointB, ink));
  const at = [pointA[0] - 0.6 * normal[0], pointA[1] - 0.6 * normal[1]];
  marks.push(text(at, `${overlaps ? "depth" : "distance"} ${Math.abs(distance).toFixed(2)}`, ink));
}

/** The circle at its start, where it first touches B or else at its end. */
function paintWay(marks, { a, way, impact }) {
  const circle = (part, ink, more) =>
    marks.push({
      ...{ kind: "circle", x: a.from[0] + part * way[0], y: a.from[1] + part * way[1] },
      ...{ radius: a.radius, ink, ...more },
    });
  circle(0, INKS[0], { opacity: 0.7 });
  const ink = impact === null ? "good" : "bad";
  circle(impact ?? 1, ink, { filled: true, opacity: 0.3 });
  circle(impact ?? 1, ink);
}
