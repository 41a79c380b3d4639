/** Distances of two shapes, and times at which moving shapes meet or pass each other. */
import type { Engine } from "../engine.js";
import { ClosestFeaturesAt, CrossingAt, MeetingAt } from "../generated/slots.js";
import { vecAt } from "../numbers.js";
import type { Vec2 } from "../types.js";
import { checkGeometry, type Motion, type PlacedShape, putPair } from "./pair.js";

export type { Motion, PlacedShape } from "./pair.js";

/** The closest points of two shapes. */
export interface ClosestPoints {
  /** Whether the shapes share a point; touching counts. */
  overlaps: boolean;
  /** The distance between the surfaces, a length; negative: the penetration depth. */
  distance: number;
  /** Unit vector, from a to b. */
  normal: Vec2;
  /** The closest point on a's surface. pointB - pointA is the distance times the normal. */
  pointA: Vec2;
  /** The closest point on b's surface. */
  pointB: Vec2;
}

/** The closest points of two shapes, and whether they overlap. */
export function closest(engine: Engine, a: PlacedShape, b: PlacedShape): ClosestPoints {
  putPair(engine, a, b);
  checkGeometry("closest", engine.exports.api_geometry_closest());
  const s = engine.slots;
  return {
    overlaps: s[ClosestFeaturesAt.overlaps] !== 0,
    distance: s[ClosestFeaturesAt.distance],
    normal: vecAt(s, ClosestFeaturesAt.normal),
    pointA: vecAt(s, ClosestFeaturesAt.pointA),
    pointB: vecAt(s, ClosestFeaturesAt.pointB),
  };
}

/**
 * The time of impact: the fraction of their motions, 0 to 1, at which two shapes first come within
 * the distance `target`, 0 to 10¹⁵, of each other; null where they do not. Exact where neither
 * turns; else it may be too early, never too late.
 */
export function timeOfImpact(
  engine: Engine,
  a: PlacedShape,
  motionA: Motion,
  b: PlacedShape,
  motionB: Motion,
  target = 0,
): number | null {
  putPair(engine, a, b, motionA, motionB);
  checkGeometry("timeOfImpact", engine.exports.api_geometry_time_of_impact(target));
  const s = engine.slots;
  return s[MeetingAt.found] === 0 ? null : s[MeetingAt.time];
}

/** The collision of two moving shapes. */
export interface Collision {
  /**
   * The fraction of the motions, 0 to 1, at which the shapes are still apart; they overlap within
   * the tolerance after it. Null: not found.
   */
  time: number | null;
  /** Whether the motions are so short that the shapes cannot have passed through each other. */
  bisectable: boolean;
}

/**
 * When two shapes begin to overlap that are apart at the start of their motions and overlap at the
 * end, by bisection. It takes one overlap test for each halving of the motion down to `tolerance`,
 * a fraction of the motion from 1e-15 to 1.
 */
export function timeOfCollision(
  engine: Engine,
  a: PlacedShape,
  motionA: Motion,
  b: PlacedShape,
  motionB: Motion,
  tolerance: number,
): Collision {
  putPair(engine, a, b, motionA, motionB);
  checkGeometry("timeOfCollision", engine.exports.api_geometry_time_of_collision(tolerance));
  const s = engine.slots;
  return {
    time: s[MeetingAt.found] === 0 ? null : s[MeetingAt.time],
    bisectable: s[MeetingAt.bisectable] !== 0,
  };
}

/** How two moving circles pass or hit each other. */
export interface Approach {
  /** The time of impact as a fraction of the motions, 0 to 1; null where there is none. */
  time: number | null;
  /**
   * The smallest distance of the centres over the whole motions, a length, without regard to an
   * impact.
   */
  minDistance: number;
  /** The time of the smallest distance, 0 to 1. */
  minDistanceTime: number;
}

/** The impact and the closest approach of two moving circles, in closed form. */
export function approach(
  engine: Engine,
  a: PlacedShape,
  motionA: Motion,
  b: PlacedShape,
  motionB: Motion,
): Approach {
  putPair(engine, a, b, motionA, motionB);
  checkGeometry("approach", engine.exports.api_geometry_approach());
  const s = engine.slots;
  return {
    time: s[MeetingAt.found] === 0 ? null : s[MeetingAt.time],
    minDistance: s[MeetingAt.minDistance],
    minDistanceTime: s[MeetingAt.minDistanceTime],
  };
}

/** Where a point enters a Minkowski sum. */
export interface SumCrossing {
  /** The fraction of the relative motion, 0 to 1. */
  fraction: number;
  /** Unit normal of the sum's surface, outward. */
  normal: Vec2;
}

/**
 * Where b's centre enters the Minkowski sum of both shapes while the two move without turning: the
 * test of two moving shapes is then that of a segment against one shape. Null where it does not
 * enter the sum.
 */
export function minkowskiCast(
  engine: Engine,
  a: PlacedShape,
  motionA: Motion,
  b: PlacedShape,
  motionB: Motion,
): SumCrossing | null {
  putPair(engine, a, b, motionA, motionB);
  checkGeometry("minkowskiCast", engine.exports.api_minkowski_cast());
  const s = engine.slots;
  if (s[CrossingAt.found] === 0) return null;
  return { fraction: s[CrossingAt.fraction], normal: vecAt(s, CrossingAt.normal) };
}
