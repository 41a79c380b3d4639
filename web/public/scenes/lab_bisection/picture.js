// What is drawn: both shapes at the ends of the interval, the intervals below each other, and the
// bullets’ lanes with the poses that a bullet takes.

import { INKS, line, paintHandles, solid, text } from "../geometry/picture.js";
import { posesAt } from "./halve.js";
import { HALF_HEIGHT, heightOf, RADIUS, START } from "./paper.js";

/** The step, from 0 to 1, is drawn from -SPAN to SPAN. */
const SPAN = 5;
const [TOP, ROW] = [-1.2, 0.12];
/** More poses than this would be one bar. */
const MOST_POSES = 80;

export function paintBisection(state, halved, shots) {
  const marks = [];
  if (state.interval) paintIntervals(marks, halved);
  paintShapes(marks, state, halved);
  paintLanes(marks, state, shots);
  return { marks };
}

function paintShapes(marks, state, { shapes, ways, intervals, found }) {
  const { low, high } = intervals.at(-1);
  const pose = (time, ink, more) => {
    for (const shape of posesAt(shapes, ways, time)) marks.push({ ...solid(shape), ink, ...more });
  };
  pose(high, "bad", { filled: true, opacity: found ? 0.3 : 0 });
  pose(high, found ? "bad" : "soft", {});
  pose(low, found ? "good" : "soft", {});
  shapes.forEach((shape, i) => {
    marks.push({ ...solid(shape), ink: INKS[i], filled: true, opacity: 0.38 });
    paintHandles(marks, state, shape, ways[i], i);
  });
}

function paintIntervals(marks, { intervals, impact, found }) {
  const at = (time) => (2 * time - 1) * SPAN;
  marks.push(text([-SPAN - 0.6, TOP], "0", "ink"), text([SPAN + 0.6, TOP], "1", "ink"));
  intervals.forEach(({ low, high }, i) => {
    const y = TOP - i * ROW;
    const last = i === intervals.length - 1;
    const ink = last ? (found ? "gold" : "ink") : "soft";
    marks.push(line([[at(low), y], [at(high), y]], ink, { width: last ? 5 : 3 }));
  });
  if (impact === null) return;
  const ink = found ? "good" : "bad";
  marks.push(line([[at(impact), TOP + 0.3], [at(impact), TOP - intervals.length * ROW]], ink, { dashed: true }));
}

function paintLanes(marks, state, { motion, thinnest, bisectable, lanes }) {
  const ink = bisectable ? "good" : "bad";
  const sign = bisectable ? "<" : "≥";
  const words = bisectable ? "is caught" : "may pass";
  const top = heightOf(0) + 1.15;
  const sum = `speed × step ${motion.toFixed(3)} ${sign} ${thinnest.toFixed(2)} thick: ${words}`;
  marks.push(text([0, top], sum, ink));
  const count = Math.floor((-2 * START) / motion);
  for (const { detection, y, x, outcome } of lanes) {
    marks.push(line([[START, y], [-START, y]], "soft", { width: 1 }));
    // A bullet that is caught takes none of the poses behind the paper.
    const poses = outcome === "is caught" ? Math.floor(-START / motion) : count;
    if (count <= MOST_POSES)
      for (let i = 0; i <= poses; i++)
        marks.push({ kind: "circle", x: START + i * motion, y, radius: RADIUS, ink, opacity: 0.6 });
    marks.push({ kind: "box", x: 0, y, halfWidth: 0.5 * state.thickness, halfHeight: HALF_HEIGHT, ink: "ink" });
    marks.push({ kind: "circle", x, y, radius: RADIUS, ink: "player", filled: true });
    marks.push(text([-4.6, y + 0.38], detection, "ink"));
    const told = outcome === "passes" ? "bad" : outcome === "flies" ? "soft" : "good";
    marks.push(text([4.6, y + 0.38], outcome, told));
  }
}
