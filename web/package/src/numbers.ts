/** How options become the numbers that the module takes, and numbers from it become handles. */
import { ThudError } from "./error.js";
import { FILTER_OPTIONS, ListAt, QUALITY_OPTIONS } from "./generated/slots.js";
import { checkNames } from "./checks/names.js";
import { COVERS } from "./fields/field-types.js";
import { generationOf, index1Of } from "./plain/handles.js";
import { MEETINGS } from "./rules/rule-types.js";
import type { QueryFilter, SolidShape } from "./query-types.js";
import {
  BODY_KINDS,
  type BodyId,
  BROADPHASES,
  DETECTIONS,
  type JointId,
  QUALITIES,
  type Quality,
  type QualityOptions,
  type ShapeId,
  type ShapeKind,
  type Vec2,
} from "./types.js";

type Numbers = Float64Array | Float32Array | Uint32Array;

/** Options that are one of several words. */
const WORDS: Readonly<Record<string, readonly string[]>> = {
  kind: BODY_KINDS,
  detection: DETECTIONS,
  broadphase: BROADPHASES,
  base: QUALITIES,
  cover: COVERS,
  meeting: MEETINGS,
};

/**
 * The number of every option in `names`, in that order; undefined where it is not given. A dot
 * after a name stands for the second number of a pair. Throws for options that are neither in
 * `names` nor in `others`, which the caller reads itself; `what` is told then.
 */
export function numbersOf(
  what: string,
  options: object,
  names: readonly string[],
  others: readonly string[] = [],
): (number | undefined)[] {
  checkNames(what, options, names, others);
  const given = options as Readonly<Record<string, unknown>>;
  const numbers: (number | undefined)[] = [];
  for (let i = 0; i < names.length; i++) {
    const value = given[names[i]];
    const isPair = names[i + 1] === ".";
    if (isPair && value === null)
      throw new ThudError("invalid", `${what}: ${names[i]} must be two numbers: null`);
    if (value === undefined) numbers.push(undefined);
    else numbers.push(numberOf(what, names[i], isPair ? (value as Vec2)[0] : value));
    if (!isPair) continue;
    numbers.push(value === undefined ? undefined : Number((value as Vec2)[1]));
    i++;
  }
  return numbers;
}

function numberOf(what: string, name: string, value: unknown): number | undefined {
  if (typeof value === "number" && name !== "userData") return value;
  if (name === "userData") return userData(value as number, `${what}: userData`);
  return WORDS[name] ? indexOf(WORDS[name], value as string, `${what}: ${name}`) : Number(value);
}

/**
 * Writes those that are given to the slots, in the order of `names`, over the defaults that are there;
 * otherwise as `numbersOf`, and without a list in between.
 */
export function writeOptions(
  what: string,
  slots: Float64Array,
  options: object,
  names: readonly string[],
  others: readonly string[],
): void {
  checkNames(what, options, names, others);
  const given = options as Readonly<Record<string, unknown>>;
  for (let i = 0; i < names.length; i++) {
    const value = given[names[i]];
    const isPair = names[i + 1] === ".";
    if (value === undefined) {
      if (isPair) i++;
      continue;
    }
    if (!isPair) {
      slots[i] = numberOf(what, names[i], value) ?? NaN;
      continue;
    }
    if (value === null)
      throw new ThudError("invalid", `${what}: ${names[i]} must be two numbers: null`);
    slots[i] = Number((value as Vec2)[0]);
    slots[++i] = Number((value as Vec2)[1]);
  }
}

const QUALITY = ["base", ...QUALITY_OPTIONS] as const;

/** Its base's number, and what an object changes of that, in the order of QUALITY. */
export function qualityNumbers(
  quality: Quality | QualityOptions = "default",
): [base: number, ...changes: (number | undefined)[]] {
  const options: QualityOptions = typeof quality === "string" ? { base: quality } : quality;
  if (typeof quality === "string") indexOf(QUALITIES, quality, "quality");
  const [base = QUALITIES.indexOf("default"), ...changes] = numbersOf("quality", options, QUALITY);
  return [base, ...changes];
}

export function bodyId(index1: number, generation: number): BodyId {
  return Object.freeze({ kind: "body", index: index1 - 1, generation });
}

