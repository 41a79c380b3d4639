/** Interpolates the poses of bodies between two steps. */

/** The poses of one engine's bodies before and after a step, and when and where to draw them. */
export interface Poses {
  readonly engine: "thud" | "box2d";
  /** Four numbers a slot: x, y, cosine, sine; NaN in empty slots. */
  readonly before: Float32Array;
  readonly now: Float32Array;
  /** The share of the step that has passed: 0 is `before`, 1 is `now`. */
  readonly alpha: number;
  /** From the camera to the origin that the poses are relative to, in world units. */
  readonly offset: readonly [x: number, y: number];
}

/**
 * Writes the interpolated pose of a slot, relative to the camera, to `into`: x, y, cosine, sine.
 * False if the slot is empty. A body that did not exist before is drawn at its present pose.
 */
export function poseBetween(poses: Poses, slot: number, into: Float64Array): boolean {
  const { before, now, alpha, offset } = poses;
  const at = 4 * slot;
  if (!isPose(now, at)) return false;
  for (let i = 0; i < 4; i++) into[i] = now[at + i];
  if (isPose(before, at)) {
    for (let i = 0; i < 4; i++) into[i] = before[at + i] + alpha * (into[i] - before[at + i]);
    const length = Math.sqrt(into[2] * into[2] + into[3] * into[3]);
    // The mean of two opposite directions has no direction: the present one is taken.
    const turned = length > LEAST_LENGTH;
    into[2] = turned ? into[2] / length : now[at + 2];
    into[3] = turned ? into[3] / length : now[at + 3];
  }
  into[0] += offset[0];
  into[1] += offset[1];
  return true;
}

/** Whether there is a pose at an index: empty slots have NaN. */
function isPose(poses: Float32Array, at: number): boolean {
  return at + 4 <= poses.length && poses[at] === poses[at];
}

/** Smallest length of a sum of two directions that is normalised. The shader uses it, too. */
export const LEAST_LENGTH = 0.001;
