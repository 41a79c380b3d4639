/**
 * What is read of a whole world: poses, events, statistics, errors, drawing. Arrays that `poses`,
 * `shapeTable` and `debugDraw` return are views straight into wasm memory: nothing is copied, and
 * they hold until the next call.
 */
import { bodyId, numbersOf, shapeId, view } from "./numbers.js";
import type { BodyId } from "./types.js";
import type {
  Contact,
  ContactEvent,
  DrawLists,
  DrawOptions,
  Events,
  HitEvent,
  Measure,
  ShapeTable,
  Stats,
  StepError,
} from "./view-types.js";
import { WorldQueries } from "./world-queries.js";

const EMPTY = new Float32Array(0);

/** In the order of the bits that api_world_draw takes. */
const DRAWN = [
  "shapes",
  "bounds",
  "cells",
  "contacts",
  "islands",
  "axes",
  "pairs",
  "motions",
  "stages",
  "colours",
  "manifolds",
] as const;

export class WorldViews extends WorldQueries {
  #poses = EMPTY;

  /**
   * Every body's pose between the last two steps (alpha 0: the one before, 1: the last), four
   * numbers each: x, y relative to the origin, cosine, sine. By slot; empty slots have x = NaN.
   * A view into wasm memory, valid until the next call: nothing is copied, whatever the number.
   */
  poses(alpha = 1, originX = 0, originY = 0): Float32Array {
    const { engine } = this;
    const at = engine.exports.api_world_poses(this.address, originX, originY, alpha);
    const length = 4 * engine.slots[0];
    const last = this.#poses;
    if (last.byteOffset !== at || last.length !== length || last.buffer !== engine.buffer)
      this.#poses = at === 0 ? EMPTY : new Float32Array(engine.buffer, at, length);
    return this.#poses;
  }

  /** Events of the last step; copied, so that they may be kept. */
  events(): Events {
    const { engine } = this;
    engine.check(engine.exports.api_world_events(this.address));
    const s = Array.from(engine.slots);
    const hits = view(Float64Array, engine.buffer, s[10], 9 * s[11]);
    const hit: HitEvent[] = [];
    for (let i = 0; i < hits.length; i += 9)
      hit.push({
        a: shapeId(hits[i], hits[i + 1]),
        b: shapeId(hits[i + 2], hits[i + 3]),
        point: [hits[i + 4], hits[i + 5]],
        normal: [hits[i + 6], hits[i + 7]],
        speed: hits[i + 8],
      });
    const quarantined = view(Uint32Array, engine.buffer, s[8], 2 * s[9]);
    return {
      begin: this.#contactEvents(s[0], s[1]),
      end: this.#contactEvents(s[2], s[3]),
      sensorBegin: this.#contactEvents(s[4], s[5]),
      sensorEnd: this.#contactEvents(s[6], s[7]),
      hit,
      quarantined: Array.from({ length: s[9] }, (_, i) =>
        bodyId(quarantined[2 * i], quarantined[2 * i + 1]),
      ),
    };
  }

  /** What a body touches, as the last step left it; the latest to touch first. Copied. */
  contactsOf(body: BodyId): Contact[] {
    this.onBody("api_body_contacts", body);
    const [address, count] = this.engine.slots;
    const rows = view(Float64Array, this.engine.buffer, address, CONTACT_ROW * count);
    return Array.from({ length: count }, (_, i) => readContact(rows, CONTACT_ROW * i));
  }

  stats(): Stats {
    const { engine } = this;
    engine.exports.api_world_stats(this.address);
    const s = engine.slots;
    return {
      steps: s[0],
      bodies: s[1],
      shapes: s[2],
      awakeBodies: s[3],
      pairs: s[4],
      contacts: s[5],
      colours: s[6],
      blocks: s[7],
      bytes: s[8],
      stepAllocations: s[9],
      substeps: s[10],
      stepSeconds: s[11],
      directIslands: s[12],
      directBodies: s[13],
      softIslands: s[14],
      impacts: s[15],
      motionPairs: { looked: s[16], circlesMet: s[17], boxesMet: s[18], exact: s[19] },
      stageSeconds: Object.fromEntries(engine.stageNames.map((name, i) => [name, s[20 + i]])),
      heldBodies: s[29],
      heldSeconds: s[30],
      unbisectable: s[31],
    };
  }

