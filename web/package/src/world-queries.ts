/** What a world is asked about places: rays, casts, the closest shape, overlaps. */
import type { Engine } from "./engine.js";
import {
  BoundsAt,
  ClosestHitAt,
  FirstHitAt,
  ListAt,
  NumberAt,
  RayHitAt,
} from "./generated/slots.js";
import { checkNames } from "./checks/names.js";
import {
  fill,
  filterNumbers,
  rowsOf,
  shapeAt,
  type SolidNumbers,
  solidNumbers,
  vecAt,
} from "./numbers.js";
import type {
  Bounds,
  CastListener,
  ClosestHit,
  OverlapQuery,
  QueryFilter,
  RayHit,
  SolidShape,
} from "./query-types.js";
import { Kind, numberOfPair } from "./plain/handles.js";
import type { ShapeId, ShapeRef, Vec2, Into } from "./types.js";
import { WorldBase } from "./world-base.js";

const EVERYTHING = filterNumbers({});

export class WorldQueries extends WorldBase {
  /**
   * The first shape along the ray, or null.
   * @example world.castRay([0, 10], [0, -20])
   */
  castRay(origin: Vec2, translation: Vec2, filter: QueryFilter = {}): RayHit | null {
    const { exports } = this.#asked(filter);
    const [x, y, dx, dy] = [origin?.[0], origin?.[1], translation?.[0], translation?.[1]];
    const result = exports.api_cast_ray(this.address, x, y, dx, dy);
    if (result !== 0) this.refuse(result, "castRay", { origin, translation });
    return readFirst(this.engine.slots);
  }

  /**
   * As `castRay`, with what is found in a list of yours: the number of the shape, x and y of the point
   * and of the normal, the fraction. False where nothing is, and the list is as before.
   * @example if (world.castRayInto(eye, way, hit)) look(hit[0])
   */
  castRayInto(origin: Vec2, translation: Vec2, into: Into, filter?: QueryFilter): boolean {
    const { exports } = filter === undefined ? this.#askedAll() : this.#asked(filter);
    const result = exports.api_cast_ray(
      this.address,
      origin?.[0],
      origin?.[1],
      translation?.[0],
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

  /** Every shape along the ray, the nearest first. */
  castRayAll(origin: Vec2, translation: Vec2, filter: QueryFilter = {}): RayHit[] {
    const args = { origin, translation };
    return this.#castAll([-1, 0, 0, 0], origin, translation, filter, "castRayAll", args);
  }

  /** The first shape that a circle, AABB or OBB meets on its way, or null. */
  castShape(
    shape: SolidShape,
    center: Vec2,
    translation: Vec2,
    filter: QueryFilter = {},
  ): RayHit | null {
    const [kind, hx, hy, angle] = solidNumbers(shape);
    const { exports } = this.#asked(filter);
    const [x, y, dx, dy] = [center?.[0], center?.[1], translation?.[0], translation?.[1]];
    const result = exports.api_cast_shape(this.address, kind, x, y, hx, hy, angle, dx, dy);
    if (result !== 0) this.refuse(result, "castShape", { center, translation, shape });
    return readFirst(this.engine.slots);
  }

  /** Every shape that a circle, AABB or OBB meets on its way, the nearest first. */
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
   * Tells of the shapes along the ray one by one, the nearest first, no further than is asked for by
   * what is answered. Meanwhile the world can be asked; what is made and destroyed waits for the
   * next step, and other changes are refused. What the listener throws ends the cast and is thrown.
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

  /** As `castRayEach`, of the shapes that a circle, AABB or OBB meets on its way. */
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

  /** The shape closest to a point, if one is no further than `maxDistance`, or null. */
  closest(point: Vec2, maxDistance: number, filter: QueryFilter = {}): ClosestHit | null {
    const { exports } = this.#asked(filter);
    const result = exports.api_closest(this.address, point?.[0], point?.[1], maxDistance);
    if (result !== 0) this.refuse(result, "closest", { point, maxDistance });
    const s = this.engine.slots;
    return s[ClosestHitAt.found] === 0 ? null : readClosest(s);
  }

  /**
   * Every shape that overlaps: by its bounds for "bounds", else by its true form.
   * @example world.overlap({ kind: "circle", center: [0, 0], radius: 1 })
   */
  overlap(query: OverlapQuery, filter: QueryFilter = {}): ShapeId[] {
    const { exports } = this.#asked(filter);
    if (query.kind === "bounds") {
      const { lower, upper } = query;
      checkNames("bounds", query, ["kind", "lower", "upper"]);
      const [left, bottom, right, top] = [lower?.[0], lower?.[1], upper?.[0], upper?.[1]];
      const result = exports.api_overlap_aabb(this.address, left, bottom, right, top);
      if (result !== 0) this.refuse(result, "overlap", query);
    } else {
      const [kind, hx, hy, angle] = solidNumbers(query, ["center"]);
      const [x, y] = [query.center?.[0], query.center?.[1]];
      const result = exports.api_overlap_shape(this.address, kind, x, y, hx, hy, angle);
      if (result !== 0) this.refuse(result, "overlap", { ...query, shape: query });
    }
    return this.shapeIds();
  }

  /**
   * The first hit of each of many rays, or null: four numbers a ray, its origin and its way. One call
   * for all of them; each hit is the one that `castRay` has.
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

  /** Where a ray first meets this shape, or null. */
  castRayAt(shape: ShapeRef, origin: Vec2, translation: Vec2): RayHit | null {
    const [x, y, dx, dy] = [origin?.[0], origin?.[1], translation?.[0], translation?.[1]];
    this.on(Kind.shape, "api_shape_meets_ray", shape, x, y, dx, dy);
    return readFirst(this.engine.slots);
  }

  /**
   * Whether a point is in a shape, or on its edge; below a terrain's line it is.
   * @example if (world.containsPoint(shape, [x, y])) pick(shape)
   */
  containsPoint(shape: ShapeRef, point: Vec2): boolean {
    this.on(Kind.shape, "api_shape_contains_point", shape, point?.[0], point?.[1]);
    return this.engine.slots[NumberAt.value] !== 0;
  }

  /** The closest point of a shape's surface, however far. */
  closestPointOf(shape: ShapeRef, point: Vec2): ClosestHit {
    this.on(Kind.shape, "api_shape_closest_point", shape, point?.[0], point?.[1]);
    return readClosest(this.engine.slots);
  }

  /** The least box around a shape as it stands; a flat terrain has none. */
  boundsOf(shape: ShapeRef): Bounds {
    this.on(Kind.shape, "api_shape_bounds", shape);
    const s = this.engine.slots;
    return { lower: vecAt(s, BoundsAt.lower), upper: vecAt(s, BoundsAt.upper) };
  }

  /** The engine, with a query of everything in its slots. */
  #askedAll(): Engine {
    for (let i = 0; i < EVERYTHING.length; i++) this.engine.slots[i] = EVERYTHING[i];
    return this.engine;
  }

  /** The engine, with what a query finds in its slots. */
  #asked(filter: QueryFilter): Engine {
    fill(this.engine.slots, filterNumbers(filter));
    return this.engine;
  }

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
    const [x, y, dx, dy] = [from?.[0], from?.[1], translation?.[0], translation?.[1]];
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
