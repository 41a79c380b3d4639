/**
 * Minkowski sums for the page to draw: of the scene's pairs of bodies, and of the body that the
 * visitor points at with its nearest neighbour.
 */
import { minkowskiSum, type ShapeId, type SolidShape, type Vec2, type World } from "thud";
import type { Sum } from "../scene/frame";
import { shapesOf } from "./lookup";

/** A shape and the place of its centre in the world. */
interface Placed {
  solid: SolidShape;
  center: Vec2;
}

/**
 * The nearest neighbour is looked for within a radius of so many sizes of the body; if there is
 * none, the radius is doubled, DOUBLINGS - 1 times at most. Chosen.
 */
const FIRST_REACH = 1.5;
const DOUBLINGS = 5;

/** Sums of the first two bodies, of the next two, and so on, by slot. */
export function sumsOfPairs(world: World, pairs: number, origin: Vec2): Sum[] {
  const bodies = Array.from({ length: 2 * pairs }, (_, slot) => shapesOf(world, slot));
  return Array.from({ length: pairs }, (_, i) => [bodies[2 * i][0], bodies[2 * i + 1][0]]).flatMap(
    ([a, b]) => {
      const first = a && place(world, a);
      const second = b && place(world, b);
      return first && second ? [sumOf(world, first, second, origin)] : [];
    },
  );
}

/** The sum of the body in a slot with the nearest shape of another body; empty if none is near. */
export function sumsOfBody(world: World, slot: number, origin: Vec2): Sum[] {
  const own = shapesOf(world, slot);
  const first = own[0] && place(world, own[0]);
  if (!first) return [];
  let radius = FIRST_REACH * sizeOf(first.solid);
  for (let i = 0; i < DOUBLINGS; i++, radius *= 2) {
    const sums = world
      .overlap({ kind: "circle", center: first.center, radius })
      .filter((shape) => world.shapeStateOf(shape).body.index !== slot)
      .flatMap((shape) => place(world, shape) ?? [])
      .map((other) => sumOf(world, first, other, origin));
    if (sums.length > 0)
      return [sums.reduce((best, sum) => (distanceOf(sum) < distanceOf(best) ? sum : best))];
  }
  return [];
}

/** Signed distance from the point to the edge of the sum; negative inside. */
function distanceOf({ point, edge, overlaps }: Sum): number {
  const distance = Math.hypot(point[0] - edge[0], point[1] - edge[1]);
  return overlaps ? -distance : distance;
}

/** Null for terrain, of which the engine has no sum. */
function place(world: World, id: ShapeId): Placed | null {
  const shape = world.shapeStateOf(id);
  if (shape.kind === "terrain") return null;
  const { body, offset } = shape;
  const { position, angle } = world.bodyStateOf(body);
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const center: Vec2 = [
    position[0] + c * offset[0] - s * offset[1],
    position[1] + s * offset[0] + c * offset[1],
  ];
  if (shape.kind === "circle") return { solid: { kind: "circle", radius: shape.radius }, center };
  const { kind, halfWidth, halfHeight } = shape;
  if (kind === "aabb") return { solid: { kind, halfWidth, halfHeight }, center };
  return { solid: { kind, halfWidth, halfHeight, angle: angle + shape.angle }, center };
}

/** Half the diagonal of a box, or the radius. */
function sizeOf(solid: SolidShape): number {
  return solid.kind === "circle" ? solid.radius : Math.hypot(solid.halfWidth, solid.halfHeight);
}

/** The sum, relative to `origin`. */
function sumOf(world: World, a: Placed, b: Placed, origin: Vec2): Sum {
  const offset: Vec2 = [b.center[0] - a.center[0], b.center[1] - a.center[1]];
  const { overlaps, edge, outline } = minkowskiSum(world.engine, a.solid, b.solid, offset);
  const start: Vec2 = [a.center[0] - origin[0], a.center[1] - origin[1]];
  return {
    origin: start,
    point: [start[0] + offset[0], start[1] + offset[1]],
    overlaps,
    edge: [start[0] + edge[0], start[1] + edge[1]],
    outline,
  };
}
