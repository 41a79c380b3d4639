/** What the calls of geometry/ return, and how it is read from the module's slots. */
import type { Engine } from "../engine.js";
import {
  ClosestFeaturesAt,
  CrossingAt,
  MeetingAt,
  TouchingPointAt,
  TouchingPointsAt,
} from "../generated/slots.js";
import { vecAt } from "../numbers.js";
import type { Vec2 } from "../types.js";

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

/** Reads the slots of `closest_features`. */
export function closestNow({ slots: s }: Engine): ClosestPoints {
  return {
    overlaps: s[ClosestFeaturesAt.overlaps] !== 0,
    distance: s[ClosestFeaturesAt.distance],
    normal: vecAt(s, ClosestFeaturesAt.normal),
    pointA: vecAt(s, ClosestFeaturesAt.pointA),
    pointB: vecAt(s, ClosestFeaturesAt.pointB),
  };
}

/** A point at which two shapes touch or nearly do. */
export type TouchingPoint = Omit<ClosestPoints, "overlaps">;

/** Reads the slots of `touching_points`. */
export function contactsNow({ slots: s }: Engine): TouchingPoint[] {
  return [TouchingPointsAt.first, TouchingPointsAt.second]
    .filter((_, number) => number < s[TouchingPointsAt.count])
    .map((at) => ({
      distance: s[at + TouchingPointAt.distance],
      normal: vecAt(s, at + TouchingPointAt.normal),
      pointA: vecAt(s, at + TouchingPointAt.pointA),
      pointB: vecAt(s, at + TouchingPointAt.pointB),
    }));
}

/** Where a point that moves enters a shape or a Minkowski sum. */
export interface Crossing {
  /** The fraction of its motion, 0 to 1. */
  fraction: number;
  /** Unit normal of the surface there, outward. */
  normal: Vec2;
}

/** Reads the slots of `crossing`; null where there is none. */
export function crossingNow({ slots: s }: Engine): Crossing | null {
  if (s[CrossingAt.found] === 0) return null;
  return { fraction: s[CrossingAt.fraction], normal: vecAt(s, CrossingAt.normal) };
}

/** The time in the slots of `meeting`; null where there is none. */
export function meetingNow({ slots: s }: Engine): number | null {
  return s[MeetingAt.found] === 0 ? null : s[MeetingAt.time];
}
