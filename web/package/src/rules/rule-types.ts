/** What two kinds of shapes are to each other, and what listeners of contacts are given. */
import { ImpulseEventAt, ListenedRowAt } from "../generated/slots.js";
import type { ShapeId, Vec2 } from "../types.js";

/**
 * `ignore`: the two never make a pair, as if their filters kept them apart. `oneWay`: the first
 * holds the second on one side only, as a plank does that is jumped through from below.
 */
export const MEETINGS = ["collide", "ignore", "oneWay"] as const;
export type RuleMeeting = (typeof MEETINGS)[number];

/**
 * Between two kinds of shapes; the kind of a shape is the lowest bit of its `category`. What is not
 * given is as the two shapes make it.
 */
export interface Rule {
  /** Default "collide". */
  meeting?: RuleMeeting;
  /**
   * Of "oneWay": the side of the first kind's shape on which it holds, in the frame of its body.
   * Default [0, 1], the top. What begins to touch elsewhere passes until the two part.
   */
  solidSide?: Vec2;
  /** [0, 1e6]. */
  friction?: number;
  /** [0, 4]; above 1 the pair leaves faster than it came. */
  restitution?: number;
  /** Length/s, of either surface, clockwise: on top to +x, as a conveyor belt. */
  surfaceSpeed?: number;
  /** Mass * length/s in a step; a contact that gives more is told by `impulses`. Default: none. */
  mostImpulse?: number;
}

/** A rule as it is kept; what is not in it is as the two shapes make it. */
export interface RuleFound extends Rule {
  meeting: RuleMeeting;
  solidSide: Vec2;
  /** It was set with the second kind first: `solidSide` is of that. */
  reversed: boolean;
}

/** A contact that gave more than its rule's `mostImpulse`. */
export interface ImpulseEvent {
  a: ShapeId;
  b: ShapeId;
  point: Vec2;
  /** From a to b. */
  normal: Vec2;
  /** Along the normal, the sum over the step: mass * length/s. */
  impulse: number;
}

/** Where in a row of `World.impulseView` its numbers begin; a row has `length` of them. */
export const IMPULSE_ROW = {
  shapeA: ImpulseEventAt.shapeA,
  shapeB: ImpulseEventAt.shapeB,
  point: ImpulseEventAt.point,
  normal: ImpulseEventAt.normal,
  impulse: ImpulseEventAt.impulse,
  length: ImpulseEventAt.length,
} as const;

/**
 * Where in a row of what listeners are given its numbers begin; a row has `length` of them. Handles
 * are two numbers, index1 (one above the slot) and generation. Of a static and a moving shape, a is
 * the static one. Impulses are an epilogue's. A prologue writes its answers into the last four,
 * which begin as what the pair has by itself: 0 into `collide` has the pair do nothing.
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
 * Called once a step for all contacts, with rows as LISTENED_ROW has them: a view into wasm memory
 * that ends with the call, or with a call that makes the memory grow. What detection finds on the
 * way is asked about by itself, with a `count` of 1.
 */
export type Listener = (rows: Float64Array, count: number) => void;

/** Of a row: bodyA and bodyB; point. */
export type ContactPart = "bodies" | "point";

export interface Listeners {
  /** Before contacts are solved (pre-solve). */
  prologue?: Listener;
  /** After them, and after the step's motion (post-solve). */
  epilogue?: Listener;
  /** What neither of them looks at: numbers that may be zero then, and take no time. */
  without?: readonly ContactPart[];
}

/** False: the two never make a pair. While nothing else changes it must answer the same. */
export type PairFilter = (shapeA: ShapeId, shapeB: ShapeId) => boolean;
