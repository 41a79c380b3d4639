/**
 * The layer of World that creates and reads shapes, and edits the line of a terrain. Edits of a
 * terrain change the line at once; the next step wakes the bodies that touch a changed part.
 * thud.h and thud_terrain.h describe them in full.
 */
import { explained, shown } from "./checks/hook.js";
import { ThudError } from "./error.js";
import {
  FootAt,
  GroundAt,
  HandleAt,
  SHAPE_OPTIONS,
  ShapeStateAt,
  TerrainAt,
} from "./generated/slots.js";
import { bodyAt, FORMS, rowsOf, shapeAt, vecAt, writeOptions, xOf } from "./numbers.js";
import { generationOf, index1Of, Kind } from "./plain/handles.js";
import { TERRAIN_KINDS, withLine } from "./terrain-line.js";
import {
  type BodyRef,
  type BoxOptions,
  type CircleOptions,
  type Foot,
  type Ground,
  type ObbOptions,
  SHAPE_KINDS,
  type ShapeId, type ShapeRef,
  type ShapeKind,
  type ShapeOptions,
  type ShapeState,
  type SolidOptions,
  type Terrain,
  type Vec2,
} from "./types.js";
import { WorldLists } from "./world-lists.js";

/** The options of each kind of shape beside those of all shapes (SHAPE_OPTIONS). */
const SOLIDS = {
  circle: [...FORMS.circle, "offset"],
  aabb: [...FORMS.aabb, "offset"],
  obb: [...FORMS.obb, "offset"],
};

/** The method that creates a shape of each kind, for messages. */
const CREATE = {
  circle: "createCircle",
  aabb: "createAabb",
  obb: "createObb",
  terrain: "createTerrain",
} as const;

/** The module's function that creates a shape of each kind. */
const MODULE_CREATE = {
  circle: "api_circle_create",
  aabb: "api_aabb_create",
  obb: "api_obb_create",
} as const;
type SolidKind = keyof typeof MODULE_CREATE;

/** The options of a shape of any kind but terrain. */
type SolidLike = ShapeOptions & {
  kind?: ShapeKind;
  offset?: Vec2;
  radius?: number;
  halfWidth?: number;
  halfHeight?: number;
  angle?: number;
};

/** The layer of World with shapes and terrain. */
export class WorldShapes extends WorldLists {
  /**
   * Adds a circle to a body.
   * @throws {ThudError} "invalid", "stale", "memory".
   * @example world.createCircle(ball, { radius: 0.5, restitution: 0.4 })
   */
  createCircle(body: BodyRef, options: CircleOptions): ShapeId {
    return this.#createSolid("circle", body, options);
  }

  /**
   * Adds an axis-aligned box to a body with angle 0, whose rotation is fixed from then on.
   * @throws {ThudError} "invalid", also for a body that is turned; "stale", "memory".
   * @example world.createAabb(ground, { halfWidth: 10, halfHeight: 1 })
   */
  createAabb(body: BodyRef, options: BoxOptions): ShapeId {
    return this.#createSolid("aabb", body, options);
  }

  /**
   * Adds an oriented box to a body, which turns with it.
   * @throws {ThudError} "invalid", "stale", "memory".
   * @example world.createObb(body, { halfWidth: 1, halfHeight: 0.5 })
   */
  createObb(body: BodyRef, options: ObbOptions): ShapeId {
    return this.#createSolid("obb", body, options);
  }

  /**
   * Adds a terrain to a static body with angle 0: a ground line of any length, solid below. Its
   * coordinates are relative to the body's origin.
   * @throws {ThudError} "invalid", also for another kind of body; "stale", "memory".
   * @example world.createTerrain(body, { kind: "uniform", x0: 0, spacing: 1, heights })
   */
  createTerrain(
    body: BodyRef,
    terrain: Terrain,
    options: ShapeOptions & { kind?: "terrain" } = {},
  ): ShapeId {
    return withLine(this.engine, "createTerrain", terrain, (...line) => {
      const { exports, slots } = this.engine;
      exports.api_shape_defaults();
      writeOptions("createTerrain", slots, options, SHAPE_OPTIONS, FORMS.terrain);
      if ((options.kind ?? "terrain") !== "terrain")
        throw new ThudError("invalid", `createTerrain: its kind is ${shown(options.kind)}`);
      try {
        this.on(Kind.body, "api_terrain_create", body, ...line);
      } catch (refused) {
        throw explained(refused, "createTerrain", { ...options, terrain }, this.lengthScale);
      }
      this.shapesRevision++;
      // Not those of before: the call may have made the memory grow, and they are then of the old one.
      return shapeAt(this.engine.slots, HandleAt.index1);
    });
  }

