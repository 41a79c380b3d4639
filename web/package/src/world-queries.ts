/**
 * The layer of World with queries: rays, shape casts, the closest shape, overlaps, and poses to
 * come. A query sees all changes made before it, except those made inside callbacks. Places and the
 * ends of casts lie within 10⁹ length scales of the origin. thud_queries.h, thud_casts.h and
 * thud_prediction.h describe queries in full.
 */
import type { Engine } from "./engine.js";
import {
  BoundsAt,
  ClosestHitAt,
  FirstHitAt,
  ListAt,
  NumberAt,
  PoseAheadAt,
  PredictionAt,
  RayHitAt,
} from "./generated/slots.js";
import { checkOptions } from "./checks/names.js";
import {
  fill,
  filterNumbers,
  rowsOf,
  shapeAt,
  solidNumbers,
  type SolidNumbers,
  vecAt,
  xOf,
} from "./numbers.js";
import type {
  Bounds,
  CastListener,
  ClosestHit,
  OverlapQuery,
  Prediction,
  QueryFilter,
  RayHit,
  SolidShape,
} from "./query-types.js";
import { Kind, numberOfPair } from "./plain/handles.js";
import type { BodyRef, ShapeId, ShapeRef, Vec2, Into } from "./types.js";
import { WorldBase } from "./world-base.js";

/** The numbers of the default filter. */
const EVERYTHING = filterNumbers({});

/** The layer of World with queries. */
export class WorldQueries extends WorldBase {
  /**
   * The first shape on the ray from `origin` to `origin` + `translation`, or null. `translation` is
   * a displacement: towards a point it is the point minus the origin. A ray that starts inside a
   * shape does not hit it.
   * @throws {ThudError} "invalid"; "memory".
   * @example world.castRay([0, 10], [0, -20])
   */
  castRay(origin: Vec2, translation: Vec2, filter: QueryFilter = {}): RayHit | null {
    const { exports } = this.#asked(filter);
    const [x, y, dx, dy] = [xOf(origin, "origin"), origin?.[1], xOf(translation, "translation"), translation?.[1]];
    const result = exports.api_cast_ray(this.address, x, y, dx, dy);
    if (result !== 0) this.refuse(result, "castRay", { origin, translation });
    return readFirst(this.engine.slots);
  }

  /**
   * As `castRay`, but writes the hit to a list: the number of the shape, x and y of the point and
   * of the normal, the fraction. Returns false, with the list unchanged, where there is no hit. A
   * filter of null finds everything but sensors.
   * @throws {ThudError} "invalid"; "memory".
   * @example if (world.castRayInto(eye, way, null, hit)) look(hit[0])
   */
  castRayInto(origin: Vec2, translation: Vec2, filter: QueryFilter | null, into: Into): boolean {
    const { exports } = filter === null ? this.#askedAll() : this.#asked(filter);
    const result = exports.api_cast_ray(
      this.address,
      xOf(origin, "origin"),
      origin?.[1],
      xOf(translation, "translation"),
      translation?.[1],
    );
    if (result !== 0) this.refuse(result, "castRayInto", { origin, translation });
    const s = this.engine.slots;
    if (s[FirstHitAt.found] === 0) return false;
    const shape = FirstHitAt.hit + RayHitAt.shape;
    into[0] = numberOfPair(s[shape], s[shape + 1], Kind.shape);
    into[1] = s[FirstHitAt.hit + RayHitAt.point];
    into[2] = s[FirstHitAt.hit + RayHitAt.point + 1];
    into[3] = s[FirstHitAt.hit + RayHitAt.normal];
    into[4] = s[FirstHitAt.hit + RayHitAt.normal + 1];
    into[5] = s[FirstHitAt.hit + RayHitAt.fraction];
    return true;
  }

  /**
   * All shapes on the ray, each with its first hit, the nearest first.
   * @throws {ThudError} "invalid"; "memory".
   */
  castRayAll(origin: Vec2, translation: Vec2, filter: QueryFilter = {}): RayHit[] {
    const args = { origin, translation };
    return this.#castAll([-1, 0, 0, 0], origin, translation, filter, "castRayAll", args);
  }

