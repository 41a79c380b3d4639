/**
 * Short functions that make the options of shapes for bodies, movers and queries. They return plain
 * objects, which could be written out as well, and check nothing: the call that gets them does.
 *
 *     world.createBody({ position: [0, 3], shapes: [circle(0.5, { restitution: 0.8 })] });
 */
import { ThudError } from "../error.js";
import type { BoxOptions, CircleOptions, ObbOptions } from "../types.js";

/** The options of a circle beside its radius. */
export type CircleRest = Omit<CircleOptions, "kind" | "radius">;
/** The options of an AABB beside its half extents. */
export type BoxRest = Omit<BoxOptions, "kind" | "halfWidth" | "halfHeight">;
/** The options of an OBB beside its half extents. */
export type ObbRest = Omit<ObbOptions, "kind" | "halfWidth" | "halfHeight">;

type Circle = CircleOptions & { kind: "circle" };
type Aabb = BoxOptions & { kind: "aabb" };
type Obb = ObbOptions & { kind: "obb"; angle: number };

/** A circle; `radius`: length. */
export function circle(radius: number, rest?: CircleRest): Circle {
  return { ...rest, kind: "circle", radius };
}

/** An axis-aligned box by its half extents, length. It fixes the rotation of its body. */
export function aabb(halfWidth: number, halfHeight: number, rest?: BoxRest): Aabb {
  return { ...rest, kind: "aabb", halfWidth, halfHeight };
}

/** An oriented box by its half extents, length, which turns with its body. */
export function obb(halfWidth: number, halfHeight: number, rest?: ObbRest): Obb {
  return { angle: 0, ...rest, kind: "obb", halfWidth, halfHeight };
}

/**
 * Four boxes that enclose a rectangle with these half extents, whose centre is `offset`; all
 * lengths.
 * @throws {ThudError} "invalid" for a thickness that is not above 0.
 */
export function walls(
  halfWidth: number,
  halfHeight: number,
  thickness: number,
  rest: BoxRest = {},
): Aabb[] {
  if (!(thickness > 0))
    throw new ThudError("invalid", `walls: thickness must be above 0: ${thickness}`);
  const [x, y] = rest.offset ?? [0, 0];
  const half = thickness / 2;
  const [left, top] = [halfWidth + half, halfHeight + half];
  const level = (offset: BoxOptions["offset"]) =>
    aabb(halfWidth + thickness, half, { ...rest, offset });
  const upright = (offset: BoxOptions["offset"]) => aabb(half, halfHeight, { ...rest, offset });
  return [
    level([x, y + top]),
    level([x, y - top]),
    upright([x + left, y]),
    upright([x - left, y]),
  ];
}
