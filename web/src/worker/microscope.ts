/**
 * The collision microscope: lists what touched or met in the last step, and takes one pair of it
 * apart. The step of the pair is shown twice. Once as the engine made it: its velocities before and
 * after are read. And once by the formulas of a lecture, for the pair alone: the overlap is found,
 * the bodies are moved back to where they met, their velocities are changed, and they move for the
 * rest of the step; the time of impact of the swept shapes is shown beside that.
 */
import type { BodyState, Engine, ShapeId, ShapeState, Vec2, World } from "thud";
import type * as Geometry from "thud/geometry";
import { type Partner, resolve, type Resolved } from "./collision";
import type { Session } from "./session";
import { recordOf } from "./watch";

/** Two shapes of a contact or an event. */
export interface Pair {
  a: ShapeId;
  b: ShapeId;
}

/** A pair in the list of contacts. */
export interface Met extends Pair {
  /** The slots of their bodies. */
  bodyA: number;
  bodyB: number;
  /** Whether they began to touch, or hit each other, in this step. */
  began: boolean;
  /** The speed of approach that the step reported, length/s; 0 where it reported no hit. */
  speed: number;
  /**
   * Mass times length/s: the impulse that held them apart in the step or, after a hit, the
   * formula's impulse without friction if that is larger.
   */
  impulse: number;
}

/** The contacts of the last step, the largest impulse first. */
export interface ContactList {
  step: number;
  contacts: Met[];
  /** How many there are; `contacts` has at most LIST_MAX of them. */
  count: number;
}

/** A body of the pair, as the engine has it before and after the step. */
export interface Side {
  slot: number;
  kind: BodyState["kind"];
  mass: number;
  inertia: number;
  before: { velocity: Vec2; spin: number };
  after: { velocity: Vec2; spin: number };
  /** What gravity adds to the velocity in a whole step. */
  gravity: Vec2;
}

/** Both shapes at one time of the step, in world coordinates. */
export type Places = readonly [Geometry.PlacedShape, Geometry.PlacedShape];

/** The motion of the step by the lecture's overlap resolution, and beside it the swept one. */
export interface Resolution {
  /** Whether the shapes overlap at the end of the motion, and how deep: a length. */
  found: boolean;
  depth: number;
  /** The time of collision as a fraction of the step, by bisection; null: pushed apart instead. */
  time: number | null;
  start: Places;
  end: Places;
  /** Moved back to the time of collision, or pushed apart along the normal. */
  apart: Places;
  /** The rest of the step moved with the new velocities. */
  rest: Places;
  /** The fraction of the step at which the swept shapes meet; null where they do not. */
  impact: number | null;
  /** Where they stand then; null likewise. */
  met: Places | null;
}

/** Everything that the microscope shows of a pair. Plain data. */
export interface Collision extends Pair {
  step: number;
  /** Seconds. */
  timeStep: number;
  bodyA: Side;
  bodyB: Side;
  normal: Vec2;
  point: Vec2;
  /** The distance of the surfaces before the step, a length; negative: the depth. */
  separation: number;
  /** Of the pair: the larger restitution, the geometric mean of the frictions. */
  restitution: number;
  friction: number;
  /** Pairs with a restitution below 1 that approach more slowly do not bounce, length/s. */
  threshold: number;
  /**
   * The restitution that counts at this speed: 0 below the threshold, unless the restitution is 1
   * or more.
   */
  bounce: number;
  /** The speed of approach that the step reported; 0 where it reported no hit. */
  reported: number;
  /**
   * Whether the pair was apart before the step. If so, `formula` has gravity's share of the step in
   * its speeds; else gravity comes on top of its results.
   */
  arriving: boolean;
  formula: Resolved;
  /** v_n and v_t by the engine's velocities before and after the step, at the same point. */
  measured: { normalBefore: number; tangentBefore: number; normalAfter: number; tangentAfter: number };
  resolution: Resolution;
}

/** Rows of the list. Chosen. */
const LIST_MAX = 40;
/** Steps that `runToContact` makes at most: 20 s at 60 steps a second. Chosen. */
const STEPS_MAX = 1200;
/** Bisection ends at this fraction of the motion. Chosen. */
const TOLERANCE = 2 ** -20;
/** Two points of a manifold whose depths differ by less, in length scales, count as one between
 * them. Chosen. */
const LEVEL = 1e-3;

