/** Two shapes on their way into the module's slots. */
import type { Engine } from "../engine.js";
import { ThudError } from "../error.js";
import { GeometryPairAt, PlacedAt } from "../generated/slots.js";
import { solidNumbers } from "../numbers.js";
import type { SolidShape } from "../query-types.js";
import type { Vec2 } from "../types.js";

/** A shape where it stands. */
export type PlacedShape = SolidShape & { center: Vec2 };

/** A straight way, and by how many radians an OBB turns along it. */
export interface Motion {
  way: Vec2;
  /** Default 0. */
  turn?: number;
}

/** What a shape does that stays. */
export const STILL: Motion = { way: [0, 0] };

export function putShape(engine: Engine, shape: PlacedShape, at: number): void {
  const { slots } = engine;
  slots.set(solidNumbers(shape, ["center"]), at);
  slots.set(shape.center, at + PlacedAt.center);
}

export function putPair(
  engine: Engine,
  a: PlacedShape,
  b: PlacedShape,
  motionA: Motion = STILL,
  motionB: Motion = STILL,
): void {
  putShape(engine, a, GeometryPairAt.a);
  putShape(engine, b, GeometryPairAt.b);
  engine.slots.set([...motionA.way, motionA.turn ?? 0], GeometryPairAt.motionA);
  engine.slots.set([...motionB.way, motionB.turn ?? 0], GeometryPairAt.motionB);
}

/** Throws if the module refused. */
export function checkGeometry(name: string, result: number): void {
  if (result !== 0)
    throw new ThudError("invalid", `${name}: sizes must be above 0 and all numbers in range`);
}