  /**
   * The first shape that a circle, AABB or OBB hits which moves from `center` by `translation`
   * without rotation, or null. Touching counts; a shape that overlaps it at the start is hit at
   * fraction 0.
   * @throws {ThudError} "invalid"; "memory".
   */
  castShape(
    shape: SolidShape,
    center: Vec2,
    translation: Vec2,
    filter: QueryFilter = {},
  ): RayHit | null {
    const [kind, hx, hy, angle] = solidNumbers(shape);
    const { exports } = this.#asked(filter);
    const [x, y, dx, dy] = [xOf(center, "center"), center?.[1], xOf(translation, "translation"), translation?.[1]];
    const result = exports.api_cast_shape(this.address, kind, x, y, hx, hy, angle, dx, dy);
    if (result !== 0) this.refuse(result, "castShape", { center, translation, shape });
    return readFirst(this.engine.slots);
  }

  /**
   * All shapes that the moving shape of `castShape` hits, the nearest first.
   * @throws {ThudError} "invalid"; "memory".
   */
  castShapeAll(
    shape: SolidShape,
    center: Vec2,
    translation: Vec2,
    filter: QueryFilter = {},
  ): RayHit[] {
    const args = { center, translation, shape };
    return this.#castAll(solidNumbers(shape), center, translation, filter, "castShapeAll", args);
  }

  /**
   * Calls the listener for each shape on the ray, the nearest first, up to the limit that it
   * returns (CastListener). Inside the listener queries are allowed; what it creates or destroys
   * takes effect with the next step, and other changes throw "locked". An exception of the listener
   * ends the cast and is passed on.
   * @throws {ThudError} "invalid"; "memory".
   * @example world.castRayEach([0, 10], [0, -20], (hit) => (isGlass(hit.shape) ? -1 : 0))
   */
  castRayEach(
    origin: Vec2,
    translation: Vec2,
    listener: CastListener,
    filter: QueryFilter = {},
  ): void {
    const args = { origin, translation };
    this.#castEach([-1, 0, 0, 0], origin, translation, listener, filter, "castRayEach", args);
  }

  /**
   * As `castRayEach`, for the shapes that the moving shape of `castShape` hits.
   * @throws {ThudError} "invalid"; "memory".
   */
  castShapeEach(
    shape: SolidShape,
    center: Vec2,
    translation: Vec2,
    listener: CastListener,
    filter: QueryFilter = {},
  ): void {
    const args = { center, translation, shape };
    const solid = solidNumbers(shape);
    this.#castEach(solid, center, translation, listener, filter, "castShapeEach", args);
  }

  /**
   * The shape closest to a point, or null where none is within `maxDistance`: a length, 0 to 10⁹
   * length scales. A point inside a shape has a negative distance.
   * @throws {ThudError} "invalid"; "memory".
   */
  closest(point: Vec2, maxDistance: number, filter: QueryFilter = {}): ClosestHit | null {
    const { exports } = this.#asked(filter);
    const result = exports.api_closest(this.address, xOf(point, "point"), point?.[1], maxDistance);
    if (result !== 0) this.refuse(result, "closest", { point, maxDistance });
    const s = this.engine.slots;
    return s[ClosestHitAt.found] === 0 ? null : readClosest(s);
  }

  /**
   * All shapes that overlap a region, in the order of their slots; touching counts. The region is a
   * box from `lower` to `upper` ("bounds"), or a circle, AABB or OBB around `center`.
   * @throws {ThudError} "invalid"; "memory".
   * @example world.overlap({ kind: "circle", center: [0, 0], radius: 1 })
   */
  overlap(query: OverlapQuery, filter: QueryFilter = {}): ShapeId[] {
    const { exports } = this.#asked(filter);
    if (query.kind === "bounds") {
      const { lower, upper } = query;
      checkOptions("bounds", query, ["kind", "lower", "upper"]);
      const [left, bottom, right, top] = [xOf(lower, "lower"), lower?.[1], xOf(upper, "upper"), upper?.[1]];
      const result = exports.api_overlap_aabb(this.address, left, bottom, right, top);
      if (result !== 0) this.refuse(result, "overlap", query);
    } else {
      const [kind, hx, hy, angle] = solidNumbers(query, ["center"]);
      const [x, y] = [xOf(query.center, "center"), query.center?.[1]];
      const result = exports.api_overlap_shape(this.address, kind, x, y, hx, hy, angle);
      if (result !== 0) this.refuse(result, "overlap", { ...query, shape: query });
    }
    return this.shapeIds();
  }

