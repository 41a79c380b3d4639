// The numbers that the panel reads out, and the line over the picture.

import { number, yesNo } from "../geometry/tell.js";

const place = (vec) => vec.map(number).join(", ");

export function tellCapsules({ a, b, closest, segment, impact }) {
  const { overlaps, distance, normal, pointA, pointB } = closest;
  const rows = [
    ["They overlap", yesNo(overlaps)],
    ["Segment of A from B", segment.toFixed(3)],
    ["Radius of A", a.radius.toFixed(3)],
    ["Distance, segment − radius", distance.toFixed(3)],
    ["Depth", overlaps ? (-distance).toFixed(3) : "none"],
    ["Normal, A to B", place(normal)],
    ["Point of A", place(pointA)],
    ["Point of B", place(pointB)],
  ];
  const way = [
    ["The circle hits B", impact === null ? "never" : `at ${impact.toFixed(4)} of its way`],
    ["The capsule overlaps B", yesNo(overlaps)],
    ["Length of the way", Math.hypot(a.to[0] - a.from[0], a.to[1] - a.from[1]).toFixed(2)],
  ];
  return { readings: { closest: rows, way }, message: message(b, overlaps) };
}

const NAMES = { circle: "the circle", aabb: "the AABB", obb: "the OBB", capsule: "capsule B" };

/** Without numbers, which change all the time while something is dragged: it is said aloud. */
function message({ kind }, overlaps) {
  return overlaps
    ? `Capsule A overlaps ${NAMES[kind]}: the circle on this way hits it.`
    : `Capsule A and ${NAMES[kind]} are apart: the circle on this way passes.`;
}
