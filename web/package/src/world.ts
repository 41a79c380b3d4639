/**
 * A world: bodies and shapes that advance in fixed steps. Handles are checked by the engine in
 * every call; a stale one throws. Arrays that `poses`, `shapeTable` and `debugDraw` return are
 * views straight into wasm memory: nothing is copied, and they hold until the next call.
 */
import type { Engine } from "./engine.js";
import { ThudError } from "./error.js";
import { restoreSnapshot, takeSnapshot } from "./snapshot.js";
import {
  BODY_KINDS,
  BROADPHASES,
  DETECTIONS,
  QUALITIES,
  SHAPE_KINDS,
  type BodyId,
  type BodyOptions,
  type BodyState,
  type BoxOptions,
  type CircleOptions,
  type ClosestHit,
  type ContactEvent,
  type Detection,
  type DrawLists,
  type DrawOptions,
  type Events,
  type Foot,
  type Ground,
  type HitEvent,
  type Measure,
  type ObbOptions,
  type OverlapQuery,
  type Quality,
  type QueryFilter,
  type RayHit,
  type ShapeId,
  type ShapeOptions,
  type ShapeState,
  type ShapeTable,
  type SolidShape,
  type Stats,
  type StepError,
  type Terrain,
  type Vec2,
  type WorldOptions,
} from "./types.js";

/** As far out as a body can be, in length scales; a little less, for rounding. */
const EVERYWHERE = 0.999e9;
const EMPTY = new Float32Array(0);
const TERRAIN_KINDS = ["flat", "uniform", "irregular"] as const;

export class World {
  readonly engine: Engine;
  #address: number;
  #poses = EMPTY;
  readonly #reach: number;
  #shapesRevision = 0;
  #terrainsRevision = 0;

  /**
   * Made by `Engine.createWorld`. An address adopts a world that other code in the module made; of
   * the options only its length scale counts then.
   */
  constructor(engine: Engine, options: WorldOptions = {}, address = 0) {
    this.engine = engine;
    this.#address = address;
    this.#reach = EVERYWHERE * (options.lengthScale ?? 1);
    if (address !== 0) return;
    World.writeOptions(engine, options);
    engine.check(engine.exports.api_world_create());
    this.#address = engine.slots[0];
  }

  /** Fills the slots of api_world_defaults, for code that makes worlds in the module itself. */
  static writeOptions(engine: Engine, options: WorldOptions): void {
    engine.exports.api_world_defaults();
    const quality =
      options.quality === undefined ? undefined : indexOf(QUALITIES, options.quality, "quality");
    fill(engine.slots, [
      options.gravity?.[0],
      options.gravity?.[1],
      options.timeStep,
      options.lengthScale,
      quality,
      options.substeps,
      options.contactStiffness,
      options.contactDamping,
      options.pushSpeed,
      options.restitutionThreshold,
      options.hitSpeed,
      options.maximumSpeed,
      options.sleeping,
      detectionIndex(options.detection),
      options.contactEvents,
      options.timed,
      options.broadphase && indexOf(BROADPHASES, options.broadphase, "broadphase"),
      options.timeBudget,
      options.maxError,
    ]);
  }

