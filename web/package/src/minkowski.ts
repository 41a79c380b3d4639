/**
 * The Minkowski sum of two shapes: all places of the second shape's centre, relative to the
 * first's, at which the shapes share a point. It reduces the overlap of two shapes to a point in a
 * shape.
 */
import type { Engine } from "./engine.js";
import { ThudError } from "./error.js";
import { MinkowskiPairAt, MinkowskiSumAt } from "./generated/slots.js";
import { solidNumbers, vecAt } from "./numbers.js";
import type { SolidShape } from "./query-types.js";
import type { Vec2 } from "./types.js";

/** The sum and the place of b in it. Places are relative to the first shape's centre. */
export interface MinkowskiSum {
  /** Whether the shapes share a point: the offset lies in the sum or on its edge. */
  overlaps: boolean;
  /** The point of the sum's edge that is closest to the offset. */
  edge: Vec2;
  /** x and y of points along the edge, counter-clockwise; the first is not repeated at the end. */
  outline: Float64Array;
}

/** Line segments of a rounded corner, and of a whole circle, in the outline. Chosen for drawing. */
const ARC = 12;
const CIRCLE = 96;

/**
 * The sum of `a` and the reflected `b`, whose centre lies at `offset` from a's.
 * @throws {ThudError} "invalid" for sizes that are not above 0 and numbers that are not finite.
 */
export function minkowskiSum(
  engine: Engine,
  a: SolidShape,
  b: SolidShape,
  offset: Vec2,
): MinkowskiSum {
  const s = engine.slots;
  s.set(solidNumbers(a), MinkowskiPairAt.a);
  s.set(solidNumbers(b), MinkowskiPairAt.b);
  s.set(offset, MinkowskiPairAt.offset);
  if (engine.exports.api_minkowski_sum() !== 0)
    throw new ThudError("invalid", "minkowskiSum: sizes must be above 0 and all numbers finite");
  const first = MinkowskiSumAt.vertices;
  const vertices = Array.from(s.subarray(first, first + 2 * s[MinkowskiSumAt.count]));
  return {
    overlaps: s[MinkowskiSumAt.overlaps] !== 0,
    edge: vecAt(s, MinkowskiSumAt.edge),
    outline: Float64Array.from(outlineOf(vertices, s[MinkowskiSumAt.radius])),
  };
}

/**
 * The outline of a polygon rounded by a radius: around each vertex an arc from the normal of one
 * face to that of the next. `vertices`: x and y, counter-clockwise; one vertex makes a circle.
 */
function outlineOf(vertices: number[], radius: number): number[] {
  if (radius === 0) return vertices;
  const count = vertices.length / 2;
  if (count === 1) {
    const last = 2 * Math.PI * (1 - 1 / CIRCLE);
    return arc(vertices[0], vertices[1], radius, 0, last, CIRCLE - 1);
  }
  const directions = Array.from({ length: count }, (_, i) => {
    const next = (i + 1) % count;
    const x = vertices[2 * next] - vertices[2 * i];
    const y = vertices[2 * next + 1] - vertices[2 * i + 1];
    return Math.atan2(-x, y);
  });
  return directions.flatMap((to, i) => {
    const from = directions[(i + count - 1) % count];
    const end = to < from ? to + 2 * Math.PI : to;
    return arc(vertices[2 * i], vertices[2 * i + 1], radius, from, end, ARC);
  });
}

/** x and y of `pieces` + 1 points of an arc around (x, y), between two angles in radians. */
function arc(
  x: number,
  y: number,
  radius: number,
  from: number,
  to: number,
  pieces: number,
): number[] {
  return Array.from({ length: pieces + 1 }, (_, i) => from + ((to - from) * i) / pieces).flatMap(
    (angle) => [x + radius * Math.cos(angle), y + radius * Math.sin(angle)],
  );
}
