/** What joints are made of, and what is read of them. Units as in types.ts. */
import { JointRowAt } from "./generated/slots.js";
import type { BodyId, BodyRef, JointId, JointRef, Vec2 } from "./types.js";

export const JOINT_KINDS = [
  "distance",
  "hinge",
  "slider",
  "weld",
  "wheel",
  "target",
  "filter",
  "gear",
] as const;
export type JointKind = (typeof JOINT_KINDS)[number];

export const DIRECTIONS = ["along", "across", "turn"] as const;
/**
 * A joint looks at body b from body a: along the axis (of a distance: how far apart both ends are),
 * across it, and by turning.
 */
export type Direction = (typeof DIRECTIONS)[number];

/**
 * What acts in a direction that is not locked: limits, a spring and a motor, all at once if you
 * like. Lengths and forces, or radians and torques.
 */
export interface Drive {
  /**
   * The least that there may be. A single limit leaves the other side open, but for a turn, which
   * keeps within (-π, π). Default -Infinity, none.
   * @example lower: -0.5
   */
  lower?: number;
  /**
   * The most that there may be: a rope is a distance with an upper limit. Default Infinity, none.
   * @example upper: 0.5
   */
  upper?: number;
  /**
   * Hz, of a spring towards `target`, up to 10⁴: about the mass that the bodies have there. Default
   * 0, no spring.
   * @example frequency: 4
   */
  frequency?: number;
  /** The spring's damping ratio, 0 or more; 1 is critical. Default 0.7. */
  damping?: number;
  /** Where the spring pulls to. Default 0, of a distance -Infinity: its length. */
  target?: number;
  /**
   * The spring pulls no harder. Default: as hard as it takes. Where springs act along and across,
   * both together pull no harder than the greater of the two.
   */
  springForce?: number;
  /**
   * How fast a motor moves or turns b, seen from a: length/s or radians/s. Default 0, a brake.
   * @example motorSpeed: 3
   */
  motorSpeed?: number;
  /**
   * The motor pushes no harder. Default 0, no motor. Where motors act along and across, both
   * together push no harder than the greater of the two.
   * @example motorForce: 100
   */
  motorForce?: number;
}

/** A place and an axis in a body, from its origin and in its frame. */
export interface JointFrame {
  /** Default [0, 0]. */
  position?: Vec2;
  /** Of the axis, radians against the body's. Default 0. */
  angle?: number;
}

/** What every joint may have. */
export interface JointOptions {
  /** Whether the shapes of its bodies meet. Default false, of a gear true. */
  collideConnected?: boolean;
  /**
   * A joint that pulls harder breaks at the end of that step; see World.jointEvents. Default: never.
   * @example breakForce: 500
   */
  breakForce?: number;
  /** Likewise of its torque. Default: never. */
  breakTorque?: number;
  /** One that would break is told of in every step, and goes on. Default false. */
  onlyReports?: boolean;
  /** Whether it acts. Default true. */
  enabled?: boolean;
  /** For your own use: a whole number from 0 to 2⁵³ - 1. */
  userData?: number;
}

/** Of all but gears. */
export interface PairOptions extends JointOptions {
  /**
   * The body from which the other is looked at. One of both is dynamic.
   * @example bodyA: ground
   */
  bodyA: BodyId;
  /**
   * The other body. That of a wheel or a target is dynamic.
   * @example bodyB: ball
   */
  bodyB: BodyId;
}

/** Where a joint is: at a place in the world, or by a frame in each body. */
export interface PlacedOptions extends PairOptions {
  /**
   * A place in the world: both frames are worked out from where the bodies are now, and the turn
   * counts from there.
   * @example at: [0, 5]
   */
  at?: Vec2;
  /**
   * With `at`: which way the joint's axis points in the world. Default [1, 0], of a wheel [0, 1].
   * @example axis: [0, 1]
   */
  axis?: Vec2;
  /** With `at`: the same as an angle, radians. */
  angle?: number;
  /** Instead of `at`: where the joint is in body a. */
  frameA?: JointFrame;
  /** Instead of `at`: where the joint is in body b. */
  frameB?: JointFrame;
}