  /** The world's address in wasm memory; throws after `close`. */
  get address(): number {
    if (this.#address === 0) throw new ThudError("stale", "the world has been destroyed");
    return this.#address;
  }

  /** Frees the world. Using it afterwards throws. */
  close(): void {
    this.engine.exports.api_world_destroy(this.address);
    this.#address = 0;
    this.#poses = EMPTY;
  }

  // ---- going back ----

  /** The whole state as bytes: a copy that stays as it is. See thud_snapshot.h for what it holds. */
  snapshot(): Uint8Array<ArrayBuffer> {
    return takeSnapshot(this.engine, this.address);
  }

  /**
   * Back to a snapshot of this world, or of another with the same options: from there on the same
   * calls give the same bits and the same handles. Throws, and changes nothing, for bytes that are
   * damaged, or of another version or kind of world.
   */
  restore(snapshot: Uint8Array): void {
    restoreSnapshot(this.engine, this.address, snapshot);
    this.#shapesRevision++;
    this.#terrainsRevision++;
  }

  /**
   * Two numbers that rise when bodies or shapes came, went or were enabled or disabled, and when the
   * ground changed: whoever draws reads the shape table and the terrains anew then.
   */
  get revision(): { readonly shapes: number; readonly terrains: number } {
    return { shapes: this.#shapesRevision, terrains: this.#terrainsRevision };
  }

  // ---- time ----

  /** Runs one step. */
  step(): void {
    this.engine.check(this.engine.exports.api_world_step(this.address));
  }

  /**
   * Runs as many whole steps as the elapsed seconds allow, at most `maxSteps`. `alpha` tells how
   * far the present lies between the last step and the next, for `poses`.
   */
  advance(elapsed: number, maxSteps = 4): { steps: number; alpha: number } {
    const { engine } = this;
    engine.check(engine.exports.api_world_advance(this.address, elapsed, maxSteps));
    return { steps: engine.slots[0], alpha: engine.slots[1] };
  }

  setGravity(gravity: Vec2): void {
    this.engine.check(
      this.engine.exports.api_world_set_gravity(this.address, gravity[0], gravity[1]),
    );
  }

  setTimeStep(seconds: number): void {
    this.engine.check(this.engine.exports.api_world_set_time_step(this.address, seconds));
  }

  /** For experts, with another number of substeps, 1 to 64; 0 takes the quality's. */
  setQuality(quality: Quality, substeps = 0): void {
    const index = indexOf(QUALITIES, quality, "quality");
    this.engine.check(this.engine.exports.api_world_set_quality(this.address, index, substeps));
  }

  /** See WorldOptions.maxError. */
  setMaxError(maxError: number): void {
    this.engine.check(this.engine.exports.api_world_set_max_error(this.address, maxError));
  }

  setSleeping(sleeping: boolean): void {
    this.engine.check(this.engine.exports.api_world_set_sleeping(this.address, Number(sleeping)));
  }

  // ---- bodies ----

  createBody(options: BodyOptions = {}): BodyId {
    const { engine } = this;
    engine.exports.api_body_defaults();
    fill(engine.slots, [
      options.kind === undefined ? undefined : indexOf(BODY_KINDS, options.kind, "body kind"),
      options.position?.[0],
      options.position?.[1],
      options.angle,
      options.velocity?.[0],
      options.velocity?.[1],
      options.angularVelocity,
      options.gravityScale,
      options.linearDamping,
      options.angularDamping,
      options.fixedRotation,
      options.maySleep,
      userData(options.userData),
      detectionIndex(options.detection),
    ]);
    engine.check(engine.exports.api_body_create(this.address));
    this.#shapesRevision++;
    return bodyId(engine.slots[0], engine.slots[1]);
  }

  /** Removes a body with its shapes, or one shape. */
  destroy(id: BodyId | ShapeId): void {
    const { exports } = this.engine;
    const destroy = id.kind === "body" ? exports.api_body_destroy : exports.api_shape_destroy;
    this.engine.check(destroy(this.address, id.index + 1, id.generation));
    this.#shapesRevision++;
  }

  isValid(id: BodyId | ShapeId): boolean {
    const { exports } = this.engine;
    const isValid = id.kind === "body" ? exports.api_body_is_valid : exports.api_shape_is_valid;
    return isValid(this.address, id.index + 1, id.generation) !== 0;
  }

  bodyState(body: BodyId): BodyState {
    this.#onBody("api_body_get", body);
    const s = this.engine.slots;
    return {
      kind: BODY_KINDS[s[0]],
      position: [s[1], s[2]],
      center: [s[3], s[4]],
      angle: s[5],
      velocity: [s[6], s[7]],
      angularVelocity: s[8],
      mass: s[9],
      inertia: s[10],
      gravityScale: s[11],
      awake: s[12] !== 0,
      enabled: s[16] !== 0,
      quarantined: s[13] !== 0,
      userData: s[14],
      shapeCount: s[15],
    };
  }

  setTransform(body: BodyId, position: Vec2, angle = 0): void {
    this.#onBody("api_body_set_transform", body, position[0], position[1], angle);
  }

  setVelocity(body: BodyId, velocity: Vec2, angularVelocity = 0): void {
    this.#onBody("api_body_set_velocity", body, velocity[0], velocity[1], angularVelocity);
  }

  applyImpulse(body: BodyId, impulse: Vec2, point: Vec2): void {
    this.#onBody("api_body_apply_impulse", body, impulse[0], impulse[1], point[0], point[1]);
  }

  /** Acts through the next step only. */
  applyForce(body: BodyId, force: Vec2, torque = 0): void {
    this.#onBody("api_body_apply_force", body, force[0], force[1], torque);
  }

  setAwake(body: BodyId, awake: boolean): void {
    this.#onBody("api_body_set_awake", body, Number(awake));
  }

  /**
   * False takes the body and its shapes out of the world: nothing moves, meets or finds them. True
   * brings it back, where it is and at the velocity it had.
   */
  setEnabled(body: BodyId, enabled: boolean): void {
    this.#onBody("api_body_set_enabled", body, Number(enabled));
    this.#shapesRevision++;
  }

  setUserData(body: BodyId, data: number): void {
    this.#onBody("api_body_set_user_data", body, userData(data) ?? 0);
  }

  shapesOf(body: BodyId): ShapeId[] {
    this.#onBody("api_body_shapes", body);
    return this.#shapeIds(this.engine.slots[0], this.engine.slots[1]);
  }

  // ---- shapes ----

  createCircle(body: BodyId, options: CircleOptions): ShapeId {
    const [x, y] = options.offset ?? [0, 0];
    return this.#createShape(options, "api_circle_create", body, x, y, options.radius);
  }

  /** A box that keeps its axes: the rotation of its body is fixed from then on. */
  createAabb(body: BodyId, options: BoxOptions): ShapeId {
    const [x, y] = options.offset ?? [0, 0];
    const { halfWidth, halfHeight } = options;
    return this.#createShape(options, "api_aabb_create", body, x, y, halfWidth, halfHeight);
  }

  createObb(body: BodyId, options: ObbOptions): ShapeId {
    const [x, y] = options.offset ?? [0, 0];
    const { halfWidth, halfHeight, angle = 0 } = options;
    return this.#createShape(options, "api_obb_create", body, x, y, halfWidth, halfHeight, angle);
  }

  /** Only on static bodies with angle 0. */
  createTerrain(body: BodyId, terrain: Terrain, options: ShapeOptions = {}): ShapeId {
    const create = (points: number, count: number, slope: number, x0: number, spacing: number) =>
      this.#createShape(
        options,
        "api_terrain_create",
        body,
        indexOf(TERRAIN_KINDS, terrain.kind, "terrain kind"),
        slope,
        x0,
        spacing,
        points,
        count,
      );
    if (terrain.kind === "flat") return create(0, 0, terrain.slope ?? 0, 0, 0);
    const uniform = terrain.kind === "uniform";
    const count = uniform ? terrain.heights.length : terrain.points.length;
    const fillPoints = (doubles: Float64Array) => {
      for (let i = 0; i < count; i++) {
        doubles[2 * i] = uniform ? terrain.x0 + i * terrain.spacing : terrain.points[i][0];
        doubles[2 * i + 1] = uniform ? terrain.heights[i] : terrain.points[i][1];
      }
    };
    return this.engine.withDoubles(2 * count, fillPoints, (points) =>
      uniform
        ? create(points, count, 0, terrain.x0, terrain.spacing)
        : create(points, count, 0, 0, 0),
    );
  }

  shapeState(shape: ShapeId): ShapeState {
    this.#onShape("api_shape_get", shape);
    const s = this.engine.slots;
    return {
      kind: SHAPE_KINDS[s[0]],
      body: bodyId(s[1], s[2]),
      offset: [s[3], s[4]],
      halfExtents: [s[5], s[6]],
      angle: s[7],
      density: s[8],
      friction: s[9],
      restitution: s[10],
      surfaceSpeed: s[16],
      category: s[11],
      mask: s[12],
      group: s[13],
      sensor: s[14] !== 0,
      userData: s[15],
    };
  }

  /** A copy of a terrain as the world has it. */
  terrain(shape: ShapeId): Terrain {
    this.#onShape("api_shape_terrain", shape);
    const [kind, slope, x0, spacing, address, count] = this.engine.slots;
    if (kind === 0) return { kind: "flat", slope };
    const numbers = new Float64Array(this.engine.buffer, address, 2 * count);
    if (kind === 1)
      return { kind: "uniform", x0, spacing, heights: numbers.filter((_, i) => i % 2 === 1) };
    const points = Array.from({ length: count }, (_, i): Vec2 => [
      numbers[2 * i],
      numbers[2 * i + 1],
    ]);
    return { kind: "irregular", points };
  }

  /** Replaces the heights of a terrain's vertices from `first` on. */
  setHeights(shape: ShapeId, first: number, heights: ArrayLike<number>): void {
    this.engine.withDoubles(
      heights.length,
      (doubles) => doubles.set(heights),
      (address) => this.#onShape("api_shape_set_heights", shape, first, address, heights.length),
    );
    this.#terrainsRevision++;
  }

  /**
   * Takes away the ground inside a circle, and what stands above it; not of flat ground. Whatever
   * rests there wakes in the next step. A uniform line keeps its grid.
   */
  dig(shape: ShapeId, center: Vec2, radius: number): void {
    this.#onShape("api_shape_dig", shape, center[0], center[1], radius);
    this.#terrainsRevision++;
  }

  /** Raises a smooth mound about x; a negative height makes a hollow. Otherwise as `dig`. */
  raise(shape: ShapeId, x: number, radius: number, height: number): void {
    this.#onShape("api_shape_raise", shape, x, radius, height);
    this.#terrainsRevision++;
  }

  /**
   * Replaces the points of an irregular line at x0 to x1, both included, by others with strictly
   * increasing x in that range. Like those of a new terrain they are relative to the body's origin.
   */
  replaceRange(shape: ShapeId, x0: number, x1: number, points: ArrayLike<Vec2>): void {
    const { length } = points;
    const fill = (doubles: Float64Array) => {
      for (let i = 0; i < length; i++) doubles.set(points[i], 2 * i);
    };
    this.engine.withDoubles(2 * length, fill, (address) =>
      this.#onShape("api_shape_replace_range", shape, x0, x1, address, length),
    );
    this.#terrainsRevision++;
  }

  /** The ground of a terrain at x, a place in the world; throws beyond its ends. */
  groundAt(shape: ShapeId, x: number): Ground {
    this.#onShape("api_ground_at", shape, x);
    const [height, nx, ny, segment, left, right] = this.engine.slots;
    return { height, normal: [nx, ny], segment, weights: [left, right] };
  }

  /** Puts a level sole of the given width onto a terrain, with its middle at x. */
  placeFoot(shape: ShapeId, x: number, width: number): Foot {
    this.#onShape("api_place_foot", shape, x, width);
    const [height, at, nx, ny] = this.engine.slots;
    return { height, x: at, normal: [nx, ny] };
  }

  // ---- reading ----

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
      stageSeconds: Object.fromEntries(engine.stageNames.map((name, i) => [name, s[12 + i]])),
    };
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

