// The bisection of a step, halving by halving, as the engine does it: an overlap test at the end of
// the step and one at its start, and one more in the middle of the interval for each halving.

import { along, LETTERS, shapeOf, wayOf } from "../geometry/look.js";

/** The most halvings that can be shown. */
export const HALVINGS = 12;

export function halve(thud, geometry, state) {
  const shapes = LETTERS.map((letter) => shapeOf(state, letter));
  const ways = LETTERS.map((letter) => wayOf(state, letter));
  const overlapAt = (time) => geometry.closest(thud, ...posesAt(shapes, ways, time)).overlaps;
  const intervals = [{ low: 0, high: 1 }];
  const overlapsAtEnd = overlapAt(1);
  const overlapsAtStart = overlapAt(0);
  let tests = 2;
  if (overlapsAtEnd && !overlapsAtStart)
    for (let i = 0; i < state.halving; i++) {
      const { low, high } = intervals.at(-1);
      const middle = 0.5 * (low + high);
      intervals.push(overlapAt(middle) ? { low, high: middle } : { low: middle, high });
      tests++;
    }
  const moving = [shapes[0], { way: ways[0] }, shapes[1], { way: ways[1] }];
  return {
    shapes,
    ways,
    intervals,
    tests,
    overlapsAtStart,
    found: overlapsAtEnd && !overlapsAtStart,
    /** The same asked of the engine in one call, and the exact time. */
    engine: geometry.timeOfCollision(thud, ...moving, 2 ** -state.halving),
    impact: geometry.timeOfImpact(thud, ...moving),
  };
}

/** Both shapes a part of the step on. */
export function posesAt(shapes, ways, time) {
  return shapes.map((shape, i) => along(shape, ways[i], time));
}
