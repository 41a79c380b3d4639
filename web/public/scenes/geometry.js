// Two shapes to drag and turn, and what the engine’s geometry tells of them. No world is needed for
// that: the one here is empty. What is drawn and read out stands in geometry/picture.js and tell.js.

import { drag } from "./geometry/hands.js";
import { paintAll } from "./geometry/picture.js";
import { addClock, look } from "./geometry/look.js";
import { tell } from "./geometry/tell.js";

export const title = "Geometry of two shapes";
export const about =
  "Drag and turn two shapes and see how far they are apart, when they meet and what bounds them.";
export const menu = { group: "How it is done", place: 645 };

const KINDS = [
  { value: "circle", label: "Circle" },
  { value: "aabb", label: "AABB" },
  { value: "obb", label: "OBB" },
];

/** What is set of a shape; the letter ends the names in the state. */
const controlsOf = (letter, group) => [
  { kind: "choice", name: `kind${letter}`, label: "Kind", options: KINDS, group },
  ...[
    ["x", "Place, x", -8, 8, 0.05],
    ["y", "Place, y", -5, 5, 0.05],
    ["angle", "Angle, °", -180, 180, 1],
    ["width", "Width", 0.4, 5, 0.1],
    ["height", "Height", 0.4, 5, 0.1],
    ["wayX", "Way, x", -12, 12, 0.1],
    ["wayY", "Way, y", -8, 8, 0.1],
  ].map(([name, label, least, most, step]) => (
    { kind: "slider", name: name + letter, label, least, most, step, group }
  )),
];

const check = (name, label, about) => ({ kind: "check", name, label, about, group: "Look at" });

const CONTROLS = [
  ...controlsOf("A", "Shape A"),
  ...controlsOf("B", "Shape B"),
  check("overlap", "Overlap",
    "Do they share a point? Asked directly, and by halving their ways until it is found when."),
  check("closest", "Closest points",
    "The shortest way from one to the other, or out of each other."),
  check("ways", "Their ways",
    "Where they first touch if both go along their arrows, or how near they come."),
  check("sum", "Minkowski sum",
    "One shape and one point: the point is in the sum while the two overlap, and two ways are one " +
      "segment that enters it."),
  check("circle", "Bounding circle", "The cheapest to test, and it may turn; it fits loosely."),
  check("aabb", "Bounding AABB", "Two intervals to compare; it grows as the shape turns."),
  check("obb", "Bounding OBB", "It turns with the shape and fits best; the dearest of the three."),
];

export default async function ({ createWorld, loadGeometry, thud }) {
  const geometry = await loadGeometry();
  const clock = addClock(thud, geometry);
  const scene = {
    world: createWorld({ gravity: [0, 0] }),
    view: { x: 0.4, y: 0, height: 10.5, width: 13 },
    pointer: true,
    controls: CONTROLS,
    state: {
      ...{ kindA: "obb", xA: -3, yA: -1.2, angleA: 24, widthA: 3.4, heightA: 1.6, wayXA: 1.6, wayYA: 0.9 },
      ...{ kindB: "obb", xB: 3, yB: 1.2, angleB: -32, widthB: 2.2, heightB: 1.5, wayXB: -3.4, wayYB: -0.8 },
      ...{ overlap: true, closest: true, ways: true },
      ...{ sum: false, circle: false, aabb: false, obb: false },
      grip: null, // what the pointer holds
      near: null, // what it would take
    },
    update: ({ pointer }) => drag(scene.state, pointer),
    paint() {
      const seen = look(thud, geometry, scene.state);
      return { ...paintAll(scene.state, seen), ...tell(scene.state, seen, clock.costs(seen)) };
    },
  };
  return scene;
}
