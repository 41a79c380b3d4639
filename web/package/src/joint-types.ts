/**
 * The options of joints, and what a world reports about them. Units as in types.ts. Lengths are up
 * to 10⁶ length scales; thud_joint.h describes joints in full.
 */
import { JointRowAt } from "./generated/slots.js";
import type { BodyId, BodyRef, JointId, JointRef, Vec2 } from "./types.js";

/** The kinds of joints, in the order of thud_joint_kind. */
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
 * The directions in which a joint measures body b relative to body a: along the x axis of the frame
 * in a (of a distance: the distance of both ends), across it, and rotation. A joint's value in a
 * direction is a length, of turn an angle in radians.
 */
export type Direction = (typeof DIRECTIONS)[number];

/**
 * What acts in a direction that is not locked: limits, a spring and a motor, or several of them.
 * Values are lengths and forces (mass times length/s²), of turn radians and torques.
 */
export interface Drive {
  /**
   * The lower limit of the joint's value: of turn within ±π, of a distance 0 or more. If only one
   * limit is given there is none on the other side; a turn with a limit stays within (-π, π).
   * Default -Infinity, no limit.
   * @example lower: -0.5
   */
  lower?: number;
  /**
   * The upper limit of the joint's value, at least `lower`: a distance with it is a rope. Equal
   * limits lock the direction. Default Infinity, no limit.
   * @example upper: 0.5
   */
  upper?: number;
  /**
   * The frequency of a spring towards `target`: Hz, 0 to 10⁴, with the effective mass of both
   * bodies in this direction. Default 0, no spring.
   * @example frequency: 4
   */
  frequency?: number;
  /** The spring's damping ratio, 0 to 1000; 1 is critical. Default 0.7. */
  damping?: number;
  /** The value to which the spring pulls. Default 0, of a distance -Infinity: its length. */
  target?: number;
  /**
   * The maximum force of the spring, 0 to 10³⁰. Default: no maximum. Where springs act along and
   * across, the resultant of both is at most the greater maximum.
   */
  springForce?: number;
  /**
   * The speed to which a motor brings b relative to a: length/s, of turn radians/s, up to 10⁶
   * (length scales a second) either way. Default 0, a brake.
   * @example motorSpeed: 3
   */
  motorSpeed?: number;
  /**
   * The maximum force of the motor, 0 to 10³⁰. Default 0, no motor. Where motors act along and
   * across, the resultant of both is at most the greater maximum.
   * @example motorForce: 100
   */
  motorForce?: number;
}

/** The anchor and the x axis of a joint in a body. */
export interface JointFrame {
  /** The anchor in the body's frame, up to 10⁶ length scales. Default [0, 0]. */
  position?: Vec2;
  /** The angle of the joint's x axis from the body's: radians, up to 10⁶ either way. Default 0. */
  angle?: number;
}

/** Options of every kind of joint. */
export interface JointOptions {
  /** Whether the shapes of its bodies collide. Default false, of a gear true. */
  collideConnected?: boolean;
  /**
   * The force beyond which the joint breaks: it is destroyed at the end of that step, and
   * World.jointEvents reports it. 0 to 10³⁰, mass times length/s². Default: never.
   * @example breakForce: 500
   */
  breakForce?: number;
  /** The torque beyond which the joint breaks, 0 to 10³⁰, mass times length²/s². Default: never. */
  breakTorque?: number;
  /** True: a joint that would break stays, and is reported in every such step. Default false. */
  onlyReports?: boolean;
  /** Whether the joint acts. Default true. */
  enabled?: boolean;
  /** For your own use: a whole number from 0 to 2⁵³ - 1. Default 0. */
  userData?: number;
}

/** Options of every kind of joint but gears. */
export interface PairOptions extends JointOptions {
  /**
   * The body relative to which the other is measured. At least one of both must be dynamic.
   * @example bodyA: ground
   */
  bodyA: BodyId;
  /**
   * The other body, not the same one. That of a wheel or a target must be dynamic.
   * @example bodyB: ball
   */
  bodyB: BodyId;
}

