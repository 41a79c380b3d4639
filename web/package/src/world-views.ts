/**
 * The layer of World that reads all of a world: poses, events, statistics, errors, tables for
 * drawing. The arrays that `poses`, `eventViews`, `contactViewOf`, `shapeTable` and `draw`
 * return are views into wasm memory: nothing is copied, and they are valid until the next call of
 * the engine.
 */
import {
  ContactPointAt,
  ContactRowAt,
  DrawLineAt,
  DrawListsAt,
  DrawPointAt,
  DrawShapeAt,
  EventPairAt,
  EventsAt,
  HandleAt,
  HashAt,
  HitEventAt,
  ListAt,
  MeasureAt,
  ShapeHandlesAt,
  ShapeRowAt,
  ShapeTableAt,
  BroadphaseCountsAt,
  StatsAt,
  StepErrorAt,
} from "./generated/slots.js";
import { bodyAt, numbersOf, rowsOf, shapeAt, vecAt, view } from "./numbers.js";
import { Kind } from "./plain/handles.js";
import type { BodyRef } from "./types.js";
import { DRAW_FLAGS } from "./view-types.js";
import type {
  Contact,
  ContactEvent,
  ContactPoint,
  DrawLists,
  DrawOptions,
  Events,
  EventViews,
  HitEvent,
  Measure,
  ShapeTable,
  BroadphaseCounts,
  Stats,
  StepError,
} from "./view-types.js";
import { WorldQueries } from "./world-queries.js";

const EMPTY = new Float32Array(0);
const NO_HANDLES = new Uint32Array(0);


