/**
 * The shapes of everything that goes into a world and comes out of it. Units are the caller's own
 * (metres, pixels); y is up, angles are radians counter-clockwise, masses are density times area.
 */

export type Vec2 = readonly [x: number, y: number];

/** Names a body. `index` is its slot: its pose stands at `4 * index` in `World.poses()`. */
export interface BodyId {
  readonly kind: "body";
  readonly index: number;
  readonly generation: number;
}

/** Names a shape of a body. */
export interface ShapeId {
  readonly kind: "shape";
  readonly index: number;
  readonly generation: number;
}

export const DETECTIONS = ["overlap", "continuous", "bisect", "swept"] as const;
/**
 * How moving shapes are tested: where they stand at the start of a step ("overlap"); that, and fast
 * ones stop at static shapes ("continuous"); taken back to their collisions ("bisect"); or moved
 * from collision to collision ("swept"). docs/catalogue.md has what each costs and gets wrong.
 */
export type Detection = (typeof DETECTIONS)[number];

export const BROADPHASES = ["grid", "sweep", "all"] as const;
/** How pairs that may touch are found. */
export type Broadphase = (typeof BROADPHASES)[number];

export const QUALITIES = ["draft", "default", "high", "exact"] as const;
/** 2, 4, 8 or 16 substeps a step. */
export type Quality = (typeof QUALITIES)[number];

export const BODY_KINDS = ["static", "kinematic", "dynamic"] as const;
export type BodyKind = (typeof BODY_KINDS)[number];

export const SHAPE_KINDS = ["circle", "aabb", "obb", "terrain"] as const;
export type ShapeKind = (typeof SHAPE_KINDS)[number];

export interface WorldOptions {
  /** Length/s². Default [0, -10]. */
  gravity?: Vec2;
  /** Seconds, (0, 1]. Default 1/60. */
  timeStep?: number;
  /** The size of a typical body in your unit; every tolerance is a multiple of it. Default 1. */
  lengthScale?: number;
  quality?: Quality;
  /** For experts: 1 to 64; 0, the default, takes the quality's. */
  substeps?: number;
  /** For experts: contact frequency over substep rate, [0.01, 0.5]; 0 takes the default. */
  contactStiffness?: number;
  /** For experts: damping ratio, [0, 100]; 0 takes the default. */
  contactDamping?: number;
  /** Highest speed at which overlap is pushed apart, in length scales per second. */
  pushSpeed?: number;
  /** Slower approaches do not bounce, in length scales per second. */
  restitutionThreshold?: number;
  /** Faster approaches are hit events, in length scales per second. */
  hitSpeed?: number;
  /** In length scales per second. */
  maximumSpeed?: number;
  /** Default true. */
  sleeping?: boolean;
  /** How moving shapes are tested. Default: as the quality says. */
  detection?: Detection;
  /** How pairs are found; all find the same. Default "grid". */
  broadphase?: Broadphase;
  /** Collect begin, end and hit events. Default true. */
  contactEvents?: boolean;
  /** Measure the time of every stage of the step. Default false. */
  timed?: boolean;
  /**
   * Seconds, up to 1. Where steps take longer, substeps are halved, and doubled again when there is
   * time: the clock then decides what happens, and runs differ. Default 0, none.
   */
  timeBudget?: number;
  /**
   * A length: islands in which something overlaps by more are solved directly, from the next step on
   * and for as long as they do. Default 0, none.
   */
  maxError?: number;
}

export interface BodyOptions {
  /** Default "static". */
  kind?: BodyKind;
  position?: Vec2;
  angle?: number;
  velocity?: Vec2;
  angularVelocity?: number;
  gravityScale?: number;
  linearDamping?: number;
  angularDamping?: number;
  fixedRotation?: boolean;
  maySleep?: boolean;
  /** How its motion is tested. Default: as the world. */
  detection?: Detection;
  /** A whole number from 0 to 2⁵³ - 1. */
  userData?: number;
}

export interface ShapeOptions {
  /** Default 1. */
  density?: number;
  /** Default 0.6; a pair's is the geometric mean. */
  friction?: number;
  /** [0, 1]. Default 0; a pair's is the larger. */
  restitution?: number;
  /**
   * A second, along the surface, clockwise about the shape: to +x on its top, as a conveyor belt runs.
   * Default 0; a pair's is the sum.
   */
  surfaceSpeed?: number;
  /** What it is: bits. Default 1. */
  category?: number;
  /** What it meets: bits. Default all. */
  mask?: number;
  /** Two of one group: above 0 they always meet, below 0 never. Default 0, no group. */
  group?: number;
  /** Reports overlaps and collides with nothing. */
  sensor?: boolean;
  /** A whole number from 0 to 2⁵³ - 1. */
  userData?: number;
}

