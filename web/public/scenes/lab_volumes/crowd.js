// What stands around shapes, and how often it tells the truth of their pairs.

import { areaOf } from "../geometry/tell.js";
import { VOLUMES } from "../geometry/look.js";

/** The bounding volumes, and a proxy. */
export const KINDS = [...VOLUMES, "proxy"];

/** Where the crowd is, below the two shapes. */
const [HALF_WIDTH, BOTTOM, TOP] = [6, -4.9, 1];

/** Places and directions of a crowd; the same for the same generator. */
export function makeCrowd(chance, count) {
  // As many cover about as much of the window.
  const length = 5.2 / Math.sqrt(count);
  return Array.from({ length: count }, () => (
    { x: chance(-HALF_WIDTH, HALF_WIDTH), y: chance(BOTTOM, TOP), spread: chance(-1, 1), length }
  ));
}

/** One of the crowd as a box: so slender, and turned by up to so much. */
export function moved({ x, y, spread, length }, { slender, turned }) {
  return {
    kind: "obb",
    center: [x, y],
    halfWidth: 0.5 * length * Math.sqrt(slender),
    halfHeight: (0.5 * length) / Math.sqrt(slender),
    angle: (spread * turned * Math.PI) / 180,
  };
}

/** A circle of the same area. */
function proxyOf(shape) {
  return { kind: "circle", center: shape.center, radius: Math.sqrt(areaOf(shape) / Math.PI) };
}

/**
 * By kind: `volumes`, one for each shape; `overlap`, whether those of the first two do; and `wasted`,
 * the share of their area that exceeds that of the shapes, 0 for proxies.
 */
export function boundsOf(thud, geometry, shapes) {
  const filled = sum(shapes);
  return Object.fromEntries(KINDS.map((kind) => {
    const around = (shape) =>
      kind === "proxy" ? proxyOf(shape) : geometry.volumeAroundShape(thud, kind, shape);
    const volumes = shapes.map(around);
    const overlap = geometry.volumesOverlap(thud, volumes[0], volumes[1]);
    return [kind, { volumes, overlap, wasted: 1 - filled / sum(volumes) }];
  }));
}

const sum = (shapes) => shapes.reduce((area, shape) => area + areaOf(shape), 0);

/**
 * Tests all pairs. `hits`: those that overlap. By kind also `told`, the pairs whose volumes overlap;
 * `alarms`, those of them that do not overlap themselves; `missed`, pairs that overlap although
 * their volumes do not.
 */
export function countCrowd(thud, geometry, shapes) {
  const bounds = boundsOf(thud, geometry, shapes);
  const pairs = shapes.flatMap((_, i) => shapes.slice(0, i).map((_, k) => [k, i]));
  const hits = pairs.map(([i, k]) => geometry.closest(thud, shapes[i], shapes[k]).overlaps);
  for (const kind of KINDS) {
    const { volumes } = bounds[kind];
    const told = pairs.map(([i, k]) => geometry.volumesOverlap(thud, volumes[i], volumes[k]));
    const alarms = pairs.filter((_, i) => told[i] && !hits[i]);
    const missed = pairs.filter((_, i) => !told[i] && hits[i]);
    Object.assign(bounds[kind], { told: told.filter(Boolean).length, alarms, missed });
  }
  return { shapes, bounds, pairs: pairs.length, hits: hits.filter(Boolean).length };
}
