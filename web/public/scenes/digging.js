// Boxes and balls on the hills of Tennessee. Dig the ground away under them.

export const title = "Digging";
export const about = "Boxes and balls on real hills: dig away the ground under them.";
export const menu = { group: "Piles and stacks", place: 340 };
export const size = { means: "bodies", usual: 240, least: 1, most: 20000 };

const FINER = 4; // vertices to a sample, so that craters are round
// Samples are 74.4 m apart, here 1; heights are stretched half as much again.
const RISE = 1.5 / 74.4;

export default async function ({ createWorld, readText, random, grid, seed, size }) {
  const world = createWorld();
  const samples = await elevations(readText, 60, 180);
  const lowest = Math.min(...samples);
  const last = samples.length - 1;

  const heights = Array.from({ length: last * FINER + 1 }, (_, i) => {
    const sample = Math.min(last - 1, Math.floor(i / FINER));
    const share = (i - sample * FINER) / FINER;
    const metres = samples[sample] + share * (samples[sample + 1] - samples[sample]);
    return (metres - lowest) * RISE;
  });
  const friction = 0.9;
  const ground = { kind: "uniform", x0: -0.5 * last, spacing: 1 / FINER, heights };
  world.createTerrain(world.createBody(), ground, { friction });
  for (const side of [-1, 1]) {
    const wall = world.createBody({ position: [side * (0.5 * last + 1), 20] });
    world.createAabb(wall, { halfWidth: 1, halfHeight: 40, friction });
  }

  const spacing = 1.45; // more than the diagonal of the largest box
  const columns = Math.floor((last - 2) / spacing);
  const chance = random(seed + 5);
  for (let i = 0; i < size; i++) {
    const x = ((i % columns) - 0.5 * (columns - 1)) * spacing;
    const below = (samples[Math.floor(x + 0.5 * samples.length)] - lowest) * RISE;
    const y = below + 1.5 + Math.floor(i / columns) * spacing;
    const halfWidth = chance(0.25, 0.5);
    const halfHeight = chance(0.25, 0.5);
    const body = world.createBody({ kind: "dynamic", position: [grid(x), grid(y)] });
    if (chance(0, 1) < 0.35) world.createCircle(body, { radius: halfWidth, friction });
    else world.createObb(body, { halfWidth, halfHeight, friction });
  }

  return { world, view: { x: -30, y: 5, height: 24 }, spawn: [-30, 18] };
}

// Metres above the sea, from west to east.
async function elevations(readText, first, last) {
  const lines = (await readText("terrain/jacksboro_200.csv")).trim().split("\n").slice(1);
  return lines.slice(first, last + 1).map((line) => Number(line.split(",")[1]));
}
