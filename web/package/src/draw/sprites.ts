/** Keeps what a program draws for bodies: sprites, meshes or functions that paint. */
import { index1Of, Kind, numberOf } from "../plain/handles.js";
import type { BodyRef, Vec2 } from "../types.js";
import type { World } from "../world.js";

/** Draws a thing, or moves it, to a pose: place and cosine and sine of the angle, in the world's units. */
export type Place<Thing> = (thing: Thing, x: number, y: number, cosine: number, sine: number) => void;

/**
 * Things by the body that each is drawn for, at most one a body. A thing whose body was destroyed is removed
 * by the next `update`.
 */
export class Sprites<Thing> {
  readonly #world: World;
  readonly #place: Place<Thing>;
  readonly #remove: (thing: Thing) => void;
  /** Things by their bodies' numbers; the order is that of `add`. */
  readonly #things = new Map<number, Thing>();

  constructor(world: World, place: Place<Thing>, remove: (thing: Thing) => void = () => {}) {
    this.#world = world;
    this.#place = place;
    this.#remove = remove;
  }

  /**
   * Draws a thing for a body from now on, in place of the thing that it had. Returns the thing.
   * @throws {ThudError} "stale" for a body that does not exist, "null" for no handle of a body.
   */
  add(body: BodyRef, thing: Thing): Thing {
    this.#world.positionOf(body);
    if (this.#things.get(keyOf(body)) === thing) return thing;
    this.delete(body);
    this.#things.set(keyOf(body), thing);
    return thing;
  }

  /** Removes the thing of a body, which may have been destroyed. */
  delete(body: BodyRef): void {
    const key = keyOf(body);
    const thing = this.#things.get(key);
    if (thing === undefined) return;
    this.#things.delete(key);
    this.#remove(thing);
  }

  /**
   * Places all things at their bodies' poses between the last two steps. `alpha`: what `World.advance`
   * returned. `origin`: the place of the world that poses are relative to, near what is seen, so that single
   * precision is enough far from the world's origin.
   */
  update(alpha: number, [x, y]: Vec2 = [0, 0]): void {
    for (const body of this.#things.keys()) if (!this.#world.isValid(body)) this.delete(body);
    const poses = this.#world.poses(alpha, x, y);
    for (const [body, thing] of this.#things) {
      const at = 4 * (index1Of(body, Kind.body) - 1);
      this.#place(thing, poses[at], poses[at + 1], poses[at + 2], poses[at + 3]);
    }
  }
}

function keyOf(body: BodyRef): number {
  return typeof body === "number" ? body : numberOf(body);
}
