/**
 * The layer of World with lists of handles: bodies, shapes, moved bodies, the shapes that a sensor
 * overlaps, and pairs that met. Lists are in the order of slots. thud_lists.h describes them in
 * full. All are allowed inside callbacks. Each throws a ThudError "memory" where a list has no
 * room.
 */
import { ThudError } from "./error.js";
import { HandleAt, ListAt, PairAt, PairSideAt, ShapeStateAt } from "./generated/slots.js";
import { bodyAt, rowsOf, shapeAt } from "./numbers.js";
import { index1Of, Kind } from "./plain/handles.js";
import { WorldRules } from "./rules/world-rules.js";
import type { BodyId, ShapeId, ShapeRef } from "./types.js";
import type { ContactEvent, EventPair, Events, Pair, PairSide } from "./view-types.js";

/** The layer of World with lists. */
export class WorldLists extends WorldRules {
  /**
   * The array of thud_body_seen in wasm memory, with the poses that movedBodies last listed, and
   * the number of body slots for which it has room.
   */
  #seen = { address: 0, slots: 0 };

  protected override freeRoom(): void {
    this.engine.exports.free(this.#seen.address);
    this.#seen = { address: 0, slots: 0 };
  }

  /** All bodies, disabled and quarantined ones included. */
  bodies(): BodyId[] {
    this.onWorld("api_world_bodies");
    return this.#bodyIds();
  }

  /** The awake bodies: the dynamic and kinematic bodies that the next step integrates. */
  awakeBodies(): BodyId[] {
    this.onWorld("api_world_awake_bodies");
    return this.#bodyIds();
  }

  /** All shapes, sensors and terrains included. */
  shapes(): ShapeId[] {
    this.onWorld("api_world_shapes");
    return this.shapeIds();
  }

  /**
   * The bodies whose pose has changed since this was last called, and new ones: a renderer need not
   * update the others. Bodies that `setTransform` moved or `restore` brought back are listed,
   * destroyed ones are not. A renderer that interpolates by `poses(alpha)` must also update the
   * bodies of the call before: a body that has stopped was last drawn before its final pose.
   * @throws {ThudError} "memory".
   * @example for (const body of world.movedBodies()) redraw(body)
   */
  movedBodies(): BodyId[] {
    const { exports } = this.engine;
    const slots = exports.api_world_body_slots(this.address);
    if (slots > this.#seen.slots) this.#makeRoom(slots);
    this.engine.check(exports.api_world_moved_bodies(this.address, this.#seen.address, slots));
    return this.#bodyIds();
  }

  /**
   * The body of a slot, whose pose is at `4 * slot` in `poses()`; null for an empty slot.
   * @throws {ThudError} "invalid" for a slot that was never used.
   */
  bodyAt(slot: number): BodyId | null {
    this.onWorld("api_world_body_at", slot);
    const s = this.engine.slots;
    return s[HandleAt.index1] === 0 ? null : bodyAt(s, HandleAt.index1);
  }

  /**
   * The shape of a slot, which is the `index` of its handle; null for an empty slot.
   * @throws {ThudError} "invalid" for a slot that was never used.
   */
  shapeAt(slot: number): ShapeId | null {
    this.onWorld("api_world_shape_at", slot);
    const s = this.engine.slots;
    return s[HandleAt.index1] === 0 ? null : shapeAt(s, HandleAt.index1);
  }

  /**
   * The shapes that a sensor overlaps, as the last step found them.
   * @throws {ThudError} "stale"; "invalid" for a shape that is no sensor.
   * @example if (world.sensorOverlapsOf(goal).length > 0) score()
   */
  sensorOverlapsOf(sensor: ShapeRef): ShapeId[] {
    this.on(Kind.shape, "api_shape_sensor_overlaps", sensor);
    return this.shapeIds();
  }

  /**
   * The bodies of the two shapes of a contact or an event, with the user data of bodies and shapes;
   * null for a shape that was destroyed since.
   * @example const { a, b } = world.pairOf(hit)
   */
  pairOf({ a, b }: Pick<ContactEvent, "a" | "b">): Pair {
    const { exports, slots: s } = this.engine;
    const [index1A, index1B] = [index1Of(a, Kind.shape), index1Of(b, Kind.shape)];
    const call = exports.api_world_pair;
    this.engine.check(call(this.address, index1A, a.generation, index1B, b.generation));
    return { a: readSide(s, PairAt.a), b: readSide(s, PairAt.b) };
  }

  /**
   * The pairs of shapes of two categories (bits) that met in the last step, or in the steps of the
   * last `advance`: they began to touch, hit each other, or a sensor began to overlap a shape. `a`
   * is of the first category, whatever the order in the event. A pair is listed once; a bounce that
   * hits in one step and touches in the next is listed after both. Pairs with a shape that was
   * destroyed since are left out, also where the loop over the result destroyed it.
   * @throws {ThudError} "invalid" for a category that is no whole number of 32 bits.
   * @example for (const { b: brick } of world.eventPairs(BALL, BRICK)) world.destroy(brick.body)
   */
  eventPairs(categoryA: number, categoryB: number): Generator<EventPair> {
    for (const category of [categoryA, categoryB])
      if (category >>> 0 !== category && (category | 0) !== category)
        throw new ThudError("invalid", "eventPairs: a category is bits, 0 to 0xffffffff");
    return this.#pairsOf(this.events(), categoryA, categoryB);
  }

  /** The pairs of begin, hit and sensorBegin events, each pair of shapes once. */
  *#pairsOf(events: Events, kindA: number, kindB: number): Generator<EventPair> {
    const told = new Set<string>();
    for (const pair of [...events.begin, ...events.hit, ...events.sensorBegin]) {
      const { a, b } = this.pairOf(pair);
      const key = `${pair.a.index} ${pair.b.index}`;
      if (!a || !b || told.has(key)) continue;
      told.add(key);
      const [ofA, ofB] = [this.#categoryOf(pair.a), this.#categoryOf(pair.b)];
      const one = { shape: pair.a, category: ofA, ...a };
      const two = { shape: pair.b, category: ofB, ...b };
      if (ofA & kindA && ofB & kindB) yield { a: one, b: two };
      else if (ofB & kindA && ofA & kindB) yield { a: two, b: one };
    }
  }

  /** The category bits of a shape. */
  #categoryOf(shape: ShapeId): number {
    this.on(Kind.shape, "api_shape_state", shape);
    return this.engine.slots[ShapeStateAt.category];
  }

  /** The body handles of the list that the last call of the module has left in the slots. */
  #bodyIds(): BodyId[] {
    const { buffer, slots } = this.engine;
    return rowsOf(Uint32Array, buffer, slots, ListAt.address, HandleAt.length, bodyAt);
  }

  /** Moves #seen to an array for at least 2 * `least` slots, at least 64; new elements are 0. */
  #makeRoom(least: number): void {
    const { exports } = this.engine;
    const bytes = exports.api_body_seen_bytes();
    const slots = Math.max(64, 2 * least);
    const address = exports.malloc(slots * bytes);
    if (address === 0) throw new ThudError("memory", "out of memory");
    const before = this.#seen;
    const room = new Uint8Array(this.engine.buffer, address, slots * bytes);
    room.fill(0);
    room.set(new Uint8Array(this.engine.buffer, before.address, before.slots * bytes));
    exports.free(before.address);
    this.#seen = { address, slots };
  }
}

/** A side of a pair in the slots; null where the shape has been destroyed. */
function readSide(s: Float64Array, at: number): PairSide | null {
  if (s[at + PairSideAt.body] === 0) return null;
  return {
    body: bodyAt(s, at + PairSideAt.body),
    bodyData: s[at + PairSideAt.bodyData],
    shapeData: s[at + PairSideAt.shapeData],
    sensor: s[at + PairSideAt.sensor] !== 0,
  };
}
