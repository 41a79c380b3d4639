// A line of ground to drag: where a place is found on it, what the two vertices beside it weigh, and
// what is made of that: height, texture coordinate, friction, the place of a foot. Without a world it
// is asked in lab_terrain/look.js; the box slides in the world, on the same line.

import { addClock } from "./lab_terrain/cost.js";
import { drag } from "./lab_terrain/hands.js";
import { ENDS, INNER, lineOf, textureOf, VERTICES } from "./lab_terrain/line.js";
import { look } from "./lab_terrain/look.js";
import { paintAll } from "./lab_terrain/picture.js";
import { addRunner } from "./lab_terrain/runner.js";
import { tell } from "./lab_terrain/tell.js";

export const title = "Terrain";
export const about =
  "Drag the ground, and see how a place on it is found and what its two vertices weigh there.";
export const menu = { group: "Laboratory", place: 158 };

const check = (name, label, about) => ({ kind: "check", name, label, about, group: "Look at" });
const slider = (name, label, least, most, step, group) => (
  { kind: "slider", name, label, least, most, step, group }
);

const CONTROLS = [
  {
    kind: "choice",
    name: "line",
    label: "Is",
    options: [
      { value: "flat", label: "Flat" },
      { value: "uniform", label: "Uniform" },
      { value: "irregular", label: "Irregular" },
    ],
    group: "The line",
  },
  check("weights", "Weights at a place",
    "The nearer vertex weighs more; with these two weights whatever the vertices have is interpolated."),
  check("foot", "Feet on the ground",
    "Each sole stands on the highest ground under it; the character leans by the line between its ends."),
  check("box", "A box on textured ground",
    "Its friction is read where it touches: weights give the texture coordinate, and the texture the friction. " +
    "The sum is of a box that never leaves the ground: where the line bends down, this one flies."),
  check("cost", "What a look-up costs",
    "Flat ground needs no search, equal distances a division, any others a binary search."),
  slider("x", "Place, x", -7.9, 7.9, 0.05, "Set by numbers"),
  slider("stance", "Width of the stance", 0.6, 4, 0.1, "Set by numbers"),
  slider("speed", "Speed of the box", 1, 12, 0.5, "Set by numbers"),
  slider("left", "Friction at the left end", 0, 1.2, 0.01, "Set by numbers"),
  slider("right", "Friction at the right end", 0, 1.2, 0.01, "Set by numbers"),
  slider("size", "Vertices of the measured lines, a power of 2", 2, 17, 1, "Set by numbers"),
  ...Array.from({ length: VERTICES }, (_, i) =>
    slider(`y${i}`, `Height of vertex ${i}`, -2, 3, 0.05, "Vertices by numbers")),
  ...INNER.map((i) =>
    slider(`x${i}`, `Place of vertex ${i}, irregular`, ...ENDS, 0.05, "Vertices by numbers")),
];

/** Heights and irregular places of the vertices at the start. */
const HEIGHTS = [1, 0.7, 0.35, 0.2, 0.3, 0.05, -0.3, -0.15, 0.5];
const PLACES = [-8, -6.2, -3.6, -2.2, -0.6, 1.6, 3.4, 6.2, 8];

export default async function ({ createWorld, loadGeometry, thud }) {
  const geometry = await loadGeometry();
  const clock = addClock(thud, geometry);
  const state = {
    ...{ line: "irregular", x: 0.7, stance: 1.6, speed: 7, left: 0.5, right: 0.02, size: 10 },
    ...{ weights: true, foot: true, box: true, cost: false },
    ...Object.fromEntries(HEIGHTS.map((y, i) => [`y${i}`, y])),
    ...Object.fromEntries(PLACES.map((x, i) => [`x${i}`, x])),
    grip: null, // what the pointer holds
    near: null, // what it would take
  };
  const world = createWorld();
  const runner = addRunner(world, state);
  const scene = {
    world,
    view: { x: 0, y: 0.6, height: 9.5, width: 18.4 },
    pointer: true,
    keys: { left: "move", right: "move", up: "raise", down: "lower", fire: "slide" },
    controls: CONTROLS,
    state,
    pointed: (pointer) => drag(scene.state, pointer),
    update: (input) => runner.update(scene.state, input),
    paint() {
      const seen = look(thud, geometry, scene.state, lineOf(scene.state), textureOf(scene.state));
      const box = runner.look(scene.state);
      const costs = scene.state.cost ? clock.costs(2 ** scene.state.size) : null;
      return { ...paintAll(scene.state, seen, box), ...tell(scene.state, seen, box, costs) };
    },
  };
  return scene;
}
