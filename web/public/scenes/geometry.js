// Two shapes to drag and turn, and what the engine’s geometry tells of them. No world is needed for
// that: the one here is empty. What is drawn and read out stands in geometry/picture.js and tell.js.

import { check, kindOf, slidersOf } from "./geometry/controls.js";
import { drag } from "./geometry/hands.js";
import { paintAll } from "./geometry/picture.js";
import { addClock, look } from "./geometry/look.js";
import { tell } from "./geometry/tell.js";

export const title = "Geometry of two shapes";
export const about =
  "Drag and turn two shapes and see how far they are apart, when they meet and what bounds them.";
export const menu = { group: "How it is done", place: 645 };

const CONTROLS = [
  kindOf("A"),
  kindOf("B"),
  check("overlap", "Overlap",
    "Do they share a point? Asked directly, and by halving their ways until it is found when."),
  check("closest", "Closest points",
    "The shortest way from one to the other, or out of each other."),
  check("ways", "Their ways",
    "Where they first touch if both go along their arrows, and how near they come: below 0, how deep."),
  check("sum", "Minkowski sum",
    "One shape and one point: the point is in the sum while the two overlap, and two ways are one " +
      "segment that enters it."),
  check("circle", "Bounding circle", "One distance to compare, the same however the shape turns; it fits loosely."),
  check("aabb", "Bounding AABB", "Two intervals to compare; it grows and shrinks as the shape turns."),
  check("obb", "Bounding OBB", "It turns with the shape and fits best."),
  ...slidersOf("A"),
  ...slidersOf("B"),
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
      ...{ kindA: "obb", xA: -3.2, yA: -1.6, angleA: -154, widthA: 3.4, heightA: 1.6 },
      ...{ kindB: "obb", xB: 3, yB: -0.2, angleB: -32, widthB: 2.2, heightB: 1.5 },
      ...{ wayXA: 2.6, wayYA: 3.2, wayXB: -3, wayYB: 2.4 },
      ...{ overlap: true, closest: true, ways: true },
      ...{ sum: false, circle: false, aabb: false, obb: false },
      grip: null, // what the pointer holds
      near: null, // what it would take
    },
    pointed: (pointer) => drag(scene.state, pointer),
    paint() {
      const seen = look(thud, geometry, scene.state);
      return { ...paintAll(scene.state, seen), ...tell(scene.state, seen, clock.costs(seen)) };
    },
  };
  return scene;
}
