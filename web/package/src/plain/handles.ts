/**
 * Handles as plain numbers: the generation times 2²¹, the kind times 2¹⁹, and the index plus 1; exact,
 * as all together have 53 bits. The kind keeps a shape's number from being a body's. Whoever keeps
 * numbers makes no objects that the collector must find again.
 */
import { shown } from "../checks/hook.js";
import { ThudError } from "../error.js";
import type { BodyId, JointId, ShapeId } from "../types.js";

/** Of each kind as many have a number: half a million. */
const INDICES = 0x80000;
const GENERATIONS = 0x200000;

type Id = BodyId | ShapeId | JointId;

/** What a call is of; the number is that in the numbers of handles. */
export const enum Kind {
  body = 1,
  shape,
  joint,
}
const NAMES: readonly (Id["kind"] | "")[] = ["", "body", "shape", "joint"];

/**
 * The number of a handle, which every method takes in its place.
 * @example const ball = numberOf(world.createBody({ kind: "dynamic" }))
 */
export function numberOf(id: Id): number {
  return numberOfPair(id.index + 1, id.generation, kindOf(id));
}

/**
 * The same of a handle in a list of two numbers each, such as those of `eventViews`, of the kind that
 * the list has; 0, which is nobody's, where there is none.
 * @example const shape = numberAt(world.eventViews().begin, 0, "shape")
 */
export function numberAt(list: ArrayLike<number>, at: number, kind: Id["kind"]): number {
  return numberOfPair(list[at], list[at + 1], kindNamed(kind));
}

/**
 * The handle of a number. With a kind a number of another is refused.
 * @example const ball = handleOf(number, "body")
 */
export function handleOf<Kind extends Id["kind"]>(number: number, kind?: Kind): Id & { kind: Kind } {
  const its = kindOf(number, kind);
  const index = index1Of(number, its) - 1;
  const generation = Math.floor(number / GENERATIONS);
  return Object.freeze({ kind: NAMES[its], index, generation }) as Id & { kind: Kind };
}

/** Of the two numbers that the module gives. */
export function numberOfPair(index1: number, generation: number, kind: Kind): number {
  if (index1 >= INDICES)
    throw new ThudError("invalid", `only the first ${INDICES - 1} of a kind have numbers`);
  return index1 === 0 ? 0 : generation * GENERATIONS + kind * INDICES + index1;
}

/** What the module takes first of a handle. Throws for one of another kind than is wanted. */
export function index1Of(handle: Id | number, wanted: Kind): number {
  if (typeof handle === "number") {
    const low = lowOf(handle);
    if (low >= INDICES && low >> 19 !== wanted) refuse(handle, wanted);
    return low >= INDICES ? low & (INDICES - 1) : 0;
  }
  if (handle?.kind !== NAMES[wanted]) refuse(handle, wanted);
  return handle.index + 1;
}

/** And second; signed, which the module does not mind: a small number lies in no object. */
export function generationOf(handle: Id | number): number {
  return typeof handle === "number" ? Math.floor(handle / GENERATIONS) | 0 : handle.generation | 0;
}

/** As the handle says itself; throws where `told` is another. Of 0, which is nobody's, as told. */
export function kindOf(handle: Id | number, told?: Id["kind"]): Kind {
  const wanted = told === undefined ? undefined : kindNamed(told);
  const its = typeof handle === "number" ? lowOf(handle) >> 19 : NAMES.indexOf(handle?.kind);
  if (typeof handle === "number" && its === 0) return wanted ?? Kind.body;
  if (its < 1 || (wanted ?? its) !== its) refuse(handle, wanted ?? its);
  return its;
}

function kindNamed(name: Id["kind"]): Kind {
  const kind = NAMES.indexOf(name);
  if (kind < 1) throw new ThudError("null", `a kind is "body", "shape" or "joint": ${shown(name)}`);
  return kind;
}

/** What is below the generation; 0 of what is no number of a handle. A remainder is slower. */
function lowOf(number: number): number {
  return number > 0 ? (number - Math.floor(number / GENERATIONS) * GENERATIONS) | 0 : 0;
}

function refuse(handle: unknown, wanted: Kind): never {
  const its = typeof handle === "number" ? lowOf(handle) >> 19 : NAMES.indexOf(Object(handle).kind);
  if (its < 1) throw new ThudError("null", `this is no handle: ${shown(handle)}`);
  throw new ThudError("invalid", `this is a ${NAMES[its]}, a ${NAMES[wanted]} is wanted`);
}
