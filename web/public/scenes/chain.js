// A chain of links with a ball of 10,000 times a link’s mass at its end. It starts level and swings.
// Turn up the links; and take hold of the ball.

import { partsOf, PI } from "./joints/parts.js";

export const title = "Chain with a weight";
export const about =
  "A hundred links swing a ball of 10,000 times a link’s mass, and none of them gives way.";
export const menu = { group: "Joints", place: 532 };
export const size = { means: "links", usual: 100, least: 1, most: 1000 };

const length = 0.5; // of a link
const group = -1; // links do not meet each other, nor the ball

export default function ({ createWorld, grid, size }) {
  const world = createWorld();
  const { fixed, bar, circle, hinge } = partsOf(world, grid);
  const reach = length * size;

  const hook = fixed([0, 0.5]);
  world.createAabb(hook.body, { halfWidth: 0.5, halfHeight: 0.5, group });
  let last = hook;
  for (let i = 0; i < size; i++) {
    const [from, to] = [[i * length, 0], [(i + 1) * length, 0]];
    const link = bar(from, to, 0.06, { group });
    hinge(last, link, from);
    last = link;
  }

  // Not much larger than the chain, whatever its mass.
  const radius = 0.4 + 0.04 * reach;
  const density = (10000 * last.mass) / (PI * radius * radius);
  const ball = circle([reach + radius, 0], radius, { density, group });
  hinge(last, ball, [reach, 0]);

  return {
    world,
    view: { x: 0, y: -0.44 * reach - 1, height: 1.32 * reach + 4 },
    spawn: [0, -0.3 * reach],
  };
}
