/** What is read of a whole world: events, statistics, errors, drawing. Units as in types.ts. */
import { ContactPointAt, ContactRowAt, HitEventAt } from "./generated/slots.js";
import type { BodyId, QualityOptions, ShapeId, Vec2 } from "./types.js";

/** Two shapes that began or ceased to touch; after an end either may be gone. */
export interface ContactEvent {
  a: ShapeId;
  b: ShapeId;
}

/** Whose a shape of a contact or an event is, and what either keeps for you. */
export interface PairSide {
  body: BodyId;
  bodyData: number;
  shapeData: number;
  sensor: boolean;
}

/** Of two shapes; null for one that was destroyed. */
export interface Pair {
  a: PairSide | null;
  b: PairSide | null;
}

/** One of two shapes that met. */
export interface MeetingSide extends PairSide {
  shape: ShapeId;
  /** All of its bits. */
  category: number;
}

/** Of the kinds that `World.meetings` was asked for. */
export interface Meeting {
  a: MeetingSide;
  b: MeetingSide;
}

/** A collision faster than WorldOptions.hitSpeed. */
export interface HitEvent extends ContactEvent {
  point: Vec2;
  /** From a to b. */
  normal: Vec2;
  /** Of approach, length/s. */
  speed: number;
}

/** Events of the last step, or of all steps of the last `advance`, in a deterministic order. */
export interface Events {
  begin: ContactEvent[];
  end: ContactEvent[];
  /**
   * `a` is the sensor that reports, `b` any shape of another body that both filters let meet: of
   * every kind of body, awake or asleep, but for two static ones. Of two sensors each reports the
   * other. They go by where bodies stand as the step begins.
   */
  sensorBegin: ContactEvent[];
  sensorEnd: ContactEvent[];
  hit: HitEvent[];
  /** Bodies that were frozen because they became non-finite. */
  quarantined: BodyId[];
}

/**
 * Events as they lie in wasm memory, valid until the next call. Handles are two numbers, index1 (one
 * above the slot) and generation; HIT_ROW has the places in a row of `hit`.
 */
export interface EventViews {
  /** Four numbers a pair: two handles. */
  readonly begin: Uint32Array;
  readonly end: Uint32Array;
  readonly sensorBegin: Uint32Array;
  readonly sensorEnd: Uint32Array;
  readonly hit: Float64Array;
  /** Two numbers a body. */
  readonly quarantined: Uint32Array;
}

/** Where in a row of EventViews.hit its numbers begin; a row has `length` of them. */
export const HIT_ROW = {
  shapeA: HitEventAt.shapeA,
  shapeB: HitEventAt.shapeB,
  point: HitEventAt.point,
  normal: HitEventAt.normal,
  speed: HitEventAt.speed,
  length: HitEventAt.length,
} as const;

/**
 * Where in a row of `World.contactView` its numbers begin; a row has `length` of them. Of `points`
 * there are two, `pointLength` numbers each: place, separation, impulse along the normal.
 */
export const CONTACT_ROW = {
  shapeA: ContactRowAt.shapeA,
  shapeB: ContactRowAt.shapeB,
  bodyA: ContactRowAt.bodyA,
  bodyB: ContactRowAt.bodyB,
  normal: ContactRowAt.normal,
  pointCount: ContactRowAt.pointCount,
  tangentImpulse: ContactRowAt.tangentImpulse,
  direct: ContactRowAt.direct,
  points: ContactRowAt.points,
  pointLength: ContactPointAt.length,
  length: ContactRowAt.length,
} as const;

/** By which the next step is made. */
export interface StepSettings {
  /** Length/s². */
  gravity: Vec2;
  /** Seconds. */
  timeStep: number;
  maxError: number;
  /** Fewer than the quality's where a time budget says so. */
  substeps: number;
  sleeping: boolean;
  /** The world's copy, with what its options named; `setQuality` takes it. */
  quality: Required<QualityOptions>;
}

/** What a world holds, and what its last step did and took. */
export interface Stats {
  /** Made since the world was. */
  steps: number;
  bodies: number;
  shapes: number;
  awakeBodies: number;
  /** Of shapes whose fat bounds overlap: the broadphase's candidates. */
  pairs: number;
  /** Touching pairs. */
  contacts: number;
  /** Sets of contacts that share no moving body, and the blocks in which they are solved. */
  colours: number;
  blocks: number;
  /** Memory held by the world. */
  bytes: number;
  /** Allocations made by the last step. */
  stepAllocations: number;
  /** Of the last step; fewer than the quality's where the time budget is short. */
  substeps: number;
  /** Seconds of the last step; 0 unless the world is timed or has a time budget. */
  stepSeconds: number;
  /** Islands that the soft solver could not hold, solved directly in the last step. */
  directIslands: number;
  /** In those islands. */
  directBodies: number;
  /** Of those islands, how many stayed as the soft solver had them. */
  softIslands: number;
  /** Collisions found within the last step, by the detections "bisect" and "swept". */
  impacts: number;
  /** Pairs of moving shapes in the last step, by how far their tests went. */
  motionPairs: Readonly<{ looked: number; circlesMet: number; boxesMet: number; exact: number }>;
  /** By the names of `Engine.stageNames`; 0 unless the world is timed. */
  stageSeconds: Readonly<Record<string, number>>;
  /** Bodies that "swept" and "bisect" stopped before the step's end, in a crowd of collisions. */
  heldBodies: number;
  /** The time that those lost, together. */
  heldSeconds: number;
  /** Bisected bodies that were too fast for it: they may have passed something. */
  unbisectable: number;
}

