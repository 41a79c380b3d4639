// The Minkowski sum of two shapes, or of a shape and the ground: one grows by what the other shrinks,
// until a point is left. Whether the two touch, and when, stays the same all the while.

import { check, kindOf, slider, slidersOf } from "./geometry/controls.js";
import { drag } from "./geometry/hands.js";
import { createGround } from "./lab_minkowski/ground.js";
import { growShape } from "./lab_minkowski/grow.js";
import { paintSum } from "./lab_minkowski/picture.js";
import { tellSum } from "./lab_minkowski/tell.js";

export const title = "Growing into the sum";
export const about = "One shape grows into the Minkowski sum as the other shrinks to a point.";
export const menu = { group: "Laboratory", place: 155 };

const SUM = "The sum";
const AGAINST = [
  { value: "shape", label: "Shape" },
  { value: "terrain", label: "Terrain" },
];

const CONTROLS = [
  { kind: "choice", name: "against", label: "B against", options: AGAINST, group: SUM },
  slider("grown", "B shrinks by", 0, 1, 0.01, SUM),
  check("auto", "Grow by itself", "To the sum and back in eight seconds.", SUM),
  check("sum", "Point against sum", "B’s centre goes along a segment, which enters the sum when the shapes meet.", SUM),
  kindOf("A"),
  kindOf("B"),
  ...slidersOf("A"),
  ...slidersOf("B"),
];

/** Steps of growing to the sum, or back. */
const SWELL = 240;

export default async function ({ createWorld, loadGeometry, thud }) {
  const geometry = await loadGeometry();
  const growGround = createGround(thud, geometry);
  const world = createWorld({ gravity: [0, 0] });
  const state = {
    ...{ against: "shape", grown: 0.5, auto: false, sum: true },
    ...{ kindA: "obb", xA: -2.6, yA: -1, angleA: 25, widthA: 3, heightA: 1.6, wayXA: 1, wayYA: 1.4 },
    ...{ kindB: "obb", xB: 3.4, yB: 2.6, angleB: -20, widthB: 2, heightB: 1.2, wayXB: -5, wayYB: -3.5 },
    grip: null, // what the pointer holds
    near: null, // what it would take
  };
  return {
    world,
    view: { x: 0, y: 0.4, height: 11.5, width: 13 },
    pointer: true,
    controls: CONTROLS,
    state,
    pointed: (pointer) => drag(state, pointer, state.against === "terrain" ? ["B"] : undefined),
    update({ step }) {
      if (state.auto) state.grown = Math.abs(((step + SWELL) % (2 * SWELL)) - SWELL) / SWELL;
    },
    paint() {
      const grown = state.against === "terrain" ? growGround(state) : growShape(thud, geometry, state);
      return { ...paintSum(state, grown), ...tellSum(grown) };
    },
  };
}