  // ---- queries ----

  /** The first shape along the ray, or null. */
  castRay(origin: Vec2, translation: Vec2, filter: QueryFilter = {}): RayHit | null {
    const { engine } = this;
    engine.check(
      engine.exports.api_cast_ray(
        this.address,
        origin[0],
        origin[1],
        translation[0],
        translation[1],
        ...filterNumbers(filter),
      ),
    );
    return engine.slots[0] === 0 ? null : readHit(engine.slots, 1);
  }

  /** Every shape along the ray, the nearest first. */
  castRayAll(origin: Vec2, translation: Vec2, filter: QueryFilter = {}): RayHit[] {
    return this.#castAll([-1, 0, 0, 0], origin, translation, filter);
  }

  /** The first shape that a circle, AABB or OBB meets on its way, or null. */
  castShape(
    shape: SolidShape,
    center: Vec2,
    translation: Vec2,
    filter: QueryFilter = {},
  ): RayHit | null {
    const { engine } = this;
    const [kind, hx, hy, angle] = solidNumbers(shape);
    engine.check(
      engine.exports.api_cast_shape(
        this.address,
        kind,
        ...center,
        hx,
        hy,
        angle,
        ...translation,
        ...filterNumbers(filter),
      ),
    );
    return engine.slots[0] === 0 ? null : readHit(engine.slots, 1);
  }