  /**
   * The speed, length/s, from which on the detection "bisect" may miss something; Infinity without
   * shapes. `Stats.unbisectable` counts who was faster.
   */
  bisectionLimit(): number {
    this.engine.check(this.engine.exports.api_world_bisection_limit(this.address));
    return this.engine.slots[0];
  }

  /** Costs nothing: the step itself has found it. */
  error(): StepError {
    this.engine.exports.api_world_error(this.address);
    const [penetrationMax, penetrationMean, residual, energyChange, overlaps] = this.engine.slots;
    return { penetrationMax, penetrationMean, residual, energyChange, overlaps };
  }

  /** Costs a pass over contacts and bodies. */
  measure(): Measure {
    this.engine.exports.api_world_measure(this.address);
    const [penetrationMax, penetrationMean, kineticEnergy, potentialEnergy] = this.engine.slots;
    return { penetrationMax, penetrationMean, kineticEnergy, potentialEnergy };
  }

  /** Of every body's exact state, as 16 hexadecimal digits: equal on every platform. */
  hash(): string {
    this.engine.exports.api_world_hash(this.address);
    const half = (value: number) => value.toString(16).padStart(8, "0");
    return half(this.engine.slots[0]) + half(this.engine.slots[1]);
  }

  /** Every shape of the world, to be read once after shapes came or went, not in every frame. */
  shapeTable(): ShapeTable {
    const { engine } = this;
    engine.check(
      engine.exports.api_shape_table(
        this.address,
        -this.reach,
        -this.reach,
        this.reach,
        this.reach,
      ),
    );
    const [rows, handles, count] = engine.slots;
    return {
      count,
      rows: view(Float32Array, engine.buffer, rows, 10 * count),
      handles: view(Uint32Array, engine.buffer, handles, 4 * count),
    };
  }

  /** For each row of the last `shapeTable` 1 if its body is awake, 0 if it sleeps or has gone. */
  shapeTableAwake(): Uint8Array {
    const { engine } = this;
    engine.check(engine.exports.api_shape_table_awake(this.address));
    return view(Uint8Array, engine.buffer, engine.slots[0], engine.slots[1]);
  }

  /** What the engine's debug drawing shows inside the bounds. */
  debugDraw(options: DrawOptions): DrawLists {
    const { engine } = this;
    const numbers = numbersOf("debugDraw", options, DRAWN, ["origin", "lower", "upper"]);
    const flags = numbers.reduce((sum: number, on, i) => sum + (on ? 1 << i : 0), 0);
    const [x, y] = options.origin ?? [0, 0];
    engine.check(
      engine.exports.api_world_draw(this.address, flags, x, y, ...options.lower, ...options.upper),
    );
    const s = engine.slots;
    return {
      shapes: view(Float32Array, engine.buffer, s[0], 9 * s[1]),
      lines: view(Float32Array, engine.buffer, s[2], 5 * s[3]),
      points: view(Float32Array, engine.buffer, s[4], 3 * s[5]),
    };
  }

  #contactEvents(address: number, count: number): ContactEvent[] {
    const numbers = view(Uint32Array, this.engine.buffer, address, 4 * count);
    return Array.from({ length: count }, (_, i) => ({
      a: shapeId(numbers[4 * i], numbers[4 * i + 1]),
      b: shapeId(numbers[4 * i + 2], numbers[4 * i + 3]),
    }));
  }
}

/** See api_body_contacts. */
const CONTACT_ROW = 21;

function readContact(rows: Float64Array, at: number): Contact {
  const s = rows.subarray(at, at + CONTACT_ROW);
  return {
    a: shapeId(s[0], s[1]),
    b: shapeId(s[2], s[3]),
    bodyA: bodyId(s[4], s[5]),
    bodyB: bodyId(s[6], s[7]),
    normal: [s[8], s[9]],
    points: Array.from({ length: s[10] }, (_, k) => ({
      point: [s[13 + 4 * k], s[14 + 4 * k]],
      separation: s[15 + 4 * k],
      normalImpulse: s[16 + 4 * k],
    })),
    tangentImpulse: s[11],
    direct: s[12] !== 0,
  };
}
