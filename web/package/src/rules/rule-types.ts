/** The types of collision rules between kinds of shapes, and of the listeners of contacts. */
import { ImpulseEventAt, ListenedRowAt } from "../generated/slots.js";
import type { ShapeId, Vec2 } from "../types.js";

/**
 * `collide`: the shapes collide. `ignore`: they never make a pair, as if their filters excluded it.
 * `oneWay`: they collide on one side of the first kind only, as a platform that is jumped through
 * from below.
 */
export const RULE_KINDS = ["collide", "ignore", "oneWay"] as const;
export type RuleKind = (typeof RULE_KINDS)[number];

/**
 * The rule of two kinds of shapes. The kind of a shape is the lowest bit of its `category`. Without
 * friction, restitution or surfaceSpeed the pair has the value of its two shapes (ShapeOptions).
 */
export interface Rule {
  /** How the shapes interact. Default "collide". */
  kind?: RuleKind;
  /**
   * Of "oneWay": the side of the first kind's shape on which the second collides with it, as a
   * direction in the frame of the first's body, of any length but 0. A shape that begins to touch
   * on another side passes until the two part. Default [0, 1], the top.
   */
  solidSide?: Vec2;
  /** The coefficient of friction of the pair, 0 to 10⁶. Default: that of the two shapes. */
  friction?: number;
  /**
   * The restitution of the pair, 0 to 4; above 1 a bounce adds energy. Default: that of the two
   * shapes.
   */
  restitution?: number;
  /**
   * The speed of each of the two surfaces, length/s, clockwise about the shape, to +x on its top,
   * up to 10⁶ length scales a second either way. Default: those of the two shapes.
   */
  surfaceSpeed?: number;
  /**
   * A contact whose normal impulse in a step is larger is reported by `impulseEvents`: mass times
   * length/s, 0 or more. Default: none is.
   */
  eventImpulse?: number;
}

/** A rule of a world. Values that are undefined are those of the two shapes. */
export interface RuleFound extends Rule {
  kind: RuleKind;
  solidSide: Vec2;
  /**
   * Whether the rule was set with the second kind first: `solidSide` is then that of the second.
   */
  reversed: boolean;
}

/** A contact whose normal impulse was larger than its rule's `eventImpulse`. */
export interface ImpulseEvent {
  a: ShapeId;
  b: ShapeId;
  /** In the world. */
  point: Vec2;
  /** Unit vector, from a to b. */
  normal: Vec2;
  /** The impulse along the normal, the sum over the step: mass times length/s. */
  impulse: number;
}

/** The index of each number in a row of `World.impulseEventView`; a row has `length` numbers. */
export const IMPULSE_ROW = {
  shapeA: ImpulseEventAt.shapeA,
  shapeB: ImpulseEventAt.shapeB,
  point: ImpulseEventAt.point,
  normal: ImpulseEventAt.normal,
  impulse: ImpulseEventAt.impulse,
  length: ImpulseEventAt.length,
} as const;

/**
 * The index of each number in a row of a listener; a row has `length` numbers and describes one
 * contact. Handles are two numbers, index1 (slot + 1) and generation. Of a static and a moving
 * shape, a is the static one. Normal: unit, from a to b. Separation: length, of the deepest point,
 * negative where the shapes overlap. Impulses are set for epilogues only: mass times length/s, the
 * sum over the step. A prologue writes its answers to the last four numbers, which begin with the
 * values of the pair: with 0 in `collide` the pair has no effect in this step.
 */
export const LISTENED_ROW = {
  shapeA: ListenedRowAt.shapeA,
  shapeB: ListenedRowAt.shapeB,
  bodyA: ListenedRowAt.bodyA,
  bodyB: ListenedRowAt.bodyB,
  normal: ListenedRowAt.normal,
  point: ListenedRowAt.point,
  separation: ListenedRowAt.separation,
  normalImpulse: ListenedRowAt.normalImpulse,
  tangentImpulse: ListenedRowAt.tangentImpulse,
  pointCount: ListenedRowAt.pointCount,
  collide: ListenedRowAt.collide,
  friction: ListenedRowAt.friction,
  restitution: ListenedRowAt.restitution,
  surfaceSpeed: ListenedRowAt.surfaceSpeed,
  length: ListenedRowAt.length,
} as const;

/**
 * Is called once a step for all contacts, with `count` rows (LISTENED_ROW): a view into wasm
 * memory, valid until the callback returns, or calls something that makes the memory grow. Each
 * collision that detection finds within the step makes a call of its own, with a `count` of 1.
 */
export type Listener = (rows: Float64Array, count: number) => void;

/**
 * Is called for one contact of a body or a category, with its row (LISTENED_ROW): a view into wasm
 * memory, as of a Listener. `side`: 0 where the object is a of the contact, 1 where it is b.
 */
export type ObjectListener = (row: Float64Array, side: 0 | 1) => void;

/** The velocities of a body right after a collision. */
export interface Velocities {
  /** Of the centre of mass, length/s. */
  velocity: Vec2;
  /** Radians/s. Default 0; 0 is taken where the rotation is fixed. */
  angularVelocity?: number;
}

/** What a prologue decides about a contact: at least one of both bodies; the other does not change. */
export interface ContactResponse {
  /** Of bodyA, which must be dynamic. Default: its velocities do not change. */
  a?: Velocities;
  /** Of bodyB, likewise. */
  b?: Velocities;
}

/** Parts of a row that a listener may do without: bodyA and bodyB, or point. */
export type ContactPart = "bodies" | "point";

/** The callbacks of a world for contacts. */
export interface Listeners {
  /** Called before contacts are solved (pre-solve). Default none. */
  prologue?: Listener;
  /** Called after the motion of the step (post-solve). Default none. */
  epilogue?: Listener;
  /**
   * Parts of a row that neither callback reads: they are not computed, and may be 0. Default none.
   */
  without?: readonly ContactPart[];
}

/**
 * Whether two shapes may make a pair. As long as nothing else changes it must return the same. The
 * order of the two shapes is not specified.
 */
export type PairFilter = (shapeA: ShapeId, shapeB: ShapeId) => boolean;
