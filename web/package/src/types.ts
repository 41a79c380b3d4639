/**
 * The options of worlds, bodies and shapes, and their states. Lengths are in a unit of the caller's
 * choice (metres, pixels), time is in seconds; y is up, angles are radians counter-clockwise,
 * masses are density times area. "Length scales" are multiples of WorldOptions.lengthScale. Numbers
 * are finite, and in the range that the comment names; each end of a range is allowed unless the
 * comment says "above", "below" or has a round bracket.
 */
export type Vec2 = readonly [x: number, y: number];

/** The handle of a body. `index` is its slot: its pose is at `4 * index` in `World.poses()`. */
export interface BodyId {
  readonly kind: "body";
  readonly index: number;
  readonly generation: number;
}

/** The handle of a shape. */
export interface ShapeId {
  readonly kind: "shape";
  readonly index: number;
  readonly generation: number;
}

/** The handle of a joint. */
export interface JointId {
  readonly kind: "joint";
  readonly index: number;
  readonly generation: number;
}

/** A list of the caller's, into which a call writes numbers from index 0 on. */
export type Into = number[] | Float64Array | Float32Array;

/** A body by its handle or by its number: see `numberOf`. */
export type BodyRef = BodyId | number;
/** A shape by its handle or by its number. */
export type ShapeRef = ShapeId | number;
/** A joint by its handle or by its number. */
export type JointRef = JointId | number;

export const DETECTIONS = ["overlap", "continuous", "bisect", "swept"] as const;
/**
 * How collisions of moving shapes are found. "overlap": shapes are tested at their poses at the
 * start of each step only. "continuous": as that, and fast bodies stop at static shapes for the
 * rest of the step. "bisect": pairs that overlap after the step's motion are moved back to the time
 * of their collision, by bisection. "swept": bodies move from one time of impact to the next.
 * A world that chooses "bisect" or "swept" solves islands without joints directly, at "draft" too,
 * within the quality's budget, so that what stands under "continuous" stands under them.
 *
 * docs/catalogue.md has the cost and the errors of each.
 */
export type Detection = (typeof DETECTIONS)[number];

export const BROADPHASES = [
  "grid",
  "sweep",
  "all",
  "sweep_y",
  "sweep_widest",
  "sweep_both",
] as const;
/**
 * How pairs of shapes whose bounds overlap are found: by a hashed grid, by sort and sweep along x
 * ("sweep"), along y ("sweep_y"), along the axis along which shapes are spread more widely
 * ("sweep_widest") or along both, of which each shape takes the one with fewer others to test
 * ("sweep_both"), or by a test of each shape against each ("all"), which is fast for a few shapes.
 * Results are the same.
 */
export type Broadphase = (typeof BROADPHASES)[number];

export const QUALITIES = ["draft", "default", "high", "exact"] as const;
/**
 * Sets of solver settings, from the fastest to the most accurate. docs/tradeoff.md has the cost and
 * the errors of each.
 *
 * - "draft": 2 substeps. A pyramid takes 0.6 times the default's time, and a column of 30 sinks
 *   4 times as deep.
 * - "default": 4 substeps; islands in which contacts would overlap too much under their load are
 *   solved directly (all their contacts as one system of equations), within a budget of work.
 * - "high": 8 substeps, and every island is solved directly, within a budget. A column of 30 at
 *   rest takes 6 times the default's time, a pyramid 15 times, and they do not sink.
 * - "exact": 16 substeps, every island is solved directly without a budget, and bodies are swept
 *   from impact to impact. The time of a step has no bound.
 */
export type Quality = (typeof QUALITIES)[number];

/** A quality with changes. Options that are not given are those of `base`. */
export interface QualityOptions {
  /** The quality that is changed. Default "default". */
  base?: Quality;
  /** The number of substeps of a step, whole, 1 to 64. */
  substeps?: number;
  /** The frequency of the contact springs over the substep rate, [0.01, 0.5]. */
  contactStiffness?: number;
  /** The damping ratio of the contact springs, [0, 100]. */
  contactDamping?: number;
  detection?: Detection;
  /**
   * Whether islands in which contacts would overlap too much are solved directly; `maxError` needs
   * it. False for "draft", else true.
   */
  islands?: boolean;
}

export const BODY_KINDS = ["static", "kinematic", "dynamic"] as const;
/**
 * "static": has no velocity, and moves by `setTransform` only. "kinematic": moves at the velocity
 * that is set; no force or contact changes it. "dynamic": moves by forces and contacts.
 */
