/**
 * What worlds, bodies and shapes are made of, and their state. Units are the caller's own
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

/** Names a joint. */
export interface JointId {
  readonly kind: "joint";
  readonly index: number;
  readonly generation: number;
}

/** Where numbers are written, from its beginning. */
export type Into = number[] | Float64Array | Float32Array;

/** A body by its handle or by its number: see `numberOf`. */
export type BodyRef = BodyId | number;
/** Likewise a shape. */
export type ShapeRef = ShapeId | number;
/** Likewise a joint. */
export type JointRef = JointId | number;

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
/**
 * The knob between speed and accuracy; docs/tradeoff.md has what each costs and gets wrong.
 *
 * - "draft": 2 substeps. A pyramid takes 0.6 times the default's time, and a column of 30 sinks
 *   4 times as deep.
 * - "default": 4 substeps; islands that the soft solver cannot hold are solved directly, all their
 *   contacts at once, if that is not too dear.
 * - "high": 8 substeps, and every island solved directly that is not too dear. A column of 30 at
 *   rest takes 6 times the default's time, a pyramid 19 times, and they do not sink.
 * - "exact": 16 substeps, every island solved directly whatever it takes, and bodies swept from
 *   impact to impact. Nothing bounds its time.
 */
export type Quality = (typeof QUALITIES)[number];

/** A quality with some of it changed. What is not named is as in `base`. */
export interface QualityOptions {
  /** Default "default". */
  base?: Quality;
  /** 1 to 64. */
  substeps?: number;
  /** Contact frequency over substep rate, [0.01, 0.5]. */
  contactStiffness?: number;
  /** Damping ratio of overlap that is pushed apart, [0, 100]. */
  contactDamping?: number;
  detection?: Detection;
  /**
   * Whether islands that the soft solver cannot hold are solved directly. False for "draft";
   * `maxError` needs it.
   */
  islands?: boolean;
}

export const BODY_KINDS = ["static", "kinematic", "dynamic"] as const;
export type BodyKind = (typeof BODY_KINDS)[number];

export const SHAPE_KINDS = ["circle", "aabb", "obb", "terrain"] as const;
export type ShapeKind = (typeof SHAPE_KINDS)[number];

export interface WorldOptions {
  /** Gravity, length/s². Default [0, -10]. */
  gravity?: Vec2;
  /** Seconds of a step, (0, 1]. Default 1/60. */
  timeStep?: number;
  /** The size of a typical body in your unit; every tolerance is a multiple of it. Default 1. */
  lengthScale?: number;
  /** The knob between speed and accuracy. Default "default". */
  quality?: Quality | QualityOptions;
  /** For experts: substeps, 1 to 64; 0, the default, takes the quality's. */
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
  /** Nothing moves faster, in length scales per second. */
  maximumSpeed?: number;
  /** Whether bodies at rest may sleep. Default true. */
  sleeping?: boolean;
  /** How moving shapes are tested. Default: as the quality says. */
  detection?: Detection;
  /** How pairs are found; all find the same. Default "grid". */
  broadphase?: Broadphase;
  /** Collect begin, end and hit events. Default true. Sensors report either way. */
  contactEvents?: boolean;
  /** Measure the time of every stage of the step. Default false. */
  timed?: boolean;
  /**
   * Seconds, up to 1. Where steps take longer, substeps are halved, and doubled again when there is
   * time: the clock then decides what happens, and runs differ. Default 0, none.
   */
  timeBudget?: number;
  /**
   * A length: islands in which something overlaps by more are solved directly, from the next step
   * on and for as long as they do. Default 0, none.
   */
  maxError?: number;
}

/** What `World.advance` calls around each step that it makes. */
export interface StepCalls {
  /**
   * Before each step: forces that are applied here act in that step alone. For what depends on where
   * bodies are and how they move: wind, water, tyres, steering.
   */
  before?: () => void;
  /** After each step; `events` are then those of this step alone. */
  after?: () => void;
}

export interface BodyOptions {
  /**
   * What moves it: pushes ("dynamic"), its own velocity alone ("kinematic"), or nothing. Default
   * "static".
   * @example kind: "dynamic"
   */
  kind?: BodyKind;
  /**
   * The place of its origin, up to 10⁹ length scales away. Default [0, 0].
   * @example position: [0, 5]
   */
  position?: Vec2;
  /** How far it is turned: radians, up to 10⁶ either way. Default 0. */
  angle?: number;
  /**
   * The velocity of its centre of mass, length/s. Default [0, 0], as it must be where static.
   * @example velocity: [3, 0]
   */
  velocity?: Vec2;
  /** How fast it turns, radians/s. Default 0, as it must be where static. */
  angularVelocity?: number;
  /** What it feels of the world's gravity: 0 floats. Default 1. */
  gravityScale?: number;
  /** What slows its motion, 1/s, 0 or more. Default 0. */
  linearDamping?: number;
  /** What slows its turning, 1/s, 0 or more. Default 0. */
  angularDamping?: number;
  /** Whether it never turns. Default false. */
  fixedRotation?: boolean;
  /**
   * Axes of the world that it does not move along, of a dynamic body; see setLocks. Default none.
   * @example locks: { x: true }
   */
  locks?: Locks;
  /** Whether it may sleep once it is at rest. Default true. */
  maySleep?: boolean;
  /** How its motion is tested. Default: as the world. */
  detection?: Detection;
  /**
   * Its shapes, which may be made and destroyed later, too. Default none.
   * @example shapes: [{ kind: "circle", radius: 0.5 }]
   */
  shapes?: readonly SolidOptions[];
  /** For your own use: a whole number from 0 to 2⁵³ - 1. */
  userData?: number;
}

