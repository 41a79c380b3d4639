// Sand runs through a neck. Every half minute the glass, one kinematic body, is turned over.

export const title = "Hourglass";
export const about = "Three thousand grains run through a neck; every half minute the glass turns.";
export const menu = { group: "In motion", place: 420 };
export const size = { means: "grains", usual: 3000, least: 1, most: 3000 };

const [HALF_WIDTH, HALF_HEIGHT, NECK, THICK] = [7, 11, 0.7, 0.3];
const RADIUS = 0.08;
const QUARTER = 0.7853981633974483; // 45 degrees
const [REST, TURN] = [1800, 180]; // steps

export default function ({ createWorld, random, grid, seed, size }) {
  const world = createWorld({ lengthScale: 0.5 }); // grains are small
  const glass = world.createBody({ kind: "kinematic" });
  const side = (x, y, halfWidth, halfHeight, angle = 0) =>
    world.createObb(glass, { halfWidth, halfHeight, offset: [x, y], angle, friction: 0.2 });
  for (const s of [-1, 1]) {
    side(0, s * (HALF_HEIGHT + THICK), HALF_WIDTH + 2 * THICK, THICK);
    side(s * (HALF_WIDTH + THICK), 0, THICK, HALF_HEIGHT);
    // Slopes from the neck to the sides: a square stands on its corner in between.
    const run = HALF_WIDTH - NECK;
    const half = 0.5 * Math.sqrt(2) * run;
    const x = s * (NECK + 0.5 * run + THICK);
    for (const t of [-1, 1]) side(x, t * (0.5 * run - THICK), half + THICK, THICK, s * t * QUARTER);
  }

  const chance = random(seed + 1);
  const spacing = 0.17;
  let left = size;
  for (let y = HALF_HEIGHT - 0.2; left > 0; y -= spacing) {
    // A row as long as the glass is wide there.
    const inside = Math.min(HALF_WIDTH - 0.2, NECK + y - 0.4);
    const columns = Math.min(left, Math.floor((2 * inside) / spacing));
    for (let i = 0; i < columns; i++) {
      const x = (i - 0.5 * (columns - 1)) * spacing + chance(-0.004, 0.004);
      const grain = world.createBody({ kind: "dynamic", position: [grid(x), grid(y)] });
      world.createCircle(grain, { radius: RADIUS, friction: 0.3 });
    }
    left -= columns;
  }

  return {
    world,
    view: { x: 0, y: 0, height: 26, width: 18 },
    spawn: [0, 8],
    update({ step }) {
      const turning = step % (REST + TURN) >= REST;
      if (world.isValid(glass))
        world.setVelocity(glass, [0, 0], turning ? (Math.PI * 60) / TURN : 0);
    },
  };
}
