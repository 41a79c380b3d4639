/** A polygon approximated by circles and boxes. */
import { checkOptions } from "../checks/names.js";
import type { Engine } from "../engine.js";
import { RESULT_CODES, ThudError } from "../error.js";
import { ApproximationAt, PlacedAt, SolidAt } from "../generated/slots.js";
import { indexOf, rowsOf, vecAt } from "../numbers.js";
import type { SolidOptions, Vec2 } from "../types.js";
import type { PlacedShape } from "./pair.js";

/** The kinds of shapes that `approximate` uses, in the order of the engine's enum. */
export const APPROXIMATE_KINDS = ["both", "circles", "boxes"] as const;

export interface ApproximateOptions {
  /** The largest number of shapes, 1 to 64. */
  shapes: number;
  /** Circles, boxes (OBBs) or both. Default "both". */
  kinds?: (typeof APPROXIMATE_KINDS)[number];
  /**
   * The error that is good enough, a length from 0 to 10¹⁵: no more shapes are added once the
   * result's `distance` is at most this. Default 0.
   */
  distance?: number;
}

/** The shapes that approximate a polygon, and what they miss; areas are shares of the polygon's. */
export interface Approximation {
  /** They may overlap. */
  shapes: PlacedShape[];
  /** The same shapes as `createBody` takes them: `shapes` of a body whose origin is that of the points. */
  parts: SolidOptions[];
  /** The area of the polygon that no shape covers. */
  missed: number;
  /** The area outside of the polygon that shapes cover. */
  extra: number;
  /**
   * The sum of the shapes' areas less the area that they cover together, which counts in a body's
   * mass: a density divided by 1 + overlap + extra - missed gives the body the polygon's mass.
   */
  overlap: number;
  /**
   * An upper bound of the Hausdorff distance, a length: no point of the polygon is further from the
   * nearest shape, and no point of a shape further from the polygon.
   */
  distance: number;
}

/** The most shapes (THUD_APPROXIMATE_SHAPES_MAX). */
const MOST = 64;

/**
 * Covers a polygon by circles and boxes. `points`: 3 to 256 corners in either direction, |x|, |y|
 * up to 10¹²; edges must not cross or touch. Neither missed + extra nor distance is larger for a
 * larger number of shapes. Rectangles and most right-angled polygons are covered exactly.
 * @throws {ThudError} "invalid" where the points are no polygon, with the reason; "memory".
 */
export function approximate(
  engine: Engine,
  points: ArrayLike<Vec2>,
  options: ApproximateOptions,
): Approximation {
  checkOptions("approximate", options, ["shapes", "kinds", "distance"]);
  const { shapes, kinds = "both", distance = 0 } = options;
  if (!(Number.isInteger(shapes) && shapes >= 1 && shapes <= MOST))
    throw new ThudError("invalid", `approximate: shapes is ${shapes}, no whole number from 1 to ${MOST}`);
  const number = indexOf(APPROXIMATE_KINDS, kinds, "approximate: kinds");
  const result = engine.withPoints(points, (at, count) =>
    engine.exports.api_approximate(at, count, shapes, number, distance),
  );
  const { slots: s } = engine;
  if (RESULT_CODES[result] === "memory") throw new ThudError("memory", "approximate: out of memory");
  if (result !== 0) {
    const reason = s[ApproximationAt.reason];
    const why = reason === 0 ? `distance is ${distance}, out of range` : engine.text(reason);
    throw new ThudError("invalid", `approximate: ${why}`);
  }
  const { buffer } = engine;
  const found = rowsOf(Float64Array, buffer, s, ApproximationAt.shapes, PlacedAt.length, shapeAt);
  return {
    shapes: found,
    parts: found.map(({ center, ...shape }) => ({ ...shape, offset: center }) as SolidOptions),
    missed: s[ApproximationAt.missed],
    extra: s[ApproximationAt.extra],
    overlap: s[ApproximationAt.overlap],
    distance: s[ApproximationAt.distance],
  };
}

/** A row of `placed`: a circle or an OBB. */
function shapeAt(rows: Float64Array, at: number): PlacedShape {
  const [halfWidth, halfHeight] = vecAt(rows, at + SolidAt.halfExtents);
  const center = vecAt(rows, at + PlacedAt.center);
  if (rows[at + SolidAt.kind] === 0) return { kind: "circle", center, radius: halfWidth };
  return { kind: "obb", center, halfWidth, halfHeight, angle: rows[at + SolidAt.angle] };
}
