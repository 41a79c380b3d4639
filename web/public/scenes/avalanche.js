// Rubble comes down both sides of a real mountain in Tennessee, made three times as steep. It
// slides until the slope is less than friction holds.

export const title = "Avalanche";
export const about = "Rubble comes down both sides of a real mountain until friction holds it.";
export const menu = { group: "Piles and stacks", place: 350 };
export const size = { means: "stones", usual: 1500, least: 1, most: 20000 };

const SPACING = 3; // between samples, which are 74.4 m apart in nature
const RISE = (3 * SPACING) / 74.4;

export default async function ({ createWorld, readText, random, grid, seed, size }) {
  const lines = (await readText("terrain/jacksboro_200.csv")).trim().split("\n");
  const samples = lines.slice(145, 195).map((line) => Number(line.split(",")[1]));
  const lowest = Math.min(...samples);
  const heights = samples.map((metres) => (metres - lowest) * RISE);
  const height = Math.max(...heights);
  const x0 = -heights.indexOf(height) * SPACING; // the summit stands at 0

  const world = createWorld();
  const friction = 0.4;
  const terrain = { kind: "uniform", x0, spacing: SPACING, heights };
  const ground = world.createTerrain(world.createBody(), terrain, { friction });
  for (const x of [x0 - 1, x0 + (samples.length - 1) * SPACING + 1]) {
    const wall = world.createBody({ position: [x, 20] });
    world.createAabb(wall, { halfWidth: 1, halfHeight: 60 });
  }

  // Layers of stones on both slopes.
  const chance = random(seed + 1);
  const columns = 50;
  for (let i = 0; i < size; i++) {
    const x = ((i % columns) - 0.5 * (columns - 1)) * 1.8;
    const y = world.groundAt(ground, x).height + 1.5 + Math.floor(i / columns) * 1.8;
    const part = chance(0, 1);
    const half = 0.2 + 0.5 * part * part; // most are small
    const position = [grid(x), grid(y)];
    const stone = world.createBody({ kind: "dynamic", position, angle: chance(-3, 3) });
    if (i % 3 === 0) world.createCircle(stone, { radius: half, friction });
    else world.createObb(stone, { halfWidth: half, halfHeight: 0.8 * half, friction });
  }

  return {
    world,
    view: { x: 0, y: 0.5 * height, height: 1.4 * height, width: 110 },
    spawn: [0, height + 12],
  };
}
