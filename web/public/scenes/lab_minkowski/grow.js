// A shape that grows by a part of another. The sum A + B is A + g B + (1 - g) B for any part g of
// convex shapes: what A grows by, B has lost, and both touch at the same places of their centres.

import { along, shapeOf, wayOf } from "../geometry/look.js";

/** Shapes have a size: what is left of B as a point, as a part of it. */
const POINT = 1e-9;

/** B in this part of its size. */
export function shrunk(shape, part) {
  const sized = Math.max(part, POINT);
  const size = ({ radius, halfWidth, halfHeight }) =>
    radius
      ? { radius: radius * sized }
      : { halfWidth: halfWidth * sized, halfHeight: halfHeight * sized };
  return { ...shape, ...size(shape) };
}

export function growShape(thud, geometry, state) {
  const [a, b] = [shapeOf(state, "A"), shapeOf(state, "B")];
  const way = ["A", "B"].map((letter) => wayOf(state, letter));
  const moving = [a, { way: way[0] }, b, { way: way[1] }];
  const relative = [way[1][0] - way[0][0], way[1][1] - way[0][1]];
  const segment = [b.center, along(b, relative, 1).center];
  const crossing = geometry.minkowskiCast(thud, ...moving);
  return {
    letters: ["A", "B"],
    shapes: [a, b],
    ways: way,
    outline: outlineOf(thud, geometry, a, shrunk(b, state.grown)),
    closed: true,
    rest: shrunk(b, 1 - state.grown),
    segment,
    crossing: crossing && { time: crossing.fraction, normal: crossing.normal },
    swept: geometry.timeOfImpact(thud, ...moving),
    inside: geometry.minkowskiSum(thud, unplaced(a), unplaced(b), minus(b.center, a.center)).overlaps,
    overlaps: geometry.closest(thud, a, b).overlaps,
  };
}

const minus = ([x, y], [u, v]) => [x - u, y - v];

function unplaced({ center, ...shape }) {
  return shape;
}

/** The edge of A grown by B, in the world. */
function outlineOf(thud, geometry, a, b) {
  const { outline } = geometry.minkowskiSum(thud, unplaced(a), unplaced(b), [0, 0]);
  return Array.from({ length: outline.length / 2 }, (_, i) => [
    a.center[0] + outline[2 * i],
    a.center[1] + outline[2 * i + 1],
  ]);
}
