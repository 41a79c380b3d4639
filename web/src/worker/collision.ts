/**
 * One collision of two rigid bodies at one point, worked out by the formulas of a lecture: the
 * impulse along the normal, then that of friction across it. Sources: Hecker, "Physics, Part 3:
 * Collision Response" (1997), for the impulse; Coulomb's law for the bound of friction.
 */
import type { Vec2 } from "thud";

/** A body as the collision finds it. */
export interface Partner {
  /** 0: nothing pushes it (a static or kinematic body). */
  mass: number;
  /** About the centre of mass; 0: nothing turns it. */
  inertia: number;
  /** The centre of mass in the world. */
  center: Vec2;
  /** Of the centre of mass, length/s. */
  velocity: Vec2;
  /** Radians/s. */
  spin: number;
}

/** Where two bodies meet, and what their surfaces are. */
export interface Meeting {
  point: Vec2;
  /** Unit vector, from a to b. */
  normal: Vec2;
  restitution: number;
  friction: number;
}

/** What a body has after the collision, and its terms of the formula. */
export interface PartnerAfter {
  velocity: Vec2;
  spin: number;
  /** 1/m. */
  inverseMass: number;
  /** r × n, r from the centre of mass to the point: a length. */
  arm: number;
  /** (r × n)² / I. */
  turning: number;
}

/** The collision with every number of its formulas. Speeds are of b relative to a at the point. */
export interface Resolved {
  /** v_n, along the normal: negative while they approach. */
  normalSpeed: number;
  /** v_t, along (normal[1], -normal[0]). */
  tangentSpeed: number;
  /** 1/m_a + 1/m_b + (r_a×n)²/I_a + (r_b×n)²/I_b: what an impulse of 1 changes v_n by. */
  response: number;
  /** j = -(1 + e) v_n / response; 0 where they part already, or where nothing moves. */
  impulse: number;
  /** v_n after the impulse j alone: -e v_n. */
  normalSpeedAfter: number;
  /** The same sum as `response`, across the normal. */
  tangentResponse: number;
  /** v_t after the impulse j alone, which turning bodies change. */
  tangentSpeedBetween: number;
  /** The impulse on b along the tangent: what stops v_t, but no more than friction · j. */
  frictionImpulse: number;
  /** Whether friction · j was less than what stops v_t, so that the surfaces go on sliding. */
  slides: boolean;
  /** v_n and v_t after both impulses: where a body turns, friction changes v_n too. */
  normalSpeedFinal: number;
  tangentSpeedFinal: number;
  a: PartnerAfter;
  b: PartnerAfter;
}

const dot = ([x, y]: Vec2, [u, v]: Vec2) => x * u + y * v;
const cross = ([x, y]: Vec2, [u, v]: Vec2) => x * v - y * u;
const inverse = (value: number) => (value > 0 ? 1 / value : 0);

/** The velocity of the body's point at `arm` from its centre of mass. */
function speedAt({ velocity: [x, y], spin }: Pick<Partner, "velocity" | "spin">, arm: Vec2): Vec2 {
  return [x - spin * arm[1], y + spin * arm[0]];
}

/** The body after an impulse at `arm` from its centre of mass. */
function pushed(body: Partner, arm: Vec2, [x, y]: Vec2): Partner {
  const { mass, inertia, velocity, spin } = body;
  const [m, i] = [inverse(mass), inverse(inertia)];
  return {
    ...body,
    velocity: [velocity[0] + m * x, velocity[1] + m * y],
    spin: spin + i * cross(arm, [x, y]),
  };
}

/** Resolves a collision. The bodies are not changed. */
export function resolve(a: Partner, b: Partner, meeting: Meeting): Resolved {
  const { point, normal, restitution, friction } = meeting;
  const tangent: Vec2 = [normal[1], -normal[0]];
  const armOf = ({ center }: Partner): Vec2 => [point[0] - center[0], point[1] - center[1]];
  const [armA, armB] = [armOf(a), armOf(b)];
  const relative = (first: Partner, second: Partner): Vec2 => {
    const [va, vb] = [speedAt(first, armA), speedAt(second, armB)];
    return [vb[0] - va[0], vb[1] - va[1]];
  };
  const turningOf = ({ inertia }: Partner, arm: Vec2, along: Vec2) =>
    inverse(inertia) * cross(arm, along) ** 2;
  const responseTo = (along: Vec2) =>
    inverse(a.mass) + inverse(b.mass) + turningOf(a, armA, along) + turningOf(b, armB, along);
  const push = (first: Partner, second: Partner, along: Vec2, size: number) =>
    [
      pushed(first, armA, [-size * along[0], -size * along[1]]),
      pushed(second, armB, [size * along[0], size * along[1]]),
    ] as const;

  const before = relative(a, b);
  const [normalSpeed, tangentSpeed] = [dot(before, normal), dot(before, tangent)];
  const [response, tangentResponse] = [responseTo(normal), responseTo(tangent)];
  const meets = normalSpeed < 0 && response > 0;
  const impulse = meets ? (-(1 + restitution) * normalSpeed) / response : 0;
  const between = push(a, b, normal, impulse);
  const relativeBetween = relative(...between);
  const tangentSpeedBetween = dot(relativeBetween, tangent);
  const stopping = tangentResponse > 0 ? -tangentSpeedBetween / tangentResponse : 0;
  const bound = friction * impulse;
  const frictionImpulse = bound > 0 ? Math.max(-bound, Math.min(bound, stopping)) : 0;
  const after = push(...between, tangent, frictionImpulse);
  const relativeAfter = relative(...after);
  const told = (body: Partner, { velocity, spin }: Partner, arm: Vec2): PartnerAfter => ({
    velocity,
    spin,
    inverseMass: inverse(body.mass),
    arm: cross(arm, normal),
    turning: turningOf(body, arm, normal),
  });
  return {
    normalSpeed,
    tangentSpeed,
    response,
    impulse,
    normalSpeedAfter: dot(relativeBetween, normal),
    tangentResponse,
    tangentSpeedBetween,
    frictionImpulse,
    slides: Math.abs(stopping) > bound,
    normalSpeedFinal: dot(relativeAfter, normal),
    tangentSpeedFinal: dot(relativeAfter, tangent),
    a: told(a, after[0], armA),
    b: told(b, after[1], armB),
  };
}
