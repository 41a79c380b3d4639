// The numbers that the panel reads out, and the line over the picture.

import { percent } from "../geometry/tell.js";
import { KINDS } from "./crowd.js";

export function tellVolumes(seen, costs) {
  const rows = KINDS.map((kind) => [kind, rowsOf(seen, kind, costs[kind])]);
  const { shapes, pairs, hits } = seen.crowd;
  const exact = [
    ["A test takes", nanoseconds(costs.exact)],
    ["Cheapest test", extreme(costs, Math.max)],
    ["Dearest test", extreme(costs, Math.min)],
    ["Pairs of the crowd", String(pairs)],
    ["Of them overlap", String(hits)],
    ["Shapes", String(shapes.length)],
  ];
  return { readings: { ...Object.fromEntries(rows), exact }, message: message(seen) };
}

/** Without numbers, which change all the time while something is dragged: it is said aloud. */
function message({ bounds, overlaps }) {
  const told = Object.fromEntries(KINDS.map((kind) => [kind, bounds[kind].overlap]));
  if (overlaps && !told.proxy) return "A and B overlap, and their proxies miss it.";
  if (overlaps) return "A and B overlap, and every bound tells it.";
  const alarms = KINDS.filter((kind) => told[kind]).map((kind) => WORDS[kind]);
  return alarms.length > 0
    ? `A and B are apart. False alarm: ${alarms.join(", ")}.`
    : "A and B are apart, and so are all bounds.";
}

const WORDS = { circle: "circles", aabb: "AABBs", obb: "OBBs", proxy: "proxies" };

function rowsOf({ bounds, crowd }, kind, cost) {
  const { told, alarms, missed, wasted } = crowd.bounds[kind];
  return [
    ["A test takes", nanoseconds(cost)],
    ["A and B by it", bounds[kind].overlap ? "overlap" : "apart"],
    ["Area wasted, A and B", percent(bounds[kind].wasted)],
    ["Area wasted, crowd", percent(wasted)],
    ["Pairs told in the crowd", String(told)],
    ["False alarms", String(alarms.length)],
    ["Missed", String(missed.length)],
  ];
}

const NAMES = { circle: "circle", aabb: "AABB", obb: "OBB", proxy: "proxy", exact: "exact" };

/** The test whose measured rate is the greatest or least of all, once all are measured. */
function extreme(costs, of) {
  const names = Object.keys(NAMES);
  if (names.some((name) => !costs[name])) return "being measured";
  const rate = of(...names.map((name) => costs[name]));
  return `${NAMES[names.find((name) => costs[name] === rate)]}, ${nanoseconds(rate)}`;
}

const nanoseconds = (rate) => (rate ? `${(1000 / rate).toPrecision(3)} ns` : "being measured");
