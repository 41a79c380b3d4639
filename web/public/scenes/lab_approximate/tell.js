// The numbers that the panel reads out, and the line over the picture.

import { COUNTS } from "./search.js";

const percent = (share) => `${(100 * share).toFixed(2)} %`;

export function tellApproximation({ found, known, reason }) {
  if (reason) return { readings: {}, message: `The engine refuses this polygon: ${reason}.` };
  const { shapes, missed, extra, overlap, distance, milliseconds } = found;
  const circles = shapes.filter(({ kind }) => kind === "circle").length;
  const rows = [
    ["Distance missed, at most", distance.toFixed(3)],
    ["Area missed", percent(missed)],
    ["Area outside of the polygon", percent(extra)],
    ["Area that pieces share", percent(overlap)],
    ["Circles", String(circles)],
    ["Boxes", String(shapes.length - circles)],
    ["The search took", `${milliseconds.toFixed(1)} ms`],
  ];
  return { readings: { missed: rows, curve: curveRows(known) } };
}

/** Area missed and outside, and the distance, at some counts, as far as they are known. */
function curveRows(known) {
  return COUNTS.filter((n) => Number.isInteger(Math.log2(n)) || n === COUNTS.at(-1)).map((n) => {
    const found = known.get(n);
    const error = found && `${percent(found.missed + found.extra)}, ${found.distance.toFixed(3)}`;
    return [`${n} ${n === 1 ? "piece" : "pieces"}`, error ?? "being searched"];
  });
}