/** The layer of World with poses, events, statistics, errors and drawing. */
export class WorldViews extends WorldQueries {
  #poses = EMPTY;
  #contacts = new Float64Array(0);
  /**
   * The result of eventViews, which returns the same object each time, and the same views as long
   * as address and length of a list stay the same, so that a call in each frame allocates nothing.
   */
  readonly #events = {
    begin: NO_HANDLES,
    end: NO_HANDLES,
    sensorBegin: NO_HANDLES,
    sensorEnd: NO_HANDLES,
    sensorBeginTime: EMPTY,
    sensorEndTime: EMPTY,
    quarantined: NO_HANDLES,
    hit: new Float64Array(0),
  };

  /**
   * The poses of all bodies, interpolated between the last two steps (alpha 0: the step before, 1:
   * the last step): four numbers each, x and y of the body's origin relative to the origin of the
   * call, cosine and sine of its angle. Indexed by slot; empty slots have x = NaN. A view into wasm
   * memory, valid until the next call of the engine; empty where alpha is outside [0, 1], the
   * origin is further than 10⁹ length scales, or memory is short.
   */
  poses(alpha = 1, originX = 0, originY = 0): Float32Array {
    const { engine } = this;
    const at = engine.exports.api_world_poses(this.address, originX, originY, alpha);
    const length = 4 * engine.slots[ListAt.count];
    const last = this.#poses;
    if (last.byteOffset !== at || last.length !== length || last.buffer !== engine.buffer)
      this.#poses = at === 0 ? EMPTY : new Float32Array(engine.buffer, at, length);
    return this.#poses;
  }

  /**
   * The events of the last step, or of all steps of the last `advance`: contacts that began, ended
   * and hit, sensors, and quarantined bodies. A copy.
   * @example world.events().hit
   */
  events(): Events {
    const { engine } = this;
    this.onWorld("api_world_events");
    const { buffer, slots: s } = engine;
    const pairs = (list: EventsAt) =>
      rowsOf(Uint32Array, buffer, s, list, EventPairAt.length, readPair);
    const sensed = (list: EventsAt, times: EventsAt) => {
      const time = rowsOf(Float32Array, buffer, s, times, 1, (row, at) => row[at]);
      return pairs(list).map((pair, i) => ({ ...pair, time: time[i] }));
    };
    return {
      begin: pairs(EventsAt.begin),
      end: pairs(EventsAt.end),
      sensorBegin: sensed(EventsAt.sensorBegin, EventsAt.sensorBeginTime),
      sensorEnd: sensed(EventsAt.sensorEnd, EventsAt.sensorEndTime),
      hit: rowsOf(Float64Array, buffer, s, EventsAt.hits, HitEventAt.length, readHit),
      quarantined: rowsOf(Uint32Array, buffer, s, EventsAt.quarantined, HandleAt.length, bodyAt),
    };
  }

  /** The same events as views into wasm memory, valid until the next call of the engine. */
  eventViews(): EventViews {
    const { engine } = this;
    this.onWorld("api_world_events");
    const { buffer, slots: s } = engine;
    const last = this.#events;
    last.begin = again(last.begin, buffer, s, EventsAt.begin, EventPairAt.length);
    last.end = again(last.end, buffer, s, EventsAt.end, EventPairAt.length);
    last.sensorBegin = again(last.sensorBegin, buffer, s, EventsAt.sensorBegin, EventPairAt.length);
    last.sensorEnd = again(last.sensorEnd, buffer, s, EventsAt.sensorEnd, EventPairAt.length);
    last.sensorBeginTime = again(last.sensorBeginTime, buffer, s, EventsAt.sensorBeginTime, 1);
    last.sensorEndTime = again(last.sensorEndTime, buffer, s, EventsAt.sensorEndTime, 1);
    last.quarantined = again(last.quarantined, buffer, s, EventsAt.quarantined, HandleAt.length);
    last.hit = again(last.hit, buffer, s, EventsAt.hits, HitEventAt.length);
    return last;
  }

  /**
   * The touching pairs of a body as rows (CONTACT_ROW): a view into wasm memory, valid until the
   * next call of the engine. The pairs that began to touch last come first.
   * @throws {ThudError} "stale"; "locked" inside a callback; "memory".
   */
  contactViewOf(body: BodyRef): Float64Array {
    this.on(Kind.body, "api_body_contacts", body);
    const { buffer, slots } = this.engine;
    this.#contacts = again(this.#contacts, buffer, slots, ListAt.address, ContactRowAt.length);
    return this.#contacts;
  }

  /**
   * The touching pairs of a body as the last step left them, a copy. The pairs that began to touch
   * last come first.
   * @throws {ThudError} "stale"; "locked" inside a callback; "memory".
   */
  contactsOf(body: BodyRef): Contact[] {
    this.on(Kind.body, "api_body_contacts", body);
    const { buffer, slots } = this.engine;
    return rowsOf(Float64Array, buffer, slots, ListAt.address, ContactRowAt.length, readContact);
  }

  /**
   * Counts of the world, statistics of its last step and, where it is `timed`, the step's times.
   */
  stats(): Stats {
    const { engine } = this;
    engine.exports.api_world_stats(this.address);
    const s = engine.slots;
    return {
      steps: s[StatsAt.steps],
      bodies: s[StatsAt.bodies],
      shapes: s[StatsAt.shapes],
      awakeBodies: s[StatsAt.awakeBodies],
      pairs: s[StatsAt.pairs],
      contacts: s[StatsAt.contacts],
      colours: s[StatsAt.colours],
      blocks: s[StatsAt.blocks],
      bytes: s[StatsAt.bytes],
      stepAllocations: s[StatsAt.stepAllocations],
      substeps: s[StatsAt.substeps],
      stepSeconds: s[StatsAt.stepSeconds],
      directIslands: s[StatsAt.directIslands],
      directBodies: s[StatsAt.directBodies],
      softIslands: s[StatsAt.softIslands],
      impacts: s[StatsAt.impacts],
      motionPairs: s[StatsAt.motionPairs],
      motionCircles: s[StatsAt.motionCircles],
      motionBoxes: s[StatsAt.motionBoxes],
      motionExact: s[StatsAt.motionExact],
      stageSeconds: Object.fromEntries(
        engine.stageNames.map((name, i) => [name, s[StatsAt.stageSeconds + i]]),
      ),
      heldBodies: s[StatsAt.heldBodies],
      heldSeconds: s[StatsAt.heldSeconds],
      unbisectable: s[StatsAt.unbisectable],
    };
  }

  /**
   * What the broadphase did in the last step, in counts, which are the same on every machine. `cells`
   * are counted by the call.
   */
  broadphaseCounts(): BroadphaseCounts {
    this.onWorld("api_world_broadphase_counts");
    const s = this.engine.slots;
    return {
      moved: s[BroadphaseCountsAt.moved],
      tested: s[BroadphaseCountsAt.tested],
      found: s[BroadphaseCountsAt.found],
      sortMoves: s[BroadphaseCountsAt.sortMoves],
      cells: s[BroadphaseCountsAt.cells],
      cellShapes: s[BroadphaseCountsAt.cellShapes],
      cellShapesMax: s[BroadphaseCountsAt.cellShapesMax],
    };
  }

  /**
   * The speed, length/s, above which the detection "bisect" may miss a collision: the thickness of
   * the thinnest shape over the time step; Infinity without shapes. `Stats.unbisectable` counts the
   * bodies that were faster.
   */
  bisectionLimit(): number {
    this.onWorld("api_world_bisection_limit");
    return this.engine.slots[0];
  }

  /**
   * The errors of the last step. They are collected while it is solved: the call costs at most a
   * pass over joints and contacts.
   */
  stepError(): StepError {
    this.engine.exports.api_world_step_error(this.address);
    const s = this.engine.slots;
    return {
      penetrationMax: s[StepErrorAt.penetrationMax],
      penetrationMean: s[StepErrorAt.penetrationMean],
      residual: s[StepErrorAt.residual],
      energyChange: s[StepErrorAt.energyChange],
      energyDecided: s[StepErrorAt.energyDecided],
      overlaps: s[StepErrorAt.overlaps],
      shortfall: s[StepErrorAt.shortfall],
      jointGapMax: s[StepErrorAt.jointGapMax],
      jointGapMean: s[StepErrorAt.jointGapMean],
      jointAngleMax: s[StepErrorAt.jointAngleMax],
    };
  }

  /** Energy and penetration of the present state. Costs a pass over contacts and bodies. */
  measure(): Measure {
    this.engine.exports.api_world_measure(this.address);
    const s = this.engine.slots;
    return {
      penetrationMax: s[MeasureAt.penetrationMax],
      penetrationMean: s[MeasureAt.penetrationMean],
      kineticEnergy: s[MeasureAt.kineticEnergy],
      potentialEnergy: s[MeasureAt.potentialEnergy],
    };
  }

  /**
   * A hash of the exact position, angle and velocity of every body: 16 hexadecimal digits, the same
   * on every platform.
   */
  hash(): string {
    this.engine.exports.api_world_hash(this.address);
    const half = (value: number) => value.toString(16).padStart(8, "0");
    return half(this.engine.slots[HashAt.upper]) + half(this.engine.slots[HashAt.lower]);
  }

  /**
   * All shapes for drawing. Call it when `revision.shapes` has changed, not in every frame.
   * @throws {ThudError} "memory".
   */
  shapeTable(): ShapeTable {
    const { engine } = this;
    engine.check(engine.exports.api_shape_table(this.address));
    const { buffer, slots: s } = engine;
    const count = s[ShapeTableAt.count];
    return {
      count,
      rows: view(Float32Array, buffer, s[ShapeTableAt.rows], ShapeRowAt.length * count),
      handles: view(Uint32Array, buffer, s[ShapeTableAt.handles], ShapeHandlesAt.length * count),
    };
  }

  /**
   * For each row of the last `shapeTable` 1 where its body is awake, 0 where it sleeps or has been
   * destroyed. A view into wasm memory, valid until the next call of the engine.
   * @throws {ThudError} "memory".
   */
  shapeTableAwake(): Uint8Array {
    const { engine } = this;
    engine.check(engine.exports.api_shape_table_awake(this.address));
    const { buffer, slots } = engine;
    return view(Uint8Array, buffer, slots[ListAt.address], slots[ListAt.count]);
  }

  /**
   * The engine's debug drawing of the region between `lower` and `upper`, as lists of shapes, lines
   * and points.
   * @throws {ThudError} "invalid"; "memory".
   */
  draw(options: DrawOptions): DrawLists {
    const { engine } = this;
    const numbers = numbersOf("draw", options, DRAW_FLAGS, ["origin", "lower", "upper"]);
    const flags = numbers.reduce((sum: number, on, i) => sum + (on ? 1 << i : 0), 0);
    const [x, y] = options.origin ?? [0, 0];
    engine.check(
      engine.exports.api_world_draw(this.address, flags, x, y, ...options.lower, ...options.upper),
    );
    const { buffer, slots: s } = engine;
    const list = (at: DrawListsAt, length: number) =>
      view(Float32Array, buffer, s[at + ListAt.address], length * s[at + ListAt.count]);
    return {
      shapes: list(DrawListsAt.shapes, DrawShapeAt.length),
      lines: list(DrawListsAt.lines, DrawLineAt.length),
      points: list(DrawListsAt.points, DrawPointAt.length),
    };
  }
}

