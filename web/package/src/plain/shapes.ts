/**
 * Shapes in few words, for bodies, movers and queries: plain objects, which may as well be written
 * out. Numbers are checked by the call that is given them.
 *
 *     world.createBody({ position: [0, 3], shapes: [circle(0.5, { restitution: 0.8 })] });
 */
import { ThudError } from "../error.js";
import type { BoxOptions, CircleOptions, ObbOptions } from "../types.js";

/** What a shape is given beside its form. */
export type CircleRest = Omit<CircleOptions, "kind" | "radius">;
/** Likewise. */
export type BoxRest = Omit<BoxOptions, "kind" | "halfWidth" | "halfHeight">;
/** Likewise. */
export type ObbRest = Omit<ObbOptions, "kind" | "halfWidth" | "halfHeight">;

type Circle = CircleOptions & { kind: "circle" };
type Aabb = BoxOptions & { kind: "aabb" };
type Obb = ObbOptions & { kind: "obb"; angle: number };

/** A circle of a body. */
export function circle(radius: number, rest?: CircleRest): Circle {
  return { ...rest, kind: "circle", radius };
}

/** A box that keeps its axes: the rotation of its body is fixed. */
export function aabb(halfWidth: number, halfHeight: number, rest?: BoxRest): Aabb {
  return { ...rest, kind: "aabb", halfWidth, halfHeight };
}

/** A box that turns with its body. */
export function obb(halfWidth: number, halfHeight: number, rest?: ObbRest): Obb {
  return { angle: 0, ...rest, kind: "obb", halfWidth, halfHeight };
}

/**
 * Four boxes around a rectangle that keep in what is in it. Half the sizes are those of the rectangle,
 * and `offset` its centre; throws where the walls are not above 0 thick.
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
