/** The shapes of bodies: made, read and, where they are ground, dug. */
import { checkNames } from "./checks/names.js";
import { blameTerrain } from "./checks/parts.js";
import { blame, SHAPE_RANGES } from "./checks/ranges.js";
import { ThudError } from "./error.js";
import {
  FootAt,
  GroundAt,
  HandleAt,
  SHAPE_OPTIONS,
  ShapeStateAt,
  TerrainAt,
} from "./generated/slots.js";
import { bodyAt, fill, FORMS, indexOf, numbersOf, rowsOf, shapeAt, vecAt } from "./numbers.js";
import {
  type BodyId,
  type BoxOptions,
  type CircleOptions,
  type Foot,
  type Ground,
  type ObbOptions,
  SHAPE_KINDS,
  type ShapeId,
  type ShapeKind,
  type ShapeOptions,
  type ShapeState,
  type SolidOptions,
  type Terrain,
  type Vec2,
} from "./types.js";
import { WorldLists } from "./world-lists.js";

const TERRAIN_KINDS = ["flat", "uniform", "irregular"] as const;
const TERRAINS = {
  flat: ["kind", "slope"],
  uniform: ["kind", "x0", "spacing", "heights"],
  irregular: ["kind", "points"],
} as const;

/** What makes a shape beside its material. */
const SOLIDS = {
  circle: [...FORMS.circle, "offset"],
  aabb: [...FORMS.aabb, "offset"],
  obb: [...FORMS.obb, "offset"],
};

const CREATE = {
  circle: "createCircle",
  aabb: "createAabb",
  obb: "createObb",
  terrain: "createTerrain",
} as const;

export class WorldShapes extends WorldLists {
  /**
   * Gives a body a circle.
   * @example world.createCircle(ball, { radius: 0.5, restitution: 0.4 })
   */
  createCircle(body: BodyId, options: CircleOptions): ShapeId {
    return this.#createSolid("circle", body, options);
  }

  /**
   * Gives a body a box that keeps its axes: the rotation of its body is fixed from then on.
   * @example world.createAabb(ground, { halfWidth: 10, halfHeight: 1 })
   */
  createAabb(body: BodyId, options: BoxOptions): ShapeId {
    return this.#createSolid("aabb", body, options);
  }

  /**
   * Gives a body a box that turns with it.
   * @example world.createObb(body, { halfWidth: 1, halfHeight: 0.5 })
   */
  createObb(body: BodyId, options: ObbOptions): ShapeId {
    return this.#createSolid("obb", body, options);
  }

  /**
   * Gives a body ground of any length, solid below. Only on static bodies with angle 0.
   * @example world.createTerrain(body, { kind: "uniform", x0: 0, spacing: 1, heights })
   */
  createTerrain(body: BodyId, terrain: Terrain, options: ShapeOptions = {}): ShapeId {
    const kind = indexOf(TERRAIN_KINDS, terrain.kind, "createTerrain: kind");
    checkNames("createTerrain", terrain, TERRAINS[terrain.kind]);
    const create = (points: number, count: number, slope: number, x0: number, spacing: number) => {
      const numbers = [kind, slope, x0, spacing, points, count];
      try {
        return this.#createShape("terrain", options, FORMS.terrain, body, ...numbers);
      } catch (refused) {
        throw blameTerrain(refused, terrain);
      }
    };
    if (terrain.kind === "flat") return create(0, 0, terrain.slope ?? 0, 0, 0);
    const uniform = terrain.kind === "uniform";
    if (typeof (uniform ? terrain.heights : terrain.points)?.length !== "number")
      throw new ThudError("invalid", `createTerrain: ${uniform ? "heights" : "points"} must be a list`);
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

  /** What a shape was made with, and its body. */
  shapeState(shape: ShapeId): ShapeState {
    this.onShape("api_shape_get", shape);
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
      userData: s[ShapeStateAt.userData],
    };
    if (kind === "terrain") return { kind, ...material };
    const offset: Vec2 = vecAt(s, ShapeStateAt.offset);
    const [halfWidth, halfHeight] = vecAt(s, ShapeStateAt.halfExtents);
    if (kind === "circle") return { kind, radius: halfWidth, offset, ...material };
    if (kind === "aabb") return { kind, halfWidth, halfHeight, offset, ...material };
    return { kind, halfWidth, halfHeight, offset, angle: s[ShapeStateAt.angle], ...material };
  }

