/**
 * Reads the poses of the bodies that moved in a step of Box2D. Box2D lists them in its memory (move
 * events). Its bindings would create several objects for each body, so the list is read from memory
 * directly. The layout is that of b2BodyEvents and b2BodyMoveEvent in the pinned version of the
 * package, compiled for 32 bits.
 */
import type { b2WorldId } from "../../node_modules/box2d3-wasm/build/dist/es/deluxe/Box2D.deluxe";
import type { Box2D } from "./load";

/**
 * A b2BodyMoveEvent has eight words of four bytes: user data, x, y, cosine, sine, index, world and
 * generation, asleep. X_WORD and INDEX_WORD are the positions of x and of the index in it.
 */
const WORDS_PER_EVENT = 8;
const X_WORD = 1;
const INDEX_WORD = 5;

export class Moves {
  readonly #box2d: Box2D;
  #words: Uint32Array = new Uint32Array(0);
  #floats: Float32Array = new Float32Array(0);
  /** Position of the first event, in words. */
  #first = 0;
  /** Number of events. */
  count = 0;

  constructor(box2d: Box2D) {
    this.#box2d = box2d;
  }

  /**
   * Finds the events of the last step. They are valid until the next call of any function of Box2D.
   */
  read(world: b2WorldId): void {
    const events = this.#box2d.b2World_GetBodyEvents(world);
    const { buffer } = this.#box2d.HEAPU8 as Uint8Array;
    if (this.#words.buffer !== buffer) {
      // The memory has grown, and is another buffer now.
      this.#words = new Uint32Array(buffer);
      this.#floats = new Float32Array(buffer);
    }
    this.count = events.moveCount;
    // The first word of a b2BodyEvents is the address of the array of events.
    this.#first = this.#words[addressOf(events) >>> 2] >>> 2;
    events.delete();
  }

  /** The index of the b2BodyId of event i. */
  index1(i: number): number {
    return this.#words[this.#first + WORDS_PER_EVENT * i + INDEX_WORD];
  }

  /** Copies x, y, cosine and sine of event i to `into`, from position `at` on. */
  copyPose(i: number, into: Float32Array, at: number): void {
    const from = this.#first + WORDS_PER_EVENT * i + X_WORD;
    for (let k = 0; k < 4; k++) into[at + k] = this.#floats[from + k];
  }
}

/** The address of the object that a handle of the bindings (embind) stands for. */
function addressOf(handle: object): number {
  return (handle as { $$: { ptr: number } }).$$.ptr;
}
