/** Distances of two shapes, and times at which moving shapes meet or pass each other. */
import type { Engine } from "../engine.js";
import { MeetingAt } from "../generated/slots.js";
import type { Vec2 } from "../types.js";
import { checkGeometry, type Motion, type PlacedShape, putMoving, putPair } from "./pair.js";
import {
  type ClosestPoints,
  closestNow,
  contactsNow,
  type Crossing,
  crossingNow,
  meetingNow,
  type TouchingPoint,
} from "./results.js";

export type { Motion, PlacedShape } from "./pair.js";
export type { ClosestPoints, Crossing, TouchingPoint } from "./results.js";

/** Where a point enters a Minkowski sum, by the fraction of the relative motion. */
export type SumCrossing = Crossing;

/** The closest points of two shapes, and whether they overlap. */
export function closest(engine: Engine, a: PlacedShape, b: PlacedShape): ClosestPoints {
  putPair(engine, a, b);
  checkGeometry("closest", engine.exports.api_geometry_closest());
  return closestNow(engine);
}

/**
 * The points at which two shapes are within the distance `margin`, 0 to 10¹⁵, of each other: none,
 * one, or two where faces of boxes lie on each other. The first is that of `closest`.
 */
export function contacts(
  engine: Engine,
  a: PlacedShape,
  b: PlacedShape,
  margin: number,
): TouchingPoint[] {
  putPair(engine, a, b);
  checkGeometry("contacts", engine.exports.api_geometry_contacts(margin));
  return contactsNow(engine);
}

/**
 * Where a ray from `from` along `way` meets a shape; null where it does not. A ray that starts
 * inside meets nothing.
 */
export function castRay(
  engine: Engine,
  shape: PlacedShape,
  from: Vec2,
  way: Vec2,
): Crossing | null {
  putMoving(engine, shape);
  checkGeometry("castRay", engine.exports.api_geometry_cast_ray(...from, ...way));
  return crossingNow(engine);
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
  return meetingNow(engine);
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
  return {
    time: meetingNow(engine),
    bisectable: engine.slots[MeetingAt.bisectable] !== 0,
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
    time: meetingNow(engine),
    minDistance: s[MeetingAt.minDistance],
    minDistanceTime: s[MeetingAt.minDistanceTime],
  };
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
  return crossingNow(engine);
}