/** What the last step got wrong, of the contacts that are awake. */
export interface StepError {
  /** A length, over the points of touching pairs at the end of the step; negative while apart. */
  penetrationMax: number;
  penetrationMean: number;
  /** Fastest approach at a contact that the solver's last pass still met, and took away. */
  residual: number;
  /**
   * Of kinetic and potential energy. Negative where friction, damping and restitution take some;
   * positive is energy that nobody put in, or that forces, kinematic bodies and moving surfaces
   * did.
   */
  energyChange: number;
  /** Points deeper than the world's maxError, or without one than 0.005 length scales. */
  overlaps: number;
  /**
   * A length: how far the body that detection held back the most ended from where its motion would
   * have taken it; 0 where none of `Stats.heldBodies` was.
   */
  shortfall: number;
  /** Lengths: by how much joints are open at the end, asleep or awake; see JointState.gap. */
  jointGapMax: number;
  jointGapMean: number;
  /** Likewise of turns, radians. */
  jointAngleMax: number;
}

/** Error and energy of the present state; lengths, and mass times (length/s)². */
export interface Measure {
  penetrationMax: number;
  penetrationMean: number;
  kineticEnergy: number;
  potentialEnergy: number;
}

/** Every shape at once, for drawing. The arrays are views into wasm memory: see `poses()`. */
export interface ShapeTable {
  readonly count: number;
  /**
   * Ten numbers a shape: body slot, shape kind, body kind, sensor, offset x and y, half extents x
   * and y, cosine and sine in the body's frame.
   */
  readonly rows: Float32Array;
  /** Four numbers a shape: index1 and generation of the shape, and of its body. */
  readonly handles: Uint32Array;
}

/** Shapes to leave out or put in with `World.debugDraw`. */
export interface DrawOptions {
  shapes?: boolean;
  bounds?: boolean;
  cells?: boolean;
  contacts?: boolean;
  /** Shapes carry their island's number; lines for pairs whose islands are solved directly. */
  islands?: boolean;
  /** The sorted intervals of a plane sweep, at the lower edge. */
  axes?: boolean;
  /** Lines between shapes whose bounds overlap. */
  pairs?: boolean;
  /** As pairs, by how far they came: fat bounds overlap, so do the true bounds, shapes touch. */
  stages?: boolean;
  /**
   * Lines between touching shapes by the solver's colour: no two pairs of one colour share a moving
   * body, so that eight of them are solved at once.
   */
  colours?: boolean;
  /** Every point of every contact, its depth and its impulse. */
  manifolds?: boolean;
  /** Where joints have their bodies, their axes, and between which limits they let them be. */
  joints?: boolean;
  /** Lines as long as a joint's force would move its body b alone in a second, from rest. */
  jointForces?: boolean;
  /** The swept volumes of the last step, of what moved further than a quarter of its size. */
  motions?: boolean;
  /** Coordinates are relative to it. Default [0, 0]. */
  origin?: Vec2;
  /** The corners of what is drawn, in the world. */
  lower: Vec2;
  upper: Vec2;
}

/**
 * By number in `DrawLists`. "solved directly" is of pairs. "depth" is a line from a contact's point
 * as long as the penetration, "impulse" one as long as the impulse of a step alone would move the
 * lighter body in a second. "colour 15" stands for all further colours too.
 */
export const DRAW_STYLES = [
  "static",
  "kinematic",
  "dynamic",
  "sleeping",
  "sensor",
  "bounds",
  "cell",
  "contact",
  "normal",
  "interval",
  "interval overlapping",
  "pair",
  "pair touching",
  "motion",
  "pair candidate",
  "solved directly",
  "manifold",
  "depth",
  "impulse",
  "colour 0",
  "colour 1",
  "colour 2",
  "colour 3",
  "colour 4",
  "colour 5",
  "colour 6",
  "colour 7",
  "colour 8",
  "colour 9",
  "colour 10",
  "colour 11",
  "colour 12",
  "colour 13",
  "colour 14",
  "colour 15",
  "joint",
  "joint axis",
  "joint limit",
  "joint force",
] as const;

/** Views into wasm memory, valid until the next call of `debugDraw`. */
export interface DrawLists {
  /** Nine a shape: centre, half extents, cosine, sine, 1 if a circle, style, island. */
  readonly shapes: Float32Array;
  /** Five a line: both ends, style. */
  readonly lines: Float32Array;
  /** Three a point: place, style. */
  readonly points: Float32Array;
}

/** A point of a contact, after the last step. */
export interface ContactPoint {
  point: Vec2;
  /** Negative is penetration. */
  separation: number;
  /** Mass times length/s, 0 or more: the last substep's, times the substeps. */
  normalImpulse: number;
}

/** A touching pair. Of a static and a moving shape, `a` is the static one. */
export interface Contact {
  a: ShapeId;
  b: ShapeId;
  bodyA: BodyId;
  bodyB: BodyId;
  /** Unit, from a to b. */
  normal: Vec2;
  /** Two at most; none where it is about to touch again. */
  points: ContactPoint[];
  /** Friction's, on b, along (normal[1], -normal[0]). */
  tangentImpulse: number;
  /** Its island was solved at once, as the soft solver could not hold it. */
  direct: boolean;
}
