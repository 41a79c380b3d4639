/**
 * A world: bodies and shapes that advance in fixed steps. Handles are checked by the engine in
 * every call; a stale one throws, as does whatever is out of range, and nothing has changed then.
 * Built in layers, each in a file of its own: world-base (its life, time and settings),
 * world-queries, world-views (what is read of it), world-joints, world-edits, world-forces,
 * world-fields, world-lists, and here what is put into it.
 */
import { ThudError } from "./error.js";
import {
  BODY_OPTIONS,
  BodyStateAt,
  FootAt,
  GroundAt,
  HandleAt,
  SHAPE_OPTIONS,
  ShapeStateAt,
  TerrainAt,
} from "./generated/slots.js";
import { checkNames } from "./names.js";
import {
  bodyAt,
  fill,
  FORMS,
  indexOf,
  numbersOf,
  rowsOf,
  shapeAt,
  vecAt,
} from "./numbers.js";
import {
  BODY_KINDS,
  type BodyId,
  type BodyOptions,
  type BodyState,
  type BoxOptions,
  type CircleOptions,
  type Foot,
  type Ground,
  type JointId,
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

export class World extends WorldLists {
  // ---- bodies ----

  /**
   * A body, with the shapes that are named. Without any it moves, and meets nothing, until it has
   * one. Where one of them is refused nothing is left of the body.
   * @example const ball = world.createBody({ kind: "dynamic", position: [0, 5] })
   */
  createBody(options: BodyOptions = {}): BodyId {
    const { engine } = this;
    const numbers = numbersOf("body", options, BODY_OPTIONS, ["shapes"]);
    engine.exports.api_body_defaults();
    fill(engine.slots, numbers);
    engine.check(engine.exports.api_body_create(this.address));
    this.shapesRevision++;
    const body = bodyAt(engine.slots, HandleAt.index1);
    try {
      for (const shape of options.shapes ?? []) this.#createKind(body, shape);
    } catch (refused) {
      this.destroy(body);
      throw refused;
    }
    return body;
  }

  /**
   * Removes a body with its shapes and joints, or one shape, or one joint.
   * @example world.destroy(ball)
   */
  destroy(id: BodyId | ShapeId | JointId): void {
    const destroy = this.engine.exports[`api_${id.kind}_destroy`];
    this.engine.check(destroy(this.address, id.index + 1, id.generation));
    if (id.kind !== "joint") this.shapesRevision++;
  }

  /** False once it was destroyed, or broke. */
  isValid(id: BodyId | ShapeId | JointId): boolean {
    const isValid = this.engine.exports[`api_${id.kind}_is_valid`];
    return isValid(this.address, id.index + 1, id.generation) !== 0;
  }

  /**
   * Where a body is, how fast, its mass.
   * @example world.bodyState(ball).position
   */
  bodyState(body: BodyId): BodyState {
    this.onBody("api_body_get", body);
    const s = this.engine.slots;
    return {
      kind: BODY_KINDS[s[BodyStateAt.kind]],
      position: vecAt(s, BodyStateAt.position),
      center: vecAt(s, BodyStateAt.center),
      angle: s[BodyStateAt.angle],
      velocity: vecAt(s, BodyStateAt.velocity),
      angularVelocity: s[BodyStateAt.angularVelocity],
      mass: s[BodyStateAt.mass],
      inertia: s[BodyStateAt.inertia],
      gravityScale: s[BodyStateAt.gravityScale],
      awake: s[BodyStateAt.awake] !== 0,
      enabled: s[BodyStateAt.enabled] !== 0,
      quarantined: s[BodyStateAt.quarantined] !== 0,
      userData: s[BodyStateAt.userData],
      shapeCount: s[BodyStateAt.shapeCount],
    };
  }

  /**
   * Puts a body elsewhere at once, without a motion in between; radians.
   * @example world.setTransform(ball, [0, 5], 0)
   */
  setTransform(body: BodyId, position: Vec2, angle = 0): void {
    this.onBody("api_body_set_transform", body, position[0], position[1], angle);
  }

  /**
   * Sets the velocity of the centre of mass, length/s, and the angular one, radians/s. Wakes it.
   * @example world.setVelocity(ball, [3, 0])
   */
  setVelocity(body: BodyId, velocity: Vec2, angularVelocity = 0): void {
    this.onBody("api_body_set_velocity", body, velocity[0], velocity[1], angularVelocity);
  }

  /**
   * Pushes at once: mass times length/s, at a place in the world. Wakes it.
   * @example world.applyImpulse(ball, [0, 5], point)
   */
  applyImpulse(body: BodyId, impulse: Vec2, point: Vec2): void {
    this.onBody("api_body_apply_impulse", body, impulse[0], impulse[1], point[0], point[1]);
  }

  /**
   * Pushes through the next step only, at the centre of mass.
   * @example world.applyForce(ball, [10, 0])
   */
  applyForce(body: BodyId, force: Vec2, torque = 0): void {
    this.onBody("api_body_apply_force", body, force[0], force[1], torque);
  }

  /** Wakes a body. False: it counts as at rest, and sleeps as soon as its whole island does. */
  setAwake(body: BodyId, awake: boolean): void {
    this.onBody("api_body_set_awake", body, Number(awake));
  }

  /**
   * False takes the body and its shapes out of the world: nothing moves, meets or finds them. True
   * brings it back, where it is and at the velocity it had.
   */
  setEnabled(body: BodyId, enabled: boolean): void {
    this.onBody("api_body_set_enabled", body, Number(enabled));
    this.shapesRevision++;
  }

  /** The shapes of a body. */
  shapesOf(body: BodyId): ShapeId[] {
    this.onBody("api_body_shapes", body);
    return this.shapeIds();
  }

  // ---- shapes ----

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
    const kind = indexOf(TERRAIN_KINDS, terrain.kind, "terrain kind");
    checkNames("terrain", terrain, TERRAINS[terrain.kind]);
    const create = (points: number, count: number, slope: number, x0: number, spacing: number) =>
      this.#createShape(
        "terrain",
        options,
        FORMS.terrain,
        body,
        kind,
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

  #createKind(body: BodyId, shape: SolidOptions): ShapeId {
    if (shape.kind === "circle") return this.createCircle(body, shape);
    if (shape.kind === "aabb") return this.createAabb(body, shape);
    if (shape.kind === "obb") return this.createObb(body, shape);
    throw new ThudError("invalid", `shapes: a shape's kind is circle, aabb or obb`);
  }

  #createSolid(
    kind: Exclude<ShapeKind, "terrain">,
    body: BodyId,
    options: ShapeOptions & { offset?: Vec2 },
  ): ShapeId {
    const [x, y] = options.offset ?? [0, 0];
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
    const numbers = numbersOf(kind, options, SHAPE_OPTIONS, others);
    if ((options.kind ?? kind) !== kind)
      throw new ThudError("invalid", `${kind}: its kind is "${options.kind}"`);
    engine.exports.api_shape_defaults();
    fill(engine.slots, numbers);
    this.onBody(`api_${kind}_create`, body, ...args);
    this.shapesRevision++;
    return shapeAt(engine.slots, HandleAt.index1);
  }
}