const plus = ([x, y]: Vec2, [u, v]: Vec2, times = 1): Vec2 => [x + times * u, y + times * v];
const minus = (a: Vec2, b: Vec2): Vec2 => plus(a, b, -1);
const turned = ([x, y]: Vec2, angle: number): Vec2 => {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return [c * x - s * y, s * x + c * y];
};
const keyOf = ({ a, b }: Pair) => [a.index, b.index].sort((one, two) => one - two).join();

/** The contacts of the last step; `slot`: only those of the body in it; null: all. */
export function listContacts({ world, step }: Session, slot: number | null): ContactList {
  const found = new Map<string, Met>();
  const add = (pair: Pair): Met | null => {
    let met = found.get(keyOf(pair));
    if (met) return met;
    try {
      const [bodyA, bodyB] = [world.bodyOf(pair.a).index, world.bodyOf(pair.b).index];
      if (slot !== null && bodyA !== slot && bodyB !== slot) return null;
      const { a, b } = pair;
      met = { a, b, bodyA, bodyB, began: false, speed: 0, impulse: 0 };
      found.set(keyOf(pair), met);
      return met;
    } catch {
      return null; // A shape that was destroyed in the step.
    }
  };
  for (const body of world.bodies()) {
    if (slot !== null && body.index !== slot) continue;
    for (const { a, b, points } of world.contactsOf(body)) {
      if (points.length === 0) continue;
      const met = add({ a, b });
      if (met) met.impulse = points.reduce((sum, { normalImpulse }) => sum + normalImpulse, 0);
    }
  }
  const { begin, hit } = world.events();
  for (const pair of begin) {
    const met = add(pair);
    if (met) met.began = true;
  }
  for (const { a, b, point, normal, speed } of hit) {
    const met = add({ a, b });
    if (!met || speed < met.speed) continue;
    const [first, second] = [a, b].map((shape) => world.bodyStateOf(world.bodyOf(shape)));
    const approaching = { ...partnerOf(second), velocity: [0, 0] as Vec2, spin: 0 };
    const still = { ...partnerOf(first), velocity: plus([0, 0], normal, speed), spin: 0 };
    const surface = surfaceOf(world.shapeStateOf(a), world.shapeStateOf(b));
    const { impulse } = resolve(still, approaching, { point, normal, ...surface });
    Object.assign(met, { began: true, speed, impulse: Math.max(met.impulse, impulse) });
  }
  const contacts = [...found.values()].sort((one, two) => two.impulse - one.impulse);
  return { step, contacts: contacts.slice(0, LIST_MAX), count: contacts.length };
}

/**
 * Makes steps until a pair begins to touch or hits, at most STEPS_MAX. Whether one did.
 */
export function runToContact(session: Session): boolean {
  for (let i = 0; i < STEPS_MAX; i++) {
    session.makeStep();
    const { begin, hit } = session.world.events();
    if (begin.length > 0 || hit.length > 0) return true;
  }
  return false;
}

/**
 * Examines a pair: what the step that ended at `step` did with it, and what the formulas say.
 * Afterwards the session is in the same state as before. @throws {Error} if the step is not kept,
 * or a shape of the pair did not exist before and after.
 */
