// The four ways of finding collisions, a lane for each: overlap, continuous, bisect and swept.
// Above, three bullets fly up and down between thin walls: they pass them in the first lane and the
// third. Below, a gas. The lanes differ in nothing else.

export const title = "Four ways of detection";
export const about =
  "Overlap, continuous, bisect and swept, a lane each: in two of them bullets pass thin walls.";
export const menu = { group: "How it is done", place: 620 };
export const size = { means: "circles of each gas", usual: 16, least: 4, most: 10000 };

const LANES = ["overlap", "continuous", "bisect", "swept"];
// A bullet moves by up to 0.75 a step: more than a wall and it measure together.
const SPEEDS = [12, 24, 45];
const [RADIUS, THIN, STOREY, PILLAR] = [0.12, 0.02, 3, 0.5];
const ELASTIC = { friction: 0, restitution: 1 };

export default function ({ createWorld, random, grid, seed, size }) {
  const world = createWorld({ gravity: [0, 0] });
  const columns = Math.ceil(Math.sqrt(size));
  const half = 0.625 * columns + 0.5; // half a lane's width
  const range = 3 * STOREY; // the height of the bullets' part
  const pitch = 2 * (half + PILLAR);
  const end = 2 * pitch + PILLAR;

  const wall = (x, y, halfWidth, halfHeight, detection) => {
    const body = world.createBody({ position: [grid(x), grid(y)], detection });
    world.createAabb(body, { halfWidth, halfHeight, ...ELASTIC });
  };
  const circle = (x, y, radius, options) => {
    const position = [grid(x), grid(y)];
    const body = world.createBody({ kind: "dynamic", maySleep: false, position, ...options });
    world.createCircle(body, { radius, ...ELASTIC });
  };

  wall(0, -half - 1, end, 1);
  wall(0, half + 1, end, 1);
  wall(0, half + 3 + range, end, 1);
  for (let i = 0; i <= LANES.length; i++) {
    wall((i - 2) * pitch, 0, PILLAR, half);
    wall((i - 2) * pitch, half + 2 + 0.5 * range, PILLAR, 0.5 * range);
  }

  LANES.forEach((detection, lane) => {
    const x = (lane - 1.5) * pitch;
    const chance = random(seed + 4); // every lane's gas starts alike
    for (let i = 0; i < size; i++) {
      const place = (k) => (k - 0.5 * (columns - 1)) * 1.25;
      const [dx, dy] = direction(chance);
      const velocity = [5 * dx, 5 * dy];
      const options = { velocity, gravityScale: 0, detection };
      circle(x + place(i % columns), place(Math.floor(i / columns)), 0.25, options);
    }
    const floor = half + 2;
    for (const storey of [1, 2]) wall(x, floor + storey * STOREY, half, THIN, detection);
    SPEEDS.forEach((speed, i) => {
      const side = (2 * half * (i + 1)) / (SPEEDS.length + 1) - half;
      circle(x + side, floor + 0.5 * STOREY, RADIUS, { velocity: [0, speed], detection });
    });
  });

  const height = 2 * half + 6 + range;
  const y = 0.5 * height - half - 2;
  const view = { x: 0, y, height: 1.1 * height, width: 2.1 * end };
  const marks = LANES.map((text, lane) => {
    return { kind: "text", x: (lane - 1.5) * pitch, y: half + 1, text, ink: "ink", size: 13 };
  });
  return { world, view, spawn: [0, y], show: ["motions"], paint: () => ({ marks }) };
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
