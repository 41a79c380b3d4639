/**
 * Reads where bodies went in a step. Box2D lists them in its memory, and its bindings would make
 * several objects of each; the list itself is read instead, in a hundredth of the time. The layout
 * is that of b2BodyEvents and b2BodyMoveEvent in the pinned version of the package, compiled for 32
 * bits.
 */
import type { b2WorldId } from "../../node_modules/box2d3-wasm/build/dist/es/deluxe/Box2D.deluxe";
import type { Box2D } from "./load";

/** In words of four bytes: user data, x, y, cosine, sine, index, world and generation, asleep. */
const WORDS = 8;
const POSE = 1;
const INDEX = 5;

export class Moves {
  readonly #box2d: Box2D;
  #words: Uint32Array = new Uint32Array(0);
  #floats: Float32Array = new Float32Array(0);
  #first = 0;
  count = 0;

  constructor(box2d: Box2D) {
    this.#box2d = box2d;
  }

  /** Of the last step; until the next call of anything in Box2D. */
  read(world: b2WorldId): void {
    const events = this.#box2d.b2World_GetBodyEvents(world);
    const { buffer } = this.#box2d.HEAPU8 as Uint8Array;
    if (this.#words.buffer !== buffer) {
      // Memory grew.
      this.#words = new Uint32Array(buffer);
      this.#floats = new Float32Array(buffer);
    }
    this.count = events.moveCount;
    this.#first = this.#words[addressOf(events) >> 2] >> 2;
    events.delete();
  }

  /** The index of the i-th one's b2BodyId. */
  index1(i: number): number {
    return this.#words[this.#first + WORDS * i + INDEX];
  }

  /** Its x, y, cosine and sine go to `into` from `at` on. */
  copyPose(i: number, into: Float32Array, at: number): void {
    const from = this.#first + WORDS * i + POSE;
    for (let k = 0; k < 4; k++) into[at + k] = this.#floats[from + k];
  }
}

/** Where the object that a handle of the bindings (embind) stands for lies in memory. */
function addressOf(handle: object): number {
  return (handle as { $$: { ptr: number } }).$$.ptr;
}
