// The swept test. Above, two circles to drag on their ways: the quadratic equation that gives their
// time of impact. Below, a ball in free flight: its parabola beside the straight way of each step.

import { check, slider, slidersOf } from "./geometry/controls.js";
import { drag } from "./geometry/hands.js";
import { createFlight } from "./lab_swept/flight.js";
import { paintSwept } from "./lab_swept/picture.js";
import { solve } from "./lab_swept/quadratic.js";
import { tellSwept } from "./lab_swept/tell.js";

export const title = "Swept";
export const about = "When two moving circles touch, as a quadratic equation, and a flight cut into straight ways.";
export const menu = { group: "Laboratory", place: 151 };

const FLIGHT = "Straight way and parabola";

/** The height of a circle is its width: it has no slider, nor has an angle. */
const ofCircle = ({ name }) => !/^(height|angle)/.test(name);

const CONTROLS = [
  check("equation", "Time of impact", "|p + v t|² = R²: at the smaller root the circles first touch.", "Two circles"),
  check("nearest", "Closest approach", "Where p + v t is shortest, without regard to an impact.", "Two circles"),
  slider("gravity", "Gravity", 0, 30, 0.5, FLIGHT),
  slider("step", "Time step dt, s", 0.02, 0.5, 0.01, FLIGHT),
  check("sagitta", "The sagitta", "Half way through a step the parabola is g dt²/8 above the straight way.", FLIGHT),
  ...slidersOf("A").filter(ofCircle),
  ...slidersOf("B").filter(ofCircle),
];

export default async function ({ createWorld, loadGeometry, thud }) {
  const geometry = await loadGeometry();
  const world = createWorld({ gravity: [0, -10], timeStep: 0.3 });
  const state = {
    ...{ equation: true, nearest: true },
    ...{ gravity: 10, step: 0.3, sagitta: true },
    ...{ kindA: "circle", xA: -4.6, yA: 1.2, angleA: 0, widthA: 1.6, heightA: 1.6, wayXA: 6, wayYA: 1.2 },
    ...{ kindB: "circle", xB: 4, yB: 3.2, angleB: 0, widthB: 2, heightB: 2, wayXB: -5, wayYB: -0.5 },
    grip: null, // what the pointer holds
    near: null, // what it would take
    thrown: "", // the settings with which the ball was thrown
    next: 0, // the step of the next throw
    trace: [], // where the ball was since
  };
  const flight = createFlight(world, state);
  return {
    world,
    view: { x: 0, y: 0, height: 12, width: 13 },
    pointer: true,
    controls: CONTROLS,
    state,
    hidden: [flight.slot],
    pointed: (pointer) => drag(state, pointer),
    update: ({ step }) => flight.update(step),
    stepped: flight.stepped,
    paint() {
      const met = solve(thud, geometry, state);
      const flown = flight.look();
      return { ...paintSwept(state, met, flown), ...tellSwept(met, flown) };
    },
  };
}
