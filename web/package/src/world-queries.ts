/** What a world is asked about places: rays, casts, the closest shape, overlaps. */
import { checkNames } from "./names.js";
import { filterNumbers, shapeId, type SolidNumbers, solidNumbers, view } from "./numbers.js";
import type { ClosestHit, OverlapQuery, QueryFilter, RayHit, SolidShape } from "./query-types.js";
import type { ShapeId, Vec2 } from "./types.js";
import { WorldBase } from "./world-base.js";

export class WorldQueries extends WorldBase {
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
    return this.shapeIds(engine.slots[0], engine.slots[1]);
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
}

/** Eight numbers of a hit: shape, point, normal, fraction, depth. */
function readHit(numbers: Float64Array, at: number): RayHit {
  const [index1, generation, x, y, nx, ny, fraction, depth] = numbers.subarray(at, at + 8);
  return { shape: shapeId(index1, generation), point: [x, y], normal: [nx, ny], fraction, depth };
}