/**
 * The last view where it still covers the list in the slots, else a new one; `row`: numbers a row.
 */
function again<T extends Uint32Array | Float32Array | Float64Array>(
  last: T,
  buffer: ArrayBuffer,
  slots: Float64Array,
  list: number,
  row: number,
): T {
  const length = row * slots[list + ListAt.count];
  const at = length === 0 ? 0 : slots[list + ListAt.address];
  if (last.length === length && (length === 0 || (last.byteOffset === at && last.buffer === buffer)))
    return last;
  const View = last.constructor as new (buffer: ArrayBuffer, at: number, length: number) => T;
  return new View(buffer, at, length);
}

function readContact(rows: Float64Array, at: number): Contact {
  return {
    a: shapeAt(rows, at + ContactRowAt.shapeA),
    b: shapeAt(rows, at + ContactRowAt.shapeB),
    bodyA: bodyAt(rows, at + ContactRowAt.bodyA),
    bodyB: bodyAt(rows, at + ContactRowAt.bodyB),
    normal: vecAt(rows, at + ContactRowAt.normal),
    points: Array.from({ length: rows[at + ContactRowAt.pointCount] }, (_, i) =>
      readPoint(rows, at + ContactRowAt.points + ContactPointAt.length * i),
    ),
    tangentImpulse: rows[at + ContactRowAt.tangentImpulse],
    direct: rows[at + ContactRowAt.direct] !== 0,
  };
}

function readPoint(rows: Float64Array, at: number): ContactPoint {
  return {
    point: vecAt(rows, at + ContactPointAt.place),
    separation: rows[at + ContactPointAt.separation],
    normalImpulse: rows[at + ContactPointAt.normalImpulse],
  };
}

function readHit(rows: Float64Array, at: number): HitEvent {
  return {
    a: shapeAt(rows, at + HitEventAt.shapeA),
    b: shapeAt(rows, at + HitEventAt.shapeB),
    point: vecAt(rows, at + HitEventAt.point),
    normal: vecAt(rows, at + HitEventAt.normal),
    speed: rows[at + HitEventAt.speed],
  };
}

function readPair(rows: Uint32Array, at: number): ContactEvent {
  return { a: shapeAt(rows, at + EventPairAt.shapeA), b: shapeAt(rows, at + EventPairAt.shapeB) };
}