  /**
   * The options of a shape as they are now, and its body.
   * @throws {ThudError} "stale".
   */
  shapeStateOf(shape: ShapeRef): ShapeState {
    this.on(Kind.shape, "api_shape_state", shape);
    const s = this.engine.slots;
    const kind = SHAPE_KINDS[s[ShapeStateAt.kind]];
    const material = {
      body: bodyAt(s, ShapeStateAt.body),
      density: s[ShapeStateAt.density],
      friction: s[ShapeStateAt.friction],
      restitution: s[ShapeStateAt.restitution],
      surfaceSpeed: s[ShapeStateAt.surfaceSpeed],
      category: s[ShapeStateAt.category],
      mask: s[ShapeStateAt.mask],
      group: s[ShapeStateAt.group],
      sensor: s[ShapeStateAt.sensor] !== 0,
      events: s[ShapeStateAt.events] !== 0,
      userData: s[ShapeStateAt.userData],
    };
    if (kind === "terrain") return { kind, ...material };
    const offset: Vec2 = vecAt(s, ShapeStateAt.offset);
    const [halfWidth, halfHeight] = vecAt(s, ShapeStateAt.halfExtents);
    if (kind === "circle") return { kind, radius: halfWidth, offset, ...material };
    if (kind === "aabb") return { kind, halfWidth, halfHeight, offset, ...material };
    return { kind, halfWidth, halfHeight, offset, angle: s[ShapeStateAt.angle], ...material };
  }

  /**
   * A copy of the line of a terrain as it is now.
   * @throws {ThudError} "stale"; "invalid" for another kind of shape.
   */
  terrainOf(shape: ShapeRef): Terrain {
    this.on(Kind.shape, "api_shape_terrain", shape);
    const { buffer, slots: s } = this.engine;
    const kind = TERRAIN_KINDS[s[TerrainAt.kind]];
    if (kind === "flat") return { kind, slope: s[TerrainAt.slope] };
    if (kind === "irregular") {
      return { kind, points: rowsOf(Float64Array, buffer, s, TerrainAt.points, 2, vecAt) };
    }
    const [x0, spacing] = [s[TerrainAt.x0], s[TerrainAt.spacing]];
    const height = (points: Float64Array, at: number) => points[at + 1];
    const heights = rowsOf(Float64Array, buffer, s, TerrainAt.points, 2, height);
    return { kind, x0, spacing, heights: Float64Array.from(heights) };
  }

  /**
   * Replaces the heights of a terrain's vertices from number `first` on: lengths relative to the
   * body's origin.
   * @throws {ThudError} "invalid", also for flat terrain; "stale"; "locked" inside a callback;
   * "memory".
   */
  setHeights(shape: ShapeRef, first: number, heights: ArrayLike<number>): void {
    this.engine.withDoubles(
      heights.length,
      (doubles) => doubles.set(heights),
      (address) => this.on(Kind.shape, "api_shape_set_heights", shape, first, address, heights.length),
    );
    this.terrainsRevision++;
  }

  /**
   * Removes the ground of a terrain inside a circle, and the ground above it. The centre is a place
   * in the world, the radius a length from 10⁻⁴ to 16384 length scales. Bodies that rest there wake
   * with the next step. A uniform line keeps its grid; an irregular one gets new vertices.
   * @throws {ThudError} "invalid", also for flat terrain; "stale"; "locked" inside a callback;
   * "memory".
   * @example world.dig(shape, [x, y], 2)
   */
  dig(shape: ShapeRef, center: Vec2, radius: number): void {
    this.on(Kind.shape, "api_shape_dig", shape, xOf(center, "center"), center?.[1], radius);
    this.terrainsRevision++;
  }