  /** Every shape that it meets, the nearest first. */
  castShapeAll(
    shape: SolidShape,
    center: Vec2,
    translation: Vec2,
    filter: QueryFilter = {},
  ): RayHit[] {
    return this.#castAll(solidNumbers(shape), center, translation, filter);
  }

  /** The shape closest to a point, if one is no further than `maxDistance`, or null. */
  closest(point: Vec2, maxDistance: number, filter: QueryFilter = {}): ClosestHit | null {
    const { engine } = this;
    engine.check(
      engine.exports.api_closest(this.address, ...point, maxDistance, ...filterNumbers(filter)),
    );
    const s = engine.slots;
    if (s[0] === 0) return null;
    return {
      shape: shapeId(s[1], s[2]),
      point: [s[3], s[4]],
      normal: [s[5], s[6]],
      distance: s[7],
    };
  }

  /** Every shape that overlaps: by its bounds for "bounds", else by its true form. */
  overlap(query: OverlapQuery, filter: QueryFilter = {}): ShapeId[] {
    const { engine } = this;
    const last = filterNumbers(filter);
    if (query.kind === "bounds") {
      const { lower, upper } = query;
      engine.check(
        engine.exports.api_overlap_aabb(this.address, ...lower, ...upper, ...last),
      );
    } else {
      const [kind, hx, hy, angle] = solidNumbers(query);
      engine.check(
        engine.exports.api_overlap_shape(this.address, kind, ...query.center, hx, hy, angle, ...last),
      );
    }
    return this.#shapeIds(engine.slots[0], engine.slots[1]);
  }

