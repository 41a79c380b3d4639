// The ground grown by a shape: the line on which the shape’s centre lies wherever the shape is let
// down upon the ground.

import { along, shapeOf, wayOf } from "../geometry/look.js";
import { shrunk } from "./grow.js";

const HEIGHTS = [-2.2, -2.4, -1.6, -2.9, -3.2, -2.1, -2.5, -3.4, -3.1, -2.0, -2.3, -2.3, -1.9];
/** The ground as the calls take it. */
export const GROUND = { kind: "uniform", x0: -9, spacing: 1.5, heights: HEIGHTS };
const EDGE = 9;
/** From this height a shape is let down by DROP. */
const [TOP, DROP] = [20, 40];
/** Places along x at which it is let down. */
const PLACES = 360;

export function growGround(thud, geometry, state) {
  const b = shapeOf(state, "B");
  const way = wayOf(state, "B");
  const segment = [b.center, along(b, way, 1).center];
  const sum = edgeOf(thud, geometry, b);
  const crossing = geometry.castRayOnTerrain(thud, { kind: "irregular", points: sum }, b.center, way);
  const { height } = geometry.terrainAt(thud, { kind: "irregular", points: sum }, b.center[0]);
  return {
    letters: ["B"],
    shapes: [b],
    ways: [way],
    outline: edgeOf(thud, geometry, shrunk(b, state.grown)),
    closed: false,
    rest: shrunk(b, 1 - state.grown),
    segment,
    crossing: crossing && { time: crossing.fraction, normal: crossing.normal },
    swept: geometry.timeOfImpactOnTerrain(thud, GROUND, b, { way }),
    inside: b.center[1] <= height,
    overlaps: geometry.closestOnTerrain(thud, GROUND, b).overlaps,
    ground: HEIGHTS.map((y, i) => [GROUND.x0 + i * GROUND.spacing, y]),
  };
}

/** The line of the shape’s centres, by the exact time of impact of letting it down at each place. */
function edgeOf(thud, geometry, shape) {
  const motion = { way: [0, -DROP] };
  return Array.from({ length: PLACES + 1 }, (_, i) => {
    const x = -EDGE + (2 * EDGE * i) / PLACES;
    const time = geometry.timeOfImpactOnTerrain(thud, GROUND, { ...shape, center: [x, TOP] }, motion);
    return [x, TOP - time * DROP];
  });
}
