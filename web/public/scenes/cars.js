// Cars of several makes climb over a mountain, with a motor on each axle. How their springs are tuned
// stands with `wheel` in scenes/joints/parts.js. Drive them with the arrow keys.

import { drive, DRIVING, partsOf } from "./joints/parts.js";

export const title = "Cars on the mountain";
export const about =
  "Cars climb over a mountain: each spring is tuned by the frequency at which its car would bounce.";
export const menu = { group: "Joints", place: 536 };
export const size = { means: "cars", usual: 5, least: 1, most: 200 };

const POINTS = 321; // heights
const COARSE = 20; // of them from knoll to knoll
const SPACING = 0.36;

export default function ({ createWorld, grid, random, size }) {
  const world = createWorld();
  const parts = partsOf(world, grid);
  const heights = addLand(world, parts, random(11));

  const chance = random(3);
  const axles = [];
  for (let i = 0; i < size; i++) {
    const point = 80 + 12 * (i % 5);
    const x = SPACING * (point - (POINTS - 1) / 2);
    const y = heights[point + 4] + 1.4 + 3 * Math.floor(i / 5);
    axles.push(...addCar(parts, x, y, chance, -1 - i));
  }

  const scene = {
    world,
    view: { x: 0, y: 8, height: 40, width: 70 },
    spawn: [0, 16],
    keys: DRIVING,
    state: { direction: 1 },
    update: ({ held }) => drive(world, scene.state, axles, held),
  };
  return scene;
}

// Smooth from knoll to knoll: 3 t² - 2 t³.
function addLand(world, { fixed }, chance) {
  const knolls = Array.from({ length: Math.floor(POINTS / COARSE) + 2 }, () => chance(-1, 1));
  const heights = Array.from({ length: POINTS }, (_, i) => {
    const [x, t] = [(2 * i) / (POINTS - 1) - 1, (i % COARSE) / COARSE];
    const [low, high] = knolls.slice(Math.floor(i / COARSE));
    const hill = 1 - x * x;
    const edge = x * x * x * x * x * x;
    const wall = edge * edge * edge * edge;
    return (
      7 * hill * hill * hill * hill +
      0.8 * (low + (high - low) * t * t * (3 - 2 * t)) +
      5 * edge +
      30 * wall +
      chance(-0.03, 0.03)
    );
  });
  const terrain = { kind: "uniform", x0: -0.5 * SPACING * (POINTS - 1), spacing: SPACING, heights };
  world.createTerrain(fixed().body, terrain, { friction: 0.9 });
  return heights;
}

// Its parts, which are of one group, do not meet each other. Returns the axles.
function addCar({ moving, addBox, wheel }, x, y, chance, group) {
  const length = chance(1.5, 2.1);
  const radius = chance(0.42, 0.72);
  const steel = { density: 100, friction: 0.4, group };
  const rubber = { density: 60, friction: 1.3, group };
  const body = moving([x, y]);
  addBox(body, length, 0.3, steel);
  addBox(body, 0.5 * length, 0.32, { offset: [-0.15 * length, 0.6], ...steel });
  addBox(body, 0.32 * length, 0.12, { offset: [0.66 * length, 0.38], ...steel });
  const weight = 10 * body.mass;
  return [-1, 1].map((side) => {
    const place = [x + side * 0.68 * length, y - 0.2 - 0.3 * radius];
    const speed = chance(6, 8) / radius;
    const turn = { motorSpeed: -speed, motorForce: 0.29 * weight * radius };
    return { ...wheel(body, 2, place, radius, turn, rubber), speed };
  });
}
