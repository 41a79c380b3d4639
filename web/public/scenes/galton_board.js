// Balls fall through rows of pegs, left or right by chance at each. A sensor at the mouth of every
// bin counts them: the numbers come out bell-shaped.

export const size = { means: "balls", usual: 500, least: 1, most: 2000 };

const ROWS = 14;
const BINS = ROWS + 1;
const RADIUS = 0.13;

export default function ({ createWorld, random, grid, seed, size }) {
  const world = createWorld();
  const depth = Math.max(4, size / 50); // of the bins
  const half = 0.5 * BINS;
  const top = depth + ROWS;

  const wall = (x, y, halfWidth, halfHeight, angle = 0) => {
    const body = world.createBody({ position: [x, y], angle });
    world.createObb(body, { halfWidth, halfHeight, friction: 0.1 });
  };
  wall(0, -0.5, half + 0.5, 0.5);
  for (let i = 0; i <= BINS; i++) wall(i - half, 0.5 * depth, 0.06, 0.5 * depth);
  for (const side of [-1, 1]) {
    wall(side * (half + 0.4), 0.5 * top + 2, 0.4, 0.5 * top + 2); // beside the pegs
    wall(side * (4.2 + 0.55), top + 4.2, 0.3, 5.8, side * -0.7853981633974483); // the funnel
  }

  for (let row = 0; row < ROWS; row++)
    for (let i = 0; i <= row; i++) {
      const peg = world.createBody({ position: [i - 0.5 * row, top - 0.5 - row] });
      world.createCircle(peg, { radius: 0.12, friction: 0.1, restitution: 0.3 });
    }

  // A sensor stops nothing, and reports what begins to overlap it.
  const sensors = Array.from({ length: BINS }, (_, i) => {
    const body = world.createBody({ position: [i + 0.5 - half, depth - 0.3] });
    return world.createAabb(body, { halfWidth: 0.4, halfHeight: 0.1, sensor: true });
  });
  const binOf = new Map(sensors.map((sensor, bin) => [sensor.index, bin]));

  const chance = random(seed + 1);
  for (let i = 0; i < size; i++) {
    const x = ((i % 16) - 7.5) * 0.3 + chance(-0.02, 0.02);
    const y = top + 3.8 + Math.floor(i / 16) * 0.3;
    const ball = world.createBody({ kind: "dynamic", position: [grid(x), grid(y)] });
    world.createCircle(ball, { radius: RADIUS, friction: 0.1, restitution: 0.3 });
  }

  const state = { counts: new Array(BINS).fill(0) };
  return {
    world,
    view: { x: 0, y: 0.5 * top + 3, height: top + 12, width: BINS + 4 },
    spawn: [0, top + 8],
    state,
    update() {
      for (const { a } of world.events().sensorBegin) state.counts[binOf.get(a.index)]++;
    },
    paint: () => ({
      marks: state.counts.map((count, i) => ({
        kind: "text",
        x: i + 0.5 - half,
        y: -0.5,
        text: String(count),
        ink: "ink",
      })),
    }),
  };
}
