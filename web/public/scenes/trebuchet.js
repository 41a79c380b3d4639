// A trebuchet throws a stone at a tower. The sling is a rope that bears so much and no more: it
// breaks at the right moment, because it pulls the hardest when the stone is fastest.

import { NOTHING, partsOf } from "./joints/parts.js";

export const title = "Trebuchet";
export const about =
  "A counterweight of three tonnes throws a stone at a tower, from a sling that lets go in time.";
export const menu = { group: "Joints", place: 537 };
export const size = { means: "bricks", usual: 40, least: 1, most: 1000 };

const AXLE = 5.2; // above the ground
const [LONG, SHORT, SLING] = [6.4, 1.5, 2.4]; // both arms, and the rope
const STONE = 0.32; // its radius
const BREAKS = 6900; // N

export default function ({ createWorld, grid, size }) {
  const world = createWorld();
  const parts = partsOf(world, grid);
  world.createTerrain(parts.fixed().body, { kind: "flat", slope: 0 });
  addEngine(parts, -22);

  const [halfWidth, halfHeight, columns] = [0.5, 0.4, 4];
  for (let i = 0; i < size; i++) {
    const row = Math.floor(i / columns);
    const x = 17.6 + 2 * halfWidth * (i % columns) + (row % 2 ? 0.5 * halfWidth : 0);
    const y = halfHeight + 2 * halfHeight * row;
    parts.box([x, y], halfWidth, halfHeight, { density: 20, friction: 0.7 });
  }
  return { world, view: { x: 2, y: 11, height: 38, width: 62 }, spawn: [0, 12] };
}

// The arm reaches down to the left, to just above the ground, and the stone lies in front of it.
function addEngine({ fixed, addBar, bar, box, circle, hinge, link }, x) {
  const group = -1; // its parts do not meet
  const trestle = fixed([x, 0]);
  const still = { group, mask: NOTHING }; // and nothing meets the trestle
  addBar(trestle, [x - 2.4, 0], [x, AXLE], 0.14, still);
  addBar(trestle, [x + 2.4, 0], [x, AXLE], 0.14, still);
  addBar(trestle, [x - 1.5, 2], [x + 1.5, 2], 0.1, still);

  const low = 0.6;
  const fall = (AXLE - low) / LONG;
  const run = Math.sqrt(1 - fall * fall);
  const tip = [x - LONG * run, low];
  const butt = [x + SHORT * run, AXLE + SHORT * fall];
  const wood = { density: 60, group };
  const arm = bar(tip, butt, 0.13, wood);
  hinge(trestle, arm, [x, AXLE]);
  const weight = box([butt[0], butt[1] - 1.3], 0.75, 0.75, { density: 1220, group });
  addBar(weight, [butt[0], butt[1] - 0.6], butt, 0.08, wood);
  hinge(arm, weight, butt);

  const drop = low - STONE;
  const ahead = [tip[0] + Math.sqrt(SLING * SLING - drop * drop), STONE];
  const stone = circle(ahead, STONE, { density: 250, friction: 0.2, group });
  link(arm, stone, tip, ahead, (length) => ({
    along: { lower: 0, upper: length },
    breakForce: BREAKS,
  }));
}
