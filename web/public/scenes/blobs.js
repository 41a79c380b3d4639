// Soft balls of springs: twelve circles about a hub, tied to it and to their neighbours. A spring’s
// stiffness is told by a frequency. Take hold of one and pull.

import { partsOf } from "./joints/parts.js";

export const title = "Soft blobs";
export const about =
  "Balls of circles and springs squash, wobble and find their shape again.";
export const menu = { group: "Joints", place: 541 };
export const size = { means: "blobs", usual: 15, least: 1, most: 500 };

const RIM = 12;
const [SINE, HALF, WIDE] = [0.8660254037844386, 0.5, 9];
// The twelfths of a turn.
const ROUND = [
  [1, 0], [SINE, HALF], [HALF, SINE], [0, 1], [-HALF, SINE], [-SINE, HALF],
  [-1, 0], [-SINE, -HALF], [-HALF, -SINE], [0, -1], [HALF, -SINE], [SINE, -HALF],
];

export default function ({ createWorld, grid, random, size }) {
  const world = createWorld();
  const parts = partsOf(world, grid);
  const wall = (x, y, halfWidth, halfHeight) =>
    world.createAabb(parts.fixed([x, y]).body, { halfWidth, halfHeight, friction: 0.5 });
  wall(0, -1, WIDE + 2, 1);
  wall(-WIDE - 1, 7, 1, 7);
  wall(WIDE + 1, 7, 1, 7);

  const chance = random(7);
  for (let i = 0; i < size; i++) {
    const x = 3.4 * ((i % 5) - 2) + chance(-0.3, 0.3);
    const y = 2.2 + 3.4 * Math.floor(i / 5);
    addBlob(parts, x, y, chance(0.8, 1.2), chance(6, 11), -1 - i);
  }
  return { world, view: { x: 0, y: 7.5, height: 19 }, spawn: [0, 16] };
}

// Circles of one group do not meet.
function addBlob({ circle, link }, x, y, radius, frequency, group) {
  const material = { friction: 0.5, group };
  // One that gets too short would turn inside out.
  const spring = (a, b, hertz) =>
    link(a, b, [a.x, a.y], [b.x, b.y], (length) => ({
      along: {
        frequency: hertz,
        damping: 0.3,
        target: length,
        lower: 0.4 * length,
        upper: 1.6 * length,
      },
    }));

  const hub = circle([x, y], 0.3 * radius, material);
  const rim = ROUND.map(([cosine, sine]) => {
    const part = circle([x + radius * cosine, y + radius * sine], 0.26 * radius, material);
    spring(hub, part, frequency);
    return part;
  });
  rim.forEach((part, i) => spring(part, rim[(i + 1) % RIM], 1.5 * frequency));
}