  // ---- drawing ----

  /** Every shape of the world, to be read once after shapes came or went, not in every frame. */
  shapeTable(): ShapeTable {
    const { engine } = this;
    engine.check(
      engine.exports.api_shape_table(
        this.address,
        -this.#reach,
        -this.#reach,
        this.#reach,
        this.#reach,
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
    const flags =
      (options.shapes ? 1 : 0) |
      (options.bounds ? 2 : 0) |
      (options.cells ? 4 : 0) |
      (options.contacts ? 8 : 0) |
      (options.islands ? 16 : 0) |
      (options.axes ? 32 : 0) |
      (options.pairs ? 64 : 0) |
      (options.motions ? 128 : 0);
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

  #castAll(
    [kind, hx, hy, angle]: SolidNumbers,
    [x, y]: Vec2,
    [dx, dy]: Vec2,
    filter: QueryFilter,
  ): RayHit[] {
    const { engine } = this;
    const last = filterNumbers(filter);
    engine.check(
      engine.exports.api_cast_all(this.address, kind, x, y, hx, hy, angle, dx, dy, ...last),
    );
    const [address, count] = engine.slots;
    const rows = view(Float64Array, engine.buffer, address, 8 * count);
    return Array.from({ length: count }, (_, i) => readHit(rows, 8 * i));
  }

  #onBody(name: string, body: BodyId, ...args: number[]): void {
    const call = this.engine.exports[name];
    this.engine.check(call(this.address, body.index + 1, body.generation, ...args));
  }

  #onShape(name: string, shape: ShapeId, ...args: number[]): void {
    const call = this.engine.exports[name];
    this.engine.check(call(this.address, shape.index + 1, shape.generation, ...args));
  }

