/** Bounding volumes, whose overlap test is cheaper than the exact test of shapes. */
import type { Engine } from "../engine.js";
import { GeometryPairAt, NumberAt, VolumeAt } from "../generated/slots.js";
import { indexOf, vecAt } from "../numbers.js";
import { SHAPE_KINDS } from "../types.js";
import { checkGeometry, type PlacedShape, putPair, putShape } from "./pair.js";

export type VolumeKind = PlacedShape["kind"];

/** The smallest circle, AABB or OBB that contains a shape. */
export function volumeAroundShape(engine: Engine, kind: VolumeKind, shape: PlacedShape): PlacedShape {
  putShape(engine, shape, GeometryPairAt.a);
  const number = indexOf(SHAPE_KINDS, kind, "volume kind");
  checkGeometry("volumeAroundShape", engine.exports.api_volume_around_shape(number));
  const s = engine.slots;
  const center = vecAt(s, VolumeAt.center);
  const [halfWidth, halfHeight] = vecAt(s, VolumeAt.halfExtents);
  if (kind === "circle") return { kind, center, radius: halfWidth };
  if (kind === "aabb") return { kind, center, halfWidth, halfHeight };
  const [c, sine] = vecAt(s, VolumeAt.turn);
  return { kind, center, halfWidth, halfHeight, angle: Math.atan2(sine, c) };
}

/** Whether two volumes share a point; touching counts. */
export function volumesOverlap(engine: Engine, a: PlacedShape, b: PlacedShape): boolean {
  putPair(engine, a, b);
  checkGeometry("volumesOverlap", engine.exports.api_volumes_overlap());
  return engine.slots[NumberAt.value] !== 0;
}

/**
 * Runs the same overlap test `count` times, to measure its time: `exact`, the test of shapes, or
 * that of bounding volumes. Returns how many of the tests found an overlap.
 */
export function overlapOften(
  engine: Engine,
  a: PlacedShape,
  b: PlacedShape,
  exact: boolean,
  count: number,
): number {
  putPair(engine, a, b);
  checkGeometry("overlapOften", engine.exports.api_overlap_often(Number(exact), count));
  return engine.slots[NumberAt.value];
}
