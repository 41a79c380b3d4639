// Dolls of eleven bodies and ten hinges fall down the stairs. The limits are those of people’s
// joints, and each has a weak spring, as of muscles that are not quite loose.

import { partsOf } from "./joints/parts.js";

export const title = "Ragdolls";
export const about =
  "Dolls of eleven bodies tumble down the stairs, and no limb bends further than it should.";
export const menu = { group: "Joints", place: 535 };
export const size = { means: "dolls", usual: 10, least: 1, most: 1000 };

const [STEPS, RUN, RISE] = [9, 1.35, 0.62];
const friction = 0.5;

export default function ({ createWorld, grid, random, size }) {
  const world = createWorld();
  const parts = partsOf(world, grid);
  world.createTerrain(parts.fixed().body, { kind: "flat", slope: 0 }, { friction });
  const block = (x, y, halfWidth, halfHeight) =>
    world.createAabb(parts.fixed([x, y]).body, { halfWidth, halfHeight, friction });
  for (let i = 0; i < STEPS; i++) {
    const high = 0.5 * RISE * (STEPS - i);
    block((i - 0.5 * STEPS + 0.5) * RUN - 1.5, high, 0.5 * RUN, high);
  }
  const landing = 0.5 * RISE * STEPS + 0.5;
  block(-0.5 * STEPS * RUN - 4.5, landing, 3, landing);

  const chance = random(1);
  const top = RISE * STEPS + 0.4;
  for (let i = 0; i < size; i++) {
    const x = ((i % 5) - 0.5 * STEPS) * RUN - 1.2 + chance(-0.2, 0.2);
    addDoll(parts, x, top + 2.6 * Math.floor(i / 5), chance(1, 2.5), -1 - i);
  }
  return { world, view: { x: -0.5, y: 5, height: 13, width: 18 }, spawn: [-4, 11] };
}

// Standing upright with its feet at (x, y), seen from the side and looking to the right. Shapes of
// one group do not meet.
function addDoll(parts, x, y, speed, group) {
  const material = { density: 60, friction, group };
  const velocity = [speed, 0];
  const box = (high, halfWidth, halfHeight) =>
    parts.box([x, y + high], halfWidth, halfHeight, material, { velocity });
  // Ties b to a so that it turns from `lower` to `upper` against how the doll stands.
  const limb = (a, b, high, lower, upper) =>
    parts.hinge(a, b, [x, y + high], { turn: { lower, upper, frequency: 0.5, damping: 1 } });

  const head = parts.circle([x, y + 1.83], 0.17, material, { velocity });
  const chest = box(1.4, 0.15, 0.24);
  const hips = box(1.02, 0.14, 0.14);
  limb(chest, head, 1.65, -0.5, 0.6);
  limb(chest, hips, 1.16, -0.3, 0.7);
  for (let side = 0; side < 2; side++) {
    const upperArm = box(1.42, 0.055, 0.18);
    const forearm = box(1.06, 0.05, 0.18);
    const thigh = box(0.71, 0.08, 0.23);
    const shin = box(0.24, 0.065, 0.24);
    limb(chest, upperArm, 1.58, -0.7, 2.6);
    limb(upperArm, forearm, 1.24, 0, 2.4);
    limb(hips, thigh, 0.92, -0.4, 1.9);
    limb(thigh, shin, 0.48, -2.3, 0);
  }
}
