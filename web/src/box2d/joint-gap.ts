/**
 * Computes how far a joint is open from the poses of its bodies, by the same code for both engines.
 */
import type { Drive, JointFrame, Vec2 } from "thud";
import { isDriven, type Tie } from "./make-joint";

/** A length and an angle in radians; both at least 0. */
export type Gap = readonly [length: number, angle: number];

/**
 * The gap of a joint, as JointState.gap and angleGap have it: how far the bodies are off in
 * directions that are locked, or beyond a limit. `poses` is laid out like World.poses.
 */
export function gapOf(tie: Exclude<Tie, { kind: "filter" | "target" }>, poses: Float32Array): Gap {
  const a = placeOf(poses, tie.bodyA.index, tie.frameA);
  const b = placeOf(poses, tie.bodyB.index, tie.frameB);
  const [dx, dy] = [b.at[0] - a.at[0], b.at[1] - a.at[1]];
  if (tie.kind === "distance") {
    const length = Math.hypot(dx, dy);
    return [isDriven(tie.along) ? beyond(length, tie.along) : Math.abs(length - (tie.length ?? 1)), 0];
  }
  const turn = turnFrom(a.axis, b.axis);
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
      const off = (value: number, drive?: Drive) =>
        isDriven(drive) ? beyond(value, drive) : Math.abs(value);
      return [Math.hypot(off(along, tie.along), off(across, tie.across)), off(turn, tie.turn)];
    }
  }
}

/** How far a value is outside of the limits; 0 within. */
function beyond(value: number, { lower = -Infinity, upper = Infinity }: Drive = {}): number {
  return Math.max(0, lower - value, value - upper);
}

/** The place and axis of a joint's frame in the world, in double precision. */
function placeOf(
  poses: Float32Array,
  slot: number,
  { position = [0, 0], angle = 0 }: JointFrame = {},
): { at: Vec2; axis: Vec2 } {
  const [x, y, c, s] = poses.subarray(4 * slot, 4 * slot + 4);
  const [ac, as] = [Math.cos(angle), Math.sin(angle)];
  return {
    at: [x + c * position[0] - s * position[1], y + s * position[0] + c * position[1]],
    axis: [c * ac - s * as, s * ac + c * as],
  };
}

/** The angle from axis a to axis b, in (-pi, pi]. */
function turnFrom(a: Vec2, b: Vec2): number {
  return Math.atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
}
