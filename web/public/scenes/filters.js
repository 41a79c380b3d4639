// Two heaps in one pit that do not know of each other. Circles meet circles and boxes meet boxes,
// and both meet the walls: each shape's `category` says what it is, its `mask` what it meets.

export const title = "Filters";
export const about = "Two heaps in one pit, circles and boxes, that pass through each other.";
export const menu = { group: "How it is done", place: 640 };
export const size = { means: "bodies", usual: 800, least: 2, most: 20000 };

const [WALL, CIRCLE, BOX] = [1, 2, 4];

export default function ({ createWorld, random, grid, seed, size }) {
  const spacing = 1.1;
  const columns = Math.ceil(Math.sqrt(size));
  const half = 0.5 * spacing * columns + 0.6;
  const world = createWorld();

  const wall = (x, y, halfWidth, halfHeight) => {
    const body = world.createBody({ position: [grid(x), grid(y)] });
    world.createAabb(body, { halfWidth, halfHeight, category: WALL });
  };
  wall(0, -1, half + 1, 1);
  for (const side of [-1, 1]) wall(side * (half + 0.5), half, 0.5, half);

  const chance = random(seed + 1);
  for (let i = 0; i < size; i++) {
    const x = ((i % columns) - 0.5 * (columns - 1)) * spacing;
    const y = (Math.floor(i / columns) + 0.6) * spacing;
    const radius = chance(0.3, 0.5);
    // The boxes lie left, the circles right, and they fall towards each other.
    const isBox = i % columns < 0.5 * columns;
    const velocity = [isBox ? 6 : -6, 0];
    const body = world.createBody({ kind: "dynamic", position: [grid(x), grid(y)], velocity });
    if (isBox)
      world.createObb(body, {
        halfWidth: radius,
        halfHeight: chance(0.3, 0.5),
        category: BOX,
        mask: WALL | BOX,
      });
    else world.createCircle(body, { radius, category: CIRCLE, mask: WALL | CIRCLE });
  }

  return { world, view: { x: 0, y: 0.85 * half, height: 2.1 * half }, spawn: [0, 2 * half] };
}
