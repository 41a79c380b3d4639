// The time of impact of two moving circles. Seen from A, B’s centre goes from p along v. Where it is
// R away, the sum of both radii, the circles touch: |p + v t|² = R² is a t² + b t + c = 0 with
// a = v·v, b = 2 p·v, c = p·p - R². Of its two roots the smaller is the time at which they begin to
// overlap.

import { LETTERS, shapeOf, wayOf } from "../geometry/look.js";

const dot = ([x, y], [u, v]) => x * u + y * v;

export function solve(thud, geometry, state) {
  const [a, b] = LETTERS.map((letter) => shapeOf(state, letter));
  const [wayA, wayB] = LETTERS.map((letter) => wayOf(state, letter));
  const p = [b.center[0] - a.center[0], b.center[1] - a.center[1]];
  const v = [wayB[0] - wayA[0], wayB[1] - wayA[1]];
  const reach = a.radius + b.radius;
  const coefficients = [dot(v, v), 2 * dot(p, v), dot(p, p) - reach * reach];
  return {
    shapes: [a, b],
    ways: [wayA, wayB],
    reach,
    coefficients,
    ...rootsOf(coefficients),
    /** The engine’s own answer: its time of impact and closest approach. */
    approach: geometry.approach(thud, a, { way: wayA }, b, { way: wayB }),
  };
}

/** The discriminant and both roots, the smaller first; none where it is negative or nothing moves. */
function rootsOf([a, b, c]) {
  const discriminant = b * b - 4 * a * c;
  if (discriminant < 0 || a === 0) return { discriminant, roots: [] };
  // The sum with equal signs loses no digits; the other root follows from the product c / a.
  const q = -0.5 * (b + (b < 0 ? -1 : 1) * Math.sqrt(discriminant));
  const roots = q === 0 ? [0, 0] : [q / a, c / q];
  return { discriminant, roots: roots.sort((one, other) => one - other) };
}
