/**
 * Impulses on bodies from outside: the pushes of a character (Mover) and the visitor's blasts. The
 * code is the same for both engines: a thud World and a Box2DWorld both implement `Hands`, and each
 * engine's own state of a body is used.
 */
import type { BodyId, BodyState, Vec2 } from "thud";

/** The part of a body's state that is used here. */
export type Held = Pick<
  BodyState,
  "kind" | "position" | "center" | "angle" | "velocity" | "angularVelocity" | "mass" | "inertia"
>;

/** What pushes and blasts need of an engine's world; as the methods of World. */
export interface Hands {
  isValid(body: BodyId): boolean;
  bodyStateOf(body: BodyId): Held;
  setVelocity(body: BodyId, velocity: Vec2, angularVelocity?: number): void;
  applyImpulse(body: BodyId, impulse: Vec2, point: Vec2): void;
}

/** A blast: a circle in the world, from whose middle bodies are thrown away. */
export interface Blast {
  x: number;
  y: number;
  radius: number;
  /** The speed that a body in the middle gains, in world units a second. */
  speed: number;
}

/** The push of a character (Mover) against a body that it touched in the thud world. */
export interface Push {
  body: BodyId;
  /** The place where the character touched the body: in the body's frame, and in the world. */
  anchor: Vec2;
  met: Vec2;
  /** The normal of the body's surface at that place, outward. */
  normal: Vec2;
  /** The character's velocity. */
  velocity: Vec2;
  /** The largest impulse. */
  most: number;
  /**
   * If the anchor is now further than this from `met`, a length, the body is not pushed. (In Box2D
   * the body may be elsewhere.)
   */
  reach: number;
}

/**
 * Pushes a body as a Mover of thud does (push in engine/src/api/mover.c): with the impulse against
 * the surface that brings the touched place to the character's speed along the normal.
 */
export function push(hands: Hands, { body, anchor, normal, velocity, ...push }: Push): void {
  if (!hands.isValid(body)) return;
  const state = hands.bodyStateOf(body);
  const point = inWorld(state, anchor);
  if (Math.hypot(point[0] - push.met[0], point[1] - push.met[1]) > push.reach) return;
  const [nx, ny] = normal;
  const rx = point[0] - state.center[0];
  const ry = point[1] - state.center[1];
  const spin = state.angularVelocity;
  const closing =
    (state.velocity[0] - spin * ry - velocity[0]) * nx +
    (state.velocity[1] + spin * rx - velocity[1]) * ny;
  const arm = rx * ny - ry * nx;
  const give = 1 / state.mass + (state.inertia > 0 ? (arm * arm) / state.inertia : 0);
  const impulse = Math.min(closing / give, push.most);
  if (impulse > 0) hands.applyImpulse(body, [-nx * impulse, -ny * impulse], point);
}

/**
 * Throws bodies away from a blast. A dynamic body whose centre of mass is in the circle gains the
 * speed `speed` * (1 - distance / `radius`), away from the middle.
 */
export function explode(
  hands: Hands,
  bodies: Iterable<BodyId>,
  { x, y, radius, speed }: Blast,
): void {
  for (const body of bodies) {
    if (!hands.isValid(body)) continue;
    const state = hands.bodyStateOf(body);
    const [dx, dy] = [state.center[0] - x, state.center[1] - y];
    const distance = Math.hypot(dx, dy);
    if (state.kind !== "dynamic" || distance >= radius) continue;
    const impulse = state.mass * speed * (1 - distance / radius);
    // A body exactly in the middle is thrown upwards.
    const [nx, ny] = distance > 0 ? [dx / distance, dy / distance] : [0, 1];
    hands.applyImpulse(body, [impulse * nx, impulse * ny], state.center);
  }
}

/** Transforms a place from the world into the body's frame. */
export function inFrame({ position, angle }: Pick<Held, "position" | "angle">, place: Vec2): Vec2 {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const [x, y] = [place[0] - position[0], place[1] - position[1]];
  return [c * x + s * y, c * y - s * x];
}

/** Transforms a place from the body's frame into the world. */
export function inWorld({ position, angle }: Pick<Held, "position" | "angle">, place: Vec2): Vec2 {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return [position[0] + c * place[0] - s * place[1], position[1] + s * place[0] + c * place[1]];
}