export type BodyKind = (typeof BODY_KINDS)[number];

/** The kinds of shapes, in the order of thud_shape_kind. */
export const SHAPE_KINDS = ["circle", "aabb", "obb", "terrain"] as const;
/** A circle, an axis-aligned box, an oriented box, or a ground line. */
export type ShapeKind = (typeof SHAPE_KINDS)[number];

/** The options of `Engine.createWorld`. */
export interface WorldOptions {
  /** Gravity, length/s². Default [0, -10]. */
  gravity?: Vec2;
  /** The length of a step: seconds, (0, 1]. Default 1/60. */
  timeStep?: number;
  /**
   * The size of a typical body in your unit, 10⁻⁶ to 10⁶; every tolerance is a multiple of it.
   * Default 1.
   */
  lengthScale?: number;
  /** The solver settings, between speed and accuracy. Default "default". */
  quality?: Quality | QualityOptions;
  /** For experts: substeps of a step, 1 to 64; 0, the default, takes the quality's. */
  substeps?: number;
  /**
   * For experts: the frequency of the contact springs over the substep rate, [0.01, 0.5]; 0, the
   * default, takes the quality's.
   */
  contactStiffness?: number;
  /**
   * For experts: the damping ratio of the contact springs, [0, 100]; 0, the default, takes the
   * quality's.
   */
  contactDamping?: number;
  /**
   * The maximum speed at which overlapping shapes are separated: length scales per second, 0 to
   * 10⁶. Default 3.
   */
  pushSpeed?: number;
  /**
   * Pairs that approach more slowly do not bounce: length scales per second, 0 to 10⁶. Default 1.
   */
  restitutionThreshold?: number;
  /** Pairs that approach faster make hit events: length scales per second, 0 to 10⁶. Default 1. */
  hitSpeed?: number;
  /**
   * The maximum of x and of y of a body's velocity, each by itself: length scales per second, above
   * 0, up to 10⁶. After an impact within a step a body may be faster until the next one. Default:
   * 10⁶.
   */
  maximumSpeed?: number;
  /** Whether bodies at rest may sleep. Default true. */
  sleeping?: boolean;
  /** How collisions of moving shapes are found. Default: as the quality says. */
  detection?: Detection;
  /** How pairs are found; all broadphases find the same pairs. Default "grid". */
  broadphase?: Broadphase;
  /** Whether begin, end and hit events are collected; sensor events always are. Default true. */
  contactEvents?: boolean;
  /** Whether the time of every stage of the step is measured. Default false. */
  timed?: boolean;
  /**
   * The time that a step may take: seconds, 0 to 1. Where steps take longer, substeps are halved,
   * and doubled again where time allows; results then depend on the clock and differ from run to
   * run. Default 0, no budget.
   */
  timeBudget?: number;
  /**
   * A penetration depth, a length from 0 to 10⁹: an island with a contact that overlaps by more is
   * solved directly, from the next step on, until the soft solver keeps to it again. Default 0,
   * none.
   */
  maxError?: number;
  /**
   * The width of the cells of the broadphase "grid", for all shapes whose bounds fit into one: a
   * length from 0 to 16,384 length scales. Default 0: chosen by the sizes of the shapes, which is
   * faster in nearly all worlds. Results are the same.
   */
  cellSize?: number;
}

/** Callbacks of `World.advance` before and after each step. */
export interface StepCalls {
  /**
   * Called before each step. Forces that are applied in it act in that step alone; it is the place
   * for forces that depend on positions or velocities: wind, water, tyres, steering.
   */
  before?: () => void;
  /** Called after each step; `events` are then those of this step alone. */
  after?: () => void;
}

