// Rubble comes down both sides of a real mountain in Tennessee, steepened three times. The large
// stones run ahead, the small ones come to rest in between.

export const size = { means: "stones", usual: 2500, least: 1, most: 20000 };

const SPACING = 3; // between samples, which are 74.4 m apart in nature
const RISE = (3 * SPACING) / 74.4;

export default async function ({ createWorld, readText, random, grid, seed, size }) {
  const lines = (await readText("terrain/jacksboro_200.csv")).trim().split("\n");
  const samples = lines.slice(145, 195).map((line) => Number(line.split(",")[1]));
  const lowest = Math.min(...samples);
  const heights = samples.map((metres) => (metres - lowest) * RISE);
  const summit = heights.indexOf(Math.max(...heights));
  const x0 = -summit * SPACING; // the summit stands at 0

  const world = createWorld();
  const ground = { kind: "uniform", x0, spacing: SPACING, heights };
  world.createTerrain(world.createBody(), ground, { friction: 0.4 });
  for (const x of [x0 - 1, x0 + (samples.length - 1) * SPACING + 1]) {
    const wall = world.createBody({ position: [x, 20] });
    world.createAabb(wall, { halfWidth: 1, halfHeight: 60 });
  }

  const chance = random(seed + 1);
  const columns = 50;
  for (let i = 0; i < size; i++) {
    const x = ((i % columns) - 0.5 * (columns - 1)) * 1.3 + chance(-0.2, 0.2);
    const y = heights[summit] + 2 + Math.floor(i / columns) * 1.3;
    const part = chance(0, 1);
    const half = 0.12 + 0.5 * part * part * part; // most are small
    const position = [grid(x), grid(y)];
    const stone = world.createBody({ kind: "dynamic", position, angle: chance(-3, 3) });
    if (i % 3 === 0) world.createCircle(stone, { radius: half, friction: 0.4 });
    else world.createObb(stone, { halfWidth: half, halfHeight: 0.8 * half, friction: 0.4 });
  }

  return {
    world,
    view: { x: 0, y: 0.6 * heights[summit], height: 1.5 * heights[summit], width: 100 },
    spawn: [0, heights[summit] + 12],
  };
}
