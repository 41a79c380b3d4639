// The tanks, the one shell that they share, and the loose things about them.

import { directionOf } from "./flight.js";
import { REACH } from "./ground.js";

export const TANK = { halfWidth: 1.2, halfHeight: 0.4 };
export const SHELL_RADIUS = 0.22;
const PIVOT = 0.6; // of the barrel, above the middle of the hull
const BARREL = 1.7;

export function buildTank(world, site) {
  const position = [site.x, site.y + TANK.halfHeight + 0.1];
  const body = world.createBody({ kind: "dynamic", position, angularDamping: 1 });
  world.createObb(body, { ...TANK, density: 4, friction: 0.6 });
  return { body, position, angle: 0 };
}

/** It is there all the time, and in the world only while it flies. */
export function buildShell(world) {
  const body = world.createBody({ kind: "dynamic", position: [0, 100], detection: "swept" });
  world.createCircle(body, { radius: SHELL_RADIUS, density: 2, friction: 1 });
  world.setEnabled(body, false);
  return body;
}

/** Stacks of crates, upright to the ground, and rocks. */
export function buildLoose(world, grid, ground, chance) {
  const things = [];
  const add = (x, above, halfWidth, halfHeight) => {
    const { height, normal } = world.groundAt(ground, x);
    const position = [x + above * normal[0], height + above * normal[1]];
    const angle = slope(grid, normal);
    const body = world.createBody({ kind: "dynamic", position, angle });
    world.createObb(body, { halfWidth, halfHeight, density: 0.6, friction: 0.9 });
    things.push({ body, position, angle });
  };
  for (const middle of [-6, 0, 6]) {
    const x = middle + chance(-2, 2);
    for (let i = 0; i < 3; i++) add(x, 0.55 + 1.02 * i, 0.5, 0.5);
  }
  for (let i = 0; i < 12; i++) {
    const x = chance(-26, 26);
    const isNearTank = Math.abs(Math.abs(x) - 16.5) < 5;
    if (!isNearTank) add(x, 4 + (i % 3), chance(0.25, 0.5), chance(0.2, 0.4));
  }
  return things;
}

/** Where the barrel turns and where it ends; the angle counts from +x counter-clockwise. */
export function barrel(world, { body }, degrees) {
  const [x, y] = world.positionOf(body);
  const { cosine, sine } = world.rotationOf(body);
  const pivot = [x - PIVOT * sine, y + PIVOT * cosine];
  const direction = directionOf(degrees);
  const muzzle = [pivot[0] + BARREL * direction[0], pivot[1] + BARREL * direction[1]];
  return { pivot, direction, muzzle };
}

/** The angle of what stands upright on ground with this normal; `grid` takes off bits that browsers differ in. */
const slope = (grid, [x, y]) => grid(Math.atan2(-x, y));

/** Puts a tank that lies on its side or roof back onto its tracks. */
export function right(world, grid, ground, { body }) {
  if (world.rotationOf(body).cosine > 0.4) return;
  const [x, y] = world.positionOf(body);
  const { normal } = world.groundAt(ground, Math.max(-REACH, Math.min(REACH, x)));
  world.setTransform(body, [x, y + 0.8], slope(grid, normal));
  world.setVelocity(body, [0, 0]);
}
