/** What a world reports: events, statistics, errors, tables for drawing. Units as in types.ts. */
import { ContactPointAt, ContactRowAt, HitEventAt } from "./generated/slots.js";
import type { BodyId, QualityOptions, ShapeId, Vec2 } from "./types.js";

/** Two shapes that began or ceased to touch. In an end event either may have been destroyed. */
export interface ContactEvent {
  a: ShapeId;
  b: ShapeId;
}

/** The body of a shape of a contact or an event. */
export interface PairSide {
  body: BodyId;
  /** The user data of the body. */
  bodyData: number;
  /** The user data of the shape. */
  shapeData: number;
  /** Whether the shape is a sensor. */
  sensor: boolean;
}

/** The sides of two shapes; null for a shape that was destroyed. */
export interface Pair {
  a: PairSide | null;
  b: PairSide | null;
}

/** One of two shapes that met. */
export interface EventPairSide extends PairSide {
  shape: ShapeId;
  /** All category bits of the shape. */
  category: number;
}

/** Two shapes that met: `a` of the first category of `World.eventPairs`, `b` of the second. */
export interface EventPair {
  a: EventPairSide;
  b: EventPairSide;
}

/** A collision faster than WorldOptions.hitSpeed. */
export interface HitEvent extends ContactEvent {
  /** In the world. */
  point: Vec2;
  /** Unit vector, from a to b. */
  normal: Vec2;
  /** The speed of approach along the normal, length/s. */
  speed: number;
}

/** A sensor (`a`) and a shape that it began or ceased to overlap (`b`). */
export interface SensorEvent extends ContactEvent {
  /**
   * The time within the step at which the overlap began or ended, in [0, 1]: computed where a
   * detection tests the motion; else 1, the end of the step; 0 where an edit before the step ended
   * it.
   */
  time: number;
}

/** Events of the last step, or of all steps of the last `advance`, in a deterministic order. */
export interface Events {
  /** Pairs that began to touch. */
  begin: ContactEvent[];
  /** Pairs that ceased to touch, also because a shape was destroyed or fell asleep. */
  end: ContactEvent[];
  /**
   * Overlaps that began. `a` is the sensor that reports, `b` a shape of another body that the
   * filters of both allow: of every kind of body, awake or asleep, but not of two static bodies. Of
   * two sensors each reports the other. Overlaps are tested at the end of the step. A sensor that a
   * fast body passed within the step is in both lists: with detection "continuous" sensors of
   * static bodies, with "bisect" and "swept" all.
   */
  sensorBegin: SensorEvent[];
  /** Overlaps that ended. */
  sensorEnd: SensorEvent[];
  /** Pairs that met faster than WorldOptions.hitSpeed. A hit may come without a begin. */
  hit: HitEvent[];
  /** Bodies that were stopped because their position or velocity became non-finite. */
  quarantined: BodyId[];
}

/**
 * The events as views into wasm memory, valid until the next call of the engine. Handles are two
 * numbers, index1 (slot + 1) and generation; HIT_ROW has the places of the numbers in a row of
 * `hit`.
 */
export interface EventViews {
  /** Four numbers a pair: two handles. */
  readonly begin: Uint32Array;
  readonly end: Uint32Array;
  readonly sensorBegin: Uint32Array;
  readonly sensorEnd: Uint32Array;
  /** One number a pair of sensorBegin: the time within the step, in [0, 1]. */
  readonly sensorBeginTime: Float32Array;
  /** The same for sensorEnd. */
  readonly sensorEndTime: Float32Array;
  readonly hit: Float64Array;
  /** Two numbers a body. */
  readonly quarantined: Uint32Array;
}

/** The index of each number in a row of EventViews.hit; a row has `length` numbers. */
export const HIT_ROW = {
  shapeA: HitEventAt.shapeA,
  shapeB: HitEventAt.shapeB,
  point: HitEventAt.point,
  normal: HitEventAt.normal,
  speed: HitEventAt.speed,
  length: HitEventAt.length,
} as const;

