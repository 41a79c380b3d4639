// The ground grown by a shape: the line on which the shape’s centre lies wherever the shape is let
// down upon the ground.

import { along, shapeOf, wayOf } from "../geometry/look.js";
import { shrunk } from "./grow.js";

const HEIGHTS = [-1.2, -1.4, -0.6, -1.9, -2.2, -1.1, -1.5, -2.4, -2.1, -1, -1.3, -1.3, -0.9];
/** The ground as the calls take it. */
export const GROUND = { kind: "uniform", x0: -9, spacing: 1.5, heights: HEIGHTS };
const EDGE = 9;
/** From this height a shape is let down by DROP. */
const [TOP, DROP] = [20, 40];
/** Places along x at which it is let down. */
const PLACES = 240;

/**
 * A function that grows the ground, as growShape grows a shape. It remembers the last two lines, which
 * take hundreds of tests each, and stay the same while the shape is dragged.
 */
export function createGround(thud, geometry) {
  const known = { sum: {}, grown: {} };
  const lineOf = (name, shape) => {
    const key = JSON.stringify({ ...shape, center: null });
    if (known[name].key !== key) known[name] = { key, line: edgeOf(thud, geometry, shape) };
    return known[name].line;
  };
  return (state) => growGround(thud, geometry, state, lineOf);
}

function growGround(thud, geometry, state, lineOf) {
  const b = shapeOf(state, "B");
  const way = wayOf(state, "B");
  const segment = [b.center, along(b, way, 1).center];
  const sum = lineOf("sum", b);
  const crossing = geometry.castRayOnTerrain(thud, { kind: "irregular", points: sum }, b.center, way);
  const { height } = geometry.terrainAt(thud, { kind: "irregular", points: sum }, b.center[0]);
  return {
    letters: ["B"],
    shapes: [b],
    ways: [way],
    outline: lineOf("grown", shrunk(b, state.grown)),
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
