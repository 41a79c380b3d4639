// What the pointer takes hold of: the tip of an arrow, the knob that turns an OBB, or a shape.

import { LETTERS, shapeOf, wayOf } from "./look.js";

/** How near to a tip or knob a pointer must come, and to a shape, in world units. */
const REACH = 0.75;
const AROUND = 0.3;
/** Of the knob beyond the shape’s end. */
const STEM = 0.7;

/** Of places and ways, as the sliders have them. */
const LIMITS = { x: 8, y: 5, wayX: 12, wayY: 8 };

/** The state follows the pointer, which may take the shapes of these letters. */
export function drag(state, { x, y, down }, letters = LETTERS) {
  if (!down) {
    state.grip = null;
    state.near = takenAt(state, x, y, letters);
  } else if (state.grip) move(state, state.grip, x, y);
  else state.near = state.grip = takenAt(state, x, y, letters) ?? { part: "nothing" };
}

/** Where the knob is that turns a shape; null for what does not turn. */
export function knobOf({ kind, center: [x, y], halfWidth, angle }) {
  if (kind !== "obb") return null;
  const reach = halfWidth + STEM;
  return [x + reach * Math.cos(angle), y + reach * Math.sin(angle)];
}

export function tipOf({ center: [x, y] }, [dx, dy]) {
  return [x + dx, y + dy];
}

/** { part, letter, dx, dy }: what a press would take, and how far from it; null for nothing. */
function takenAt(state, x, y, letters) {
  const [handle] = letters.flatMap((letter) => handlesOf(state, letter))
    .map((one) => ({ ...one, dx: one.at[0] - x, dy: one.at[1] - y }))
    .map((one) => ({ ...one, away: Math.hypot(one.dx, one.dy) }))
    .sort((one, other) => one.away - other.away);
  // A shape is taken beside its handles, and the one that is drawn last lies on top.
  if (handle?.away < REACH / 2) return handle;
  const letter = [...letters].reverse().find((one) => beside(shapeOf(state, one), x, y) <= AROUND);
  if (letter) return { part: "move", letter, dx: state[`x${letter}`] - x, dy: state[`y${letter}`] - y };
  return handle?.away < REACH ? handle : null;
}

function handlesOf(state, letter) {
  const shape = shapeOf(state, letter);
  const knob = knobOf(shape);
  return [
    // A scene whose shapes do not move has no ways in its state.
    ...(`wayX${letter}` in state ? [{ part: "way", letter, at: tipOf(shape, wayOf(state, letter)) }] : []),
    ...(knob ? [{ part: "turn", letter, at: knob }] : []),
  ];
}

/** How far a point lies outside of a shape; 0 inside. */
function beside({ center, radius, halfWidth, halfHeight, angle = 0 }, x, y) {
  const [dx, dy] = [x - center[0], y - center[1]];
  if (radius) return Math.max(0, Math.hypot(dx, dy) - radius);
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const u = Math.max(0, Math.abs(c * dx + s * dy) - halfWidth);
  const v = Math.max(0, Math.abs(c * dy - s * dx) - halfHeight);
  return Math.hypot(u, v);
}

function move(state, { part, letter, dx, dy }, x, y) {
  const put = (name, value) => {
    const limit = LIMITS[name];
    state[name + letter] = Math.min(limit, Math.max(-limit, value));
  };
  const [x0, y0] = [state[`x${letter}`], state[`y${letter}`]];
  if (part === "move") {
    put("x", x + dx);
    put("y", y + dy);
  } else if (part === "way") {
    put("wayX", x + dx - x0);
    put("wayY", y + dy - y0);
  } else if (part === "turn") {
    state[`angle${letter}`] = (Math.atan2(y + dy - y0, x + dx - x0) * 180) / Math.PI;
  }
}
