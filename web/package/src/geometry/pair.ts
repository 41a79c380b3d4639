/** Writes two shapes and their motions to the module's slots, for the calls of geometry/. */
import type { Engine } from "../engine.js";
import { ThudError } from "../error.js";
import { GeometryPairAt, PlacedAt } from "../generated/slots.js";
import { solidNumbers } from "../numbers.js";
import type { SolidShape } from "../query-types.js";
import type { Vec2 } from "../types.js";

/** A shape at a place. */
export type PlacedShape = SolidShape & { center: Vec2 };

/** A motion along a straight line, with a rotation at a constant rate. */
export interface Motion {
  /** The displacement of the centre, length. */
  way: Vec2;
  /** The rotation of an OBB along the way, radians. Default 0. */
  turn?: number;
}

/** The motion of a shape at rest. */
export const STILL: Motion = { way: [0, 0] };

/** Writes a shape to the slots from `at` on. */
export function putShape(engine: Engine, shape: PlacedShape, at: number): void {
  const { slots } = engine;
  slots.set(solidNumbers(shape, ["center"]), at);
  slots.set(shape.center, at + PlacedAt.center);
}

/** Writes both shapes and motions to the slots of `geometry_pair` (web/wasm/slots.h). */
export function putPair(
  engine: Engine,
  a: PlacedShape,
  b: PlacedShape,
  motionA: Motion = STILL,
  motionB: Motion = STILL,
): void {
  putMoving(engine, a, motionA);
  putShape(engine, b, GeometryPairAt.b);
  engine.slots.set([...motionB.way, motionB.turn ?? 0], GeometryPairAt.motionB);
}

/** Writes one shape and its motion to the slots of `geometry_pair`. */
export function putMoving(engine: Engine, shape: PlacedShape, motion: Motion = STILL): void {
  putShape(engine, shape, GeometryPairAt.a);
  engine.slots.set([...motion.way, motion.turn ?? 0], GeometryPairAt.motionA);
}

/** Throws "invalid" unless the result is 0. `name`: the call, for the message. */
export function checkGeometry(name: string, result: number): void {
  if (result !== 0)
    throw new ThudError("invalid", `${name}: sizes must be above 0 and all numbers in range`);
}