  /**
   * The first hit of each of many rays, or null, in one call of the module. `rays` has four numbers
   * a ray: x and y of its origin and of its translation. Each hit is the same as that of `castRay`.
   * @throws {ThudError} "invalid" where one of the rays is out of range; "memory".
   * @example world.castRays([0, 10, 0, -20, 5, 10, 0, -20])
   */
  castRays(rays: ArrayLike<number>, filter: QueryFilter = {}): (RayHit | null)[] {
    const { engine } = this;
    const { exports } = this.#asked(filter);
    const count = Math.floor(rays.length / 4);
    engine.withDoubles(
      4 * count,
      (doubles) => {
        for (let i = 0; i < doubles.length; i++) doubles[i] = rays[i];
      },
      (address) => {
        const result = exports.api_cast_rays(this.address, address, count);
        if (result !== 0) this.refuse(result, "castRays", { rays });
      },
    );
    const { buffer, slots } = engine;
    const read = (rows: Float64Array, at: number) =>
      rows[at + RayHitAt.shape] === 0 ? null : readHit(rows, at);
    return rowsOf(Float64Array, buffer, slots, ListAt.address, RayHitAt.length, read);
  }

  // ---- one shape, whatever its filter ----

  /**
   * The first hit of a ray on this shape, or null. A ray that starts inside the shape does not hit
   * it.
   * @throws {ThudError} "invalid", "stale".
   */
  shapeCastRay(shape: ShapeRef, origin: Vec2, translation: Vec2): RayHit | null {
    const [x, y, dx, dy] = [xOf(origin, "origin"), origin?.[1], xOf(translation, "translation"), translation?.[1]];
    this.on(Kind.shape, "api_shape_cast_ray", shape, x, y, dx, dy);
    return readFirst(this.engine.slots);
  }

  /**
   * Whether a point is in a shape or on its edge. A point below the line of a terrain is inside.
   * @throws {ThudError} "invalid", "stale".
   * @example if (world.containsPoint(shape, [x, y])) pick(shape)
   */
  containsPoint(shape: ShapeRef, point: Vec2): boolean {
    this.on(Kind.shape, "api_shape_contains_point", shape, xOf(point, "point"), point?.[1]);
    return this.engine.slots[NumberAt.value] !== 0;
  }

  /**
   * The closest point of a shape's surface, at any distance.
   * @throws {ThudError} "invalid", "stale".
   */
  closestPointOf(shape: ShapeRef, point: Vec2): ClosestHit {
    this.on(Kind.shape, "api_shape_closest_point", shape, xOf(point, "point"), point?.[1]);
    return readClosest(this.engine.slots);
  }

  /**
   * The smallest axis-aligned box around a shape at its present place, or around the line of a
   * terrain.
   * @throws {ThudError} "stale"; "invalid" for flat terrain, which has no ends.
   */
  boundsOf(shape: ShapeRef): Bounds {
    this.on(Kind.shape, "api_shape_bounds", shape);
    const s = this.engine.slots;
    return { lower: vecAt(s, BoundsAt.lower), upper: vecAt(s, BoundsAt.upper) };
  }

  // ---- poses to come ----

  /**
   * Where a body will be in `seconds` (0 to 60) if nothing touches it: on the parabola of gravity, or
   * the curve of its damping, in closed form. Steps without contacts lead there, too. A body that is
   * static, asleep or disabled stays. Allowed inside callbacks. thud_prediction.h has the equations.
   * @throws {ThudError} "invalid", "stale".
   * @example world.extrapolate(ball, 0.1).position
   */
  extrapolate(body: BodyRef, seconds: number): Prediction {
    this.on(Kind.body, "api_body_extrapolate", body, seconds);
    return readPrediction(this.engine.slots);
  }

  /**
   * As `extrapolate`, but the body stops where it first meets another shape, all of which stand where
   * they are now. What lies on another shape, and would go on into it, stops at once.
   * @throws {ThudError} "invalid", "stale"; "memory".
   * @example world.predict(ball, 0.1).met
   */
  predict(body: BodyRef, seconds: number): Prediction {
    this.on(Kind.body, "api_body_predict", body, seconds);
    return readPrediction(this.engine.slots);
  }

