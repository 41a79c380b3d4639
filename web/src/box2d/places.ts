/**
 * The poses of a Box2DWorld's bodies. Box2D has them as floats, in metres, relative to an origin of
 * its own; the thud world has doubles in its own units.
 */
import type { Vec2, World } from "thud";

/** Largest distance from the origin that Box2D is made for, in metres (its B2_HUGE). */
const FARTHEST = 1e5;

/** The length of a metre in the world's units, and the place of Box2D's origin in the world. */
export interface Placing {
  unit: number;
  origin: Vec2;
}

export class Places {
  readonly #unit: number;
  readonly #origin: Vec2;
  /**
   * Poses before and after the last step: by slot x, y, cosine and sine, in metres; NaN in empty
   * slots.
   */
  #before = new Float32Array(0);
  #now = new Float32Array(0);

  constructor({ unit, origin }: Placing) {
    this.#unit = unit;
    this.#origin = origin;
  }

  /** A place in the thud world, in Box2D's coordinates. */
  toMetres([x, y]: Vec2): Vec2 {
    const [ox, oy] = this.#origin;
    return [(x - ox) / this.#unit, (y - oy) / this.#unit];
  }

  /** The poses in metres. After a step the caller writes new ones, at 4 times the slot. */
  get now(): Float32Array {
    return this.#now;
  }

  /** A pose as x, y, cosine and sine, in the world's units. */
  pose(slot: number): readonly [number, number, number, number] {
    const [x, y, cosine, sine] = this.#now.subarray(4 * slot, 4 * slot + 4);
    const [ox, oy] = this.#origin;
    return [x * this.#unit + ox, y * this.#unit + oy, cosine, sine];
  }

  /**
   * The poses, laid out like World.poses and relative to x, y: for alpha 1 after the last step, for
   * alpha 0 before it.
   */
  copy(alpha: 0 | 1, x: number, y: number): Float32Array<ArrayBuffer> {
    const poses = new Float32Array(alpha === 0 ? this.#before : this.#now);
    // The difference of two near places is small, and exact as a float, also far from the world's
    // origin.
    const [dx, dy] = [this.#origin[0] - x, this.#origin[1] - y];
    for (let i = 0; i < poses.length; i += 4) {
      poses[i] = poses[i] * this.#unit + dx;
      poses[i + 1] = poses[i + 1] * this.#unit + dy;
    }
    return poses;
  }

  /** Keeps the present poses as those before the step. */
  beginStep(): void {
    this.#before.set(this.#now);
  }

  /** Adds a body: its pose before the step is its present one. */
  add(slot: number, position: Vec2, angle: number): void {
    if (4 * slot >= this.#now.length) this.#grow(slot);
    this.put(slot, position, angle);
    const end = 4 * slot + 4;
    this.#before.set(this.#now.subarray(end - 4, end), end - 4);
  }

  /** Sets the present pose of a body. */
  put(slot: number, position: Vec2, angle: number): void {
    this.#now.set([...this.toMetres(position), Math.cos(angle), Math.sin(angle)], 4 * slot);
  }

  remove(slot: number): void {
    for (const poses of [this.#before, this.#now]) poses.fill(NaN, 4 * slot, 4 * slot + 4);
  }

  #grow(slot: number): void {
    const grown = (old: Float32Array) => {
      const larger = new Float32Array(4 * Math.max(slot + 1, 64, old.length / 2)).fill(NaN);
      larger.set(old);
      return larger;
    };
    this.#now = grown(this.#now);
    this.#before = grown(this.#before);
  }
}

/** The mean place of all bodies, rounded to whole numbers. */
export function middleOf(world: World): Vec2 {
  let [count, x, y] = [0, 0, 0];
  for (const [px, py] of placesOf(world)) [count, x, y] = [count + 1, x + px, y + py];
  return count > 0 ? [Math.round(x / count), Math.round(y / count)] : [0, 0];
}

/**
 * The place for Box2D's origin: the world's own origin, or the middle of the bodies if these are
 * too far from it for Box2D. Throws if they are too far from each other.
 */
export function originFor(world: World, unit: number): Vec2 {
  const most = FARTHEST * unit;
  const reach = ([x, y]: Vec2) =>
    placesOf(world).reduce((far, [px, py]) => Math.max(far, Math.hypot(px - x, py - y)), 0);
  if (reach([0, 0]) <= most) return [0, 0];
  const middle = middleOf(world);
  const far = reach(middle);
  if (far <= most) return middle;
  throw new Error(
    "Box2D keeps places as numbers of 32 bits and is made for 100 km around its origin; this " +
      `world has bodies ${Math.round(far / (most / 100))} km from their middle.`,
  );
}

/** The places of all bodies, as floats. */
function placesOf(world: World): Vec2[] {
  const poses = world.poses(1, 0, 0);
  const places: Vec2[] = [];
  for (let i = 0; i < poses.length; i += 4)
    if (!Number.isNaN(poses[i])) places.push([poses[i], poses[i + 1]]);
  return places;
}
