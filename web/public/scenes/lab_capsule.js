// A capsule, which is an extruded circle: what a circle covers on a straight way. It is tested
// against a circle, a box or another capsule without a world; the one here is empty.

import { check, slider } from "./geometry/controls.js";
import { drag } from "./lab_capsule/hands.js";
import { paintCapsules } from "./lab_capsule/picture.js";
import { look } from "./lab_capsule/solids.js";
import { tellCapsules } from "./lab_capsule/tell.js";

export const title = "Capsules: extruded circles";
export const about =
  "A capsule against a circle, a box or a capsule: distance, normal, overlap, and the circle that it is the way of.";
export const menu = { group: "Laboratory", place: 152 };

const KINDS = [
  { value: "circle", label: "Circle" },
  { value: "aabb", label: "AABB" },
  { value: "obb", label: "OBB" },
  { value: "capsule", label: "Capsule" },
];
const A = "Capsule A by numbers";
const B = "B by numbers";
const place = (name, label, group) => [
  slider(`x${name}`, `${label}, x`, -6, 6, 0.05, group),
  slider(`y${name}`, `${label}, y`, -5, 5, 0.05, group),
];

const CONTROLS = [
  { kind: "choice", name: "kindB", label: "B is", options: KINDS, group: "Capsule A against B" },
  check("closest", "Distance and normal",
    "The distance of A’s segment from B less the radius; below 0 they overlap, by that depth.", "Look at"),
  check("way", "The way of a circle",
    "A circle that goes along A’s segment hits B exactly if the capsule overlaps B.", "Look at"),
  ...place("A1", "First end", A),
  ...place("A2", "Second end", A),
  slider("radiusA", "Radius", 0.1, 2, 0.05, A),
  ...place("B1", "Centre, or first end", B),
  ...place("B2", "Second end of a capsule", B),
  slider("radiusB", "Radius", 0.1, 2, 0.05, B),
  slider("widthB", "Width of a box", 0.4, 5, 0.1, B),
  slider("heightB", "Height of a box", 0.4, 5, 0.1, B),
  slider("angleB", "Angle of an OBB, °", -180, 180, 1, B),
];

export default async function ({ createWorld, loadGeometry, thud }) {
  const geometry = await loadGeometry();
  const state = {
    ...{ kindB: "obb", closest: true, way: true },
    ...{ xA1: -4, yA1: -1.6, xA2: 1.4, yA2: 2.4, radiusA: 0.8 },
    ...{ xB1: 2.4, yB1: -0.9, xB2: 4.4, yB2: 1.6, radiusB: 0.7 },
    ...{ widthB: 3, heightB: 1.4, angleB: 25 },
    grip: null, // what the pointer holds
    near: null, // what it would take
  };
  return {
    world: createWorld({ gravity: [0, 0] }),
    view: { x: 0, y: 0.2, height: 10.5, width: 13 },
    pointer: true,
    controls: CONTROLS,
    state,
    pointed: (pointer) => drag(state, pointer),
    paint() {
      const seen = look(thud, geometry, state);
      return { ...paintCapsules(state, seen), ...tellCapsules(seen) };
    },
  };
}