/** What a shape is and meets; see ShapeOptions. */
export interface Filter {
  category?: number;
  mask?: number;
  group?: number;
}

/** Axes of the world; what is not named is free. */
export interface Locks {
  x?: boolean;
  y?: boolean;
}

/** What a body is given whatever its shapes weigh. */
export interface Mass {
  /** [10⁻³⁰, 10³⁰]. */
  mass: number;
  /** Mass times length², about the centre, likewise; or 0: it does not turn. */
  inertia: number;
  /** Of mass, in the body's frame. Default [0, 0]. */
  center?: Vec2;
}

export interface ShapeOptions {
  /** Mass per area, 0 or more. Default 1. */
  density?: number;
  /** Coefficient of friction, 0 or more. Default 0.6; a pair's is the geometric mean. */
  friction?: number;
  /**
   * How much it bounces, [0, 1]. Default 0; a pair's is the larger.
   * @example restitution: 0.5
   */
  restitution?: number;
  /**
   * The speed of a conveyor belt: length/s along the surface, clockwise about the shape, to +x on
   * its top. Default 0; a pair's is the sum.
   * @example surfaceSpeed: 2
   */
  surfaceSpeed?: number;
  /** What it is: bits. Default 1. */
  category?: number;
  /** What it meets: bits. Default all. */
  mask?: number;
  /** Two of one group: above 0 they always meet, below 0 never. Default 0, no group. */
  group?: number;
  /** Notes what is there and stops nothing; see Events. Default false. */
  sensor?: boolean;
  /** False: nothing that it does is told, be it touches, hits or sensors. Default true. */
  events?: boolean;
  /** For your own use: a whole number from 0 to 2⁵³ - 1. */
  userData?: number;
}

/** Sizes are from 10⁻⁴ to 16384 length scales, of static bodies to 32000. */
export interface CircleOptions extends ShapeOptions {
  /** As a state tells it; may be left out. */
  kind?: "circle";
  /**
   * From the centre to the rim.
   * @example radius: 0.5
   */
  radius: number;
  /**
   * Its centre in the body's frame. Default [0, 0].
   * @example offset: [0, 1]
   */
  offset?: Vec2;
}

/** Sizes are from 10⁻⁴ to 16384 length scales, of static bodies to 32000. */
export interface BoxOptions extends ShapeOptions {
  /** As a state tells it; may be left out. */
  kind?: "aabb";
  /**
   * From the centre to the right side.
   * @example halfWidth: 1
   */
  halfWidth: number;
  /**
   * From the centre to the top.
   * @example halfHeight: 0.5
   */
  halfHeight: number;
  /**
   * Its centre in the body's frame. Default [0, 0].
   * @example offset: [0, 1]
   */
  offset?: Vec2;
}

export interface ObbOptions extends Omit<BoxOptions, "kind"> {
  /** As a state tells it; may be left out. */
  kind?: "obb";
  /** How far it is turned in the body's frame, radians. Default 0. */
  angle?: number;
}

/** A circle or a box, by its kind. */
export type SolidOptions =
  | (CircleOptions & { kind: "circle" })
  | (BoxOptions & { kind: "aabb" })
  | (ObbOptions & { kind: "obb" });

/**
 * A ground line, one-sided: solid below. Coordinates are relative to the body's origin; the points
 * of an irregular line go from left to right, each strictly right of the one before.
 */
export type Terrain =
  | { kind: "flat"; slope?: number }
  | { kind: "uniform"; x0: number; spacing: number; heights: ArrayLike<number> }
  | { kind: "irregular"; points: ArrayLike<Vec2> };

/** The ground at one x. */
export interface Ground {
  height: number;
  /** Unit, upward. */
  normal: Vec2;
  /** Between the vertices `segment` and `segment + 1`; 0 for flat ground. */
  segment: number;
  /** Of those two vertices, to interpolate what a game keeps at them (texture); they sum to 1. */
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
  /** Of its origin. */
  position: Vec2;
  /** Centre of mass. */
  center: Vec2;
  /** Radians, in (-π, π]. */
  angle: number;
  /** Of the centre of mass, length/s. */
  velocity: Vec2;
  /** Radians/s. */
  angularVelocity: number;
  /** 0 unless dynamic; 1 for a dynamic body whose shapes have none. */
  mass: number;
  /** About the centre of mass; 0 where the body cannot turn. */
  inertia: number;
  gravityScale: number;
  awake: boolean;
  enabled: boolean;
  /** Frozen because it became non-finite. */
  quarantined: boolean;
  userData: number;
  shapeCount: number;
}

/**
 * What a shape was made with, and its body. Of a terrain `World.terrain` has the ground. Without
 * `body` it is what another like it can be made with.
 */
export type ShapeState = { body: BodyId } & (
  | Required<CircleOptions>
  | Required<BoxOptions>
  | Required<ObbOptions>
  | ({ kind: "terrain" } & Required<ShapeOptions>)
);
