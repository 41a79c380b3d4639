/**
 * Geometry of two shapes without a world: how far apart they are, when they meet on their ways, and
 * what bounds them. Every call throws for sizes that are not above 0 and numbers that are not finite.
 *
 *     import { closestPoints } from "thud/geometry";
 *     const { distance } = closestPoints(thud, { kind: "circle", center: [0, 0], radius: 1 }, other);
 */
export { type MinkowskiSum, minkowskiSum } from "../minkowski.js";
export * from "./passing.js";
export * from "./volumes.js";