export function examine(
  session: Session,
  engine: Engine,
  geometry: typeof Geometry,
  pair: Pair,
  step: number,
): Collision {
  const { world, lengthScale, timeStep } = session;
  const [before, after] = session.review(step, () => readPair(world, pair));
  if (!before || !after)
    throw new Error("One of the two shapes was made or removed in this step.");
  const { gravity } = before;
  const fall = (body: BodyState): Vec2 =>
    body.kind === "dynamic"
      ? plus([0, 0], gravity, body.gravityScale * timeStep)
      : [0, 0];
  const falls = before.bodies.map(fall);
  const places = placesOf(engine, geometry, world, before);
  const now = geometry.closest(engine, ...places);
  const arriving = now.distance > 0;
  const meeting = before.bodies.map((body, i) => {
    const partner = partnerOf(body);
    return arriving ? { ...partner, velocity: plus(partner.velocity, falls[i]) } : partner;
  });
  // If the shapes overlapped before this step already, the overlap came from the motion of the step
  // before: the motion is followed one step backwards.
  const [from, to] = arriving ? [0, 1] : [-1, 0];
  const at = (time: number) => places.map((place, i) => moved(place, meeting[i], time * timeStep));
  const start = at(from) as unknown as Places;
  const end = at(to) as unknown as Places;
  const motions = [0, 1].map((i) => ({
    way: minus(end[i].center, start[i].center),
    turn: start[i].kind === "obb" ? meeting[i].spin * timeStep : 0,
  }));
  const moving = [start[0], motions[0], start[1], motions[1]] as const;
  const last = geometry.closest(engine, ...end);
  const { time } = geometry.timeOfCollision(engine, ...moving, TOLERANCE);
  const impact = geometry.timeOfImpact(engine, ...moving);
  const apart = time === null ? pushedApart(end, last, meeting) : (at(from + time) as unknown as Places);

  const { restitution, friction } = surfaceOf(...before.shapes);
  const touching = pointOf(engine, geometry, apart, lengthScale);
  const { normal, point } = touching;
  const options = recordOf(world)?.options;
  const threshold = (options?.restitutionThreshold ?? 1) * lengthScale;
  const stands = time === null ? to : from + time;
  const centered = meeting.map((partner, i) => ({
    ...partner,
    center: plus(
      plus(partner.center, partner.velocity, timeStep * stands),
      time === null ? minus(apart[i].center, end[i].center) : [0, 0],
    ),
  }));
  const free = resolve(centered[0], centered[1], { point, normal, restitution: 0, friction: 0 });
  const bounce = restitution >= 1 || -free.normalSpeed > threshold ? restitution : 0;
  const formula = resolve(centered[0], centered[1], { point, normal, restitution: bounce, friction });
  const left = time === null ? 0 : 1 - time;
  const rest = apart.map((place, i) => {
    const { velocity, spin } = i === 0 ? formula.a : formula.b;
    return moved(place, { ...centered[i], velocity, spin }, left * timeStep);
  }) as unknown as Places;
  const measure = (bodies: readonly BodyState[]) => {
    const partners = bodies.map((body, i) => ({ ...partnerOf(body), center: centered[i].center }));
    return resolve(partners[0], partners[1], { point, normal, restitution: 0, friction: 0 });
  };
  const [first, second] = [measure(before.bodies), measure(after.bodies)];
  const sideOf = (i: number): Side => {
    const body = before.bodies[i];
    return {
      slot: before.slots[i],
      kind: body.kind,
      mass: body.mass,
      inertia: body.inertia,
      before: { velocity: body.velocity, spin: body.angularVelocity },
      after: { velocity: after.bodies[i].velocity, spin: after.bodies[i].angularVelocity },
      gravity: falls[i],
    };
  };
  return {
    ...pair,
    step,
    timeStep,
    bodyA: sideOf(0),
    bodyB: sideOf(1),
    normal,
    point,
    separation: now.distance,
    restitution,
    friction,
    threshold,
    bounce,
    reported: after.reported,
    arriving,
    formula,
    measured: {
      normalBefore: first.normalSpeed,
      tangentBefore: first.tangentSpeed,
      normalAfter: second.normalSpeed,
      tangentAfter: second.tangentSpeed,
    },
    resolution: {
      found: last.distance <= 0,
      depth: Math.max(0, -last.distance),
      time,
      start,
      end,
      apart,
      rest,
      impact,
      met: impact === null ? null : (at(from + impact) as unknown as Places),
    },
  };
}

interface PairState {
  shapes: readonly [ShapeState, ShapeState];
  ids: readonly [ShapeId, ShapeId];
  bodies: readonly [BodyState, BodyState];
  slots: readonly [number, number];
  gravity: Vec2;
  /** The speed of the pair's hit in the last step, or 0. */
  reported: number;
}

/** Reads a pair's present state; null if one of its shapes does not exist. */
function readPair(world: World, pair: Pair): PairState | null {
  try {
    const ids = [pair.a, pair.b] as const;
    const shapes = [world.shapeStateOf(ids[0]), world.shapeStateOf(ids[1])] as const;
    const hit = world.events().hit.filter((one) => keyOf(one) === keyOf(pair));
    return {
      shapes,
      ids,
      bodies: [world.bodyStateOf(shapes[0].body), world.bodyStateOf(shapes[1].body)],
      slots: [shapes[0].body.index, shapes[1].body.index],
      gravity: world.stepSettings().gravity,
      reported: Math.max(0, ...hit.map(({ speed }) => speed)),
    };
  } catch {
    return null;
  }
}

function partnerOf(body: BodyState): Partner {
  const { mass, inertia, center, velocity, angularVelocity } = body;
  return { mass, inertia, center, velocity, spin: angularVelocity };
}

