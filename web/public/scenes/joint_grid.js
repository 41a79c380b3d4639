// A plate of circles, each hinged to its neighbours, hangs by the middle of its upper edge. None can
// turn unless its neighbours do, and those that hold it cannot: where it sags, hinges have opened.
// Choose the quality “exact”, and nothing moves.

import { partsOf } from "./joints/parts.js";

export const title = "Grid of hinges";
export const about =
  "A plate of circles, each hinged to its neighbours: none can turn, so that it hardly sags.";
export const menu = { group: "Joints", place: 542 };
export const size = { means: "circles along an edge", usual: 30, least: 2, most: 120 };

export default function ({ createWorld, grid, size }) {
  const world = createWorld();
  const { fixed, moving, addCircle, hinge } = partsOf(world, grid);
  const held = Math.floor(size / 2);
  const circles = [];
  for (let i = 0; i < size; i++)
    for (let k = 0; k < size; k++) {
      const still = k === 0 && i >= held - 3 && i <= held + 3;
      const x = i - 0.5 * (size - 1);
      const at = [x, -k];
      const circle = addCircle(still ? fixed(at) : moving(at), 0.4, { group: -1 });
      if (k > 0) hinge(circles.at(-1), circle, [x, 0.5 - k]);
      if (i > 0 && !(still && i > held - 3)) hinge(circles.at(-size), circle, [x - 0.5, -k]);
      circles.push(circle);
    }
  return {
    world,
    view: { x: 0, y: -0.6 * size, height: 1.35 * size + 2, width: size + 2 },
    spawn: [0, 3],
  };
}
