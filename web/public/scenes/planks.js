// Balls and crates under one-way planks, through which they rise and on which they land. Planks are
// belts, which take balls to the right and crates to the left; there they fall onto trampolines, and
// what falls between lands on ice and slides to these. No callback: all of it is rules between kinds,
// and a kind is the lowest bit of a shape’s `category`.

import { partsOf } from "./joints/parts.js";

export const title = "One-way planks and belts";
export const about =
  "Bodies rise through planks and land on them; belts take balls right and crates left, by rules.";
export const menu = { group: "Who meets whom", place: 561 };
export const size = { means: "balls and crates", usual: 30, least: 1, most: 400 };

const [GAP, ROOF, HEIGHTS] = [3, 16, [5.6, 9.2]];
const [HALF, APART] = [0.35, 1.1];

// What a visitor drops has kind 1, and so have the walls.
const [ANY, PLANK, ICE, TRAMPOLINE, BALL, CRATE] = [1, 2, 4, 8, 16, 32];
const LOOSE = ANY | BALL | CRATE;

const friction = 0.6;

export default function ({ createWorld, grid, size }) {
  const world = createWorld();
  const parts = partsOf(world, grid);
  const half = 6 + 0.2 * size;
  addFrame(world, parts, half);
  addFloor(parts, [0, 0.8], [half - GAP, 0], 0.8, ICE);
  addFloor(parts, [half - GAP - 0.5, -1.5], [half + 0.5, -0.3], 0.6, TRAMPOLINE);
  for (const y of HEIGHTS) {
    const plank = { halfWidth: half - GAP, halfHeight: 0.15, friction, category: PLANK };
    world.createAabb(parts.fixed([0, y]).body, plank);
  }
  const columns = Math.floor((2 * (half - 1.5)) / APART);
  for (let i = 0; i < size; i++) {
    const at = [APART * ((i % columns) - 0.5 * (columns - 1)), 2.6 + 1.1 * Math.floor(i / columns)];
    // A ball that may turn rolls in place on a belt.
    const thrown = { velocity: [0, 8 + 2 * (Math.floor(i / 2) % 4)], fixedRotation: true };
    if (i % 2 === 0) parts.circle(at, HALF, { friction, category: BALL }, thrown);
    else parts.box(at, HALF, HALF, { friction, category: CRATE }, thrown);
  }

  world.setRule(PLANK, ANY | BALL, { kind: "oneWay", surfaceSpeed: 2 });
  world.setRule(PLANK, CRATE, { kind: "oneWay", surfaceSpeed: -2 });
  world.setRule(BALL | CRATE, BALL | CRATE, { kind: "ignore" });
  world.setRule(ICE, LOOSE, { friction: 0 });
  world.setRule(TRAMPOLINE, LOOSE, { restitution: 1.25 });
  return {
    world,
    view: { x: 0, y: 7, height: 20, width: 2 * half + 2 },
    spawn: [0, 7],
  };
}

function addFrame(world, { fixed }, half) {
  const wall = (at, halfWidth, halfHeight) =>
    world.createAabb(fixed(at).body, { halfWidth, halfHeight, friction });
  for (const side of [-1, 1]) wall([side * (half + 0.5), 0.5 * ROOF], 0.5, 0.5 * ROOF + 2);
  wall([0, ROOF + 0.5], half, 0.5);
}

/** A bar on the right, and the same on the left. */
function addFloor({ fixed, addBar }, a, b, thick, category) {
  const floor = fixed();
  addBar(floor, a, b, thick, { friction, category });
  addBar(floor, [-b[0], b[1]], [-a[0], a[1]], thick, { friction, category });
}