export interface CircleOptions extends ShapeOptions {
  radius: number;
  /** In the body's frame. Default [0, 0]. */
  offset?: Vec2;
}

export interface BoxOptions extends ShapeOptions {
  halfWidth: number;
  halfHeight: number;
  offset?: Vec2;
}

export interface ObbOptions extends BoxOptions {
  /** In the body's frame. Default 0. */
  angle?: number;
}

/** A ground line, one-sided: solid below. Coordinates are relative to the body's origin. */
export type Terrain =
  | { kind: "flat"; slope?: number }
  | { kind: "uniform"; x0: number; spacing: number; heights: ArrayLike<number> }
  | { kind: "irregular"; points: ArrayLike<Vec2> };

/** The ground at one x. */
export interface Ground {
  height: number;
  normal: Vec2;
  /** Between the vertices `segment` and `segment + 1`; 0 for flat ground. */
  segment: number;
  /** Of those two vertices, for whatever a game keeps at them, as texture coordinates; they sum to 1. */
  weights: Vec2;
}

/** Where a foot comes to stand. */
export interface Foot {
  /** Of the highest ground under the sole. */
  height: number;
  /** Where that is. */
  x: number;
  /** Of the straight line between the ground under the sole's two ends. */
  normal: Vec2;
}

export interface BodyState {
  kind: BodyKind;
  position: Vec2;
  /** Centre of mass. */
  center: Vec2;
  angle: number;
  velocity: Vec2;
  angularVelocity: number;
  mass: number;
  inertia: number;
  gravityScale: number;
  awake: boolean;
  enabled: boolean;
  /** Frozen because it became non-finite. */
  quarantined: boolean;
  userData: number;
  shapeCount: number;
}

export interface ShapeState {
  kind: ShapeKind;
  body: BodyId;
  offset: Vec2;
  /** A circle's radius is the first. */
  halfExtents: Vec2;
  angle: number;
  density: number;
  friction: number;
  restitution: number;
  surfaceSpeed: number;
  category: number;
  mask: number;
  group: number;
  sensor: boolean;
  userData: number;
}

export interface QueryFilter {
  category?: number;
  mask?: number;
  /** Find sensors too. Default false. */
  sensors?: boolean;
}

export interface RayHit {
  shape: ShapeId;
  point: Vec2;
  normal: Vec2;
  /** Of the translation, 0 to 1. */
  fraction: number;
  /** Of the overlap with a shape that is met at 0; else, and of rays, 0. */
  depth: number;
}

/** A shape that asks or moves. */
export type SolidShape =
  | { kind: "circle"; radius: number }
  | { kind: "aabb"; halfWidth: number; halfHeight: number }
  | { kind: "obb"; halfWidth: number; halfHeight: number; angle: number };

export interface ClosestHit {
  shape: ShapeId;
  /** Of its surface, the closest. */
  point: Vec2;
  /** Outward. */
  normal: Vec2;
  /** Negative: so deep inside, by the shortest way out. */
  distance: number;
}

/** A character; lengths are in your own unit. */
export interface MoverOptions {
  shape: SolidShape;
  position: Vec2;
  /** Unit; [0, 0] for a game seen from above, which has no ground. Default [0, 1]. */
  up?: Vec2;
  /** Kept free between it and what it meets. Default 2 % of the smallest half extent. */
  skin?: number;
  /** Radians, 0 to 1.55; steeper ground is a wall. Default 0.9. */
  maxSlope?: number;
  /** Default 60 % of the half height. */
  stepHeight?: number;
  /** How far the ground may fall away under a step. Default as stepHeight. */
  snapDistance?: number;
  /** Most force on a dynamic body in the way. Default 0. */
  pushForce?: number;
  /** A kinematic body about its centre that follows it, so that dynamic bodies meet it. */
  body?: BodyId;
  filter?: QueryFilter;
  /** Bits: shapes of these categories are passed from below and stood on. Default none. */
  oneWay?: number;
}

export interface MoverHit {
  shape: ShapeId;
  body: BodyId;
  point: Vec2;
  normal: Vec2;
  depth: number;
}

