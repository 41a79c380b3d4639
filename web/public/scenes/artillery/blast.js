// What an explosion does: a crater, damage by distance, and a push on all that is loose.

import { lengthOf } from "./flight.js";

export const CRATER = 2.2; // metres
export const BLAST = 4.2; // metres; beyond it nothing is felt
const WORST = 55; // health points, of a hit on the hull
const PUSH = 11; // metres a second that the nearest crates get
const TANK_PUSH = 4;

/** The health points that each tank loses. */
export function explode(world, ground, tanks, [x, y]) {
  world.dig(ground, [x, y], CRATER);
  const hurt = tanks.map(({ body }) => WORST * nearness(world, body, x, y));
  const bodies = world
    .overlap({ kind: "circle", center: [x, y], radius: BLAST })
    .map((shape) => world.shapeStateOf(shape).body)
    .filter((body) => world.bodyStateOf(body).kind === "dynamic");
  for (const body of bodies) {
    const isTank = tanks.some((tank) => tank.body.index === body.index);
    const { position, mass } = world.bodyStateOf(body);
    const [dx, dy] = [position[0] - x, position[1] - y];
    const distance = lengthOf([dx, dy]) || 1;
    const impulse = mass * (isTank ? TANK_PUSH : PUSH) * nearness(world, body, x, y);
    // Half a metre a metre more upward than outward: things fly instead of grinding along.
    const push = [(impulse * dx) / distance, impulse * (dy / distance + 0.5)];
    world.applyImpulse(body, push, [position[0], position[1] + 0.1]);
  }
  return hurt;
}

/** 1 at the hull, 0 from BLAST metres on. */
function nearness(world, body, x, y) {
  const { position } = world.bodyStateOf(body);
  const gap = lengthOf([position[0] - x, position[1] - y]) - 0.9; // a hull is about so big
  return Math.min(1, Math.max(0, 1 - gap / (BLAST - 0.9)));
}
