/**
 * What a visitor does to a running world, as plain data: applied before a step, and kept in the
 * journal under that step's number, so that going back in time does the same again.
 */
import { SHAPE_KINDS } from "thud";
import type { BodyId, ShapeId, World } from "thud";
import type { Blast, Pull } from "../rival/hands";
import type { KeyName } from "../scene/scene";

export type Deed =
  | { kind: "grab"; x: number; y: number; reach: number }
  | { kind: "drag"; x: number; y: number }
  | { kind: "release" }
  | { kind: "spawn"; shape: "circle" | "box"; x: number; y: number; size: number }
  | ({ kind: "explode" } & Blast)
  | { kind: "dig"; x: number; y: number; radius: number }
  | { kind: "keys"; held: Readonly<Record<KeyName, boolean>> }
  | { kind: "pointer"; x: number; y: number; down: boolean };

const TERRAIN = SHAPE_KINDS.indexOf("terrain");

/** The moving body at or nearest to a place, within `reach`, taken there; or null. */
export function takeHold(world: World, x: number, y: number, reach: number): Pull | null {
  let best: { body: BodyId; distance: number } | null = null;
  for (const shape of world.overlap({ kind: "circle", center: [x, y], radius: reach })) {
    const { body } = world.shapeState(shape);
    const state = world.bodyState(body);
    if (state.kind !== "dynamic") continue;
    const distance = Math.hypot(state.center[0] - x, state.center[1] - y);
    if (!best || distance < best.distance) best = { body, distance };
  }
  if (!best) return null;
  const { position, angle } = world.bodyState(best.body);
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const [dx, dy] = [x - position[0], y - position[1]];
  return { body: best.body, anchor: [c * dx + s * dy, c * dy - s * dx], target: [x, y] };
}

/** Whether there is still something to be pulled. */
export function canPull(world: World, { body }: Pull): boolean {
  if (!world.isValid(body)) return false;
  const { kind, enabled, quarantined } = world.bodyState(body);
  return kind === "dynamic" && enabled && !quarantined;
}

/** A new body; its size and angle vary a little with the number that exist. */
export function spawn(
  world: World,
  { shape, x, y, size }: { shape: "circle" | "box"; x: number; y: number; size: number },
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

/** The bodies that a blast may reach. */
export function reachedBy(world: World, { x, y, radius }: Blast): BodyId[] {
  const reached = new Map<number, BodyId>();
  for (const shape of world.overlap({ kind: "circle", center: [x, y], radius })) {
    const { body } = world.shapeState(shape);
    reached.set(body.index, body);
  }
  return [...reached.values()];
}

/** A crater in every ground line that has vertices. */
export function dig(world: World, { x, y, radius }: { x: number; y: number; radius: number }): void {
  for (const shape of groundLines(world))
    if (world.terrain(shape).kind !== "flat") world.dig(shape, [x, y], radius);
}

function groundLines(world: World): ShapeId[] {
  const { count, rows, handles } = world.shapeTable();
  const found: ShapeId[] = [];
  for (let i = 0; i < count; i++)
    if (rows[10 * i + 1] === TERRAIN)
      found.push({ kind: "shape", index: handles[4 * i] - 1, generation: handles[4 * i + 1] });
  return found;
}
