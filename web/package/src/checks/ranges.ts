/**
 * The ranges of all options, and the search for the option that is out of range. The search runs
 * only after the engine refused a call, since the engine's message names a group of values: a call
 * that is accepted pays nothing for it. The ranges are those of engine/include/thud/thud_limits.h;
 * tests/web/package/ranges.test.mjs tries both ends of each.
 */
import { ThudError } from "../error.js";
import { isRefusal } from "./hook.js";
import { show } from "./show.js";

/** The range of an option. */
interface Range {
  /** The minimum. */
  readonly least: number;
  /** The maximum. */
  readonly most: number;
  /** The option is a pair of numbers, each in the range. */
  readonly pair?: boolean;
  /** The minimum itself is not allowed. */
  readonly above?: boolean;
  /** 0 is allowed, also where the minimum is above 0. */
  readonly orZero?: boolean;
  /** Minimum and maximum are in length scales of the world. */
  readonly scaled?: boolean;
  /** The option has no default: it must be given. */
  readonly needed?: boolean;
}

/** The ranges of the options of a call or an object, by the option's name. */
export type Ranges = Readonly<Record<string, Range>>;

/** The largest finite number in single precision. */
const FINITE = 3.4028234e38;
/** |x|, |y| of a place in the world, length scales (THUD_PLACE_MAX). */
const FARTHEST = 1e9;
export const PLACE: Range = { least: -FARTHEST, most: FARTHEST, pair: true, scaled: true };
/** The translation of a cast: at most from one end of the world to the other. */
export const WAY: Range = { ...PLACE, least: -2 * FARTHEST, most: 2 * FARTHEST };
/** Radians. */
export const ANGLE: Range = { least: -1e6, most: 1e6 };
/** A finite number, and two of them. */
export const ANY: Range = { least: -FINITE, most: FINITE };
export const VECTOR: Range = { ...ANY, pair: true };
export const POSITIVE: Range = { least: 0, most: FINITE };
/** Speeds of WorldOptions, length scales a second. */
const SPEED: Range = { least: 0, most: 1e6 };
/** The contact frequency over the substep rate; 0 takes the quality's. */
const STIFFNESS: Range = { least: 0.01, most: 0.5, orZero: true };
/** The damping ratio of contacts. */
const DAMPING: Range = { least: 0, most: 100 };
/** A length, length scales. */
const DISTANCE: Range = { least: 0, most: FARTHEST, scaled: true };
/** The density of air or water, mass per area. */
const FLUID: Range = { least: 0, most: 1e12 };
/** A coefficient of drag, lift or rolling resistance; in water 1/s. */
export const DRAG: Range = { least: 0, most: 1e6 };
/**
 * A radius or half extent. On a static body the engine accepts up to 32000 length scales; the
 * message names the smaller maximum of other bodies.
 */
export const SIZE: Range = { least: 1e-4, most: 16384, scaled: true, needed: true };
/** A radius or half extent of a shape without a body. */
const EXTENT: Range = { least: 0, most: FINITE, above: true, needed: true };

export const WORLD_RANGES: Ranges = {
  gravity: VECTOR,
  timeStep: { least: 0, most: 1, above: true },
  lengthScale: { least: 1e-6, most: 1e6 },
  substeps: { least: 0, most: 64 },
  contactStiffness: STIFFNESS,
  contactDamping: DAMPING,
  pushSpeed: SPEED,
  restitutionThreshold: SPEED,
  hitSpeed: SPEED,
  maximumSpeed: { ...SPEED, above: true },
  timeBudget: { least: 0, most: 1 },
  maxError: { least: 0, most: 1e9 },
  cellSize: { least: 0, most: 16384, scaled: true },
};

export const QUALITY_RANGES: Ranges = {
  substeps: { least: 1, most: 64, orZero: true },
  contactStiffness: STIFFNESS,
  contactDamping: DAMPING,
};

export const BODY_RANGES: Ranges = {
  position: PLACE,
  angle: ANGLE,
  velocity: VECTOR,
  angularVelocity: ANY,
  gravityScale: ANY,
  linearDamping: POSITIVE,
  angularDamping: POSITIVE,
};

/** The material of shapes. */
export const MATERIAL = {
  density: { least: 0, most: 1e12 },
  friction: { least: 0, most: 1e6 },
  restitution: { least: 0, most: 1 },
  surfaceSpeed: { least: -1e6, most: 1e6, scaled: true },
} satisfies Ranges;
/** A place in a body's frame, length scales. */
const OFFSET: Range = { least: -16384, most: 16384, pair: true, scaled: true };

export const RULE_RANGES: Ranges = {
  solidSide: VECTOR,
  friction: MATERIAL.friction,
  restitution: { least: 0, most: 4 },
  surfaceSpeed: MATERIAL.surfaceSpeed,
  eventImpulse: POSITIVE,
};

/** By the kind of the shape. */
export const SHAPE_RANGES: Readonly<Record<string, Ranges>> = {
  circle: { ...MATERIAL, offset: OFFSET, radius: SIZE },
  aabb: { ...MATERIAL, offset: OFFSET, halfWidth: SIZE, halfHeight: SIZE },
  obb: { ...MATERIAL, offset: OFFSET, angle: ANGLE, halfWidth: SIZE, halfHeight: SIZE },
  terrain: MATERIAL,
};

export const TERRAIN_RANGES: Ranges = {
  slope: ANY,
  x0: { ...ANY, needed: true },
  spacing: { ...ANY, least: 0, above: true, needed: true },
};

/** The numbers of a texture of the ground: THUD_TERRAIN_PLACE_MAX for texture coordinates. */
export const TEXTURE_RANGES = {
  friction: MATERIAL.friction,
  coordinate: { least: -1e9, most: 1e9 },
} satisfies Ranges;