/** The place of a joint: a place in the world, or a frame in each body. One of them is needed. */
export interface PlacedOptions extends PairOptions {
  /**
   * The place of the joint in the world, up to 10⁹ length scales away: both frames are computed
   * from the present poses of the bodies, at which the turn is 0.
   * @example at: [0, 5]
   */
  at?: Vec2;
  /**
   * With `at`: the direction of the joint's x axis in the world, of any length but 0. Default [1,
   * 0], of a wheel [0, 1].
   * @example axis: [0, 1]
   */
  axis?: Vec2;
  /** With `at`, instead of `axis`: the angle of that direction, radians, up to 10⁶ either way. */
  angle?: number;
  /** Instead of `at`: the joint's frame in body a. */
  frameA?: JointFrame;
  /** Instead of `at`: the joint's frame in body b. */
  frameB?: JointFrame;
}

/**
 * A rod: it keeps the distance of two anchors at `length`. With `along` it is driven instead: with
 * `along: { upper: 3 }` it is a rope, with a frequency a spring that pulls to `length` or its
 * target.
 * @example { kind: "distance", bodyA, bodyB, from: [0, 9], to: [0, 5] }
 */
export interface DistanceOptions extends PairOptions {
  kind: "distance";
  /**
   * The anchor on body a, as a place in the world. Without it `frameA` counts.
   * @example from: [0, 9]
   */
  from?: Vec2;
  /**
   * The anchor on body b, as a place in the world. Without it `frameB` counts.
   * @example to: [0, 5]
   */
  to?: Vec2;
  /** Instead of `from`: the anchor in body a. Default its origin. */
  frameA?: JointFrame;
  /** Instead of `to`: the anchor in body b. Default its origin. */
  frameB?: JointFrame;
  /**
   * The length of a rod, or of a spring without a target: more than 0, up to 10⁶ length scales.
   * Default: the present distance of both anchors.
   */
  length?: number;
  /**
   * The drive along the joint: of a distance between its anchors, of other kinds along the axis.
   * @example along: { frequency: 4 }
   */
  along?: Drive;
}

/**
 * A hinge: it keeps two anchors together, about which the bodies turn.
 * @example { kind: "hinge", bodyA, bodyB, at: [0, 5], turn: { motorSpeed: 3, motorForce: 100 } }
 */
export interface HingeOptions extends PlacedOptions {
  /**
   * The kind of the joint.
   * @example kind: "hinge"
   */
  kind: "hinge";
  /**
   * The drive of the rotation of b relative to a.
   * @example turn: { motorSpeed: 3, motorForce: 100 }
   */
  turn?: Drive;
}

/**
 * A slider: body b moves along an axis of body a, and does not turn relative to it.
 * @example { kind: "slider", bodyA, bodyB, at: [0, 5], axis: [0, 1], along: { lower: 0, upper: 3 } }
 */
export interface SliderOptions extends PlacedOptions {
  kind: "slider";
  /** The drive along the axis. */
  along?: Drive;
}

/**
 * A weld: it locks two bodies together. A direction with a spring, a motor or limits is driven
 * instead.
 * @example { kind: "weld", bodyA, bodyB, at: [0, 5] }
 */
export interface WeldOptions extends PlacedOptions {
  kind: "weld";
  /** The drive along the axis. Default: locked. */
  along?: Drive;
  /** The drive across the axis. Default: of a weld locked, of a target free. */
  across?: Drive;
  /** The drive of the rotation. Default: locked. */
  turn?: Drive;
}

/**
 * A wheel b on body a: it turns, and moves along the axis of the suspension only.
 * @example { kind: "wheel", bodyA, bodyB, at: [2, 1], along: { frequency: 4 } }
 */
export interface WheelOptions extends PlacedOptions {
  kind: "wheel";
  /** The drive along the axis: the suspension. */
  along?: Drive;
  /** The drive of the wheel's rotation: the axle. */
  turn?: Drive;
}

/**
 * A target: it locks no direction; its drives pull b towards the frame in a, which `setJointFrame`
 * moves. It serves to drag a body with a pointer, to hold it back, or to move a platform by forces.
 * A spring in one direction leaves the body free in the other.
 * @example { kind: "target", bodyA, bodyB, at: [0, 5], along: { frequency: 5 }, across: { frequency: 5 } }
 */
