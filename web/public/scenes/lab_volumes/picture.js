// What is drawn: two shapes with the chosen volume around them, and the crowd with its volumes, its
// false alarms and what is missed as lines from centre to centre.

import { dot, INKS, line, solid, text } from "../geometry/picture.js";
import { knobOf } from "../geometry/hands.js";
import { LETTERS } from "../geometry/look.js";

export function paintVolumes(state, { shapes, bounds, overlaps, crowd }) {
  const marks = [];
  const { drawn } = state;
  const [first, second] = bounds[drawn].volumes;
  for (const volume of [first, second]) marks.push({ ...solid(volume), ink: "gold" });
  shapes.forEach((shape, i) => paintShape(marks, state, shape, overlaps ? "bad" : INKS[i], i));
  paintCrowd(marks, crowd, drawn);
  return { marks };
}

function paintShape(marks, state, shape, ink, i) {
  marks.push({ ...solid(shape), ink, filled: true, opacity: 0.38 }, { ...solid(shape), ink });
  const knob = knobOf(shape);
  if (knob) {
    const held = state.near?.part === "turn" && state.near.letter === LETTERS[i];
    marks.push(line([shape.center, knob], ink, { dashed: true, width: 1.5 }));
    marks.push(dot(knob, ink, held ? 0.26 : 0.17));
  }
  const [x, y] = shape.center;
  marks.push(text([x - 0.3, y - 0.3], LETTERS[i], ink));
}

function paintCrowd(marks, { shapes, bounds }, drawn) {
  const { volumes, alarms, missed } = bounds[drawn];
  for (const volume of volumes) marks.push({ ...solid(volume), ink: "soft", opacity: 0.7 });
  for (const shape of shapes) marks.push({ ...solid(shape), ink: "accent", filled: true, opacity: 0.5 });
  const join = (pairs, ink, more) => {
    for (const [i, k] of pairs)
      marks.push(line([shapes[i].center, shapes[k].center], ink, { width: 2.5, ...more }));
  };
  join(alarms, "gold", { dashed: true });
  join(missed, "bad", { width: 4 });
}