  /**
   * Adds a smooth hill to a terrain around x, a coordinate in the world, over `radius` (with the
   * range of `dig`) to either side. A negative height, a length, makes a hollow. Otherwise as
   * `dig`.
   * @throws {ThudError} "invalid", also for flat terrain; "stale"; "locked" inside a callback;
   * "memory".
   */
  raise(shape: ShapeRef, x: number, radius: number, height: number): void {
    this.on(Kind.shape, "api_shape_raise", shape, x, radius, height);
    this.terrainsRevision++;
  }

  /**
   * Replaces the points of an irregular line from x0 to x1, both included, by others with strictly
   * increasing x in that range. Coordinates are relative to the body's origin, as in createTerrain.
   * At least two points must remain.
   * @throws {ThudError} "invalid", also for another kind of line; "stale"; "locked" inside a
   * callback; "memory".
   */
  replaceRange(shape: ShapeRef, x0: number, x1: number, points: ArrayLike<Vec2>): void {
    this.engine.withPoints(points, (at, count) =>
      this.on(Kind.shape, "api_shape_replace_range", shape, x0, x1, at, count),
    );
    this.terrainsRevision++;
  }

  /**
   * The ground of a terrain at x, a coordinate in the world.
   * @throws {ThudError} "invalid" beyond the ends of the line; "stale".
   */
  groundAt(shape: ShapeRef, x: number): Ground {
    this.on(Kind.shape, "api_ground_at", shape, x);
    const s = this.engine.slots;
    return {
      height: s[GroundAt.height],
      normal: vecAt(s, GroundAt.normal),
      segment: s[GroundAt.segment],
      weights: vecAt(s, GroundAt.weights),
    };
  }

  /**
   * Places a horizontal sole of this width (a length, 0 or more) on a terrain, with its middle at
   * x, a coordinate in the world.
   * @throws {ThudError} "invalid" where no part of the sole is over the line; "stale".
   */
  placeFoot(shape: ShapeRef, x: number, width: number): Foot {
    this.on(Kind.shape, "api_place_foot", shape, x, width);
    const s = this.engine.slots;
    return { height: s[FootAt.height], x: s[FootAt.x], normal: vecAt(s, FootAt.normal) };
  }

  /** Adds a shape of the kind that its options name to a body. */
  protected makeSolid(index1: number, generation: number, shape: SolidOptions): void {
    const kind = shape?.kind;
    if (kind !== "circle" && kind !== "aabb" && kind !== "obb")
      throw new ThudError("invalid", "a shape's kind is circle, aabb or obb");
    this.#makeShape(kind, index1, generation, shape);
  }

  #createSolid(kind: SolidKind, body: BodyRef, options: Omit<SolidOptions, "kind">): ShapeId {
    this.#makeShape(kind, index1Of(body, Kind.body), generationOf(body), options);
    return shapeAt(this.engine.slots, HandleAt.index1);
  }

  /** Adds a shape to a body, and leaves the shape's handle in the slots. */
  #makeShape(kind: SolidKind, index1: number, generation: number, options: SolidLike): void {
    const { exports, slots } = this.engine;
    const [call, name] = [CREATE[kind], MODULE_CREATE[kind]];
    exports.api_shape_defaults();
    writeOptions(call, slots, options, SHAPE_OPTIONS, SOLIDS[kind]);
    if ((options.kind ?? kind) !== kind)
      throw new ThudError("invalid", `${call}: its kind is ${shown(options.kind)}`);
    const { offset, radius = 0, halfWidth = 0, halfHeight = 0, angle = 0 } = options;
    const x = offset === undefined ? 0 : (offset?.[0] ?? NaN);
    const y = offset === undefined ? 0 : (offset?.[1] ?? NaN);
    const first = kind === "circle" ? radius : halfWidth;
    const create = exports[name];
    const result = create(this.address, index1, generation, x, y, first, halfHeight, angle);
    if (result !== 0) this.refuse(result, call, options);
    this.shapesRevision++;
  }
}
