// What the pointer takes hold of: an end of a capsule, the knob that turns an OBB, or a whole shape.

import { knobOf } from "../geometry/hands.js";
import { capsuleOf, otherOf } from "./solids.js";

/** How near to an end or knob a pointer must come, and to a shape, in world units. */
const REACH = 0.5;
const AROUND = 0.3;
const LIMITS = { x: 6, y: 5 };

/** The state follows the pointer. */
export function drag(state, { x, y, down }) {
  if (!down) {
    state.grip = null;
    state.near = takenAt(state, x, y);
  } else if (state.grip) move(state, state.grip, x, y);
  else state.near = state.grip = takenAt(state, x, y) ?? { part: "nothing" };
}

/** The ends and knobs: { part, at }; of an end the part is the name of its place in the state. */
export function handlesOf(state) {
  const other = otherOf(state);
  const ends = ({ from, to }, letter) => [
    { part: `${letter}1`, at: from },
    { part: `${letter}2`, at: to },
  ];
  if (other.kind === "capsule") return [...ends(other, "B"), ...ends(capsuleOf(state, "A"), "A")];
  const knob = knobOf(other);
  return [...(knob ? [{ part: "turn", at: knob }] : []), ...ends(capsuleOf(state, "A"), "A")];
}

/** What a press would take, with its way from the pointer; null for nothing. */
function takenAt(state, x, y) {
  const [handle] = handlesOf(state)
    .map(({ part, at }) => ({ part, dx: at[0] - x, dy: at[1] - y }))
    .filter(({ dx, dy }) => Math.hypot(dx, dy) < REACH)
    .sort((one, other) => Math.hypot(one.dx, one.dy) - Math.hypot(other.dx, other.dy));
  if (handle) return handle;
  const shapes = { B: otherOf(state), A: capsuleOf(state, "A") };
  const letter = Object.keys(shapes).find((name) => beside(shapes[name], x, y) <= AROUND);
  return letter ? { part: letter, dx: state[`x${letter}1`] - x, dy: state[`y${letter}1`] - y } : null;
}

/** How far a point lies outside of a shape; 0 inside. */
function beside(shape, x, y) {
  const { kind, center, radius, halfWidth, halfHeight, angle = 0 } = shape;
  if (kind === "capsule") return Math.max(0, fromSegment(shape, x, y) - radius);
  const [dx, dy] = [x - center[0], y - center[1]];
  if (kind === "circle") return Math.max(0, Math.hypot(dx, dy) - radius);
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const u = Math.max(0, Math.abs(c * dx + s * dy) - halfWidth);
  const v = Math.max(0, Math.abs(c * dy - s * dx) - halfHeight);
  return Math.hypot(u, v);
}

function fromSegment({ from, to }, x, y) {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const squared = dx * dx + dy * dy;
  const along = squared > 0 ? ((x - from[0]) * dx + (y - from[1]) * dy) / squared : 0;
  const part = Math.min(1, Math.max(0, along));
  return Math.hypot(x - from[0] - part * dx, y - from[1] - part * dy);
}

const within = (value, limit) => Math.min(limit, Math.max(-limit, value));

function move(state, { part, dx, dy }, x, y) {
  if (part === "turn") {
    const [u, v] = [x + dx - state.xB1, y + dy - state.yB1];
    state.angleB = Math.round((Math.atan2(v, u) * 180) / Math.PI);
    return;
  }
  if (part === "A" || part === "B") {
    // Both ends go as far, and none of them beyond the limits.
    const ends = part === "A" || state.kindB === "capsule" ? [1, 2] : [1];
    for (const [axis, to] of [["x", x + dx], ["y", y + dy]]) {
      const names = ends.map((end) => axis + part + end);
      const by = to - state[names[0]];
      if (names.every((name) => Math.abs(state[name] + by) <= LIMITS[axis]))
        for (const name of names) state[name] += by;
    }
    return;
  }
  if (part === "nothing") return;
  state[`x${part}`] = within(x + dx, LIMITS.x);
  state[`y${part}`] = within(y + dy, LIMITS.y);
}
