/**
 * Options of explosions, wind, water and tyres, which world-fields.ts takes. Units as in types.ts;
 * thud_fields.h has the formulas.
 */
import type { QueryFilter } from "../query-types.js";
import type { Vec2 } from "../types.js";

export const COVERS = ["none", "static", "all"] as const;
/**
 * Which bodies shield a shape from an explosion: none, static and kinematic ones ("static"), or
 * every other body ("all").
 */
export type Cover = (typeof COVERS)[number];

/**
 * An explosion: an impulse on shapes, away from its centre, in proportion to the length of the side
 * that faces the centre.
 */
export interface Explosion {
  /** The centre, a place in the world up to 10⁹ length scales away. Default [0, 0]. */
  center?: Vec2;
  /**
   * The distance up to which the impulse is constant: a length, 0 to 10⁹ length scales. Default 0.
   * Radius and falloff must not both be 0.
   */
  radius?: number;
  /**
   * The distance beyond the radius over which the impulse falls linearly to 0: a length, 0 to 10⁹
   * length scales. Default 0.
   */
  falloff?: number;
  /**
   * The impulse for each length of a shape, measured at a right angle to the direction from the
   * centre: mass/s, up to 10¹⁵ either way; a negative one pulls towards the centre. Default 1.
   */
  impulse?: number;
  /** Which bodies shield others from the explosion. Default "all". */
  cover?: Cover;
  /** The number of rays to each shape that test for shields: whole, 1 to 16. Default 5. */
  rays?: number;
  /** Which shapes are pushed; the body `ignore` does not shield others either. Default all. */
  filter?: QueryFilter;
}

/** The air, and the coefficients of a body in it. */
export interface Wind {
  /** The density of the air, mass per area, 0 to 10¹². Default 1. */
  density?: number;
  /** The drag coefficient, 0 to 10⁶; about 1 for plates. Default 1. */
  drag?: number;
  /** The lift coefficient, 0 to 10⁶; about 1 for plates. Default 1. */
  lift?: number;
}

/** Water below a straight water line. */
export interface Water {
  /** A point of the water line, up to 10⁹ length scales away. Default [0, 0]. */
  point?: Vec2;
  /** The direction out of the water, of length 1 within 10⁻³. Default [0, 1]. */
  normal?: Vec2;
  /** The density of the water, mass per area, 0 to 10¹². Default 1. */
  density?: number;
  /**
   * The velocity of the water, length/s, components up to 10⁶ length scales a second. Default [0,
   * 0].
   */
  flow?: Vec2;
  /**
   * The drag, 1/s, 0 to 10⁶: the force is this, times the mass of the displaced water, times the
   * velocity relative to the water. Default 2.
   */
  linearDrag?: number;
  /** The same for rotation, 1/s, 0 to 10⁶. Default 2. */
  angularDrag?: number;
}

/**
 * A tyre of a body that is seen from above, and what acts on it in one step. Forces are mass times
 * length/s², up to 10³⁰.
 */
export interface Tyre {
  /** The place of the tyre in the body's frame. */
  at: Vec2;
  /**
   * The direction in which the tyre rolls: radians from the body's x axis, up to 10⁶. Default 0.
   */
  steer?: number;
  /** The driving force along the rolling direction; a negative one drives backwards. Default 0. */
  thrust?: number;
  /** The maximum braking force, 0 or more; it at most stops the tyre. Default 0. */
  brake?: number;
  /**
   * The maximum force of the ground on the tyre, 0 or more; where more is needed the tyre slides.
   */
  grip: number;
}
