/**
 * What a visitor does to bodies by hand, for either engine: each takes it by the same rule from its
 * own state of the body. A World of thud has such hands, and a Box2DWorld.
 */
import type { BodyId, BodyState, Vec2 } from "thud";

export type Held = Pick<
  BodyState,
  "kind" | "position" | "center" | "angle" | "velocity" | "angularVelocity" | "mass" | "inertia"
>;

export interface Hands {
  isValid(body: BodyId): boolean;
  bodyState(body: BodyId): Held;
  setVelocity(body: BodyId, velocity: Vec2, angularVelocity?: number): void;
  applyImpulse(body: BodyId, impulse: Vec2, point: Vec2): void;
}

export interface Blast {
  x: number;
  y: number;
  radius: number;
  /** That a body in the middle gains. */
  speed: number;
}

/** By a character (Mover) that met the body in the thud world. */
export interface Push {
  body: BodyId;
  /** Where it was met, in the body's frame, and in the world. */
  anchor: Vec2;
  met: Vec2;
  /** Of its surface there, outward. */
  normal: Vec2;
  /** The character's. */
  velocity: Vec2;
  /** The largest impulse. */
  most: number;
  /** A body whose anchor is further than this from where it was met is not in the way. */
  reach: number;
}

/**
 * As a Mover of thud does it (push in engine/src/api/mover.c): the impulse against the surface that
 * takes the place that was met up to the character's speed.
 */
export function push(hands: Hands, { body, anchor, normal, velocity, ...push }: Push): void {
  if (!hands.isValid(body)) return;
  const state = hands.bodyState(body);
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
 * Throws those of some bodies away whose centre is in a blast's circle: each gains `speed` in the
 * middle, less with its distance, and nothing at `radius`. What has no mass stays.
 */
export function explode(
  hands: Hands,
  bodies: Iterable<BodyId>,
  { x, y, radius, speed }: Blast,
): void {
  for (const body of bodies) {
    if (!hands.isValid(body)) continue;
    const state = hands.bodyState(body);
    const [dx, dy] = [state.center[0] - x, state.center[1] - y];
    const distance = Math.hypot(dx, dy);
    if (state.kind !== "dynamic" || distance >= radius) continue;
    const impulse = state.mass * speed * (1 - distance / radius);
    // In the very middle there is no direction but up.
    const [nx, ny] = distance > 0 ? [dx / distance, dy / distance] : [0, 1];
    hands.applyImpulse(body, [impulse * nx, impulse * ny], state.center);
  }
}

/** A place in the world, in the body's frame. */
export function inFrame({ position, angle }: Pick<Held, "position" | "angle">, place: Vec2): Vec2 {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const [x, y] = [place[0] - position[0], place[1] - position[1]];
  return [c * x + s * y, c * y - s * x];
}

/** A place in the body's frame, in the world. */
export function inWorld({ position, angle }: Pick<Held, "position" | "angle">, place: Vec2): Vec2 {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return [position[0] + c * place[0] - s * place[1], position[1] + s * place[0] + c * place[1]];
}
