/**
 * What a visitor does to a running world, as plain data. A command is applied before a step, and
 * kept in the journal under that step's number, so that steps that are run again get the same
 * commands.
 */
import type { BodyId, Vec2, World } from "thud";
import type { Setting } from "../scene/controls";
import type { KeyName } from "../scene/scene";
import type { Blast } from "./hands";
import { groundLines } from "./lookup";
import type { Choices } from "./protocol";

/** The choices that can be changed while a world runs. */
export type Adjustment = Pick<Choices, "quality" | "substeps" | "maxError">;

export type Command =
  /**
   * Takes hold of the body in a slot. `anchor` is a point in the body's frame; the pointer is at x,
   * y.
   */
  | { kind: "grab"; slot: number; anchor: Vec2; x: number; y: number }
  | { kind: "drag"; x: number; y: number }
  | { kind: "release" }
  | { kind: "spawn"; shape: "circle" | "box"; x: number; y: number; size: number }
  | ({ kind: "explode" } & Blast)
  | { kind: "dig"; x: number; y: number; radius: number }
  | { kind: "keys"; held: Readonly<Record<KeyName, boolean>> }
  | { kind: "pointer"; x: number; y: number; down: boolean }
  /** Sets one of the scene's controls. */
  | { kind: "set"; name: string; value: Setting }
  | ({ kind: "choose" } & Adjustment);

/**
 * Creates a dynamic body of half size `size`. Its width (or radius, 0.8 to 1.2 of `size`) and the
 * angle of a box depend on the number of bodies in the world.
 */
export function spawn(
  world: World,
  { shape, x, y, size }: Extract<Command, { kind: "spawn" }>,
): void {
  const wobble = 0.8 + 0.4 * ((world.stats().bodies * 0.618034) % 1);
  const body = world.createBody({
    kind: "dynamic",
    position: [x, y],
    angle: shape === "box" ? (wobble - 1) * 2 : 0,
  });
  if (shape === "circle") world.createCircle(body, { radius: size * wobble });
  else world.createObb(body, { halfWidth: size * wobble, halfHeight: size });
}

/** The bodies whose shapes overlap the circle of a blast. */
export function reachedBy(world: World, { x, y, radius }: Blast): BodyId[] {
  const reached = new Map<number, BodyId>();
  for (const shape of world.overlap({ kind: "circle", center: [x, y], radius })) {
    const { body } = world.shapeStateOf(shape);
    reached.set(body.index, body);
  }
  return [...reached.values()];
}

/** Digs a crater into every terrain that has vertices. */
export function dig(world: World, { x, y, radius }: Extract<Command, { kind: "dig" }>): void {
  for (const { shape } of groundLines(world))
    if (world.terrainOf(shape).kind !== "flat") world.dig(shape, [x, y], radius);
}
