/**
 * Computes, from the poses of two bodies alone, how far the joint between them is open: by the same
 * code for thud's poses and for Box2D's.
 */
import type { Drive, JointFrame, Vec2 } from "thud";
import { isDriven, type Tie } from "./make-joint";

/** A length in the world's unit and an angle in radians; both at least 0. */
export type Gap = readonly [length: number, angle: number];

/** The `length` of thud_joint_def where the options of a distance have none, a length. */
const DEFAULT_LENGTH = 1;

/**
 * The gap of a joint, as JointState.gap and angleGap have it: how far the bodies are off in
 * directions that are locked, or beyond the limits of driven ones. A joint of kind filter or target
 * locks no direction and has no gap. `poses` is laid out like World.poses: four numbers a body, x,
 * y, and the cosine and sine of its angle.
 */
export function gapOf(tie: Exclude<Tie, { kind: "filter" | "target" }>, poses: Float32Array): Gap {
  const a = placeOf(poses, tie.bodyA.index, tie.frameA);
  const b = placeOf(poses, tie.bodyB.index, tie.frameB);
  const [dx, dy] = [b.at[0] - a.at[0], b.at[1] - a.at[1]];
  if (tie.kind === "distance")
    return [gapOfDirection(Math.hypot(dx, dy), tie.length ?? DEFAULT_LENGTH, tie.along), 0];
  const turn = angleBetween(a.axis, b.axis);
  const along = dx * a.axis[0] + dy * a.axis[1];
  const across = dy * a.axis[0] - dx * a.axis[1];
  switch (tie.kind) {
    case "hinge":
      return [Math.hypot(dx, dy), beyond(turn, tie.turn)];
    case "slider":
      return [Math.hypot(beyond(along, tie.along), across), Math.abs(turn)];
    case "wheel":
      return [Math.hypot(beyond(along, tie.along), across), beyond(turn, tie.turn)];
    case "weld": {
      const gapAlong = gapOfDirection(along, 0, tie.along);
      const gapAcross = gapOfDirection(across, 0, tie.across);
      return [Math.hypot(gapAlong, gapAcross), gapOfDirection(turn, 0, tie.turn)];
    }
  }
}

/**
 * How far a coordinate is off in a direction that is locked at `locked` unless it has a drive (a
 * spring, a motor or limits): in a direction with a drive only the limits count.
 */
function gapOfDirection(value: number, locked: number, drive?: Drive): number {
  return isDriven(drive) ? beyond(value, drive) : Math.abs(value - locked);
}

/** How far a value is outside of the limits; 0 within. */
function beyond(value: number, { lower = -Infinity, upper = Infinity }: Drive = {}): number {
  return Math.max(0, lower - value, value - upper);
}

/**
 * The place and x axis of a joint's frame in the world, in double precision. `index`: the body's,
 * in the poses.
 */
function placeOf(
  poses: Float32Array,
  index: number,
  { position = [0, 0], angle = 0 }: JointFrame = {},
): { at: Vec2; axis: Vec2 } {
  const [x, y, c, s] = poses.subarray(4 * index, 4 * index + 4);
  const [ac, as] = [Math.cos(angle), Math.sin(angle)];
  return {
    at: [x + c * position[0] - s * position[1], y + s * position[0] + c * position[1]],
    axis: [c * ac - s * as, s * ac + c * as],
  };
}

/**
 * The angle from axis a to axis b, in (-pi, pi]. Limits of angles lie there as well: see
 * THUD_JOINT_ANGLE_MAX.
 */
function angleBetween(a: Vec2, b: Vec2): number {
  return Math.atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
}