/** How a pair mixes its surfaces, unless a rule or a listener says otherwise (surface.c). */
function surfaceOf(a: ShapeState, b: ShapeState): { restitution: number; friction: number } {
  return {
    restitution: Math.max(a.restitution, b.restitution),
    friction: Math.sqrt(a.friction * b.friction),
  };
}

/** Both shapes in the world. Ground becomes a box with one face along it where they are closest. */
function placesOf(
  engine: Engine,
  geometry: typeof Geometry,
  world: World,
  { shapes, ids, bodies }: PairState,
): Places {
  const placed = shapes.map((shape, i) => placedOf(shape, bodies[i]));
  const ground = placed.findIndex((place) => place === null);
  if (ground < 0) return placed as unknown as Places;
  const other = placed[1 - ground]!;
  const { position, angle } = bodies[ground];
  const local = {
    ...other,
    ...(other.kind === "aabb" && angle !== 0 ? { kind: "obb", angle: 0 } : {}),
    center: turned(minus(other.center, position), -angle),
  } as Geometry.PlacedShape;
  if (local.kind === "obb") local.angle -= angle;
  const line = world.terrainOf(ids[ground]);
  const { normal, pointA } = geometry.closestOnTerrain(engine, line, local);
  const up = turned(normal, angle);
  const half = 8 * reachOf(other);
  const box: Geometry.PlacedShape = {
    kind: "obb",
    center: plus(plus(position, turned(pointA, angle)), up, -half),
    halfWidth: half,
    halfHeight: half,
    angle: Math.atan2(-up[0], up[1]),
  };
  return (ground === 0 ? [box, other] : [other, box]) as unknown as Places;
}

/** A shape in the world; null for ground. */
function placedOf(shape: ShapeState, body: BodyState): Geometry.PlacedShape | null {
  if (shape.kind === "terrain") return null;
  const center = plus(body.position, turned(shape.offset, body.angle));
  if (shape.kind === "circle") return { kind: "circle", center, radius: shape.radius };
  const { halfWidth, halfHeight } = shape;
  if (shape.kind === "aabb") return { kind: "aabb", center, halfWidth, halfHeight };
  return { kind: "obb", center, halfWidth, halfHeight, angle: shape.angle + body.angle };
}

/** The distance from a shape's centre that it reaches. */
function reachOf(place: Geometry.PlacedShape): number {
  return place.kind === "circle" ? place.radius : Math.hypot(place.halfWidth, place.halfHeight);
}

/** A shape that its body has carried for so many seconds, which may be negative. */
function moved(
  place: Geometry.PlacedShape,
  { center, velocity, spin }: Partner,
  seconds: number,
): Geometry.PlacedShape {
  const turn = spin * seconds;
  const arm = turned(minus(place.center, center), turn);
  const there = { ...place, center: plus(plus(center, velocity, seconds), arm) };
  return there.kind === "obb" ? { ...there, angle: there.angle + turn } : there;
}

/** Both shapes moved out of each other along the normal, the lighter one further. */
function pushedApart(
  [a, b]: Places,
  { normal, distance }: Geometry.ClosestPoints,
  partners: readonly Partner[],
): Places {
  const depth = Math.max(0, -distance);
  const [first, second] = partners.map(({ mass }) => (mass > 0 ? 1 / mass : 0));
  const share = first + second > 0 ? depth / (first + second) : 0;
  return [
    { ...a, center: plus(a.center, normal, -share * first) },
    { ...b, center: plus(b.center, normal, share * second) },
  ];
}

/** The normal and the point of a collision: between two points of a manifold that are level. */
function pointOf(
  engine: Engine,
  geometry: typeof Geometry,
  places: Places,
  lengthScale: number,
): { normal: Vec2; point: Vec2 } {
  const middle = (one: Geometry.TouchingPoint) => plus(one.pointA, minus(one.pointB, one.pointA), 0.5);
  const nearest = geometry.closest(engine, ...places);
  const reach = Math.max(0, nearest.distance) + LEVEL * lengthScale;
  const level = geometry
    .contacts(engine, ...places, reach)
    .filter(({ distance }) => Math.abs(distance - nearest.distance) < LEVEL * lengthScale);
  const point =
    level.length === 2
      ? plus(middle(level[0]), minus(middle(level[1]), middle(level[0])), 0.5)
      : middle(nearest);
  return { normal: nearest.normal, point };
}
