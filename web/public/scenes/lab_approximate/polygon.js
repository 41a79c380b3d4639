// The corners of the polygon, which the pointer drags.

export const CORNERS = 12;

/** How near to a corner a pointer must come, in world units. */
const REACH = 0.6;
const X = [-6, 6];
const Y = [-1.5, 5];

const within = (value, [least, most]) => Math.min(most, Math.max(least, value));
/** To the steps that the sliders have. */
const round = (value) => Math.round(20 * value) / 20;

export function pointsOf(state) {
  return Array.from({ length: CORNERS }, (_, i) => [state[`x${i}`], state[`y${i}`]]);
}

/** The state follows the pointer. */
export function drag(state, { x, y, down }) {
  if (!down) {
    state.grip = null;
    state.near = nearest(state, x, y);
    return;
  }
  state.grip ??= nearest(state, x, y) ?? "nothing";
  if (state.grip === "nothing") return;
  state[`x${state.grip}`] = round(within(x, X));
  state[`y${state.grip}`] = round(within(y, Y));
}

/** The number of the corner that a press would take; null for none. */
function nearest(state, x, y) {
  const away = pointsOf(state).map(([px, py]) => Math.hypot(px - x, py - y));
  const i = away.indexOf(Math.min(...away));
  return away[i] < REACH ? i : null;
}
