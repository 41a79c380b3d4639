/**
 * Handles as plain numbers: generation * 2²¹ + kind * 2¹⁹ + index + 1, which is exact in 53 bits.
 * The kind makes the number of a shape differ from that of a body. A program that keeps numbers
 * instead of handles makes no objects for the garbage collector.
 */
import { shown } from "../checks/hook.js";
import { ThudError } from "../error.js";
import type { BodyId, JointId, ShapeId } from "../types.js";

/** 2¹⁹: indices below it, half a million of each kind, have a number. */
const INDICES = 0x80000;
/** 2²¹, the factor of the generation. */
const GENERATIONS = 0x200000;

type Id = BodyId | ShapeId | JointId;

/** The kinds of handles, as they are encoded in numbers. */
export const enum Kind {
  body = 1,
  shape,
  joint,
}
/** The names of the kinds, by their number. */
const NAMES: readonly (Id["kind"] | "")[] = ["", "body", "shape", "joint"];

/**
 * The number of a handle, which every method takes instead of the handle.
 * @throws {ThudError} "null" for a value that is no handle; "invalid" for an index above 2¹⁹ - 2.
 * @example const ball = numberOf(world.createBody({ kind: "dynamic" }))
 */
export function numberOf(id: Id): number {
  return numberOfPair(id.index + 1, id.generation, kindOf(id));
}

/**
 * The number of the handle at `at` in a list of numbers, such as those of `eventViews`, where a
 * handle is two numbers (index1 and generation). `kind`: the kind of the list's handles. Returns 0,
 * which is the number of no handle, where index1 is 0.
 * @throws {ThudError} "null" for an unknown kind; "invalid" for an index above 2¹⁹ - 2.
 * @example const shape = numberAt(world.eventViews().begin, 0, "shape")
 */
export function numberAt(list: ArrayLike<number>, at: number, kind: Id["kind"]): number {
  return numberOfPair(list[at], list[at + 1], kindNamed(kind));
}

/**
 * The handle of a number. `kind`: the kind that it must be of.
 * @throws {ThudError} "null" for a number of no handle; "invalid" for one of another kind.
 * @example const ball = handleOf(number, "body")
 */
export function handleOf<Kind extends Id["kind"]>(number: number, kind?: Kind): Id & { kind: Kind } {
  const its = kindOf(number, kind);
  const index = index1Of(number, its) - 1;
  const generation = Math.floor(number / GENERATIONS);
  return Object.freeze({ kind: NAMES[its], index, generation }) as Id & { kind: Kind };
}

/** The number of a handle, from the two numbers that the module uses; 0 where index1 is 0. */
export function numberOfPair(index1: number, generation: number, kind: Kind): number {
  if (index1 >= INDICES)
    throw new ThudError("invalid", `only the first ${INDICES - 1} of a kind have numbers`);
  return index1 === 0 ? 0 : generation * GENERATIONS + kind * INDICES + index1;
}

/**
 * The first number of a handle, as the module takes it: the slot + 1, or 0 for a number of no
 * handle. Throws "invalid" for a handle of another kind than `wanted`, "null" for what is no
 * handle.
 */
export function index1Of(handle: Id | number, wanted: Kind): number {
  if (typeof handle === "number") {
    const low = lowOf(handle);
    if (low >= INDICES && low >> 19 !== wanted) refuse(handle, wanted);
    return low >= INDICES ? low & (INDICES - 1) : 0;
  }
  if (handle?.kind !== NAMES[wanted]) refuse(handle, wanted);
  return handle.index + 1;
}

/**
 * The second number of a handle, the generation, as a signed integer: V8 stores small integers
 * without allocation, and WebAssembly takes signed and unsigned ones alike.
 */
export function generationOf(handle: Id | number): number {
  return typeof handle === "number" ? Math.floor(handle / GENERATIONS) | 0 : handle.generation | 0;
}

/**
 * The kind of a handle. `told`: the kind that the caller expects; throws "invalid" where it
 * differs. For a number of no handle, such as 0, the expected kind, or else body.
 */
export function kindOf(handle: Id | number, told?: Id["kind"]): Kind {
  const wanted = told === undefined ? undefined : kindNamed(told);
  const its = typeof handle === "number" ? lowOf(handle) >> 19 : NAMES.indexOf(handle?.kind);
  if (typeof handle === "number" && its === 0) return wanted ?? Kind.body;
  if (its < 1 || (wanted ?? its) !== its) refuse(handle, wanted ?? its);
  return its;
}

/** The kind of this name. Throws "null" for an unknown name. */
function kindNamed(name: Id["kind"]): Kind {
  const kind = NAMES.indexOf(name);
  if (kind < 1) throw new ThudError("null", `a kind is "body", "shape" or "joint": ${shown(name)}`);
  return kind;
}

/**
 * The part of a number below the generation: kind * 2¹⁹ + index1; 0 unless the number is positive.
 * The operator % would be slower.
 */
function lowOf(number: number): number {
  return number > 0 ? (number - Math.floor(number / GENERATIONS) * GENERATIONS) | 0 : 0;
}

/** Throws "null" for what is no handle, "invalid" for a handle of another kind. */
function refuse(handle: unknown, wanted: Kind): never {
  const its = typeof handle === "number" ? lowOf(handle) >> 19 : NAMES.indexOf(Object(handle).kind);
  if (its < 1) throw new ThudError("null", `this is no handle: ${shown(handle)}`);
  throw new ThudError("invalid", `this is a ${NAMES[its]}, a ${NAMES[wanted]} is wanted`);
}
