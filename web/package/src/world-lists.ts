/** What there is in a world, as lists of handles, in the order of their slots. */
import { ThudError } from "./error.js";
import { HandleAt, ListAt, PairAt, PairSideAt, ShapeStateAt } from "./generated/slots.js";
import { bodyAt, rowsOf, shapeAt } from "./numbers.js";
import { index1Of, Kind } from "./plain/handles.js";
import { WorldRules } from "./rules/world-rules.js";
import type { BodyId, ShapeId, ShapeRef } from "./types.js";
import type { ContactEvent, Events, Meeting, Pair, PairSide } from "./view-types.js";

export class WorldLists extends WorldRules {
  /** What bodies were last told to be, in wasm memory. */
  #seen = { address: 0, slots: 0 };

  protected override freeRoom(): void {
    this.engine.exports.free(this.#seen.address);
    this.#seen = { address: 0, slots: 0 };
  }

  /** Every body, disabled and quarantined ones too. */
  bodies(): BodyId[] {
    this.onWorld("api_world_bodies");
    return this.#bodyIds();
  }

  /** Those that the next step will move if something has them move. */
  awakeBodies(): BodyId[] {
    this.onWorld("api_world_awake_bodies");
    return this.#bodyIds();
  }

  /** Every shape, sensors and terrains too. */
  shapes(): ShapeId[] {
    this.onWorld("api_world_shapes");
    return this.shapeIds();
  }

  /**
   * Those that are elsewhere than when this was last called, and those that are new: a renderer need
   * touch no others. One that was created, set elsewhere or brought back by `restore` is told, too;
   * one that was destroyed is not. Where you draw between two steps, by `poses(alpha)`, touch once
   * more what was told the time before.
   * @example for (const body of world.movedBodies()) redraw(body)
   */
  movedBodies(): BodyId[] {
    const { exports } = this.engine;
    const slots = exports.api_world_body_slots(this.address);
    if (slots > this.#seen.slots) this.#makeRoom(slots);
    this.engine.check(exports.api_world_moved_bodies(this.address, this.#seen.address, slots));
    return this.#bodyIds();
  }

  /** The body whose pose stands at `4 * slot` in `poses()`; null where none lives there. */
  bodyAtSlot(slot: number): BodyId | null {
    this.onWorld("api_world_body_at", slot);
    const s = this.engine.slots;
    return s[HandleAt.index1] === 0 ? null : bodyAt(s, HandleAt.index1);
  }

  /** The shape with this `index`; null where none lives there. */
  shapeAtSlot(slot: number): ShapeId | null {
    this.onWorld("api_world_shape_at", slot);
    const s = this.engine.slots;
    return s[HandleAt.index1] === 0 ? null : shapeAt(s, HandleAt.index1);
  }

  /**
   * What a sensor overlaps now.
   * @example if (world.overlapsOf(goal).length > 0) score()
   */
  overlapsOf(sensor: ShapeRef): ShapeId[] {
    this.on(Kind.shape, "api_sensor_overlaps", sensor);
    return this.shapeIds();
  }

  /**
   * Whose the two shapes of a contact or an event are, with the user data of both; null for one that
   * was destroyed since.
   * @example const { a, b } = world.pairOf(hit)
   */
  pairOf({ a, b }: Pick<ContactEvent, "a" | "b">): Pair {
    const { exports, slots: s } = this.engine;
    const [index1A, index1B] = [index1Of(a, Kind.shape), index1Of(b, Kind.shape)];
    const call = exports.api_pair_get;
    this.engine.check(call(this.address, index1A, a.generation, index1B, b.generation));
    return { a: readSide(s, PairAt.a), b: readSide(s, PairAt.b) };
  }

  /**
   * Who of two kinds, by the categories of shapes, met in the last step: those that began to touch or
   * hit each other, be they apart again, and those that a sensor began to overlap. `a` is of the
   * first kind, whatever the event's order. A step tells a pair once; a bounce that hits in one step
   * and touches in the next is told in both. Where one was destroyed since, also by you and between
   * two meetings, there was none.
   * @example for (const { b: brick } of world.meetings(BALL, BRICK)) world.destroy(brick.body)
   */
  meetings(categoryA: number, categoryB: number): Generator<Meeting> {
    for (const category of [categoryA, categoryB])
      if (category >>> 0 !== category && (category | 0) !== category)
        throw new ThudError("invalid", "meetings: a category is bits, 0 to 0xffffffff");
    return this.#meetingsOf(this.events(), categoryA, categoryB);
  }

  *#meetingsOf(events: Events, kindA: number, kindB: number): Generator<Meeting> {
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

  #categoryOf(shape: ShapeId): number {
    this.on(Kind.shape, "api_shape_get", shape);
    return this.engine.slots[ShapeStateAt.category];
  }

  #bodyIds(): BodyId[] {
    const { buffer, slots } = this.engine;
    return rowsOf(Uint32Array, buffer, slots, ListAt.address, HandleAt.length, bodyAt);
  }

  /** Room for twice as many slots; what was seen stays. */
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

function readSide(s: Float64Array, at: number): PairSide | null {
  if (s[at + PairSideAt.body] === 0) return null;
  return {
    body: bodyAt(s, at + PairSideAt.body),
    bodyData: s[at + PairSideAt.bodyData],
    shapeData: s[at + PairSideAt.shapeData],
    sensor: s[at + PairSideAt.sensor] !== 0,
  };
}
