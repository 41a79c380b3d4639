// Elastic circles in a closed box, without friction or gravity. Watch the energy: it ought to stay.

export const title = "Gas";
export const about = "Elastic circles fly about in a closed box; watch the energy.";
export const menu = { group: "In motion", place: 520 };
export const size = { means: "circles", usual: 16000, least: 1, most: 100000 };

const ELASTIC = { friction: 0, restitution: 1 };

export default function ({ createWorld, random, grid, seed, size }) {
  const spacing = 1.25;
  const columns = Math.ceil(Math.sqrt(size));
  const half = 0.5 * spacing * columns + 0.5;
  const world = createWorld({ gravity: [0, 0] });

  const wall = (x, y, halfWidth, halfHeight) => {
    const body = world.createBody({ position: [grid(x), grid(y)] });
    world.createAabb(body, { halfWidth, halfHeight, ...ELASTIC });
  };
  wall(0, -half - 1, half + 2, 1);
  wall(0, half + 1, half + 2, 1);
  wall(-half - 1, 0, 1, half);
  wall(half + 1, 0, 1, half);

  const chance = random(seed + 4);
  for (let i = 0; i < size; i++) {
    const x = ((i % columns) - 0.5 * (columns - 1)) * spacing;
    const y = (Math.floor(i / columns) - 0.5 * (columns - 1)) * spacing;
    const [dx, dy] = direction(chance);
    const circle = world.createBody({
      kind: "dynamic",
      position: [grid(x), grid(y)],
      velocity: [5 * dx, 5 * dy],
      gravityScale: 0,
      maySleep: false,
    });
    world.createCircle(circle, { radius: 0.25, ...ELASTIC });
  }

  return { world, view: { x: 0, y: 0, height: 2.2 * half + 2 } };
}

// A point of the unit circle by rejection: Math.sin may differ between browsers.
function direction(chance) {
  for (;;) {
    const x = chance(-1, 1);
    const y = chance(-1, 1);
    const squared = x * x + y * y;
    if (squared > 0.01 && squared <= 1) return [x / Math.sqrt(squared), y / Math.sqrt(squared)];
  }
}