export interface TargetOptions extends PlacedOptions {
  kind: "target";
  /** The drive along the axis. */
  along?: Drive;
  /** The drive across the axis. */
  across?: Drive;
  /** The drive of b's rotation. */
  turn?: Drive;
}

/**
 * A filter: the shapes of two bodies do not collide. It has no other effect.
 * @example { kind: "filter", bodyA, bodyB }
 */
export interface FilterOptions extends PairOptions {
  kind: "filter";
}

/**
 * A gear couples two joints, each a hinge, a wheel, a slider or a distance between a static body
 * and a dynamic one: the value of the first plus `ratio` times that of the second stays as it is,
 * over any number of turns. The gear is destroyed with either joint.
 * @example { kind: "gear", jointA, jointB, ratio: 2 }
 */
export interface GearOptions extends JointOptions {
  kind: "gear";
  /** The first joint of a gear, whose value counts as it is. */
  jointA: JointId;
  /**
   * The second joint of a gear, whose value counts `ratio` times. Its dynamic body is another one.
   */
  jointB: JointId;
  /**
   * The factor of the second joint's value, 10⁻⁴ to 10⁴ or the negative of it. Default 1: the two
   * turn against each other, as two wheels that mesh.
   */
  ratio?: number;
}

/** The options of `World.createJoint`. */
export type AnyJointOptions =
  | DistanceOptions
  | HingeOptions
  | SliderOptions
  | WeldOptions
  | WheelOptions
  | TargetOptions
  | FilterOptions
  | GearOptions;

/** The forces of a direction's drive, of turn torques. Positive ones increase the joint's value. */
export interface DriveForces {
  limit: number;
  spring: number;
  motor: number;
}

/** The state of a joint after the last step. Forces are those of the last substep. */
export interface JointState {
  kind: JointKind;
  bodyA: BodyId;
  bodyB: BodyId;
  enabled: boolean;
  /** The value in each direction: lengths; the turn in radians, in (-π, π]. */
  value: Readonly<Record<Direction, number>>;
  /** The length by which locked directions are open and limits exceeded, 0 or more. */
  gap: number;
  /** The same of the turn: radians, 0 or more. */
  angleGap: number;
  /** The force on b, in the world: mass times length/s². */
  force: Vec2;
  /** The torque on b, mass times length²/s², without the moment of `force`. */
  torque: number;
  /** The parts of force and torque that the drives apply; 0 where a drive has no such part. */
  drive: Readonly<Record<Direction, DriveForces>>;
  userData: number;
}

/** A joint whose force or torque exceeded breakForce or breakTorque in the last step. */
export interface JointEvent {
  joint: JointId;
  bodyA: BodyId;
  bodyB: BodyId;
  userData: number;
  /** The magnitude of its force, mass times length/s². */
  force: number;
  /** The magnitude of its torque, mass times length²/s². */
  torque: number;
  /** Whether the joint was destroyed; false where it has `onlyReports`. */
  broken: boolean;
}

/** All joints at once, for drawing. The arrays are views into wasm memory: see `poses()`. */
export interface JointTable {
  readonly count: number;
  /**
   * 35 numbers a joint: kind, slots of both bodies, enabled, awake, the anchors in the bodies'
   * frames (x and y of a's, of b's), the axis in a's frame (cosine and sine); then in the world
   * both anchors, the axis, both centres of mass; then for along, across and turn the values, the
   * lower and the upper limits (equal where the direction is locked, infinite where it is free);
   * gap, angle gap, force x and y on b, torque. JOINT_ROW has their places.
   */
  readonly rows: Float32Array;
  /**
   * Six numbers a joint: index1 (slot + 1) and generation of the joint, of body a and of body b.
   */
  readonly handles: Uint32Array;
}

/** The index of each number in a row of JointTable; a row has `length` numbers. */
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

/** The options of joints that are handles. */
type Sides = { bodyA: BodyRef; bodyB: BodyRef; jointA: JointRef; jointB: JointRef };
/**
 * The options T of a joint, in which the handles (`Sides`: bodyA, bodyB, jointA and jointB) may also be given as
 * numbers (see `numberOf`).
 */
export type Numbered<T> = T extends unknown
  ? Omit<T, keyof Sides> & Pick<Sides, keyof T & keyof Sides>
  : never;
