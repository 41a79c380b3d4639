// What is drawn of two shapes: themselves with their handles, and what is ticked in the panel.

import { knobOf, tipOf } from "./hands.js";
import { along, LETTERS, VOLUMES } from "./look.js";

export const INKS = ["player", "rival"];

export function paintAll(state, seen) {
  const marks = [];
  const { shapes, ways, closest } = seen;
  if (state.sum) paintSum(marks, seen);
  for (const kind of VOLUMES.filter((name) => state[name]))
    for (const side of ["first", "second"]) marks.push({ ...solid(seen.bounds[kind][side]), ink: "ink", opacity: 0.7 });
  const hit = state.overlap && closest.overlaps;
  shapes.forEach((shape, i) => {
    marks.push({ ...solid(shape), ink: INKS[i], filled: true, opacity: 0.38 });
    marks.push({ ...solid(shape), ink: hit ? "bad" : INKS[i] });
  });
  if (state.ways) paintWays(marks, seen);
  if (state.closest) paintClosest(marks, closest);
  shapes.forEach((shape, i) => paintHandles(marks, state, shape, ways[i], i));
  return { marks };
}

/** A shape as a mark; its ink and whether it is filled come to it. */
export function solid({ kind, center: [x, y], radius, halfWidth, halfHeight, angle = 0 }) {
  if (kind === "circle") return { kind: "circle", x, y, radius };
  return { kind: "box", x, y, halfWidth, halfHeight, angle };
}

export const line = (points, ink, more = {}) => ({ kind: "line", points, ink, ...more });
export const dot = ([x, y], ink, radius = 0.09) => (
  { kind: "circle", x, y, radius, ink, filled: true }
);
export const text = ([x, y], words, ink) => ({ kind: "text", x, y, text: words, ink });

/** What turns and what is pulled, larger where the pointer would take it. */
export function paintHandles(marks, state, shape, way, i) {
  const held = (part) => state.near?.part === part && state.near.letter === LETTERS[i];
  const handle = (at, part) => {
    marks.push(dot(at, INKS[i], held(part) ? 0.26 : 0.17));
    marks.push({ ...dot(at, "ink", held(part) ? 0.26 : 0.17), filled: false });
  };
  const knob = knobOf(shape);
  if (knob) {
    marks.push(line([shape.center, knob], INKS[i], { dashed: true, width: 1.5 }));
    handle(knob, "turn");
  }
  paintArrow(marks, shape.center, way, INKS[i], held("way"));
  marks.push(dot(shape.center, "ink", 0.07));
  const [x, y] = shape.center;
  marks.push(text([x - 0.3, y - 0.3], LETTERS[i], INKS[i]));
}

function paintArrow(marks, from, [dx, dy], ink, held) {
  const length = Math.hypot(dx, dy);
  const tip = [from[0] + dx, from[1] + dy];
  const width = held ? 5 : 3;
  marks.push(line([from, tip], ink, { width }));
  const [u, v] = length > 0 ? [dx / length, dy / length] : [0, 0];
  const barb = (side) => [
    tip[0] - 0.35 * u - side * 0.2 * v,
    tip[1] - 0.35 * v + side * 0.2 * u,
  ];
  marks.push(line([barb(1), tip, barb(-1)], ink, { width }));
  marks.push({ ...dot(tip, ink, held ? 0.3 : 0.22), filled: false, opacity: 0.8 });
}

function paintClosest(marks, { pointA, pointB, distance, overlaps }) {
  const ink = overlaps ? "bad" : "gold";
  marks.push(line([pointA, pointB], ink, { width: 3 }));
  marks.push(dot(pointA, ink), dot(pointB, ink));
  const middle = [(pointA[0] + pointB[0]) / 2, (pointA[1] + pointB[1]) / 2 + 0.35];
  marks.push(text(middle, (overlaps ? -distance : distance).toFixed(2), ink));
}

/** Both where they first touch, or where they are nearest. */
function paintWays(marks, { shapes, ways, impact, least, passing }) {
  const time = impact ?? least.time;
  shapes.forEach((shape, i) => {
    const there = along(shape, ways[i], time);
    marks.push({ ...solid(there), ink: INKS[i], opacity: 0.55 });
    const end = along(shape, ways[i], 1);
    marks.push({ ...solid(end), ink: INKS[i], opacity: 0.22 });
  });
  const { pointA, pointB } = passing;
  const ink = impact === null ? "good" : "bad";
  marks.push(line([pointA, pointB], ink, { dashed: true }), dot(pointA, ink), dot(pointB, ink));
}

/** The sum about A’s centre, B as a point, and both ways as one of the point. */
function paintSum(marks, { shapes: [a, b], ways, sum, crossing }) {
  const [x, y] = a.center;
  const { outline: numbers } = sum;
  const points = [];
  for (let i = 0; i < numbers.length; i += 2) points.push([x + numbers[i], y + numbers[i + 1]]);
  const ink = sum.overlaps ? "bad" : "good";
  marks.push(line([...points, points[0]], ink, { width: 2.5 }));
  const [dx, dy] = [ways[1][0] - ways[0][0], ways[1][1] - ways[0][1]];
  marks.push(line([b.center, tipOf(b, [dx, dy])], ink, { dashed: true }));
  marks.push(dot(b.center, ink, 0.15));
  if (crossing) marks.push(dot(tipOf(b, [crossing.fraction * dx, crossing.fraction * dy]), "gold", 0.15));
}
