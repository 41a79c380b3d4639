/**
 * The options and results of queries and movers. Units as in types.ts; ranges as in
 * engine/include/thud/thud_limits.h.
 */
import type { BodyId, BodyRef, ShapeId, Vec2 } from "./types.js";

/**
 * Which shapes a query finds: those that would collide with a shape of this category, mask and
 * group. Category and mask must not both be 0 unless the group is above 0.
 */
export interface QueryFilter {
  /** The category bits of the query. Default all. */
  category?: number;
  /** The category bits that the query finds. Default all. */
  mask?: number;
  /** Whether sensors are found, too. Default false. */
  sensors?: boolean;
  /**
   * Shapes of the same group are always found (above 0) or never found (below 0), whatever category
   * and mask are. Default 0, no group.
   */
  group?: number;
  /** A body whose shapes are not found, such as the one that asks. Default none. */
  ignore?: BodyRef;
}

/** The smallest axis-aligned box around a shape: two corners in the world. */
export interface Bounds {
  lower: Vec2;
  upper: Vec2;
}

/** A hit of a ray or of a moving shape. */
export interface RayHit {
  shape: ShapeId;
  /** The point of the hit on the shape's surface, in the world. */
  point: Vec2;
  /** Unit normal of the surface, outward. */
  normal: Vec2;
  /** The fraction of the translation at which the hit is, 0 to 1. */
  fraction: number;
  /** Where a cast shape overlaps the hit shape at its start: the penetration depth; else 0. */
  depth: number;
}

/**
 * Is called for each hit, the nearest first, and returns a limit, a fraction of the whole
 * translation: hits at the limit or beyond are not reported. Undefined, or 1, goes on; 0 ends the
 * cast; `hit.fraction` makes this hit the last; a value below 0 goes on as if this shape did not
 * exist. A later, larger value does not raise the limit again.
 */
export type CastListener = (hit: RayHit) => number | void;

/**
 * A shape without a body, for queries and movers: radius and half extents are lengths above 0, the
 * angle is in radians, up to 10⁶ either way.
 */
export type SolidShape =
  | { kind: "circle"; radius: number }
  | { kind: "aabb"; halfWidth: number; halfHeight: number }
  | { kind: "obb"; halfWidth: number; halfHeight: number; angle: number };

/** The shape closest to a point. */
export interface ClosestHit {
  shape: ShapeId;
  /** The closest point of the shape's surface, in the world. */
  point: Vec2;
  /** Unit normal of the surface there, outward. */
  normal: Vec2;
  /** The distance from the surface, a length; negative: the depth inside the shape. */
  distance: number;
}

/** A body some time ahead, in free flight. */
export interface Prediction {
  position: Vec2;
  /** Radians, above -π and at most π. */
  angle: number;
  /** The velocity of the centre of mass, length/s. */
  velocity: Vec2;
  /** Radians/s. */
  angularVelocity: number;
  /** How far ahead this is, s: all that was asked, or the time at which it meets `met`. */
  seconds: number;
  /** The shape that it meets, with `predict`; null: none. */
  met: ShapeId | null;
}

/** The options of a mover. Lengths are in the caller's unit, without regard to the length scale. */
export interface MoverOptions {
  shape: SolidShape;
  /** The centre of the shape, in the world. */
  position: Vec2;
  /**
   * The direction opposite to gravity, of length 1; [0, 0] for a game seen from above, which has no
   * ground. Default [0, 1].
   */
  up?: Vec2;
  /**
   * The gap that it keeps to shapes: a length, above 0, at most the smallest half extent. Default 2
   * % of the smallest half extent.
   */
  skin?: number;
  /** The steepest ground that it walks on: radians, 0 to 1.55; steeper is a wall. Default 0.9. */
  maxSlope?: number;
  /** The highest step that it climbs: a length, 0 to 10⁶. Default 60 % of the half height. */
  stepHeight?: number;
  /**
   * How far below it the ground may be for a walking mover to follow it down: a length, 0 to 10⁶.
   * Default as stepHeight.
   */
  snapDistance?: number;
  /** The maximum force on a dynamic body in the way: mass times length/s², 0 to 10³⁰. Default 0. */
  pushForce?: number;
  /**
   * A kinematic body around its centre, which follows it so that dynamic bodies and sensors react
   * to it. Default none.
   */
  body?: BodyRef;
  /**
   * Which shapes stop it. Sensors never do; with `sensors` the report lists those that it passed.
   * Default all.
   */
  filter?: QueryFilter;
  /**
   * Category bits of one-way platforms, which it passes from below and stands on from above.
   * Default none.
   */
  oneWay?: number;
  /** The factor of the world's gravity in `walk`. Default 1. */
  gravityScale?: number;
}

/** What a mover does in a step. */
export interface Walk {
  /** The speed to the right, seen with `up` upward, length/s; negative: to the left. Default 0. */
  speed?: number;
  /**
   * The speed of a jump along `up`, length/s, 0 or more, of a mover on ground. Default 0, no jump.
   */
  jump?: number;
  /** Whether it falls through one-way platforms. Default false. */
  drop?: boolean;
}

/** A shape that a mover hit. */
export interface MoverHit {
  shape: ShapeId;
  body: BodyId;
  /** On the shape's surface, in the world. */
  point: Vec2;
  /** Unit normal of the surface, outward. */
  normal: Vec2;
  /** The penetration depth before the move, a length; 0 where the mover did not overlap. */
  depth: number;
}

/** The result of a move. */
export interface MoverReport {
  /** The centre of its shape after the move. */
  position: Vec2;
  /**
   * The ground that it stands on: its unit normal, shape, body and velocity at the mover's feet,
   * length/s; null in the air.
   */
  ground: { normal: Vec2; shape: ShapeId; body: BodyId; velocity: Vec2 } | null;
  /** What is left of the velocity of the call, length/s, without that of the ground. */
  velocity: Vec2;
  /**
   * The deepest overlap that could not be resolved, where shapes close in on it: a length, else 0.
   */
  depth: number;
  /** The first shapes that it hit, at most 8, in their order. */
  hits: MoverHit[];
  /**
   * With `filter.sensors`: the sensors that it passed or is in, at most 16, each once, in the order
   * in which it met them.
   */
  sensors: ShapeId[];
}

/** The region that `World.overlap` tests: bounds, or a shape at a place in the world. */
export type OverlapQuery =
  | { kind: "bounds"; lower: Vec2; upper: Vec2 }
  | { kind: "circle"; center: Vec2; radius: number }
  | { kind: "aabb"; center: Vec2; halfWidth: number; halfHeight: number }
  | { kind: "obb"; center: Vec2; halfWidth: number; halfHeight: number; angle: number };