/** The options of `World.createBody`. */
export interface BodyOptions {
  /**
   * What moves the body: forces and contacts ("dynamic"), its own velocity alone ("kinematic"), or
   * nothing. Default "static".
   * @example kind: "dynamic"
   */
  kind?: BodyKind;
  /**
   * The place of its origin in the world, up to 10⁹ length scales away. Default [0, 0].
   * @example position: [0, 5]
   */
  position?: Vec2;
  /** Its angle: radians, up to 10⁶ either way; 0 for a body with an AABB or terrain. Default 0. */
  angle?: number;
  /**
   * The velocity of its centre of mass, length/s. Default [0, 0], as it must be of a static body.
   * @example velocity: [3, 0]
   */
  velocity?: Vec2;
  /** Its angular velocity, radians/s. Default 0, as it must be of a static body. */
  angularVelocity?: number;
  /** The factor of the world's gravity: a body with 0 floats. Default 1. */
  gravityScale?: number;
  /**
   * The damping of its velocity, 1/s, 0 or more: what is left of a velocity after t seconds is
   * exp(-damping * t) of it. Default 0.
   */
  linearDamping?: number;
  /** The damping of its angular velocity, 1/s, 0 or more. Default 0. */
  angularDamping?: number;
  /** Whether no torque turns it. Default false. */
  fixedRotation?: boolean;
  /**
   * The axes of the world along which a dynamic body does not move; see setLocks. Default none.
   * @example locks: { x: true }
   */
  locks?: Locks;
  /** Whether it may sleep once it is at rest. Default true. */
  maySleep?: boolean;
  /** How its collisions are found. Default: as the world's. */
  detection?: Detection;
  /**
   * Its shapes; more can be created, and any destroyed, later. Default none.
   * @example shapes: [{ kind: "circle", radius: 0.5 }]
   */
  shapes?: readonly SolidOptions[];
  /** For your own use: a whole number from 0 to 2⁵³ - 1. Default 0. */
  userData?: number;
}

/** Which shapes a shape collides with; see ShapeOptions for the three options. */
export interface Filter {
  category?: number;
  mask?: number;
  group?: number;
}

/** Whether a body is locked along each axis of the world. Default false, free. */
export interface Locks {
  x?: boolean;
  y?: boolean;
}

/** A mass that does not follow from the shapes of the body. */
export interface Mass {
  /** The mass, [10⁻³⁰, 10³⁰]. */
  mass: number;
  /**
   * The moment of inertia about the centre of mass, mass times length², [10⁻³⁰, 10³⁰]; or 0: no
   * torque turns the body.
   */
  inertia: number;
  /** The centre of mass in the body's frame, up to 16384 length scales. Default [0, 0]. */
  center?: Vec2;
}

/** The options of every kind of shape. */
export interface ShapeOptions {
  /** The density, mass per area, 0 to 10¹². Default 1. */
  density?: number;
  /**
   * The coefficient of friction, 0 to 10⁶. Default 0.6; a pair has the geometric mean of its two.
   */
  friction?: number;
  /**
   * The speed after a bounce over the speed before, [0, 1]. Default 0; a pair has the larger of its
   * two.
   * @example restitution: 0.5
   */
  restitution?: number;
  /**
   * The speed of the surface, as of a conveyor belt: length/s, clockwise about the shape, to +x on
   * its top, up to 10⁶ length scales a second either way. Default 0; a pair has the sum of its two.
   * @example surfaceSpeed: 2
   */
  surfaceSpeed?: number;
  /**
   * The categories that the shape belongs to: 32 bits. Two shapes collide where the category of
   * each is in the mask of the other. Default 1.
   */
  category?: number;
  /** The categories that the shape collides with: 32 bits. Default all. */
  mask?: number;
  /**
   * Two shapes of the same group always collide where it is above 0, never where it is below 0,
   * whatever category and mask are. A whole number of 32 bits. Default 0, no group.
   */
  group?: number;
  /** Whether the shape reports overlaps and collides with nothing; see Events. Default false. */
  sensor?: boolean;
  /** Whether contacts of the shape make events: begin, end, hit and sensor events. Default true. */
  events?: boolean;
  /** For your own use: a whole number from 0 to 2⁵³ - 1. Default 0. */
  userData?: number;
}

/** The options of a circle. Sizes are 10⁻⁴ to 16384 length scales, of static bodies up to 32000. */
export interface CircleOptions extends ShapeOptions {
  /** The kind, as `shapeStateOf` returns it; may be left out. */
  kind?: "circle";
  /**
   * The radius, a length.
   * @example radius: 0.5
   */
  radius: number;
  /**
   * Its centre in the body's frame. Default [0, 0].
   * @example offset: [0, 1]
   */
  offset?: Vec2;
}

