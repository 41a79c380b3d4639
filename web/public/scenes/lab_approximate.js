// A polygon approximated by circles and boxes, since bodies have no polygons: what the pieces miss,
// and how fast that falls as there are more of them. No world is needed; the one here is empty.

import { check, slider } from "./geometry/controls.js";
import { paintApproximation } from "./lab_approximate/picture.js";
import { CORNERS, drag, pointsOf } from "./lab_approximate/polygon.js";
import { createSearch, MOST } from "./lab_approximate/search.js";
import { tellApproximation } from "./lab_approximate/tell.js";

export const title = "Approximated polygon";
export const about =
  "An irregular polygon approximated by circles and boxes: the area and distance missed over the count of pieces.";
export const menu = { group: "Laboratory", place: 154 };

const KINDS = [
  { value: "both", label: "Both" },
  { value: "circles", label: "Circles" },
  { value: "boxes", label: "Boxes" },
];
const PIECES = "The pieces";
const NUMBERS = "Corners by numbers";

const CONTROLS = [
  { kind: "choice", name: "kinds", label: "Made up of", options: KINDS, group: PIECES },
  slider("count", "Count of pieces", 1, MOST, 1, PIECES),
  check("missed", "What they miss",
    "Distance missed: no point of the polygon is further from the pieces, nor of the pieces from the polygon.", "Look at"),
  check("curve", "Error over count: area, distance",
    "More pieces miss less, and each costs its tests and memory.", "Look at"),
  ...Array.from({ length: CORNERS }, (_, i) => [
    slider(`x${i}`, `Corner ${i}, x`, -6, 6, 0.05, NUMBERS),
    slider(`y${i}`, `Corner ${i}, y`, -1.5, 5, 0.05, NUMBERS),
  ]).flat(),
];

/** The corners at the start. */
const START = [
  [-5.7, 1.2], [-5.6, -0.8], [0.65, -0.05], [2, -1.05], [3.65, -0.95], [5.1, -0.2],
  [5.75, 1.3], [5.5, 2.9], [4.55, 4.3], [2.95, 4.7], [1.35, 4.3], [0.35, 3.05],
];

export default async function ({ createWorld, loadGeometry, thud }) {
  const geometry = await loadGeometry();
  const search = createSearch(thud, geometry);
  const state = {
    ...{ kinds: "both", count: 6, missed: true, curve: true },
    ...Object.fromEntries(START.flatMap(([x, y], i) => [[`x${i}`, x], [`y${i}`, y]])),
    grip: null, // the corner that the pointer holds
    near: null, // what it would take
  };
  return {
    world: createWorld({ gravity: [0, 0] }),
    view: { x: 0, y: 0.2, height: 12.4, width: 13 },
    pointer: true,
    controls: CONTROLS,
    state,
    pointed: (pointer) => drag(state, pointer),
    paint() {
      const points = pointsOf(state);
      const seen = { points, ...search.look(points, state, state.grip !== null) };
      return { ...paintApproximation(state, seen), ...tellApproximation(seen) };
    },
  };
}