  /** A copy of a terrain as the world has it. */
  terrain(shape: ShapeId): Terrain {
    this.onShape("api_shape_terrain", shape);
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

  /** Replaces the heights of a terrain's vertices from `first` on. */
  setHeights(shape: ShapeId, first: number, heights: ArrayLike<number>): void {
    this.engine.withDoubles(
      heights.length,
      (doubles) => doubles.set(heights),
      (address) => this.onShape("api_shape_set_heights", shape, first, address, heights.length),
    );
    this.terrainsRevision++;
  }

  /**
   * Takes away the ground inside a circle, and what stands above it; not of flat ground. Whatever
   * rests there wakes in the next step. A uniform line keeps its grid.
   * @example world.dig(shape, [x, y], 2)
   */
  dig(shape: ShapeId, center: Vec2, radius: number): void {
    this.onShape("api_shape_dig", shape, center[0], center[1], radius);
    this.terrainsRevision++;
  }

  /** Raises a smooth mound about x; a negative height makes a hollow. Otherwise as `dig`. */
  raise(shape: ShapeId, x: number, radius: number, height: number): void {
    this.onShape("api_shape_raise", shape, x, radius, height);
    this.terrainsRevision++;
  }

  /**
   * Replaces the points of an irregular line at x0 to x1, both included, by others with strictly
   * increasing x in that range. Like those of a new terrain they are relative to the body's origin.
   */
  replaceRange(shape: ShapeId, x0: number, x1: number, points: ArrayLike<Vec2>): void {
    const { length } = points;
    const fillPoints = (doubles: Float64Array) => {
      for (let i = 0; i < length; i++) doubles.set(points[i], 2 * i);
    };
    this.engine.withDoubles(2 * length, fillPoints, (address) =>
      this.onShape("api_shape_replace_range", shape, x0, x1, address, length),
    );
    this.terrainsRevision++;
  }

  /** The ground of a terrain at x, a place in the world; throws beyond its ends. */
  groundAt(shape: ShapeId, x: number): Ground {
    this.onShape("api_ground_at", shape, x);
    const s = this.engine.slots;
    return {
      height: s[GroundAt.height],
      normal: vecAt(s, GroundAt.normal),
      segment: s[GroundAt.segment],
      weights: vecAt(s, GroundAt.weights),
    };
  }

  /** Puts a level sole of the given width onto a terrain, with its middle at x. */
  placeFoot(shape: ShapeId, x: number, width: number): Foot {
    this.onShape("api_place_foot", shape, x, width);
    const s = this.engine.slots;
    return { height: s[FootAt.height], x: s[FootAt.x], normal: vecAt(s, FootAt.normal) };
  }

  /** By the kind that it names. */
  protected createKind(body: BodyId, shape: SolidOptions): ShapeId {
    if (shape?.kind === "circle") return this.createCircle(body, shape);
    if (shape?.kind === "aabb") return this.createAabb(body, shape);
    if (shape?.kind === "obb") return this.createObb(body, shape);
    throw new ThudError("invalid", "a shape's kind is circle, aabb or obb");
  }

  #createSolid(
    kind: Exclude<ShapeKind, "terrain">,
    body: BodyId,
    options: ShapeOptions & { offset?: Vec2 },
  ): ShapeId {
    checkNames(CREATE[kind], options, SHAPE_OPTIONS, SOLIDS[kind]);
    const { offset = [0, 0] } = options;
    const [x, y] = [offset?.[0] ?? NaN, offset?.[1] ?? NaN];
    const given = options as Readonly<Record<string, number | undefined>>;
    const [, ...form] = FORMS[kind];
    const sizes = form.map((name) => given[name] ?? 0);
    return this.#createShape(kind, options, SOLIDS[kind], body, x, y, ...sizes);
  }

  /** `others` names the options that are no part of the material. */
  #createShape(
    kind: ShapeKind,
    options: ShapeOptions & { kind?: ShapeKind },
    others: readonly string[],
    body: BodyId,
    ...args: number[]
  ): ShapeId {
    const { engine } = this;
    const call = CREATE[kind];
    const numbers = numbersOf(call, options, SHAPE_OPTIONS, others);
    if ((options.kind ?? kind) !== kind)
      throw new ThudError("invalid", `${call}: its kind is "${options.kind}"`);
    engine.exports.api_shape_defaults();
    fill(engine.slots, numbers);
    try {
      this.onBody(`api_${kind}_create`, body, ...args);
    } catch (refused) {
      throw blame(refused, call, options, SHAPE_RANGES[kind], this.lengthScale);
    }
    this.shapesRevision++;
    return shapeAt(engine.slots, HandleAt.index1);
  }
}
