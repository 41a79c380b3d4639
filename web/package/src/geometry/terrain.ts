/**
 * A terrain line without a world, in coordinates of its own: its height at x, texture coordinates,
 * feet, and tests against shapes. The ground below the line is solid.
 */
import type { Engine } from "../engine.js";
import { FootAt, GroundAt, NumberAt, PlaceAt, SegmentsAt } from "../generated/slots.js";
import { vecAt } from "../numbers.js";
import { withTexture } from "../terrain-line.js";
import type { Foot, Ground, Terrain, Texture, Vec2 } from "../types.js";
import { onLine } from "./line.js";
import { type Motion, type PlacedShape, putMoving } from "./pair.js";
import {
  type ClosestPoints,
  closestNow,
  contactsNow,
  type Crossing,
  crossingNow,
  meetingNow,
  type TouchingPoint,
} from "./results.js";

/** The line at x. Throws a ThudError "invalid" beyond its ends. */
export function terrainAt(engine: Engine, line: Terrain, x: number): Ground {
  onLine(engine, "terrainAt", line, () => engine.exports.api_line_at(x));
  const s = engine.slots;
  return {
    height: s[GroundAt.height],
    normal: vecAt(s, GroundAt.normal),
    segment: s[GroundAt.segment],
    weights: vecAt(s, GroundAt.weights),
  };
}

/**
 * Runs `terrainAt` `count` times, at places spread from `from` to `to` in no order, and returns the
 * sum of the segments that were found. One call from JavaScript takes as long as hundreds of
 * look-ups: so the time of a look-up itself can be measured. The line is copied once; the
 * difference between two counts is free of that.
 */
export function terrainAtOften(
  engine: Engine,
  line: Terrain,
  from: number,
  to: number,
  count: number,
): number {
  onLine(engine, "terrainAtOften", line, () => engine.exports.api_line_often(from, to, count));
  return engine.slots[NumberAt.value];
}

/**
 * The texture coordinates of a line at x, between those of its vertices by their two weights.
 * `vertices`: the coordinates of each vertex; a flat line has two, at x = 0 and x = 1. Throws a
 * ThudError "invalid" beyond the ends, and where a vertex has none.
 */
export function textureAt(
  engine: Engine,
  line: Terrain,
  x: number,
  vertices: ArrayLike<Vec2>,
): Vec2 {
  onLine(engine, "textureAt", line, () =>
    engine.withPoints(vertices, (at, count) => engine.exports.api_line_texture(x, at, count)),
  );
  return vecAt(engine.slots, PlaceAt.at);
}

/**
 * The friction of a line at x, from its texture (`World.setTexture`). Throws a ThudError "invalid"
 * beyond the ends, and where a vertex has no value or one that is out of range.
 */
export function frictionAt(engine: Engine, line: Terrain, x: number, texture: Texture): number {
  onLine(engine, "frictionAt", line, () =>
    withTexture(engine, "frictionAt", texture, (...numbers) =>
      engine.exports.api_line_friction(x, ...numbers),
    ),
  );
  return engine.slots[NumberAt.value];
}

/**
 * Places a horizontal sole of this width on a line, with its middle at x. Throws a ThudError
 * "invalid" where no part of the sole is over the line.
 */
export function footOn(engine: Engine, line: Terrain, x: number, width: number): Foot {
  onLine(engine, "footOn", line, () => engine.exports.api_line_foot(x, width));
  const s = engine.slots;
  return { height: s[FootAt.height], x: s[FootAt.x], normal: vecAt(s, FootAt.normal) };
}

/** The first and last segment that the interval from `left` to `right` touches; null: none. */
export function segmentsOf(
  engine: Engine,
  line: Terrain,
  left: number,
  right: number,
): [first: number, last: number] | null {
  onLine(engine, "segmentsOf", line, () => engine.exports.api_line_segments(left, right));
  const s = engine.slots;
  const [first, last] = [s[SegmentsAt.first], s[SegmentsAt.last]];
  return first > last ? null : [first, last];
}

/** As castRay, against a line from above; a ray that starts below the line meets nothing. */
export function castRayOnTerrain(
  engine: Engine,
  line: Terrain,
  from: Vec2,
  way: Vec2,
): Crossing | null {
  onLine(engine, "castRayOnTerrain", line, () =>
    engine.exports.api_line_cast_ray(...from, ...way),
  );
  return crossingNow(engine);
}

/**
 * As closest, with the ground as a. Where they overlap, normal and distance are those of the
 * shortest way out of the ground.
 */
export function closestOnTerrain(engine: Engine, line: Terrain, shape: PlacedShape): ClosestPoints {
  onLine(engine, "closestOnTerrain", line, () => {
    putMoving(engine, shape);
    return engine.exports.api_line_closest();
  });
  return closestNow(engine);
}

/** As contacts, with the ground as a; in a valley a circle touches both slopes. */
export function contactsOnTerrain(
  engine: Engine,
  line: Terrain,
  shape: PlacedShape,
  margin: number,
): TouchingPoint[] {
  onLine(engine, "contactsOnTerrain", line, () => {
    putMoving(engine, shape);
    return engine.exports.api_line_contacts(margin);
  });
  return contactsNow(engine);
}

/** As timeOfImpact, of a shape that moves and a line at rest. */
export function timeOfImpactOnTerrain(
  engine: Engine,
  line: Terrain,
  shape: PlacedShape,
  motion: Motion,
  target = 0,
): number | null {
  onLine(engine, "timeOfImpactOnTerrain", line, () => {
    putMoving(engine, shape, motion);
    return engine.exports.api_line_time_of_impact(target);
  });
  return meetingNow(engine);
}

/** As timeOfCollision, of a shape that moves and a line at rest. */
export function timeOfCollisionOnTerrain(
  engine: Engine,
  line: Terrain,
  shape: PlacedShape,
  motion: Motion,
  tolerance: number,
): number | null {
  onLine(engine, "timeOfCollisionOnTerrain", line, () => {
    putMoving(engine, shape, motion);
    return engine.exports.api_line_time_of_collision(tolerance);
  });
  return meetingNow(engine);
}
