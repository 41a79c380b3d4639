/** Bounding volumes, whose overlap test is cheaper than the exact test of shapes. */
import type { Engine } from "../engine.js";
import { GeometryPairAt, NumberAt, VolumeAt } from "../generated/slots.js";
import { indexOf, vecAt } from "../numbers.js";
import { SHAPE_KINDS, type Terrain, type Vec2 } from "../types.js";
import { onLine } from "./line.js";
import { checkGeometry, type Motion, type PlacedShape, putMoving, putPair, putShape } from "./pair.js";

export type VolumeKind = PlacedShape["kind"];

/** The smallest circle, AABB or OBB that contains a shape. */
export function volumeAroundShape(engine: Engine, kind: VolumeKind, shape: PlacedShape): PlacedShape {
  putShape(engine, shape, GeometryPairAt.a);
  const number = indexOf(SHAPE_KINDS, kind, "volume kind");
  checkGeometry("volumeAroundShape", engine.exports.api_volume_around_shape(number));
  return volumeNow(engine, kind);
}

/** Reads the slots of `volume`. */
function volumeNow({ slots: s }: Engine, kind: VolumeKind): PlacedShape {
  const center = vecAt(s, VolumeAt.center);
  const [halfWidth, halfHeight] = vecAt(s, VolumeAt.halfExtents);
  if (kind === "circle") return { kind, center, radius: halfWidth };
  if (kind === "aabb") return { kind, center, halfWidth, halfHeight };
  const [c, sine] = vecAt(s, VolumeAt.turn);
  return { kind, center, halfWidth, halfHeight, angle: Math.atan2(sine, c) };
}

/**
 * A volume of this kind around all places of a shape during its motion; a box is taken as wide as
 * it is at any time of the motion.
 */
export function volumeAroundMotion(
  engine: Engine,
  kind: VolumeKind,
  shape: PlacedShape,
  motion: Motion,
): PlacedShape {
  putMoving(engine, shape, motion);
  const number = indexOf(SHAPE_KINDS, kind, "volume kind");
  checkGeometry("volumeAroundMotion", engine.exports.api_volume_around_motion(number));
  return volumeNow(engine, kind);
}

/** The smallest volume of this kind around one or more points; they may lie on one line. */
export function volumeAroundPoints(
  engine: Engine,
  kind: VolumeKind,
  points: ArrayLike<Vec2>,
): PlacedShape {
  const number = indexOf(SHAPE_KINDS, kind, "volume kind");
  const result = engine.withPoints(points, (at, count) =>
    engine.exports.api_volume_around_points(number, at, count),
  );
  checkGeometry("volumeAroundPoints", result);
  return volumeNow(engine, kind);
}

/**
 * The smallest volume of this kind around a terrain line, without the ground below it, from `left`
 * to `right`; the interval is cut off at the ends of the line.
 */
export function volumeAroundTerrain(
  engine: Engine,
  kind: VolumeKind,
  line: Terrain,
  left: number,
  right: number,
): PlacedShape {
  const number = indexOf(SHAPE_KINDS, kind, "volume kind");
  onLine(engine, "volumeAroundTerrain", line, () =>
    engine.exports.api_volume_around_line(number, left, right),
  );
  return volumeNow(engine, kind);
}

/** A volume of this kind around two volumes. */
export function mergeVolumes(
  engine: Engine,
  kind: VolumeKind,
  a: PlacedShape,
  b: PlacedShape,
): PlacedShape {
  putPair(engine, a, b);
  const number = indexOf(SHAPE_KINDS, kind, "volume kind");
  checkGeometry("mergeVolumes", engine.exports.api_volume_merge(number));
  return volumeNow(engine, kind);
}

/** Whether every point of the volume `inner` is in `outer`. */
export function volumeContains(engine: Engine, outer: PlacedShape, inner: PlacedShape): boolean {
  putPair(engine, outer, inner);
  checkGeometry("volumeContains", engine.exports.api_volume_contains());
  return engine.slots[NumberAt.value] !== 0;
}

/** Whether a point is in the volume or on its edge. */
export function volumeContainsPoint(engine: Engine, volume: PlacedShape, point: Vec2): boolean {
  putMoving(engine, volume);
  checkGeometry("volumeContainsPoint", engine.exports.api_volume_contains_point(...point));
  return engine.slots[NumberAt.value] !== 0;
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
