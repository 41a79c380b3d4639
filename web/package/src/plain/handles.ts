/**
 * Handles as plain numbers: the generation times 2²¹, and the index plus 1; exact, as both together
 * have 53 bits. Whoever keeps numbers makes no objects that the collector must find again.
 */
import { ThudError } from "../error.js";
import type { BodyId, JointId, ShapeId } from "../types.js";

/** Of each kind as many have a number: two million. */
const INDICES = 0x200000;

type Id = BodyId | ShapeId | JointId;

/**
 * The number of a handle, which every method takes in its place.
 * @example const ball = numberOf(world.createBody({ kind: "dynamic" }))
 */
export function numberOf(id: Id): number {
  return numberOfPair(id.index + 1, id.generation);
}

/**
 * The same of a handle in a list of two numbers each, such as those of `eventViews`; 0, which is
 * nobody's, where there is none.
 * @example const shape = numberAt(world.eventViews().begin, 4 * i)
 */
export function numberAt(list: ArrayLike<number>, at: number): number {
  return numberOfPair(list[at], list[at + 1]);
}

/**
 * The handle of a number.
 * @example const ball = handleOf(number, "body")
 */
export function handleOf<Kind extends Id["kind"]>(number: number, kind: Kind): Id & { kind: Kind } {
  const generation = Math.floor(number / INDICES);
  return Object.freeze({ kind, index: (number % INDICES) - 1, generation }) as Id & { kind: Kind };
}

/** Of the two numbers that the module gives. */
export function numberOfPair(index1: number, generation: number): number {
  if (index1 >= INDICES)
    throw new ThudError("invalid", `only the first ${INDICES - 1} of a kind have numbers`);
  return index1 === 0 ? 0 : generation * INDICES + index1;
}

/** What the module takes first of a handle. */
export function index1Of(handle: Id | number): number {
  if (typeof handle === "number") return (handle % INDICES) | 0;
  if (typeof handle !== "object" || handle === null)
    throw new ThudError("null", `this is no handle: ${handle}`);
  return handle.index + 1;
}

/** And second; signed, which the module does not mind: a small number lies in no object. */
export function generationOf(handle: Id | number): number {
  return typeof handle === "number" ? Math.floor(handle / INDICES) | 0 : handle.generation | 0;
}

/** Of a handle that says it itself, or as the caller says of a number. */
export function kindOf(handle: Id | number, kind: Id["kind"] | undefined): Id["kind"] {
  const told = typeof handle === "number" ? kind : handle?.kind;
  if (told !== "body" && told !== "shape" && told !== "joint")
    throw new ThudError("null", `of a number say whose it is, "body", "shape" or "joint": ${handle}`);
  return told;
}