  #createShape(options: ShapeOptions, name: string, body: BodyId, ...args: number[]): ShapeId {
    const { engine } = this;
    engine.exports.api_shape_defaults();
    fill(engine.slots, [
      options.density,
      options.friction,
      options.restitution,
      options.category,
      options.mask,
      options.group,
      options.sensor,
      userData(options.userData),
      options.surfaceSpeed,
    ]);
    this.#onBody(name, body, ...args);
    this.#shapesRevision++;
    return shapeId(engine.slots[0], engine.slots[1]);
  }

  #shapeIds(address: number, count: number): ShapeId[] {
    const handles = view(Uint32Array, this.engine.buffer, address, 2 * count);
    return Array.from({ length: count }, (_, i) => shapeId(handles[2 * i], handles[2 * i + 1]));
  }

  #contactEvents(address: number, count: number): ContactEvent[] {
    const numbers = view(Uint32Array, this.engine.buffer, address, 4 * count);
    return Array.from({ length: count }, (_, i) => ({
      a: shapeId(numbers[4 * i], numbers[4 * i + 1]),
      b: shapeId(numbers[4 * i + 2], numbers[4 * i + 3]),
    }));
  }
}

export function detectionIndex(detection: Detection | undefined): number | undefined {
  return detection && indexOf(DETECTIONS, detection, "detection");
}

export function bodyId(index1: number, generation: number): BodyId {
  return Object.freeze({ kind: "body", index: index1 - 1, generation });
}

export function shapeId(index1: number, generation: number): ShapeId {
  return Object.freeze({ kind: "shape", index: index1 - 1, generation });
}

/** Kind, half extents (a circle's radius is the first) and angle, as the module takes them. */
export type SolidNumbers = [kind: number, hx: number, hy: number, angle: number];

export function solidNumbers(shape: SolidShape): SolidNumbers {
  const kind = indexOf(SHAPE_KINDS, shape.kind, "shape kind");
  if (shape.kind === "circle") return [kind, shape.radius, 0, 0];
  return [kind, shape.halfWidth, shape.halfHeight, shape.kind === "obb" ? shape.angle : 0];
}

/** Eight numbers of a hit: shape, point, normal, fraction, depth. */
function readHit(numbers: Float64Array, at: number): RayHit {
  const [index1, generation, x, y, nx, ny, fraction, depth] = numbers.subarray(at, at + 8);
  return { shape: shapeId(index1, generation), point: [x, y], normal: [nx, ny], fraction, depth };
}

/** Overwrites the slots whose option is given. */
export function fill(slots: Float64Array, options: (number | boolean | undefined)[]): void {
  options.forEach((value, i) => {
    if (value !== undefined) slots[i] = Number(value);
  });
}

function indexOf<T extends string>(names: readonly T[], name: T, what: string): number {
  const index = names.indexOf(name);
  if (index < 0)
    throw new ThudError("invalid", `${what} "${name}" is none of ${names.join(", ")}`);
  return index;
}

function userData(value: number | undefined): number | undefined {
  if (value !== undefined && !(Number.isSafeInteger(value) && value >= 0))
    throw new ThudError("invalid", `userData must be a whole number from 0 to 2^53 - 1: ${value}`);
  return value;
}

function filterNumbers(filter: QueryFilter): [number, number, number] {
  return [filter.category ?? 0xffffffff, filter.mask ?? 0xffffffff, Number(filter.sensors ?? false)];
}

interface ViewClass<T> {
  new (buffer: ArrayBuffer, address: number, length: number): T;
}

/** A view into memory; where there is nothing to see, its address may be anything. */
export function view<T>(View: ViewClass<T>, buffer: ArrayBuffer, address: number, length: number): T {
  return new View(buffer, length === 0 ? 0 : address, length);
}
