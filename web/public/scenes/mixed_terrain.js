// Circles and boxes rain on irregular ground and gather in its valleys.

export const title = "Mixed bodies on terrain";
export const about = "Circles and boxes rain on irregular ground and gather in its valleys.";
export const menu = { group: "Piles and stacks", place: 360 };
export const size = { means: "bodies", usual: 4000, least: 1, most: 100000 };

const KNOTS = 64;

export default function ({ createWorld, random, grid, seed, size }) {
  const spacing = 1.6;
  const columns = Math.floor(2.4 * Math.sqrt(size)) + 1;
  const half = 0.5 * spacing * columns + 1;
  const chance = random(seed + 2);
  const world = createWorld();

  const ground = world.createBody({ position: [0, 0] });
  world.createTerrain(ground, { kind: "irregular", points: hills(half, chance) });
  for (const side of [-1, 1]) {
    const wall = world.createBody({ position: [grid(side * (half + 1)), 20] });
    world.createAabb(wall, { halfWidth: 1, halfHeight: 40 });
  }

  for (let i = 0; i < size; i++) {
    const x = ((i % columns) - 0.5 * (columns - 1)) * spacing;
    const y = 11 + Math.floor(i / columns) * spacing;
    const halfWidth = chance(0.25, 0.5);
    const halfHeight = chance(0.25, 0.5);
    const turned = chance(-3, 3);
    const round = i % 2 === 0;
    const angle = round ? 0 : turned;
    const body = world.createBody({ kind: "dynamic", position: [grid(x), grid(y)], angle });
    if (round) world.createCircle(body, { radius: halfWidth });
    else world.createObb(body, { halfWidth, halfHeight });
  }

  return { world, view: { x: 0, y: 12, height: 30, width: half }, spawn: [0, 30] };
}

// Points 0.5 to 2 apart, rough by 0.1; the ground rises towards both ends.
function hills(half, chance) {
  const knots = Array.from({ length: KNOTS }, (_, i) => {
    const offCentre = (2 * i) / (KNOTS - 1) - 1;
    return chance(-3, 3) + 6 * offCentre * offCentre;
  });
  const points = [];
  const wider = Math.max(1, half / 600);
  for (let x = -half; x < half && points.length < 2047; x += chance(0.5, 2) * wider)
    points.push([x, smooth(knots, (x + half) / (2 * half)) + chance(-0.1, 0.1)]);
  points.push([half, knots[KNOTS - 1]]);
  return points;
}

// Between two knots by 3t² - 2t³, which is level at both.
function smooth(knots, t) {
  const i = Math.min(KNOTS - 2, Math.floor(t * (KNOTS - 1)));
  const u = t * (KNOTS - 1) - i;
  return knots[i] + (knots[i + 1] - knots[i]) * (u * u * (3 - 2 * u));
}
