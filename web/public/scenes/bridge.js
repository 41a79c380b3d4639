// A lorry crosses a bridge of planks that are hinged to each other and to both sides of a valley.
// It weighs some hundred times as much as one of them. Drive it back with the arrow keys.

import { drive, DRIVING, partsOf } from "./joints/parts.js";

export const title = "Bridge";
export const about =
  "A heavy lorry crosses a bridge of planks: none of its hinges opens, and the deck bends under the wheels.";
export const menu = { group: "Joints", place: 531 };
export const size = { means: "planks", usual: 30, least: 8, most: 200 };

const HALF_PLANK = 0.12;
const SPEED = 5; // of the lorry, m/s

export default function ({ createWorld, grid, size }) {
  const world = createWorld();
  const parts = partsOf(world, grid);
  const land = addLand(world, parts, size);

  let last = land;
  for (let i = 0; i < size; i++) {
    const plank = parts.bar(knot(i, size), knot(i + 1, size), HALF_PLANK, {
      shortOf: 0.03,
      density: 120,
      friction: 0.9,
    });
    parts.hinge(last, plank, knot(i, size));
    last = plank;
  }
  parts.hinge(last, land, knot(size, size));
  const lorry = addLorry(parts, -0.5 * size - 5);

  const scene = {
    world,
    view: { x: 0, y: -0.5, height: 0.5 * size + 16, width: size + 24 },
    spawn: [0, 6],
    keys: DRIVING,
    state: { direction: 1 },
    update: ({ held }) => drive(world, scene.state, lorry, held),
  };
  return scene;
}

// The hinge before plank i of n: on a parabola that hangs below both ends.
function knot(i, n) {
  const t = (2 * i) / n - 1;
  return [0.5 * n * t, -HALF_PLANK - (n / 30) * (1 - t * t)];
}

function addLand(world, { fixed }, size) {
  const [edge, deep] = [0.5 * size, -4 - 0.12 * size];
  const points = [
    [-edge - 70, 14],
    [-edge - 60, 9],
    [-edge - 50, 3],
    [-edge - 42, 0.6],
    [-edge - 36, 0],
    [-edge, 0],
    [-edge + 0.05, -0.3],
    [-edge + 1, -3],
    [-0.72 * edge, 0.7 * deep],
    [-0.35 * edge, 0.97 * deep],
    [0, deep],
    [0.4 * edge, 0.95 * deep],
    [0.7 * edge, 0.75 * deep],
    [edge - 1, -3],
    [edge - 0.05, -0.3],
    [edge, 0],
    [edge + 30, 0],
    [edge + 36, 0.5],
    [edge + 44, 3],
    [edge + 52, 8],
    [edge + 60, 15],
  ];
  const land = fixed();
  world.createTerrain(land.body, { kind: "irregular", points }, { friction: 0.9 });
  return land;
}

// A motor on each axle. Returns the axles.
function addLorry({ moving, addBox, wheel }, x) {
  const group = -1; // its parts do not meet each other
  const steel = { density: 500, friction: 0.6, group };
  const rubber = { density: 300, friction: 1.2, group };
  const body = moving([x, 1.35]);
  addBox(body, 3.6, 0.22, steel);
  addBox(body, 0.75, 0.85, { offset: [2.85, 1.05], ...steel });
  addBox(body, 2.7, 1.1, { offset: [-0.85, 1.35], ...steel });
  const radius = 0.62;
  return [-2.7, -1.25, 2.5].map((place) => {
    const motorForce = ((0.3 * body.mass) / 3) * 10 * radius;
    const speed = SPEED / radius;
    const turn = { motorSpeed: -speed, motorForce };
    return { ...wheel(body, 3, [x + place, radius], radius, turn, rubber), speed };
  });
}