export interface MoverReport {
  position: Vec2;
  /** What it stands on. */
  ground: { normal: Vec2; shape: ShapeId; body: BodyId; velocity: Vec2 } | null;
  /** What is left of the velocity that was asked for. */
  velocity: Vec2;
  /** Of the deepest overlap left where something closed in; mostly 0. */
  depth: number;
  hits: MoverHit[];
}

/** What to look for with `World.overlap`. */
export type OverlapQuery =
  | { kind: "bounds"; lower: Vec2; upper: Vec2 }
  | { kind: "circle"; center: Vec2; radius: number }
  | { kind: "aabb"; center: Vec2; halfWidth: number; halfHeight: number }
  | { kind: "obb"; center: Vec2; halfWidth: number; halfHeight: number; angle: number };

export interface ContactEvent {
  a: ShapeId;
  b: ShapeId;
}

export interface HitEvent extends ContactEvent {
  point: Vec2;
  /** From a to b. */
  normal: Vec2;
  /** Of approach. */
  speed: number;
}

/** Events of the last step, in a deterministic order. */
export interface Events {
  begin: ContactEvent[];
  end: ContactEvent[];
  /** `a` is the sensor. */
  sensorBegin: ContactEvent[];
  sensorEnd: ContactEvent[];
  hit: HitEvent[];
  quarantined: BodyId[];
}

export interface Stats {
  steps: number;
  bodies: number;
  shapes: number;
  awakeBodies: number;
  pairs: number;
  /** Touching pairs. */
  contacts: number;
  colours: number;
  blocks: number;
  /** Memory held by the world. */
  bytes: number;
  /** Allocations made by the last step. */
  stepAllocations: number;
  /** Of the last step; fewer than the quality's where the time budget is short. */
  substeps: number;
  /** Of the last step; 0 unless the world is timed or has a time budget. */
  stepSeconds: number;
  stageSeconds: Readonly<Record<string, number>>;
}

/** What the last step got wrong, of the contacts that are awake. */
export interface StepError {
  /** Over the points of touching pairs, at the end of the step. */
  penetrationMax: number;
  penetrationMean: number;
  /** Fastest approach at a contact that the solver's last pass still met, and took away. */
  residual: number;
  /**
   * Of kinetic and potential energy. Negative where friction, damping and restitution take some;
   * positive is energy that nobody put in, or that forces, kinematic bodies and moving surfaces did.
   */
  energyChange: number;
  /** Points deeper than 0.005 length scales. */
  overlaps: number;
}

/** Error and energy of the present state. */
export interface Measure {
  penetrationMax: number;
  penetrationMean: number;
  kineticEnergy: number;
  potentialEnergy: number;
}

/** Every shape at once, for drawing. The arrays are views into wasm memory: see `poses()`. */
export interface ShapeTable {
  readonly count: number;
  /**
   * Ten numbers a shape: body slot, shape kind, body kind, sensor, offset x and y, half extents x
   * and y, cosine and sine in the body's frame.
   */
  readonly rows: Float32Array;
  /** Four numbers a shape: index1 and generation of the shape, and of its body. */
  readonly handles: Uint32Array;
}

/** Shapes to leave out or put in with `World.debugDraw`. */
export interface DrawOptions {
  shapes?: boolean;
  bounds?: boolean;
  cells?: boolean;
  contacts?: boolean;
  islands?: boolean;
  /** The sorted intervals of a plane sweep, at the lower edge. */
  axes?: boolean;
  /** Lines between shapes whose bounds overlap. */
  pairs?: boolean;
  /** The swept volumes of the last step, of what moved further than a quarter of its size. */
  motions?: boolean;
  /** Coordinates are relative to it. Default [0, 0]. */
  origin?: Vec2;
  lower: Vec2;
  upper: Vec2;
}

export const DRAW_STYLES = [
  "static",
  "kinematic",
  "dynamic",
  "sleeping",
  "sensor",
  "bounds",
  "cell",
  "contact",
  "normal",
  "interval",
  "interval overlapping",
  "pair",
  "pair touching",
  "motion",
] as const;

/** Views into wasm memory, valid until the next call of `debugDraw`. */
export interface DrawLists {
  /** Nine a shape: centre, half extents, cosine, sine, 1 if a circle, style, island. */
  readonly shapes: Float32Array;
  /** Five a line: both ends, style. */
  readonly lines: Float32Array;
  /** Three a point: place, style. */
  readonly points: Float32Array;
}
