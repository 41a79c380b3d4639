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
import { blameQuery, isQueryWrong } from "./checks/parts.js";
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
  ClosestHit,
  OverlapQuery,
  QueryFilter,
  RayHit,
  SolidShape,
} from "./query-types.js";
import type { ShapeId, Vec2 } from "./types.js";
import { WorldBase } from "./world-base.js";

export class WorldQueries extends WorldBase {
  /**
   * The first shape along the ray, or null.
   * @example world.castRay([0, 10], [0, -20])
   */
  castRay(origin: Vec2, translation: Vec2, filter: QueryFilter = {}): RayHit | null {
    const { exports } = this.#asked(filter);
    const [x, y, dx, dy] = [origin?.[0], origin?.[1], translation?.[0], translation?.[1]];
    const result = exports.api_cast_ray(this.address, x, y, dx, dy);
    if (result !== 0) this.#refuse(result, "castRay", { origin, translation });
    return readFirst(this.engine.slots);
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
    if (result !== 0) this.#refuse(result, "castShape", { center, translation }, shape);
    return readFirst(this.engine.slots);
  }

  /** Every shape that a circle, AABB or OBB meets on its way, the nearest first. */
  castShapeAll(
    shape: SolidShape,
    center: Vec2,
    translation: Vec2,
    filter: QueryFilter = {},
  ): RayHit[] {
    const args = { center, translation };
    return this.#castAll(solidNumbers(shape), center, translation, filter, "castShapeAll", args, shape);
  }

  /** The shape closest to a point, if one is no further than `maxDistance`, or null. */
  closest(point: Vec2, maxDistance: number, filter: QueryFilter = {}): ClosestHit | null {
    const { exports } = this.#asked(filter);
    const result = exports.api_closest(this.address, point?.[0], point?.[1], maxDistance);
    if (result !== 0) this.#refuse(result, "closest", { point, maxDistance });
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
      if (result !== 0) this.#refuse(result, "overlap", query);
    } else {
      const [kind, hx, hy, angle] = solidNumbers(query, ["center"]);
      const [x, y] = [query.center?.[0], query.center?.[1]];
      const result = exports.api_overlap_shape(this.address, kind, x, y, hx, hy, angle);
      if (result !== 0) this.#refuse(result, "overlap", query, query);
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
        if (result !== 0) this.#refuseRays(result, rays);
      },
    );
    const { buffer, slots } = engine;
    const read = (rows: Float64Array, at: number) =>
      rows[at + RayHitAt.shape] === 0 ? null : readHit(rows, at);
    return rowsOf(Float64Array, buffer, slots, ListAt.address, RayHitAt.length, read);
  }

  // ---- one shape, whatever its filter ----

  /** Where a ray first meets this shape, or null. */
  castRayAt(shape: ShapeId, origin: Vec2, translation: Vec2): RayHit | null {
    this.onShape("api_shape_meets_ray", shape, ...origin, ...translation);
    return readFirst(this.engine.slots);
  }

  /**
   * Whether a point is in a shape, or on its edge; below a terrain's line it is.
   * @example if (world.containsPoint(shape, [x, y])) pick(shape)
   */
  containsPoint(shape: ShapeId, point: Vec2): boolean {
    this.onShape("api_shape_contains_point", shape, ...point);
    return this.engine.slots[NumberAt.value] !== 0;
  }

  /** The closest point of a shape's surface, however far. */
  closestPointOf(shape: ShapeId, point: Vec2): ClosestHit {
    this.onShape("api_shape_closest_point", shape, ...point);
    return readClosest(this.engine.slots);
  }

  /** The least box around a shape as it stands; a flat terrain has none. */
  boundsOf(shape: ShapeId): Bounds {
    this.onShape("api_shape_bounds", shape);
    const s = this.engine.slots;
    return { lower: vecAt(s, BoundsAt.lower), upper: vecAt(s, BoundsAt.upper) };
  }

  /** The engine, with what a query finds in its slots. */
  #asked(filter: QueryFilter): Engine {
    fill(this.engine.slots, filterNumbers(filter));
    return this.engine;
  }

  /** Throws, and names the argument that was wrong, or what is of the shape that asked. */
  #refuse(result: number, call: string, args: object, shape?: SolidShape): void {
    try {
      this.engine.check(result);
    } catch (refused) {
      throw blameQuery(refused, call, args, this.lengthScale, shape);
    }
  }

  #refuseRays(result: number, rays: ArrayLike<number>): void {
    const ends = Array.from({ length: Math.floor(rays.length / 4) }, (_, i) => ({
      origin: [rays[4 * i], rays[4 * i + 1]],
      translation: [rays[4 * i + 2], rays[4 * i + 3]],
    }));
    const wrong = Math.max(0, ends.findIndex((ray) => isQueryWrong(ray, this.lengthScale)));
    this.#refuse(result, `castRays: ray ${wrong}`, ends[wrong]);
  }

  #castAll(
    [kind, hx, hy, angle]: SolidNumbers,
    from: Vec2,
    translation: Vec2,
    filter: QueryFilter,
    call: string,
    args: object,
    shape?: SolidShape,
  ): RayHit[] {
    const { engine } = this;
    const { exports } = this.#asked(filter);
    const [x, y, dx, dy] = [from?.[0], from?.[1], translation?.[0], translation?.[1]];
    const result = exports.api_cast_all(this.address, kind, x, y, hx, hy, angle, dx, dy);
    if (result !== 0) this.#refuse(result, call, args, shape);
    const { buffer, slots } = engine;
    return rowsOf(Float64Array, buffer, slots, ListAt.address, RayHitAt.length, readHit);
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
