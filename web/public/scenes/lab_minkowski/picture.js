// What is drawn: the shapes, the one that grows, what is left of the other, and the segment.

import { LETTERS } from "../geometry/look.js";
import { dot, INKS, line, paintHandles, solid } from "../geometry/picture.js";

export function paintSum(state, grown) {
  const marks = [];
  const { shapes, ways, letters, rest, ground } = grown;
  if (ground) marks.push(line(ground, "ink", { width: 3 }));
  paintGrown(marks, grown);
  shapes.forEach((shape, i) => {
    const ink = INKS[LETTERS.indexOf(letters[i])];
    marks.push({ ...solid(shape), ink, opacity: 0.5 });
    if (letters[i] === "A") marks.push({ ...solid(shape), ink, filled: true, opacity: 0.38 });
    paintHandles(marks, state, shape, ways[i], LETTERS.indexOf(letters[i]));
  });
  marks.push({ ...solid(rest), ink: INKS[1], filled: true, opacity: 0.38 }, { ...solid(rest), ink: INKS[1] });
  if (state.sum) paintSegment(marks, grown);
  return { marks };
}

function paintGrown(marks, { outline, closed, overlaps }) {
  const ink = overlaps ? "bad" : "good";
  const points = closed ? [...outline, outline[0]] : outline;
  if (closed) marks.push(line(points, ink, { filled: true, opacity: 0.2 }));
  marks.push(line(points, ink, { width: 2.5 }));
}

/** B’s centre along the way of B seen from A, and where it enters the sum. */
function paintSegment(marks, { segment: [from, to], crossing, rest }) {
  marks.push(line([from, to], "gold", { dashed: true }));
  marks.push(dot(from, "gold", 0.12));
  if (!crossing) return;
  const at = [0, 1].map((k) => from[k] + crossing.time * (to[k] - from[k]));
  const [u, v] = crossing.normal;
  marks.push(dot(at, "gold", 0.14), line([at, [at[0] + 0.8 * u, at[1] + 0.8 * v]], "gold"));
  marks.push({ ...solid({ ...rest, center: at }), ink: INKS[1], opacity: 0.7 });
}