  /**
   * Where all awake bodies will be in `seconds` (0 to 60), as by `extrapolate`: four numbers a body,
   * its slot, x, y and angle, in the order of slots. The list is a copy.
   * @throws {ThudError} "invalid"; "memory".
   * @example const ahead = world.extrapolateAwake(0.1)
   */
  extrapolateAwake(seconds: number): Float64Array {
    this.onWorld("api_world_extrapolate_awake", seconds);
    const { buffer, slots: s } = this.engine;
    const numbers = s[ListAt.count] * PoseAheadAt.length;
    return numbers === 0
      ? new Float64Array(0)
      : new Float64Array(buffer, s[ListAt.address], numbers).slice();
  }

  /** Writes the default filter to the slots, and returns the engine. */
  #askedAll(): Engine {
    for (let i = 0; i < EVERYTHING.length; i++) this.engine.slots[i] = EVERYTHING[i];
    return this.engine;
  }

  /** Writes a filter to the slots, and returns the engine. */
  #asked(filter: QueryFilter): Engine {
    fill(this.engine.slots, filterNumbers(filter));
    return this.engine;
  }

  /** All hits of a cast, sorted. A `solid` of kind -1 is a ray. `call`, `args`: for errors. */
  #castAll(
    solid: SolidNumbers,
    from: Vec2,
    translation: Vec2,
    filter: QueryFilter,
    call: string,
    args: object,
  ): RayHit[] {
    this.#cast("api_cast_all", solid, from, translation, filter, call, args);
    const { buffer, slots } = this.engine;
    return rowsOf(Float64Array, buffer, slots, ListAt.address, RayHitAt.length, readHit);
  }

  /** Calls the listener for each hit of a cast. */
  #castEach(
    solid: SolidNumbers,
    from: Vec2,
    translation: Vec2,
    listener: CastListener,
    filter: QueryFilter,
    call: string,
    args: object,
  ): void {
    const { engine } = this;
    engine.callbacks.hearing(
      () => listener(readHit(engine.slots, FirstHitAt.hit)),
      () => this.#cast("api_cast_each", solid, from, translation, filter, call, args),
    );
  }

  /** Calls the module's function `name` for a cast, and throws where it fails. */
  #cast(
    name: string,
    [kind, hx, hy, angle]: SolidNumbers,
    from: Vec2,
    translation: Vec2,
    filter: QueryFilter,
    call: string,
    args: object,
  ): void {
    const { exports, callbacks } = this.#asked(filter);
    const [x, y, dx, dy] = [xOf(from, "origin"), from?.[1], xOf(translation, "translation"), translation?.[1]];
    const result = exports[name](this.address, kind, x, y, hx, hy, angle, dx, dy);
    if (result !== 0 || callbacks.hasThrown) this.refuse(result, call, args);
  }
}

function readClosest(s: Float64Array): ClosestHit {
  return {
    shape: shapeAt(s, ClosestHitAt.shape),
    point: vecAt(s, ClosestHitAt.point),
    normal: vecAt(s, ClosestHitAt.normal),
    distance: s[ClosestHitAt.distance],
  };
}

function readPrediction(s: Float64Array): Prediction {
  const met = PredictionAt.met;
  return {
    position: vecAt(s, PredictionAt.position),
    angle: s[PredictionAt.angle],
    velocity: vecAt(s, PredictionAt.velocity),
    angularVelocity: s[PredictionAt.angularVelocity],
    seconds: s[PredictionAt.seconds],
    met: s[met] === 0 ? null : shapeAt(s, met),
  };
}

/** The first hit in the slots, or null. */
function readFirst(slots: Float64Array): RayHit | null {
  return slots[FirstHitAt.found] === 0 ? null : readHit(slots, FirstHitAt.hit);
}

function readHit(rows: Float64Array, at: number): RayHit {
  return {
    shape: shapeAt(rows, at + RayHitAt.shape),
    point: vecAt(rows, at + RayHitAt.point),
    normal: vecAt(rows, at + RayHitAt.normal),
    fraction: rows[at + RayHitAt.fraction],
    depth: rows[at + RayHitAt.depth],
  };
}
