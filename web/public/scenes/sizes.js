// Bodies from 5 cm to 20 m lie in one heap, and the small ones are not crushed. Of every size that
// doubles there are half as many, as in natural rubble.

export const title = "From 5 cm to 20 m";
export const about = "One heap of bodies of very different sizes; none is crushed.";
export const menu = { group: "Crowds and extremes", place: 720 };
export const size = { means: "bodies", usual: 4000, least: 1, most: 100000 };

export default function ({ createWorld, random, grid, seed, size }) {
  const across = Math.max(25, 2.5 * Math.sqrt(size)); // half the width of the pit
  const chance = random(seed + 5);
  const world = createWorld();

  // Row by row from the left, each row as high as the largest in it.
  let x = -across;
  let y = 0;
  let rowHeight = 0;
  for (let i = 0; i < size; i++) {
    const half = halfExtent(chance);
    const reach = 1.5 * half; // room to turn in
    const turned = chance(-3, 3);
    if (x + 2 * reach > across) {
      x = -across;
      y += rowHeight;
      rowHeight = 0;
    }
    const position = [grid(x + reach), grid(y + reach)];
    const angle = i % 3 === 1 ? turned : 0;
    const body = world.createBody({ kind: "dynamic", position, angle });
    if (i % 3 === 0) world.createCircle(body, { radius: half });
    else if (i % 3 === 1) world.createObb(body, { halfWidth: half, halfHeight: half });
    else world.createAabb(body, { halfWidth: half, halfHeight: half });
    x += 2 * reach;
    rowHeight = Math.max(rowHeight, 2 * reach);
  }
  const top = y + rowHeight;

  const block = (x, y, halfWidth, halfHeight) => {
    const body = world.createBody({ position: [grid(x), grid(y)] });
    world.createAabb(body, { halfWidth, halfHeight });
  };
  block(0, -2, across + 4, 2);
  block(-across - 2, 0.5 * top, 2, 0.5 * top);
  block(across + 2, 0.5 * top, 2, 0.5 * top);

  return { world, view: { x: 0, y: 0.35 * top, height: top }, spawn: [0, top] };
}

// From 0.025 to 10: an octave, each half as likely as the one below, and a place within it.
function halfExtent(chance) {
  let octave = 0.025;
  while (octave < 5 && chance(0, 1) < 0.5) octave *= 2;
  return Math.min(10, octave * chance(1, 2));
}
