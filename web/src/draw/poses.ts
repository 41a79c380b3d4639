/** Where bodies are between two steps. */

/** Two states of one engine's bodies, and where to draw them. */
export interface Poses {
  readonly engine: "thud" | "box2d";
  /** Four numbers a slot: x, y, cosine, sine; NaN in empty slots. */
  readonly before: Float32Array;
  readonly now: Float32Array;
  /** From 0, before, to 1, now. */
  readonly alpha: number;
  /** From the camera to the poses' origin, in the world; small where the view is. */
  readonly offset: readonly [x: number, y: number];
}

/** A slot's pose between the two states, relative to the camera, written to `into`; false where
 * the slot is empty. A body that was not there before stands where it is now. */
export function poseBetween(poses: Poses, slot: number, into: Float64Array): boolean {
  const { before, now, alpha, offset } = poses;
  const at = 4 * slot;
  if (!isPose(now, at)) return false;
  for (let i = 0; i < 4; i++) into[i] = now[at + i];
  if (isPose(before, at)) {
    for (let i = 0; i < 4; i++) into[i] = before[at + i] + alpha * (into[i] - before[at + i]);
    const length = Math.sqrt(into[2] * into[2] + into[3] * into[3]);
    // Between opposite directions lies none.
    const turned = length > LEAST_LENGTH;
    into[2] = turned ? into[2] / length : now[at + 2];
    into[3] = turned ? into[3] / length : now[at + 3];
  }
  into[0] += offset[0];
  into[1] += offset[1];
  return true;
}

function isPose(poses: Float32Array, at: number): boolean {
  return at + 4 <= poses.length && poses[at] === poses[at];
}

/** Of the sum of two directions; the shader's too. */
export const LEAST_LENGTH = 0.001;
