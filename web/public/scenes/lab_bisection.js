// The overlap test and its bisection. Above, two shapes to drag: the step in which they move is
// halved until the time of their collision is known. Below, bullets fly at paper, one for each
// detection, in the world itself.

import { check, kindOf, slider, slidersOf } from "./geometry/controls.js";
import { drag } from "./geometry/hands.js";
import { halve, HALVINGS } from "./lab_bisection/halve.js";
import { createRange } from "./lab_bisection/paper.js";
import { paintBisection } from "./lab_bisection/picture.js";
import { tellBisection } from "./lab_bisection/tell.js";

export const title = "Overlap and bisection";
export const about = "A step halved until its collision is found, and bullets that pass through paper.";
export const menu = { group: "Laboratory", place: 150 };

const [MOTION, PAPER] = ["A step, halved", "A bullet and paper"];

const CONTROLS = [
  slider("halving", "Halvings", 0, HALVINGS, 1, MOTION),
  check("auto", "Halve by itself", "One halving more every half second.", MOTION),
  check("interval", "The interval",
    "The shapes are apart at its lower end and overlap at its upper end.", MOTION),
  slider("rate", "Steps a second", 15, 240, 1, PAPER),
  slider("speed", "Speed", 1, 120, 0.5, PAPER),
  slider("thickness", "Thickness", 0.02, 0.5, 0.01, PAPER),
  check("bound", "The bound", "Speed × time step < thickness: then no pose skips the paper.", PAPER),
  kindOf("A"),
  kindOf("B"),
  ...slidersOf("A"),
  ...slidersOf("B"),
];

/** Steps from one halving to the next. */
const PACE = 30;

export default async function ({ createWorld, loadGeometry, thud }) {
  const geometry = await loadGeometry();
  const world = createWorld({ gravity: [0, 0] });
  const state = {
    ...{ halving: 3, auto: false, interval: true },
    ...{ rate: 60, speed: 55, thickness: 0.1, bound: true },
    ...{ kindA: "obb", xA: -3.6, yA: 1, angleA: 20, widthA: 2.4, heightA: 1.2, wayXA: 4, wayYA: 0.4 },
    ...{ kindB: "circle", xB: 3.2, yB: 1.3, angleB: 0, widthB: 1.6, heightB: 1.6, wayXB: -2.6, wayYB: -0.3 },
    grip: null, // what the pointer holds
    near: null, // what it would take
    shot: "", // the settings with which the bullets were fired
    next: 0, // the step of the next shots
  };
  const range = createRange(world, geometry, thud, state);
  return {
    world,
    view: { x: 0, y: -1.6, height: 12, width: 13 },
    pointer: true,
    controls: CONTROLS,
    state,
    pointed: (pointer) => drag(state, pointer),
    update({ step }) {
      if (state.auto && step % PACE === 0) state.halving = (state.halving + 1) % (HALVINGS + 1);
      range.update(step);
    },
    paint() {
      const halved = halve(thud, geometry, state);
      const shots = range.look();
      return { ...paintBisection(state, halved, shots), ...tellBisection(halved, shots) };
    },
  };
}
