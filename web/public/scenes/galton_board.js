// Balls fall through rows of pegs, left or right at each. A sensor at the mouth of every bin counts
// them: the numbers come out bell-shaped.

export const title = "Galton board";
export const about = "Sensors count the balls in each bin: the counts come out bell-shaped.";
export const menu = { group: "How it is done", place: 630 };
export const size = { means: "balls", usual: 300, least: 1, most: 2000 };

const ROWS = 14;
const BINS = 15;
const HALF = 0.5 * BINS;
const STEPS_PER_BALL = 6;
const MATERIAL = { friction: 0.1, restitution: 0.2 };

export default function ({ createWorld, random, seed, size }) {
  const world = createWorld();
  const depth = Math.max(4, size / 40); // of the bins
  const top = depth + ROWS;

  const wall = (x, y, halfWidth, halfHeight) => {
    const body = world.createBody({ position: [x, y] });
    world.createAabb(body, { halfWidth, halfHeight, ...MATERIAL });
  };
  wall(0, -0.5, HALF + 0.6, 0.5);
  for (let i = 1; i < BINS; i++) wall(i - HALF, 0.5 * depth, 0.06, 0.5 * depth);
  for (const side of [-1, 1]) wall(side * (HALF + 0.3), 0.5 * top + 1, 0.3, 0.5 * top + 1);

  for (let row = 0; row < ROWS; row++)
    for (let x = -HALF + 0.5 * (row % 2 ? 2 : 1); x < HALF; x++) {
      const peg = world.createBody({ position: [x, top - 0.5 - row] });
      world.createCircle(peg, { radius: 0.15, ...MATERIAL });
    }

  // A sensor stops nothing, and reports what begins to overlap it.
  const binOf = new Map();
  for (let bin = 0; bin < BINS; bin++) {
    const body = world.createBody({ position: [bin + 0.5 - HALF, depth - 0.2] });
    const sensor = world.createAabb(body, { halfWidth: 0.4, halfHeight: 0.1, sensor: true });
    binOf.set(sensor.index, bin);
  }

  const state = { counts: new Array(BINS).fill(0) };
  return {
    world,
    view: { x: 0, y: 0.5 * top, height: top + 5, width: BINS + 4 },
    spawn: [0, top + 1],
    state,
    update({ step }) {
      for (const { a, b } of world.events().sensorBegin)
        if (binOf.has(a.index)) {
          state.counts[binOf.get(a.index)]++;
          world.setMaySleep(world.shapeStateOf(b).body, true);
        }
      if (step % STEPS_PER_BALL > 0 || step >= size * STEPS_PER_BALL) return;
      // By the step, so that the same ball comes again when time has been turned back.
      const chance = random(seed * size + step);
      const ball = world.createBody({
        kind: "dynamic",
        position: [chance(-0.1, 0.1), top + 1],
        maySleep: false, // until it is in a bin: one that balances on a peg would stay there
        linearDamping: 3, // as in honey: a fast ball would jump from peg to peg
      });
      world.createCircle(ball, { radius: 0.16, ...MATERIAL });
    },
    paint: () => ({
      marks: state.counts.map((count, i) => ({
        kind: "text",
        x: i + 0.5 - HALF,
        y: -0.5,
        text: String(count),
        ink: "ink",
      })),
    }),
  };
}