/**
 * Keeps two places so far apart: a rod, or what `along` makes of it. With `along: { upper: 3 }` it
 * is a rope, with a frequency a spring that pulls to `length`, or to its target.
 * @example { kind: "distance", bodyA, bodyB, from: [0, 9], to: [0, 5] }
 */
export interface DistanceOptions extends PairOptions {
  kind: "distance";
  /**
   * The end on body a: a place in the world, or by `frameA`.
   * @example from: [0, 9]
   */
  from?: Vec2;
  /**
   * The end on body b: a place in the world, or by `frameB`.
   * @example to: [0, 5]
   */
  to?: Vec2;
  /** Instead of `from`: the end in body a. */
  frameA?: JointFrame;
  /** Instead of `to`: the end in body b. */
  frameB?: JointFrame;
  /** Of a rod, or of a spring without a target, more than 0. Default: what is between both ends now. */
  length?: number;
  /**
   * What acts along the joint: of a distance between its ends, of a slider and a wheel on the axis.
   * @example along: { frequency: 4 }
   */
  along?: Drive;
}

/**
 * Ties two bodies at a place, about which they turn.
 * @example { kind: "hinge", bodyA, bodyB, at: [0, 5], turn: { motorSpeed: 3, motorForce: 100 } }
 */
export interface HingeOptions extends PlacedOptions {
  /**
   * What the joint is.
   * @example kind: "hinge"
   */
  kind: "hinge";
  /**
   * What turns b against a.
   * @example turn: { motorSpeed: 3, motorForce: 100 }
   */
  turn?: Drive;
}

/**
 * Lets b slide along an axis of a, without turning.
 * @example { kind: "slider", bodyA, bodyB, at: [0, 5], axis: [0, 1], along: { lower: 0, upper: 3 } }
 */
export interface SliderOptions extends PlacedOptions {
  kind: "slider";
  /** What acts on the axis. */
  along?: Drive;
}

/**
 * Makes two bodies one. A direction with a spring, a motor or limits gives way so far.
 * @example { kind: "weld", bodyA, bodyB, at: [0, 5] }
 */
export interface WeldOptions extends PlacedOptions {
  kind: "weld";
  /** What lets it give way on the axis. */
  along?: Drive;
  /** What acts across the axis: a weld gives way there, a target pulls. */
  across?: Drive;
  /** What lets it give way by turning. */
  turn?: Drive;
}

/**
 * Hangs a wheel b on a: it turns, and moves along the axis, where its spring is.
 * @example { kind: "wheel", bodyA, bodyB, at: [2, 1], along: { frequency: 4 } }
 */
export interface WheelOptions extends PlacedOptions {
  kind: "wheel";
  /** The suspension. */
  along?: Drive;
  /** The axle. */
  turn?: Drive;
}

/**
 * Nothing is locked: drives alone pull b towards a frame of a, which may be moved with
 * `setJointFrame`. Drags a body, holds one back, moves a platform that pushes.
 * @example { kind: "target", bodyA, bodyB, at: [0, 5], along: { frequency: 5 } }
 */
export interface TargetOptions extends PlacedOptions {
  kind: "target";
  /** What pulls b on the axis. */
  along?: Drive;
  /** What pulls b across the axis. */
  across?: Drive;
  /** What turns b. */
  turn?: Drive;
}

/**
 * The shapes of two bodies do not meet, and that is all.
 * @example { kind: "filter", bodyA, bodyB }
 */
export interface FilterOptions extends PairOptions {
  kind: "filter";
}

/**
 * Ties two joints, each a hinge, a wheel, a slider or a distance between a static body and a dynamic
 * one: the value of the first plus `ratio` times that of the second stays as it is, over any number
 * of turns. Gone with either.
 * @example { kind: "gear", jointA, jointB, ratio: 2 }
 */
