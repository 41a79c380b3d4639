/**
 * Converts options to the numbers that the WebAssembly module takes, and the module's numbers to
 * handles, vectors and lists. Both pass through the slots: 64 doubles in the module's memory, laid
 * out in web/wasm/slots.h.
 */
import { ThudError } from "./error.js";
import { FILTER_OPTIONS, ListAt, QUALITY_OPTIONS } from "./generated/slots.js";
import { shown } from "./checks/hook.js";
import { checkOptions } from "./checks/names.js";
import { COVERS } from "./fields/field-types.js";
import { generationOf, index1Of, Kind } from "./plain/handles.js";
import { RULE_KINDS } from "./rules/rule-types.js";
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

/**
 * The options that are words, and the words of each in the order of the module's enum: the module
 * takes the word's index. `kind` is a body's (that of a rule is one of RULE_KINDS; the kind of a
 * shape or joint is no slot of its options and never comes here), `base` a quality's, `cover` an
 * explosion's.
 */
const WORDS: Readonly<Record<string, readonly string[]>> = {
  kind: BODY_KINDS,
  detection: DETECTIONS,
  broadphase: BROADPHASES,
  base: QUALITIES,
  cover: COVERS,
};

/**
 * The numbers of the options in `names`, in that order; undefined where an option is not given. "."
 * after a name stands for the second number of a pair. `others`: further options that the caller
 * reads itself. `what`: the call or the object that the options belong to, such as "createBody" or
 * "quality"; messages begin with it. Throws "invalid" for an unknown option, and for a value of the
 * wrong type where the checks of types are loaded (checks/hook.ts); elsewhere Number() converts it.
 */
export function numbersOf(
  what: string,
  options: object,
  names: readonly string[],
  others: readonly string[] = [],
): (number | undefined)[] {
  checkOptions(what, options, names, others);
  const given = options as Readonly<Record<string, unknown>>;
  const numbers: (number | undefined)[] = [];
  for (let i = 0; i < names.length; i++) {
    const value = given[names[i]];
    const isPair = names[i + 1] === ".";
    if (isPair && value === null)
      throw new ThudError("invalid", `${what}: ${names[i]} must be two numbers: null`);
    if (value === undefined) numbers.push(undefined);
    else numbers.push(numberOfOption(what, names[i], isPair ? (value as Vec2)[0] : value));
    if (!isPair) continue;
    numbers.push(value === undefined ? undefined : Number((value as Vec2)[1]));
    i++;
  }
  return numbers;
}

/**
 * The number of an option that is given: itself, the index of a word, or 0 or 1 of a flag. Throws
 * "invalid" for an unknown word, and for user data that are no whole number.
 */
function numberOfOption(what: string, name: string, value: unknown): number {
  if (typeof value === "number" && name !== "userData") return value;
  if (name === "userData") return userDataOf(value as number, `${what}: userData`);
  const words = what === "setRule" && name === "kind" ? RULE_KINDS : WORDS[name];
  return words ? indexOf(words, value as string, `${what}: ${name}`) : Number(value);
}

/**
 * Writes those options that are given, in the order of `names`, to the slots from 0 on. A slot
 * whose option is not given keeps the default that the caller has written there before. Otherwise
 * as `numbersOf`, but allocates no list.
 */
export function writeOptions(
  what: string,
  slots: Float64Array,
  options: object,
  names: readonly string[],
  others: readonly string[],
): void {
  checkOptions(what, options, names, others);
  const given = options as Readonly<Record<string, unknown>>;
  for (let i = 0; i < names.length; i++) {
    const value = given[names[i]];
    const isPair = names[i + 1] === ".";
    if (value === undefined) {
      if (isPair) i++;
      continue;
    }
    if (!isPair) {
      slots[i] = numberOfOption(what, names[i], value);
      continue;
    }
    if (value === null)
      throw new ThudError("invalid", `${what}: ${names[i]} must be two numbers: null`);
    slots[i] = Number((value as Vec2)[0]);
    slots[++i] = Number((value as Vec2)[1]);
  }
}

/** The options of a quality, as numbersOf takes them. */
const QUALITY = ["base", ...QUALITY_OPTIONS] as const;

/**
 * The index of the quality in QUALITIES, or of the one that QualityOptions start from, and the
 * values that replace some of its own, in the order of QUALITY_OPTIONS; undefined: its own value is
 * kept.
 */
export function qualityNumbers(
  quality: Quality | QualityOptions = "default",
): [base: number, ...changes: (number | undefined)[]] {
  const options: QualityOptions = typeof quality === "string" ? { base: quality } : quality;
  // Checked here as well, since the message of numbersOf would say "quality: base".
  if (typeof quality === "string") indexOf(QUALITIES, quality, "quality");
  const [base = QUALITIES.indexOf("default"), ...changes] = numbersOf("quality", options, QUALITY);
  return [base, ...changes];
}

/**
 * The handle of a body. `index1`, which the module counts with, is the index of the body's record
 * in its world plus 1; 0 stands for no body.
 */
export function bodyId(index1: number, generation: number): BodyId {
  return Object.freeze({ kind: "body", index: index1 - 1, generation });
}