/**
 * The index of each number in a row of `World.contactViewOf`; a row has `length` numbers. `points`
 * are two points of `pointLength` numbers each: place, separation, impulse along the normal.
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

/** What the broadphase did in the last step. */
export interface BroadphaseCounts {
  /** Shapes whose bounds moved or that are new: those for which others are searched. */
  moved: number;
  /** Pairs of bounds that were compared; n shapes make n (n - 1) / 2 pairs. */
  tested: number;
  /** Those of them that overlap. */
  found: number;
  /** Plane sweeps: how often insertion sort moved a shape past another one. */
  sortMoves: number;
  /** Grid: cells that hold shapes of awake bodies. */
  cells: number;
  /** Grid: those shapes; over `cells` the mean of a cell. */
  cellShapes: number;
  /** Grid: the most in one cell. */
  cellShapesMax: number;
}

/** The settings of the next step. */
export interface StepSettings {
  /** Length/s². */
  gravity: Vec2;
  /** Seconds. */
  timeStep: number;
  /** A length; 0: none. */
  maxError: number;
  /** Substeps of a step: fewer than the quality's where a time budget has reduced them. */
  substeps: number;
  sleeping: boolean;
  /** The world's quality with the changes of its options; `setQuality` takes it. */
  quality: Required<QualityOptions>;
}

/** Counts of a world, and statistics of its last step. */
export interface Stats {
  /** The steps that the world has run. */
  steps: number;
  bodies: number;
  shapes: number;
  /** Awake bodies, dynamic and kinematic. */
  awakeBodies: number;
  /** Pairs of shapes whose fat bounds overlap: the candidates of the broadphase. */
  pairs: number;
  /** Pairs that touch. */
  contacts: number;
  /** Graph colours of the solver: no two constraints of one colour share a moving body. */
  colours: number;
  /** Blocks of up to eight constraints, which are solved together. */
  blocks: number;
  /** The memory that the world holds, bytes. */
  bytes: number;
  /** Allocations of memory in the last step. */
  stepAllocations: number;
  /** Substeps of the last step: fewer than the quality's where a time budget has reduced them. */
  substeps: number;
  /** Seconds of the last step; 0 unless the world is timed or has a time budget. */
  stepSeconds: number;
  /** Islands that were solved directly in the last step. */
  directIslands: number;
  /** The bodies of those islands. */
  directBodies: number;
  /** Those of these islands that kept the result of the soft solver. */
  softIslands: number;
  /** Collisions that "bisect" and "swept" resolved within the last step. */
  impacts: number;
  /** Pairs of moving shapes that were tested in the last step. */
  motionPairs: number;
  /** Those of them whose swept circles met. */
  motionCircles: number;
  /** Those of them whose swept boxes met. */
  motionBoxes: number;
  /** Those of them whose time of collision was computed. */
  motionExact: number;
  /** Seconds of each stage by its name (`Engine.stageNames`); 0 unless the world is timed. */
  stageSeconds: Readonly<Record<string, number>>;
  /** Bodies that detection stopped before the end of the step, for instance in dense collisions. */
  heldBodies: number;
  /** The time that these lost, together: seconds. */
  heldSeconds: number;
  /** Bisected bodies faster than `bisectionLimit`: they may have passed through a shape. */
  unbisectable: number;
}

/** The errors of the last step, over the contacts of awake bodies. */
export interface StepError {
  /**
   * The largest penetration depth of touching pairs at the end of the step: a length, negative
   * apart.
   */
  penetrationMax: number;
  /** The mean of it over all contact points. */
  penetrationMean: number;
  /**
   * The largest speed of approach at a contact that the last pass of the soft solver corrected,
   * length/s.
   */
  residual: number;
  /**
   * The change of kinetic plus potential energy, mass times length²/s². Friction, damping and
   * restitution make it negative; forces, kinematic bodies, moving surfaces and errors of the
   * solver make it positive.
   */
  energyChange: number;
  /** The part of energyChange that prologues decided (`World.decide`). */
  energyDecided: number;
  /**
   * Contact points deeper than the world's maxError, or than 0.005 length scales where that is 0.
   */
  overlaps: number;
  /**
   * The largest distance between where a held body (`Stats.heldBodies`) ended and where its motion
   * would have taken it, a length; 0 where none was held.
   */
  shortfall: number;
  /**
   * The largest gap of all joints, asleep or awake, at the end of the step: a length,
   * JointState.gap.
   */
  jointGapMax: number;
  /** The mean of it over all joints. */
  jointGapMean: number;
  /** The largest JointState.angleGap, radians. */
  jointAngleMax: number;
}

