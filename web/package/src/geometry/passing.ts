/** How far apart two shapes are, and when they meet on their ways. */
import type { Engine } from "../engine.js";
import { ClosestFeaturesAt, CrossingAt, MeetingAt } from "../generated/slots.js";
import { vecAt } from "../numbers.js";
import type { Vec2 } from "../types.js";
import { checkGeometry, type Motion, type PlacedShape, putPair } from "./pair.js";

export type { Motion, PlacedShape } from "./pair.js";

export interface ClosestPoints {
  /** They share a point; touching counts. */
  overlaps: boolean;
  /** Negative: so deep in each other, by the shortest way out. */
  distance: number;
  /** Unit, from a to b. */
  normal: Vec2;
  /** On each surface; b's less a's is the distance times the normal. */
  pointA: Vec2;
  pointB: Vec2;
}

/** The closest points of two shapes, and whether they overlap. */
export function closestPoints(engine: Engine, a: PlacedShape, b: PlacedShape): ClosestPoints {
  putPair(engine, a, b);
  checkGeometry("closestPoints", engine.exports.api_shapes_closest());
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
 * The part of their motions after which two shapes first come within `target` of each other, 0 to 1;
 * null if they never do. Exact without turning; with it never late.
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
  checkGeometry("timeOfImpact", engine.exports.api_shapes_time_of_impact(target));
  const s = engine.slots;
  return s[MeetingAt.found] === 0 ? null : s[MeetingAt.time];
}

export interface Collision {
  /** At which they are still apart; they overlap within the tolerance of it. Null: not found. */
  time: number | null;
  /** They move so little that no passage through the middle of each other can have been missed. */
  sure: boolean;
}

/**
 * When two shapes that are apart at the start and overlap at the end began to, by halving: as many
 * overlap tests as it takes halvings of the motion to `tolerance`, 1e-15 to 1.
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
  checkGeometry("timeOfCollision", engine.exports.api_shapes_time_of_collision(tolerance));
  const s = engine.slots;
  return {
    time: s[MeetingAt.found] === 0 ? null : s[MeetingAt.time],
    sure: s[MeetingAt.sure] !== 0,
  };
}

export interface Approach {
  /** Of the impact, 0 to 1; null without one. */
  time: number | null;
  /** The smallest distance that separates the centres on the whole way, as if nothing stopped them. */
  least: number;
  /** When. */
  leastTime: number;
}

/** How two moving circles pass each other, in closed form. */
export function circlesApproach(
  engine: Engine,
  a: PlacedShape,
  motionA: Motion,
  b: PlacedShape,
  motionB: Motion,
): Approach {
  putPair(engine, a, b, motionA, motionB);
  checkGeometry("circlesApproach", engine.exports.api_circles_approach());
  const s = engine.slots;
  return {
    time: s[MeetingAt.found] === 0 ? null : s[MeetingAt.time],
    least: s[MeetingAt.least],
    leastTime: s[MeetingAt.leastTime],
  };
}

export interface SumCrossing {
  /** Of the way, 0 to 1. */
  fraction: number;
  /** Unit, out of the sum. */
  normal: Vec2;
}

/**
 * Where b's centre, as a point, enters the Minkowski sum of both while the two move without turning:
 * two moving shapes are a segment against one shape. Null if it does not.
 */
export function castInSum(
  engine: Engine,
  a: PlacedShape,
  motionA: Motion,
  b: PlacedShape,
  motionB: Motion,
): SumCrossing | null {
  putPair(engine, a, b, motionA, motionB);
  checkGeometry("castInSum", engine.exports.api_minkowski_cast());
  const s = engine.slots;
  if (s[CrossingAt.found] === 0) return null;
  return { fraction: s[CrossingAt.fraction], normal: vecAt(s, CrossingAt.normal) };
}