export const MASS_RANGES: Ranges = {
  mass: { least: 1e-30, most: 1e30, needed: true },
  inertia: { least: 1e-30, most: 1e30, orZero: true, needed: true },
  center: OFFSET,
};

/** The arguments of queries. */
export const QUERY_RANGES: Ranges = {
  origin: PLACE,
  center: PLACE,
  point: PLACE,
  lower: PLACE,
  upper: PLACE,
  translation: WAY,
  maxDistance: DISTANCE,
};
/** The sizes of the shape that a query casts or tests, or of a mover, by its kind. */
export const ASKER_RANGES: Readonly<Record<string, Ranges>> = {
  circle: { radius: EXTENT },
  aabb: { halfWidth: EXTENT, halfHeight: EXTENT },
  obb: { halfWidth: EXTENT, halfHeight: EXTENT, angle: { ...ANGLE, needed: true } },
};

export const EXPLOSION_RANGES: Ranges = {
  center: PLACE,
  radius: DISTANCE,
  falloff: DISTANCE,
  impulse: { least: -1e15, most: 1e15 },
  rays: { least: 1, most: 16 },
};

export const WIND_RANGES: Ranges = { density: FLUID, drag: DRAG, lift: DRAG };

/** The velocity of wind or water, length/s. */
export const FLOW: Range = { least: -1e6, most: 1e6, pair: true, scaled: true };
export const WATER_RANGES: Ranges = {
  point: PLACE,
  normal: { least: -1, most: 1, pair: true },
  density: FLUID,
  flow: FLOW,
  linearDrag: DRAG,
  angularDrag: DRAG,
};

/** Mass times length/s². */
const FORCE: Range = { least: 0, most: 1e30 };
export const TYRE_RANGES: Ranges = {
  at: { ...PLACE, needed: true },
  steer: ANGLE,
  thrust: { ...FORCE, least: -1e30 },
  brake: FORCE,
  grip: { ...FORCE, needed: true },
};

/** The lengths of a mover are in the caller's unit, without regard to the length scale. */
export const MOVER_RANGES: Ranges = {
  skin: { least: 0, most: FINITE, above: true },
  maxSlope: { least: 0, most: 1.55 },
  stepHeight: { least: 0, most: 1e6 },
  snapDistance: { least: 0, most: 1e6 },
  pushForce: FORCE,
  up: { least: -1, most: 1, pair: true },
  position: { ...VECTOR, needed: true },
  gravityScale: ANY,
};
export const WALK_RANGES: Ranges = { speed: ANY, jump: POSITIVE };
export const MOVE_RANGES: Ranges = { velocity: VECTOR, dt: { least: 0, most: 1, above: true } };

/** The places of a joint in the world. */
export const JOINT_RANGES: Ranges = { at: PLACE, from: PLACE, to: PLACE };
export const FRAME_RANGES: Ranges = {
  position: { least: -1e6, most: 1e6, pair: true, scaled: true },
  angle: ANGLE,
};

/**
 * The error to throw in place of `error`: where the engine refused a value, one that names the
 * first of these options that is out of range, with its range; else `error` itself. `scale`: the
 * world's length scale. `path` precedes the names of nested options, as in "quality.".
 */
export function blame(
  error: unknown,
  call: string,
  options: object,
  ranges: Ranges,
  scale = 1,
  path = "",
): unknown {
  if (!isRefusal(error)) return error;
  const why = whyNot(options, ranges, scale, path);
  return why ? new ThudError("invalid", `${call}: ${why}`, { cause: error }) : error;
}

/** Why the first option that is out of range is refused, in words; null where all are in range. */
export function whyNot(options: object, ranges: Ranges, scale: number, path = ""): string | null {
  const given = options as Readonly<Record<string, unknown>>;
  for (const [name, range] of Object.entries(ranges)) {
    const value = given[name];
    if (value === undefined && !range.needed) continue;
    if (isWithin(value, range, scale)) continue;
    const told = value === undefined ? "it is missing" : show(value);
    const hint = range.pair && Object(value) === value && "x" in Object(value) ? "; write [x, y]" : "";
    return `${path}${name} must be ${inWords(range, scale)}: ${told}${hint}`;
  }
  return null;
}

/** Whether a value, or each of a pair, is a number in the range. */
function isWithin(value: unknown, range: Range, scale: number): boolean {
  if (!range.pair) return isNumberWithin(value, range, scale);
  const pair = value as ArrayLike<unknown> | null;
  return [0, 1].every((i) => isNumberWithin(pair?.[i], range, scale));
}

function isNumberWithin(value: unknown, range: Range, scale: number): boolean {
  if (typeof value !== "number") return false;
  const number = value;
  const unit = range.scaled ? scale : 1;
  if (range.orZero && number === 0) return true;
  const { least, most, above } = range;
  return number <= most * unit && (above ? number > least * unit : number >= least * unit);
}

/** The range as an error message prints it. */
function inWords({ least, most, pair, above, orZero, scaled }: Range, scale: number): string {
  const unit = scaled ? scale : 1;
  const [low, high] = [short(least * unit), short(most * unit)];
  if (least === -FINITE) return pair ? "two finite numbers" : "a finite number";
  if (above) return most === FINITE ? `above ${low}` : `above ${low} and at most ${high}`;
  if (most === FINITE) return `${low} or more`;
  return `${orZero ? "0, or " : ""}${pair ? "two numbers " : ""}from ${low} to ${high}`;
}

/** The number, from a million on with an exponent. */
function short(number: number): string {
  const size = Math.abs(number);
  return size >= 1e6 ? number.toExponential().replace("+", "") : String(number);
}