export interface GearOptions extends JointOptions {
  kind: "gear";
  /** The first joint of a gear, whose value counts as it is. */
  jointA: JointId;
  /** The second joint of a gear, whose value counts `ratio` times. It moves another body. */
  jointB: JointId;
  /** 10⁻⁴ to 10⁴ either way. Default 1: they turn against each other, as two wheels that mesh. */
  ratio?: number;
}

/** What `World.createJoint` takes. */
export type AnyJointOptions =
  | DistanceOptions
  | HingeOptions
  | SliderOptions
  | WeldOptions
  | WheelOptions
  | TargetOptions
  | FilterOptions
  | GearOptions;

/** What drives a direction: forces or torques, which push its value up where they are above 0. */
export interface DriveForces {
  limit: number;
  spring: number;
  motor: number;
}

/** Where a joint is after the last step, and what it bears. */
export interface JointState {
  kind: JointKind;
  bodyA: BodyId;
  bodyB: BodyId;
  enabled: boolean;
  /** Where b is, seen from a; the turn in (-π, π]. */
  value: Readonly<Record<Direction, number>>;
  /** A length, 0 or more: by how much what is locked or limited is off. */
  gap: number;
  /** Likewise of the turn, radians. */
  angleGap: number;
  /** On b, in the world. */
  force: Vec2;
  /** On b, about its centre of mass, without what `force` does there. */
  torque: number;
  /** The parts of both that drives have; 0 where there is none. */
  drive: Readonly<Record<Direction, DriveForces>>;
  userData: number;
}

/** A joint that bore more than it can, in the last step. */
export interface JointEvent {
  joint: JointId;
  bodyA: BodyId;
  bodyB: BodyId;
  userData: number;
  /** What it bore, 0 or more. */
  force: number;
  torque: number;
  /** It is gone. */
  broken: boolean;
}

/** Every joint at once, for drawing. The arrays are views into wasm memory: see `poses()`. */
export interface JointTable {
  readonly count: number;
  /**
   * 35 numbers a joint: kind, slots of both bodies, enabled, awake, the anchors in the bodies'
   * frames (x and y of a's, of b's), the axis in a's frame (cosine and sine); then in the world
   * both anchors, the axis, both centres of mass; then for along, across and turn the values, the
   * least and the most that there may be (equal where it is locked, infinite where it is free); gap,
   * angle gap, force x and y on b, torque. JOINT_ROW has their places.
   */
  readonly rows: Float32Array;
  /** Six numbers a joint: index1 and generation of the joint, and of its bodies. */
  readonly handles: Uint32Array;
}

/** Where in a row of JointTable its numbers begin; a row has `length` of them. */
export const JOINT_ROW = {
  kind: JointRowAt.kind,
  slotA: JointRowAt.slotA,
  slotB: JointRowAt.slotB,
  enabled: JointRowAt.enabled,
  awake: JointRowAt.awake,
  anchorA: JointRowAt.anchorA,
  anchorB: JointRowAt.anchorB,
  axis: JointRowAt.axis,
  placeA: JointRowAt.placeA,
  placeB: JointRowAt.placeB,
  direction: JointRowAt.direction,
  centerA: JointRowAt.centerA,
  centerB: JointRowAt.centerB,
  value: JointRowAt.value,
  lower: JointRowAt.lower,
  upper: JointRowAt.upper,
  gap: JointRowAt.gap,
  angleGap: JointRowAt.angleGap,
  force: JointRowAt.force,
  torque: JointRowAt.torque,
  length: JointRowAt.length,
} as const;

type Sides = { bodyA: BodyRef; bodyB: BodyRef; jointA: JointRef; jointB: JointRef };
/** The same with numbers in the place of handles. */
export type Numbered<T> = T extends unknown
  ? Omit<T, keyof Sides> & Pick<Sides, keyof T & keyof Sides>
  : never;
