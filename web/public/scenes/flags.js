// Wind in a park of flags. Each has three stripes of plates, hinged to one another and to its pole;
// wind that slants along a plate lifts it, and so flags flutter. Turn the wind with the arrow keys.

import { NOTHING, partsOf } from "./joints/parts.js";
import { blow, windAt } from "./fields/act.js";

export const title = "Flags";
export const about = "Gusts of wind cross a park of flags, one after another: turn the wind yourself.";
export const menu = { group: "Water, wind, fire", place: 552 };
export const size = { means: "flags", usual: 5, least: 1, most: 100 };

const [STRIPES, PLATES] = [3, 7];
const SPACING = 6.5; // from pole to pole
const [HALF_LENGTH, HALF_HEIGHT] = [0.3, 0.24];
const AIR = { density: 0.08, drag: 1.1, lift: 1 };
const [STRONGEST, TURN] = [15, 0.15]; // metres a second; and what a key makes of it in a step

export default function ({ createWorld, grid, size }) {
  const world = createWorld();
  const parts = partsOf(world, grid);
  const half = 0.5 * SPACING * size;
  addPark(world, parts, half);

  const poleX = (i) => SPACING * (i - 0.5 * size);
  const poleTop = (i) => 7 + 0.9 * (i % 3);
  for (let i = 0; i <= size; i++) (i % 2 ? addTree : addBench)(parts, poleX(i) - 1.5);
  const poles = Array.from({ length: size }, (_, i) => addPole(parts, poleX(i), poleTop(i)));
  // Stripe by stripe over all flags: colours go by the order of bodies.
  for (let stripe = 0; stripe < STRIPES; stripe++)
    poles.forEach((pole, i) =>
      addStripe(parts, pole, poleX(i), poleTop(i) - HALF_HEIGHT * (2 * stripe + 1.2)),
    );

  const gusts = { origin: -half };
  const scene = {
    world,
    view: { x: 0, y: 4.6, height: 12.5, width: 2 * half + 5 },
    spawn: [0, 10],
    keys: { left: "blow to the left", right: "blow to the right" },
    state: { wind: 9, step: 0, blown: 0 },
    update({ step, held }) {
      const { state } = scene;
      const wind = state.wind + TURN * (held.right - held.left);
      state.wind = Math.max(-STRONGEST, Math.min(STRONGEST, wind));
      state.step = step;
      state.blown += windAt(step, 0, state.wind, gusts) / 60;
      blow(world, step, state.wind, gusts, AIR);
    },
    paint,
  };
  return scene;

  function paint() {
    const { wind, step, blown } = scene.state;
    const now = Math.abs(windAt(step, 0, wind, gusts));
    const arrow = wind < 0 ? "← " : wind > 0 ? "→ " : "";
    return {
      marks: streaks(2 * half + 12, blown, now),
      figures: [{ label: "Wind", value: `${arrow}${now.toFixed(0)} m/s` }],
    };
  }
}

/** Lines that the air carries along, longer and clearer the faster it is. */
function streaks(width, blown, speed) {
  return Array.from({ length: 9 }, (_, i) => {
    const at = 0.37 * i * width + (0.8 + 0.05 * i) * blown;
    const x = at - width * Math.floor(at / width) - 0.5 * width;
    const y = 1.6 + ((i * 2.9) % 8.6);
    const half = 0.12 * speed;
    const points = [[x - half, y], [x, y + 0.05], [x + half, y]];
    return { kind: "line", points, ink: "soft", width: 1.5, opacity: Math.min(0.45, 0.04 * speed) };
  });
}

const friction = 0.8;

function addPark(world, { fixed }, half) {
  const points = [
    [-half - 30, 8], [-half - 12, 1.2], [-half - 4, 0],
    [half + 4, 0], [half + 12, 1.2], [half + 30, 8],
  ];
  world.createTerrain(fixed().body, { kind: "irregular", points }, { friction });
}

function addTree({ fixed, addBox }, x) {
  const tree = fixed([x, 0]);
  addBox(tree, 0.13, 0.5, { offset: [0, 0.5], friction });
  for (let i = 0; i < 4; i++)
    addBox(tree, 1.05 - 0.25 * i, 0.275, { offset: [0, 1.25 + 0.55 * i], friction });
}

function addBench({ fixed, addBox }, x) {
  const bench = fixed([x, 0]);
  addBox(bench, 0.8, 0.06, { offset: [0, 0.5], friction });
  addBox(bench, 0.05, 0.4, { offset: [-0.75, 0.85], angle: 0.15, friction });
  for (const side of [-1, 1]) addBox(bench, 0.06, 0.22, { offset: [0.6 * side, 0.22], friction });
}

/** Nothing meets it: flags hang down along it. */
function addPole({ fixed, addBox }, x, top) {
  const pole = fixed([x, 0]);
  addBox(pole, 0.07, 0.5 * top, { offset: [0, 0.5 * top], friction, mask: NOTHING });
  addBox(pole, 0.14, 0.1, { offset: [0, top + 0.1], friction, mask: NOTHING });
  return pole;
}

function addStripe({ box, hinge }, pole, x, y) {
  let last = pole;
  for (let i = 0; i < PLATES; i++) {
    const left = x + 2 * HALF_LENGTH * i;
    const material = { density: 0.25, friction, group: -1 };
    // The wind wakes nobody.
    const awake = { maySleep: false };
    const plate = box([left + HALF_LENGTH, y], HALF_LENGTH, HALF_HEIGHT, material, awake);
    hinge(last, plate, [left, y]);
    last = plate;
  }
}