/** The options of an AABB. Sizes are 10⁻⁴ to 16384 length scales, of static bodies up to 32000. */
export interface BoxOptions extends ShapeOptions {
  /** The kind, as `shapeStateOf` returns it; may be left out. */
  kind?: "aabb";
  /**
   * Half the width: the length from the centre to the right side.
   * @example halfWidth: 1
   */
  halfWidth: number;
  /**
   * Half the height: the length from the centre to the top.
   * @example halfHeight: 0.5
   */
  halfHeight: number;
  /**
   * Its centre in the body's frame. Default [0, 0].
   * @example offset: [0, 1]
   */
  offset?: Vec2;
}

/** The options of an OBB. */
export interface ObbOptions extends Omit<BoxOptions, "kind"> {
  /** The kind, as `shapeStateOf` returns it; may be left out. */
  kind?: "obb";
  /** Its angle in the body's frame: radians, up to 10⁶ either way. Default 0. */
  angle?: number;
}

/** A circle, an AABB or an OBB, by its kind. */
export type SolidOptions =
  | (CircleOptions & { kind: "circle" })
  | (BoxOptions & { kind: "aabb" })
  | (ObbOptions & { kind: "obb" });

/**
 * The line of a terrain, which is solid below. Coordinates are lengths relative to the body's
 * origin. "flat": a straight line through the origin, without ends, of this slope (dy/dx, up to 100
 * either way, default 0). "uniform": two or more heights at x0, x0 + spacing, and so on.
 * "irregular": two or more points with strictly increasing x.
 */
export type Terrain =
  | { kind: "flat"; slope?: number }
  | { kind: "uniform"; x0: number; spacing: number; heights: ArrayLike<number> }
  | { kind: "irregular"; points: ArrayLike<Vec2> };

/**
 * What the friction of a terrain is read from, in place of one friction for the whole line. Each
 * vertex has a value, and between two vertices both are weighted as in `Ground.weights`.
 */
export interface Texture {
  /**
   * One value for each vertex of the line; of a flat line two, at x = 0 and x = 1 from its origin.
   * Coefficients of friction from 0 to 10⁶; with a table texture coordinates u, up to 10⁹ either way.
   */
  vertices: ArrayLike<number>;
  /** The friction by texture coordinate, at equal distances of u: coefficients from 0 to 10⁶. */
  table?: ArrayLike<number>;
  /**
   * True: entry i of the table is at u = i / length, and from u = 1 on it begins again. False, the
   * default: entry i is at u = i / (length - 1), and the first and the last hold beyond.
   */
  repeats?: boolean;
}

/** The ground of a terrain at one x. */
export interface Ground {
  /** y of the ground, in the world. */
  height: number;
  /** Unit normal, upward. */
  normal: Vec2;
  /** The ground there lies between the vertices `segment` and `segment + 1`; 0 for flat ground. */
  segment: number;
  /**
   * The weights of those two vertices, to interpolate what a game keeps for them, such as texture
   * coordinates; their sum is 1.
   */
  weights: Vec2;
}

/** The place of a foot on a terrain. */
export interface Foot {
  /** y of the highest ground under the sole, in the world. */
  height: number;
  /** x of that place, in the world. */
  x: number;
  /** Unit normal of the straight line between the ground under the two ends of the sole. */
  normal: Vec2;
}

/** All values of a body, as `World.bodyStateOf` returns them. */
export interface BodyState {
  kind: BodyKind;
  /** The place of its origin in the world. */
  position: Vec2;
  /** The place of its centre of mass in the world. */
  center: Vec2;
  /** Its angle: radians, in (-π, π]. */
  angle: number;
  /** The velocity of its centre of mass, length/s. */
  velocity: Vec2;
  /** Its angular velocity, radians/s. */
  angularVelocity: number;
  /** Its mass: 0 unless dynamic; 1 for a dynamic body whose shapes have none. */
  mass: number;
  /** Its moment of inertia about the centre of mass; 0 where no torque turns it. */
  inertia: number;
  gravityScale: number;
  awake: boolean;
  enabled: boolean;
  /** Whether the engine stopped it because its position or velocity became non-finite. */
  quarantined: boolean;
  userData: number;
  shapeCount: number;
}

/**
 * The options of a shape as they are now, and its body. Without `body` they are options from which
 * another such shape can be made. `World.terrainOf` has the line of a terrain.
 */
export type ShapeState = { body: BodyId } & (
  | Required<CircleOptions>
  | Required<BoxOptions>
  | Required<ObbOptions>
  | ({ kind: "terrain" } & Required<ShapeOptions>)
);
