/** What a world is asked about places: rays, casts, the closest shape, overlaps. */
import { ClosestHitAt, FirstHitAt, ListAt, RayHitAt } from "./generated/slots.js";
import { checkNames } from "./names.js";
import {
  filterNumbers,
  rowsOf,
  shapeAt,
  type SolidNumbers,
  solidNumbers,
  vecAt,
} from "./numbers.js";
import type { ClosestHit, OverlapQuery, QueryFilter, RayHit, SolidShape } from "./query-types.js";
import type { ShapeId, Vec2 } from "./types.js";
import { WorldBase } from "./world-base.js";

export class WorldQueries extends WorldBase {
  /**
   * The first shape along the ray, or null.
   * @example world.castRay([0, 10], [0, -20])
   */
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
    return readFirst(engine.slots);
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
    return readFirst(engine.slots);
  }

  /** Every shape that a circle, AABB or OBB meets on its way, the nearest first. */
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
    if (s[ClosestHitAt.found] === 0) return null;
    return {
      shape: shapeAt(s, ClosestHitAt.shape),
      point: vecAt(s, ClosestHitAt.point),
      normal: vecAt(s, ClosestHitAt.normal),
      distance: s[ClosestHitAt.distance],
    };
  }

  /**
   * Every shape that overlaps: by its bounds for "bounds", else by its true form.
   * @example world.overlap({ kind: "circle", center: [0, 0], radius: 1 })
   */
  overlap(query: OverlapQuery, filter: QueryFilter = {}): ShapeId[] {
    const { engine } = this;
    const last = filterNumbers(filter);
    if (query.kind === "bounds") {
      const { lower, upper } = query;
      checkNames("bounds", query, ["kind", "lower", "upper"]);
      engine.check(
        engine.exports.api_overlap_aabb(this.address, ...lower, ...upper, ...last),
      );
    } else {
      const [kind, hx, hy, angle] = solidNumbers(query, ["center"]);
      engine.check(
        engine.exports.api_overlap_shape(
          this.address,
          kind,
          ...query.center,
          hx,
          hy,
          angle,
          ...last,
        ),
      );
    }
    return this.shapeIds();
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
    const { buffer, slots } = engine;
    return rowsOf(Float64Array, buffer, slots, ListAt.address, RayHitAt.length, readHit);
  }
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
