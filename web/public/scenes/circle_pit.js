// Circles of many sizes fall into a pit and settle into a dense heap.

export const title = "Circle pit";
export const about = "Circles of many sizes fall into a pit and settle into a heap.";
export const menu = { group: "Piles and stacks", place: 310 };
export const size = { means: "circles", usual: 10000, least: 1, most: 100000 };

export default function ({ createWorld, random, grid, seed, size }) {
  const spacing = 1.04;
  const columns = Math.floor(Math.sqrt(size));
  const height = spacing * Math.ceil(size / columns);
  const half = 0.5 * spacing * columns + 0.5;
  const world = createWorld();

  const block = (x, y, halfWidth, halfHeight) => {
    const body = world.createBody({ position: [grid(x), grid(y)] });
    world.createAabb(body, { halfWidth, halfHeight });
  };
  block(0, -1, half + 2, 1);
  block(-half - 1, 0.5 * height, 1, 0.5 * height);
  block(half + 1, 0.5 * height, 1, 0.5 * height);

  const chance = random(seed + 1);
  for (let i = 0; i < size; i++) {
    const jitter = chance(-0.02, 0.02); // or columns would stand on each other
    const x = ((i % columns) - 0.5 * (columns - 1)) * spacing + jitter;
    const y = (Math.floor(i / columns) + 0.6) * spacing;
    const circle = world.createBody({ kind: "dynamic", position: [grid(x), grid(y)] });
    world.createCircle(circle, { radius: chance(0.25, 0.5) });
  }

  return {
    world,
    view: { x: 0, y: 0.4 * height, height: 1.1 * height },
    spawn: [0, height + 2],
  };
}
