// The numbers that the panel reads out, and the line over the picture.

import { number, yesNo } from "../geometry/tell.js";

export function tellSum({ crossing, swept, inside, overlaps, outline }) {
  const time = (value) => (value === null ? "never" : value.toFixed(4));
  const rows = [
    ["The segment enters the sum at", time(crossing && crossing.time)],
    ["The swept shapes meet at", time(swept)],
    ["Normal there", crossing ? crossing.normal.map(number).join(", ") : "none"],
    ["The centre is in the sum", yesNo(inside)],
    ["The shapes overlap", yesNo(overlaps)],
    ["Corners of what has grown", String(outline.length)],
  ];
  return { readings: { sum: rows }, message: message(overlaps, swept) };
}

/** Without numbers, which change all the time while something is dragged: it is said aloud. */
function message(overlaps, swept) {
  if (overlaps) return "They overlap: B’s centre is in the sum.";
  return swept === null
    ? "The segment passes the sum: they do not meet."
    : "They meet where the segment enters the sum.";
}
