/**
 * "thud/geometry": geometry without a world: distances, contact points, times of impact of moving
 * shapes, Minkowski sums, bounding volumes, capsules, terrain lines, and polygons approximated by
 * circles and boxes. Every call throws a ThudError "invalid" for sizes
 * that are not above 0, numbers that are not finite, and coordinates and sizes above 10¹⁵.
 *
 *     import { closest } from "thud/geometry";
 *     const { distance } = closest(thud, { kind: "circle", center: [0, 0], radius: 1 }, other);
 */
export { type MinkowskiSum, minkowskiSum } from "../minkowski.js";
export { approximate, type Approximation, type ApproximateOptions } from "./approximate.js";
export * from "./capsule.js";
export * from "./passing.js";
export * from "./terrain.js";
export * from "./volumes.js";
