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
  let [x, y, c, s] = [now[at], now[at + 1], now[at + 2], now[at + 3]];
  if (!(x === x) || at + 4 > now.length) return false;
  if (at + 4 <= before.length && before[at] === before[at]) {
    x = before[at] + alpha * (x - before[at]);
    y = before[at + 1] + alpha * (y - before[at + 1]);
    const turnC = before[at + 2] + alpha * (c - before[at + 2]);
    const turnS = before[at + 3] + alpha * (s - before[at + 3]);
    const length = Math.hypot(turnC, turnS);
    // Between opposite directions lies none.
    if (length > LEAST_LENGTH) [c, s] = [turnC / length, turnS / length];
  }
  into[0] = x + offset[0];
  into[1] = y + offset[1];
  into[2] = c;
  into[3] = s;
  return true;
}

/** Of the sum of two directions; the shader's too. */
export const LEAST_LENGTH = 0.001;
