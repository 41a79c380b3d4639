/** What queries and movers take and give. Units as in types.ts. */
import type { BodyId, BodyRef, ShapeId, Vec2 } from "./types.js";

/** Which shapes are found: those that the asker's category and mask would collide with. */
export interface QueryFilter {
  /** What asks: bits. Default all. */
  category?: number;
  /** What it asks for: bits. Default all. */
  mask?: number;
  /** Find sensors too. Default false. */
  sensors?: boolean;
  /** Shapes of the same group are found always (above 0) or never (below). Default 0, no group. */
  group?: number;
  /** A body none of whose shapes is found: the one that asks, say. */
  ignore?: BodyRef;
}

/** The least box around a shape, in the world. */
export interface Bounds {
  lower: Vec2;
  upper: Vec2;
}

export interface RayHit {
  shape: ShapeId;
  point: Vec2;
  /** Unit, out of the shape. */
  normal: Vec2;
  /** Of the translation, 0 to 1. */
  fraction: number;
  /** Of the overlap with a shape that is met at 0; else, and of rays, 0. */
  depth: number;
}

/**
 * Hears of a hit, and answers how much of the way still counts, as a fraction of the whole: of what
 * lies there or beyond nothing more is told. Nothing, or 1, goes on; 0 ends; `hit.fraction` makes
 * this hit the last; below 0 goes on as if this shape were not there. What goes on never takes back
 * that the way was shortened.
 */
export type CastListener = (hit: RayHit) => number | void;

/** A shape that asks or moves. */
export type SolidShape =
  | { kind: "circle"; radius: number }
  | { kind: "aabb"; halfWidth: number; halfHeight: number }
  | { kind: "obb"; halfWidth: number; halfHeight: number; angle: number };

export interface ClosestHit {
  shape: ShapeId;
  /** Of its surface, the closest. */
  point: Vec2;
  /** Outward. */
  normal: Vec2;
  /** Negative: so deep inside, by the shortest way out. */
  distance: number;
}

/** A character; lengths are in your own unit. */
export interface MoverOptions {
  shape: SolidShape;
  position: Vec2;
  /** Unit; [0, 0] for a game seen from above, which has no ground. Default [0, 1]. */
  up?: Vec2;
  /** Kept free between it and what it meets. Default 2 % of the smallest half extent. */
  skin?: number;
  /** Radians, 0 to 1.55; steeper ground is a wall. Default 0.9. */
  maxSlope?: number;
  /** Default 60 % of the half height. */
  stepHeight?: number;
  /** How far the ground may fall away under a step. Default as stepHeight. */
  snapDistance?: number;
  /** Most force on a dynamic body in the way, mass times length/s². Default 0. */
  pushForce?: number;
  /** A kinematic body about its centre that follows it, so that dynamic bodies and sensors meet it. */
  body?: BodyRef;
  /** What it meets. Sensors never stop it: `sensors` has it report which it went through. */
  filter?: QueryFilter;
  /** Bits: shapes of these categories are passed from below and stood on. Default none. */
  oneWay?: number;
  /** What it feels of the world's gravity where it goes by `walk`. Default 1. */
  gravityScale?: number;
}

/** What a mover does in a step. */
export interface Walk {
  /** Length/s: to the right where `up` is up, below 0 to the left. Default 0. */
  speed?: number;
  /** The speed of a jump, 0 or more, for who stands on something; 0, the default: none. */
  jump?: number;
  /** Falls through one-way platforms. Default false. */
  drop?: boolean;
}

/** What a mover met on its way. */
export interface MoverHit {
  shape: ShapeId;
  body: BodyId;
  point: Vec2;
  normal: Vec2;
  depth: number;
}

/** What became of a move. */
export interface MoverReport {
  position: Vec2;
  /** What it stands on. */
  ground: { normal: Vec2; shape: ShapeId; body: BodyId; velocity: Vec2 } | null;
  /** What is left of the velocity that was asked for. */
  velocity: Vec2;
  /** Of the deepest overlap left where something closed in; mostly 0. */
  depth: number;
  hits: MoverHit[];
  /**
   * With `filter.sensors`: those that it went through or stands in, at most 16, each once, in the
   * order in which they were met.
   */
  sensors: ShapeId[];
}

/** What to look for with `World.overlap`. */
export type OverlapQuery =
  | { kind: "bounds"; lower: Vec2; upper: Vec2 }
  | { kind: "circle"; center: Vec2; radius: number }
  | { kind: "aabb"; center: Vec2; halfWidth: number; halfHeight: number }
  | { kind: "obb"; center: Vec2; halfWidth: number; halfHeight: number; angle: number };
