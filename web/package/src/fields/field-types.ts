/** Forces on bodies from what is around them, as the calls of world-fields.ts take them. */
import type { QueryFilter } from "../query-types.js";
import type { Vec2 } from "../types.js";

export const COVERS = ["none", "static", "all"] as const;
/** What hides a body from an explosion: nothing, what stands still, or every other body. */
export type Cover = (typeof COVERS)[number];

/** A push away from a place, on each body by the length of it that faces the place. */
export interface Explosion {
  /** Default [0, 0]. */
  center?: Vec2;
  /** Up to here all of it arrives, length. Default 0. */
  radius?: number;
  /** Over so much more it falls to nothing, length. Default 0. */
  falloff?: number;
  /** Mass times speed, for each length of a shape across the way; below 0 it draws in. Default 1. */
  impulse?: number;
  /** Default "all". */
  cover?: Cover;
  /** For each shape, 1 to 16: how finely cover is told. Default 5. */
  rays?: number;
  /** Who is pushed. Default everybody. */
  filter?: QueryFilter;
}

/** The air, and what it does to a body. */
export interface Wind {
  /** Mass per area, 0 or more. Default 1. */
  density?: number;
  /** 0 or more; about 1 for plates. Default 1. */
  drag?: number;
  /** Likewise. Default 1. */
  lift?: number;
}

export interface Water {
  /** On the water line. Default [0, 0]. */
  point?: Vec2;
  /** Out of the water, of length 1. Default [0, 1]. */
  normal?: Vec2;
  /** Mass per area, 0 or more. Default 1. */
  density?: number;
  /** How it flows, length/s. Default [0, 0]. */
  flow?: Vec2;
  /** What slows motion in it, 1/s, 0 or more. Default 2. */
  linearDrag?: number;
  /** What slows turning in it, 1/s, 0 or more. Default 2. */
  angularDrag?: number;
}

/** A tyre of a body that is seen from above, in one step. Forces are mass times length/s². */
export interface Tyre {
  /** Where it stands, in the body's frame. */
  at: Vec2;
  /** Where it rolls to: radians from the body's x axis. Default 0. */
  steer?: number;
  /** What drives it on; below 0 back. Default 0. */
  thrust?: number;
  /** The most force against its rolling, which never turns that around. Default 0. */
  brake?: number;
  /** The most force that the ground gives it; what would take more slides. */
  grip: number;
}