export function shapeId(index1: number, generation: number): ShapeId {
  return Object.freeze({ kind: "shape", index: index1 - 1, generation });
}

export function jointId(index1: number, generation: number): JointId {
  return Object.freeze({ kind: "joint", index: index1 - 1, generation });
}

/** Of two numbers among slots or in a row. */
export function bodyAt(numbers: Numbers, at: number): BodyId {
  return bodyId(numbers[at], numbers[at + 1]);
}

export function shapeAt(numbers: Numbers, at: number): ShapeId {
  return shapeId(numbers[at], numbers[at + 1]);
}

export function jointAt(numbers: Numbers, at: number): JointId {
  return jointId(numbers[at], numbers[at + 1]);
}

export function vecAt(numbers: Numbers, at: number): Vec2 {
  return [numbers[at], numbers[at + 1]];
}

/** Kind, half extents (a circle's radius is the first) and angle, as the module takes them. */
export type SolidNumbers = [kind: number, hx: number, hy: number, angle: number];

const SOLID_KINDS = ["circle", "aabb", "obb"] as const;

/** What gives a shape of each kind its form, after the kind. */
export const FORMS: Readonly<Record<ShapeKind, readonly string[]>> = {
  circle: ["kind", "radius"],
  aabb: ["kind", "halfWidth", "halfHeight"],
  obb: ["kind", "halfWidth", "halfHeight", "angle"],
  terrain: ["kind"],
};

/** `others` is what a shape may have beside its form. */
export function solidNumbers(shape: SolidShape, others: readonly string[] = []): SolidNumbers {
  const kind = indexOf(SOLID_KINDS, shape.kind, "shape kind");
  checkNames(shape.kind, shape, FORMS[shape.kind], others);
  if (shape.kind === "circle") return [kind, shape.radius, 0, 0];
  return [kind, shape.halfWidth, shape.halfHeight, shape.kind === "obb" ? shape.angle : 0];
}

/** Overwrites those of the slots from `at` on whose option is given. */
export function fill(slots: Float64Array, options: readonly (number | undefined)[], at = 0): void {
  for (let i = 0; i < options.length; i++) {
    const value = options[i];
    if (value !== undefined) slots[at + i] = value;
  }
}

export function indexOf<T extends string>(names: readonly T[], name: T, what: string): number {
  const index = names.indexOf(name);
  if (index < 0)
    throw new ThudError("invalid", `${what} "${name}" is none of ${names.join(", ")}`);
  return index;
}

export function userData(value: number | undefined, what = "userData"): number | undefined {
  if (value !== undefined && !(Number.isSafeInteger(value) && value >= 0))
    throw new ThudError("invalid", `${what} must be a whole number from 0 to 2^53 - 1: ${value}`);
  return value;
}

/** In the order of filter_options. */
export function filterNumbers(filter: QueryFilter): number[] {
  const numbers = numbersOf("filter", filter, FILTER_OPTIONS, ["ignore"]);
  const [category = 0xffffffff, mask = 0xffffffff, sensors = 0, group = 0] = numbers;
  const { ignore } = filter;
  const handle = ignore ? [index1Of(ignore), generationOf(ignore) >>> 0] : [0, 0];
  return [category, mask, sensors, group, ...handle];
}

interface ViewClass<T> {
  new (buffer: ArrayBuffer, address: number, length: number): T;
}

/** A view into memory; where there is nothing to see, its address may be anything. */
export function view<T>(
  View: ViewClass<T>,
  buffer: ArrayBuffer,
  address: number,
  length: number,
): T {
  return new View(buffer, length === 0 ? 0 : address, length);
}

/** What `read` makes of each row, from `at` on, of a list that the slots tell of. */
export function rowsOf<N extends Numbers, T>(
  View: ViewClass<N>,
  buffer: ArrayBuffer,
  slots: Float64Array,
  list: number,
  length: number,
  read: (rows: N, at: number) => T,
): T[] {
  const count = slots[list + ListAt.count];
  const rows = view(View, buffer, slots[list + ListAt.address], length * count);
  return Array.from({ length: count }, (_, i) => read(rows, length * i));
}
