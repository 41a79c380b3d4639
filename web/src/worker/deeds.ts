/**
 * What a visitor does to a running world, as plain data: applied before a step, and kept in the
 * journal under that step's number, so that going back in time does the same again.
 */
import { SHAPE_KINDS } from "thud";
import type { BodyId, ShapeId, Vec2, World } from "thud";
import type { KeyName } from "../scene/scene";

export type Deed =
  | { kind: "grab"; x: number; y: number; reach: number }
  | { kind: "drag"; x: number; y: number }
  | { kind: "release" }
  | { kind: "spawn"; shape: "circle" | "box"; x: number; y: number; size: number }
  | { kind: "explode"; x: number; y: number; radius: number; speed: number }
  | { kind: "dig"; x: number; y: number; radius: number }
  | { kind: "keys"; held: Readonly<Record<KeyName, boolean>> }
  | { kind: "pointer"; x: number; y: number; down: boolean };

const TERRAIN = SHAPE_KINDS.indexOf("terrain");

export interface Pull {
  body: BodyId;
  /** Where it was taken, in the body's frame. */
  anchor: Vec2;
  target: Vec2;
}

/** How hard a pulled body follows, as speed per distance (1/s). */
const PULL_RATE = 14;
/** Largest change of speed per step by pulling, in length scales a second. */
const PULL_LIMIT = 60;
/** A body on a short line swings for ever without some friction of its own. */
const PULL_SPIN_KEPT = 0.92;

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

/** Where the pulled place of a body is. */
export function anchorOf(world: World, { body, anchor }: Pull): Vec2 {
  const { position, angle } = world.bodyState(body);
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return [
    position[0] + c * anchor[0] - s * anchor[1],
    position[1] + s * anchor[0] + c * anchor[1],
  ];
}

/** A body as pulling needs it, of either engine. */
export interface Pulled {
  point: Vec2;
  center: Vec2;
  velocity: Vec2;
  spin: number;
  inverseMass: number;
  inverseInertia: number;
}

/**
 * The impulse at the anchor that gives it the speed of an exponential approach to the pointer:
 * J = K⁻¹·(wanted - actual), with K the inverse mass that the anchor has. It does not overshoot.
 */
export function pullImpulse(target: Vec2, pulled: Pulled, lengthScale: number): Vec2 {
  const { point, center, velocity, spin, inverseMass, inverseInertia } = pulled;
  const [rx, ry] = [point[0] - center[0], point[1] - center[1]];
  let dx = (target[0] - point[0]) * PULL_RATE - (velocity[0] - spin * ry);
  let dy = (target[1] - point[1]) * PULL_RATE - (velocity[1] + spin * rx);
  const change = Math.hypot(dx, dy);
  const most = PULL_LIMIT * lengthScale;
  if (change > most) {
    dx *= most / change;
    dy *= most / change;
  }
  const kxx = inverseMass + inverseInertia * ry * ry;
  const kyy = inverseMass + inverseInertia * rx * rx;
  const kxy = -inverseInertia * rx * ry;
  const determinant = kxx * kyy - kxy * kxy;
  return [(kyy * dx - kxy * dy) / determinant, (kxx * dy - kxy * dx) / determinant];
}

/** Pulls for the next step; false if there is nothing to pull any more. */
export function applyPull(world: World, pull: Pull, lengthScale: number): boolean {
  if (!world.isValid(pull.body)) return false;
  const state = world.bodyState(pull.body);
  if (state.kind !== "dynamic" || !state.enabled || state.quarantined) return false;
  const point = anchorOf(world, pull);
  const impulse = pullImpulse(
    pull.target,
    {
      point,
      center: state.center,
      velocity: state.velocity,
      spin: state.angularVelocity,
      inverseMass: 1 / state.mass,
      inverseInertia: state.inertia > 0 ? 1 / state.inertia : 0,
    },
    lengthScale,
  );
  world.applyImpulse(pull.body, impulse, point);
  const after = world.bodyState(pull.body);
  world.setVelocity(pull.body, after.velocity, after.angularVelocity * PULL_SPIN_KEPT);
  return true;
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

/** The bodies that an explosion reaches and the speed that each gains, fading with distance. */
export function explosion(
  world: World,
  { x, y, radius, speed }: { x: number; y: number; radius: number; speed: number },
): { body: BodyId; point: Vec2; gain: Vec2 }[] {
  const reached = new Map<number, BodyId>();
  for (const shape of world.overlap({ kind: "circle", center: [x, y], radius })) {
    const { body } = world.shapeState(shape);
    if (world.bodyState(body).kind === "dynamic") reached.set(body.index, body);
  }
  return [...reached.values()].map((body) => {
    const { center } = world.bodyState(body);
    const [dx, dy] = [center[0] - x, center[1] - y];
    const distance = Math.hypot(dx, dy);
    const part = speed * Math.max(0, 1 - distance / (radius + distance));
    // What stands on the very spot goes up.
    const gain: Vec2 =
      distance > 0 ? [(part * dx) / distance, (part * dy) / distance] : [0, part];
    return { body, point: center, gain };
  });
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
