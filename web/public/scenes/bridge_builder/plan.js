// The bridge on paper: beams between places of the grid, and what they cost. A beam is
// { from, to }, both [column, row]; between places of the road's row it is road.

import { CELL, nearest, placeOf } from "./levels.js";

export const LONGEST = 4.5; // metres, of a beam
const ROAD_PRICE = 50; // a metre
const STRUT_PRICE = 25;
const GRAB = 0.5; // metres around the middle of a beam, where it is tapped

export function emptyPlan() {
  return {
    beams: [],
    past: [], // what the beams were before each change
    selected: null, // a place of the grid that was tapped, from which the next beam goes
    press: null, // where in the world the pointer was pressed, while it is
    pointer: null, // where it is then
  };
}

export function isRoad({ from, to }) {
  return from[1] === 0 && to[1] === 0;
}

export function lengthOf({ from, to }) {
  return CELL * Math.hypot(to[0] - from[0], to[1] - from[1]);
}

export function costOf(beams) {
  const prices = beams.map((beam) => lengthOf(beam) * (isRoad(beam) ? ROAD_PRICE : STRUT_PRICE));
  return Math.round(prices.reduce((sum, price) => sum + price, 0));
}

export function isSame([a, b], [c, d]) {
  return a === c && b === d;
}

/** Whether there is something at a place of the grid that a beam can be tied to. */
export function isHeld(level, beams, place) {
  const ends = beams.flatMap(({ from, to }) => [from, to]);
  return [...level.anchors, ...ends].some((end) => isSame(end, place));
}

/**
 * The beams along a straight line, from each place of the grid that it meets to the next: a stroke
 * over the whole gorge is a road. Those that are there already are left out.
 */
export function beamsAlong(beams, from, to) {
  const across = to[0] - from[0];
  const up = to[1] - from[1];
  const count = divisor(Math.abs(across), Math.abs(up));
  const at = (i) => [from[0] + (i * across) / count, from[1] + (i * up) / count];
  const all = Array.from({ length: count }, (_, i) => ({ from: at(i), to: at(i + 1) }));
  return all.filter((beam) => !beams.some((other) => joinsSame(beam, other)));
}

/** The greatest number that divides both. */
function divisor(a, b) {
  return b === 0 ? a : divisor(b, a % b);
}

/** Whether two beams have the same ends. */
export function joinsSame(beam, { from, to }) {
  return (
    (isSame(beam.from, from) && isSame(beam.to, to)) ||
    (isSame(beam.from, to) && isSame(beam.to, from))
  );
}

/** Why beams cannot be added; "" if they can. */
export function refusal(level, beams, added) {
  if (added.length === 0) return "There is a beam already.";
  if (Math.max(...added.map(lengthOf)) > LONGEST) return `No beam is longer than ${LONGEST} m.`;
  const left = level.budget - costOf(beams);
  const cost = costOf(added);
  return cost > left ? `Too dear: that costs ${cost}, and ${left} is left.` : "";
}

/** Which beam's middle is at a place in the world; -1 if none is. */
export function beamAt(level, beams, x, y) {
  return beams.findIndex(({ from, to }) => {
    const middle = placeOf(level, [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2]);
    return Math.hypot(middle[0] - x, middle[1] - y) < GRAB;
  });
}

/**
 * What a pointer asks for that was pressed at `press` and is at `now`, both [x, y] in the world, or
 * would ask for if it were let go there: { remove: i }, { add: [from, to] }, { select: place },
 * { select: null }, or nothing. `selected`: the place of the grid that was tapped before.
 */
export function wishOf(level, beams, selected, press, now) {
  const [from, to] = [nearest(level, ...press), nearest(level, ...now)];
  const held = isHeld(level, beams, from);
  if (!isSame(from, to)) {
    const start = held ? from : selected;
    return start && !isSame(start, to) ? { add: [start, to] } : {};
  }
  const beam = beamAt(level, beams, ...press);
  if (beam >= 0) return { remove: beam };
  if (selected) return isSame(selected, to) ? { select: null } : { add: [selected, to] };
  return held ? { select: to } : {};
}

/** Follows the pointer; says what became of it when it was let go, or null. */
export function sketch(plan, level, pointer) {
  const at = pointer && [pointer.x, pointer.y];
  if (pointer?.down) {
    plan.press ??= at;
    plan.pointer = at;
    return null;
  }
  if (!plan.press) return null;
  const { press } = plan;
  plan.press = null;
  return follow(plan, level, wishOf(level, plan.beams, plan.selected, press, plan.pointer));
}

function follow(plan, level, { add, remove, select }) {
  const { beams } = plan;
  if (select !== undefined) {
    plan.selected = select;
    return select ? "Now tap where the beam is to end." : "";
  }
  if (remove !== undefined) {
    change(plan, beams.filter((_, i) => i !== remove));
    plan.selected = null;
    return "Removed.";
  }
  if (!add) return "Begin at a ring, or where a beam ends.";
  const added = beamsAlong(beams, ...add);
  const why = refusal(level, beams, added);
  if (why) return why;
  change(plan, [...beams, ...added]);
  // Who taps goes on from there; who drags takes hold anew.
  if (plan.selected) [, plan.selected] = add;
  return "";
}

function change(plan, beams) {
  plan.past = [...plan.past.slice(-99), plan.beams];
  plan.beams = beams;
}

export function clear(plan) {
  if (plan.beams.length === 0) return "There is nothing to clear.";
  change(plan, []);
  plan.selected = null;
  return "Cleared. Undo brings it back.";
}

export function undo(plan) {
  const beams = plan.past.pop();
  if (!beams) return "There is nothing to undo.";
  plan.beams = beams;
  plan.selected = null;
  return "";
}