/** Penetration and energy of the present state. Energies are mass times length²/s². */
export interface Measure {
  /** The largest penetration depth of touching pairs, asleep or awake: a length. */
  penetrationMax: number;
  /** The mean of it over all contact points. */
  penetrationMean: number;
  kineticEnergy: number;
  /** 0 at the world's origin. */
  potentialEnergy: number;
}

/** All shapes at once, for drawing. The arrays are views into wasm memory: see `poses()`. */
export interface ShapeTable {
  readonly count: number;
  /**
   * Ten numbers a shape: body slot, shape kind, body kind, sensor, offset x and y, half extents x
   * and y, cosine and sine in the body's frame.
   */
  readonly rows: Float32Array;
  /** Four numbers a shape: index1 (slot + 1) and generation of the shape, and of its body. */
  readonly handles: Uint32Array;
}

/** What `World.draw` draws. Each flag is false by default. */
export interface DrawOptions {
  shapes?: boolean;
  /** The fat bounds of shapes. */
  bounds?: boolean;
  /** The cells of the grid broadphase. */
  cells?: boolean;
  /** The points and normals of contacts. */
  contacts?: boolean;
  /** Shapes get the number of their island; lines between pairs of directly solved islands. */
  islands?: boolean;
  /** The sorted intervals of the sweep broadphase, at the lower edge. */
  axes?: boolean;
  /** Lines between shapes whose bounds overlap. */
  pairs?: boolean;
  /**
   * As `pairs`, in three styles by the tests that a pair has passed: its fat bounds overlap, its
   * tight bounds overlap, its shapes touch.
   */
  stages?: boolean;
  /**
   * Lines between touching shapes by the solver's colour: no two pairs of one colour share a moving
   * body, so that eight of them are solved at once.
   */
  colours?: boolean;
  /** Every point of every contact with its depth and its impulse. */
  manifolds?: boolean;
  /** The anchors, axes and limits of joints. */
  joints?: boolean;
  /**
   * Forces of joints: lines as long as the force alone would move body b in a second, from rest.
   */
  jointForces?: boolean;
  /**
   * The swept volumes of shapes that moved further in the last step than a quarter of their size.
   */
  motions?: boolean;
  /** The place to which the drawn coordinates are relative. Default [0, 0]. */
  origin?: Vec2;
  /** The lower left corner of the region that is drawn, in the world. */
  lower: Vec2;
  /** The upper right corner of that region. */
  upper: Vec2;
}

/** What `World.draw` draws, in the order of the bits of thud_debug_draw.flags. */
export const DRAW_FLAGS = [
  "shapes",
  "bounds",
  "cells",
  "contacts",
  "islands",
  "axes",
  "pairs",
  "motions",
  "stages",
  "colours",
  "manifolds",
  "joints",
  "jointForces",
] as const;

/**
 * The styles in `DrawLists`, by their number. "solved directly" is of lines between pairs. "depth"
 * is a line from a contact point as long as the penetration; "impulse" is one as long as the
 * impulse of a step alone would move the lighter body in a second. "colour 15" also stands for all
 * further colours.
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

/** The drawing as views into wasm memory, valid until the next call of `draw`. */
export interface DrawLists {
  /** Nine numbers a shape: centre, half extents, cosine, sine, 1 if a circle, style, island. */
  readonly shapes: Float32Array;
  /** Five numbers a line: both ends, style. */
  readonly lines: Float32Array;
  /** Three numbers a point: place, style. */
  readonly points: Float32Array;
}

/** A point of a contact, after the last step. */
export interface ContactPoint {
  /** In the world. */
  point: Vec2;
  /** The separation, a length; negative: penetration. */
  separation: number;
  /** Mass times length/s, 0 or more: the impulse of the last substep, times the substeps. */
  normalImpulse: number;
}

/** A pair that touches. Of a static and a moving shape, `a` is the static one. */
export interface Contact {
  a: ShapeId;
  b: ShapeId;
  bodyA: BodyId;
  bodyB: BodyId;
  /** Unit vector, from a to b. */
  normal: Vec2;
  /** At most two points; none where the pair is about to touch again. */
  points: ContactPoint[];
  /** The same impulse of friction on b, along (normal[1], -normal[0]). */
  tangentImpulse: number;
  /** Whether its island was solved directly. */
  direct: boolean;
}
