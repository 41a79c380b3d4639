/**
 * Capsules, which are extruded circles: all points within a radius of a segment, as a circle covers
 * on a straight way. They are tested without a world; a world has no shapes of that kind.
 */
import { checkOptions } from "../checks/names.js";
import type { Engine } from "../engine.js";
import { CapsulePairAt } from "../generated/slots.js";
import type { Terrain, Vec2 } from "../types.js";
import { onLine } from "./line.js";
import { checkGeometry, type PlacedShape, putShape } from "./pair.js";
import { type ClosestPoints, closestNow, meetingNow } from "./results.js";

export interface Capsule {
  kind: "capsule";
  /** The ends of the segment, which may coincide. */
  from: Vec2;
  to: Vec2;
  /** A length above 0. */
  radius: number;
}

/**
 * What a moving circle covers on its way: a shape at rest overlaps this capsule exactly where the
 * circle hits it. `way`: the displacement of the circle.
 */
export function capsuleOf(
  engine: Engine,
  circle: PlacedShape & { kind: "circle" },
  way: Vec2,
): Capsule {
  const { center, radius } = circle;
  const to: Vec2 = [center[0] + way[0], center[1] + way[1]];
  const capsule: Capsule = { kind: "capsule", from: center, to, radius };
  // The call refuses what is no circle, and a way that leads out of range.
  putSides(engine, capsule, circle);
  checkGeometry("capsuleOf", engine.exports.api_capsule_closest());
  return capsule;
}

/** Writes a capsule to the slots from `at` on. */
function putCapsule({ slots }: Engine, capsule: Capsule, at: number): void {
  checkOptions("capsule", capsule, ["kind", "from", "to", "radius"]);
  slots.set([...capsule.from, ...capsule.to, capsule.radius], at);
}

/** Writes a capsule and what it is tested against to the slots of `capsule_pair`. */
function putSides(
  engine: Engine,
  a: Capsule,
  b: PlacedShape | Capsule,
  wayA: Vec2 = [0, 0],
  wayB: Vec2 = [0, 0],
): void {
  putCapsule(engine, a, CapsulePairAt.a);
  const isCapsule = b.kind === "capsule";
  if (isCapsule) putCapsule(engine, b, CapsulePairAt.capsuleB);
  else putShape(engine, b, CapsulePairAt.shapeB);
  engine.slots.set([Number(isCapsule), ...wayA, ...wayB], CapsulePairAt.isCapsule);
}

/**
 * The closest points of a capsule and a circle, a box or another capsule, and whether they overlap:
 * as `closest`, with the capsule as a.
 */
export function capsuleClosest(
  engine: Engine,
  a: Capsule,
  b: PlacedShape | Capsule,
): ClosestPoints {
  putSides(engine, a, b);
  checkGeometry("capsuleClosest", engine.exports.api_capsule_closest());
  return closestNow(engine);
}

/**
 * The fraction of their ways, 0 to 1, at which a capsule and a circle, a box or another capsule
 * first come within the distance `target`, 0 to 10¹⁵, of each other; null where they do not. Exact.
 * `wayA`, `wayB`: displacements.
 */
export function capsuleTimeOfImpact(
  engine: Engine,
  a: Capsule,
  wayA: Vec2,
  b: PlacedShape | Capsule,
  wayB: Vec2,
  target = 0,
): number | null {
  putSides(engine, a, b, wayA, wayB);
  checkGeometry("capsuleTimeOfImpact", engine.exports.api_capsule_time_of_impact(target));
  return meetingNow(engine);
}

/**
 * As capsuleClosest, with the ground as a. Where they overlap, the distance is that of the
 * capsule's segment from the ground less the radius.
 */
export function capsuleClosestOnTerrain(
  engine: Engine,
  line: Terrain,
  capsule: Capsule,
): ClosestPoints {
  onLine(engine, "capsuleClosestOnTerrain", line, () => {
    putCapsule(engine, capsule, CapsulePairAt.a);
    return engine.exports.api_line_capsule_closest();
  });
  return closestNow(engine);
}

/** As capsuleTimeOfImpact, of a capsule that moves and a line at rest. */
export function capsuleTimeOfImpactOnTerrain(
  engine: Engine,
  line: Terrain,
  capsule: Capsule,
  way: Vec2,
  target = 0,
): number | null {
  onLine(engine, "capsuleTimeOfImpactOnTerrain", line, () => {
    putCapsule(engine, capsule, CapsulePairAt.a);
    engine.slots.set(way, CapsulePairAt.motionA);
    return engine.exports.api_line_capsule_time_of_impact(target);
  });
  return meetingNow(engine);
}
