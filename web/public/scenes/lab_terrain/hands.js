// What the pointer takes hold of: a vertex, or else the place at which the line is looked at.

import { ENDS, pointsOf, VERTICES } from "./line.js";

/** How near to a vertex a pointer must come, in world units. */
const REACH = 0.6;
const HIGH = [-2, 3];

const within = (value, [least, most]) => Math.min(most, Math.max(least, value));
/** To the steps that the sliders have. */
const round = (value) => Math.round(20 * value) / 20;

/** The state follows the pointer. */
export function drag(state, { x, y, down }) {
  if (!down) {
    state.grip = null;
    state.near = nearest(state, x, y);
    return;
  }
  state.grip ??= nearest(state, x, y) ?? "place";
  if (state.grip === "place") state.x = round(within(x, [ENDS[0] + 0.1, ENDS[1] - 0.1]));
  else moveVertex(state, state.grip, x, y);
}

/** The number of the vertex that a press would take; null for none. */
function nearest(state, x, y) {
  const away = pointsOf(state).map(([px, py]) => Math.hypot(px - x, py - y));
  const i = away.indexOf(Math.min(...away));
  return away[i] < REACH ? i : null;
}

function moveVertex(state, i, x, y) {
  if (state.line === "flat") setSlope(state, i === 0 ? -y : y);
  else raise(state, i, y);
  if (state.line === "irregular") state[`x${i}`] = round(within(x, ENDS));
}

const setSlope = (state, y) => raise(state, VERTICES - 1, y);

function raise(state, i, y) {
  state[`y${i}`] = round(within(y, HIGH));
}

/** Moves the vertex that is nearest to the place up or down; of flat ground it tilts the line. */
export function lift(state, by) {
  if (state.line === "flat") {
    setSlope(state, state[`y${VERTICES - 1}`] + by);
    return;
  }
  const away = pointsOf(state).map(([x]) => Math.abs(x - state.x));
  const i = away.indexOf(Math.min(...away));
  raise(state, i, state[`y${i}`] + by);
}