export function shapeId(index1: number, generation: number): ShapeId {
  return Object.freeze({ kind: "shape", index: index1 - 1, generation });
}

export function jointId(index1: number, generation: number): JointId {
  return Object.freeze({ kind: "joint", index: index1 - 1, generation });
}

/** The handle whose index1 and generation are at `at` and `at` + 1 in the slots or in a row. */
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

/**
 * The first number of a pair; the caller reads the second. Throws "invalid" for a list of another
 * length. The length of a typed array is not checked, since programs keep further numbers in it.
 * Undefined, whatever the type says, for a value that is no pair: the module takes that as NaN and
 * refuses it. `name`: the argument, for the message.
 */
export function xOf(pair: Vec2, name: string): number {
  if (pair?.length !== 2 && Array.isArray(pair))
    throw new ThudError("invalid", `${name} must be two numbers: ${shown(pair)}`);
  return pair?.[0];
}

/** 1 for true, 0 for false. Throws "invalid" for a value that is no boolean. */
export function flagOf(flag: boolean, name: string): number {
  if (typeof flag !== "boolean")
    throw new ThudError("invalid", `${name} must be true or false: ${shown(flag)}`);
  return Number(flag);
}

/**
 * The numbers of a solid, a shape of any kind but terrain: the index of its kind in SOLID_KINDS,
 * half extents (of a circle: radius, 0), which are lengths, and angle in radians.
 */
export type SolidNumbers = [kind: number, hx: number, hy: number, angle: number];

/** In the order of thud_shape_kind (thud_geometry.h), which the module takes. */
const SOLID_KINDS = ["circle", "aabb", "obb"] as const;

/**
 * The options that give a shape of each kind its form. That of a terrain is no option of the shape:
 * createTerrain takes it as an argument.
 */
export const FORMS: Readonly<Record<ShapeKind, readonly string[]>> = {
  circle: ["kind", "radius"],
  aabb: ["kind", "halfWidth", "halfHeight"],
  obb: ["kind", "halfWidth", "halfHeight", "angle"],
  terrain: ["kind"],
};

/** The numbers of a solid. `others`: options that it may have beside its form. */
export function solidNumbers(shape: SolidShape, others: readonly string[] = []): SolidNumbers {
  const kind = indexOf(SOLID_KINDS, shape.kind, "shape kind");
  checkOptions(shape.kind, shape, FORMS[shape.kind], others);
  if (shape.kind === "circle") return [kind, shape.radius, 0, 0];
  return [kind, shape.halfWidth, shape.halfHeight, shape.kind === "obb" ? shape.angle : 0];
}

/** Writes the numbers in `options` that are not undefined to the slots from `at` on. */
export function fill(slots: Float64Array, options: readonly (number | undefined)[], at = 0): void {
  for (let i = 0; i < options.length; i++) {
    const value = options[i];
    if (value !== undefined) slots[at + i] = value;
  }
}

/** The index of a word in a list. Throws "invalid" where it is not there; `what`: the option. */
export function indexOf<T extends string>(names: readonly T[], name: T, what: string): number {
  const index = names.indexOf(name);
  if (index < 0)
    throw new ThudError("invalid", `${what} ${shown(name)} is none of ${names.join(", ")}`);
  return index;
}

/**
 * The value itself. Throws "invalid" unless it is undefined or a whole number from 0 to 2^53 - 1.
 * `what`: the option, for the message.
 */
export function userDataOf(value: number, what?: string): number;
export function userDataOf(value: number | undefined, what?: string): number | undefined;
export function userDataOf(value: number | undefined, what = "userData"): number | undefined {
  if (value !== undefined && !(Number.isSafeInteger(value) && value >= 0))
    throw new ThudError("invalid", `${what} must be a whole number from 0 to 2^53 - 1: ${shown(value)}`);
  return value;
}

/**
 * The numbers of a query's filter, in the order of `filter_options` in slots.h; the last two are
 * the handle of the body to ignore, 0 and 0 where there is none.
 */
export function filterNumbers(filter: QueryFilter): number[] {
  const numbers = numbersOf("filter", filter, FILTER_OPTIONS, ["ignore"]);
  const [category = 0xffffffff, mask = 0xffffffff, sensors = 0, group = 0] = numbers;
  const { ignore } = filter;
  // Unlike an argument of the module a slot is a double, where a generation has no sign.
  const handle = ignore ? [index1Of(ignore, Kind.body), generationOf(ignore) >>> 0] : [0, 0];
  return [category, mask, sensors, group, ...handle];
}

interface ViewClass<T> {
  new (buffer: ArrayBuffer, address: number, length: number): T;
}

/** A view into memory. Where it is empty the address is not used: it may be unaligned or null. */
export function view<T>(
  View: ViewClass<T>,
  buffer: ArrayBuffer,
  address: number,
  length: number,
): T {
  return new View(buffer, length === 0 ? 0 : address, length);
}

/**
 * Converts each row of a list in memory by `read`, which gets the rows and the index at which the
 * row begins. `list`: where the list's address and count are in the slots; `length`: numbers a row.
 */
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
