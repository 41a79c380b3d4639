// Upright boxes run and fall over storeys of separate tiles. Every fourth has no friction and
// glides over the seams between the tiles at full speed, until it meets a wall or a gap.

export const title = "Boxes over tile floors";
export const about = "Boxes slide over floors of separate tiles and are never caught between two.";
export const menu = { group: "Crowds and extremes", place: 730 };
export const size = {
  means: "moving boxes; there are five times as many tiles",
  usual: 2000,
  least: 1,
  most: 100000,
};

const STOREY = 6;

export default function ({ createWorld, random, grid, seed, size }) {
  const world = createWorld();
  const chance = random(seed + 3);
  const width = Math.floor(4 * Math.sqrt(5 * size)) + 4;

  let left = 5 * size; // tiles still to lay
  const tile = (x, y) => {
    if (left-- > 0)
      world.createAabb(world.createBody({ position: [x, y] }), { halfWidth: 0.5, halfHeight: 0.5 });
  };
  let storeys = 0;
  while (left > 0) layStorey(tile, chance, width, STOREY * storeys++);

  const perStorey = Math.ceil(size / storeys);
  const spacing = width / (perStorey + 1);
  for (let i = 0; i < size; i++) {
    const x = ((i % perStorey) + 1) * spacing;
    const y = Math.floor(i / perStorey) * STOREY + 4.5;
    const halfWidth = chance(0.2, 0.4);
    const halfHeight = chance(0.2, 0.45);
    const speed = chance(1, 5);
    const velocity = [i % 2 === 0 ? speed : -speed, 0];
    const body = world.createBody({ kind: "dynamic", position: [grid(x), grid(y)], velocity });
    world.createAabb(body, { halfWidth, halfHeight, friction: i % 4 === 0 ? 0 : 0.3 });
  }

  const height = STOREY * storeys;
  return {
    world,
    view: { x: 0.5 * width, y: 0.5 * height, height: 0.55 * height },
    spawn: [0.5 * width, height + 2],
  };
}

// A wall on either side; between them platforms of 5 to 14 tiles, some with a flight of stairs, and
// gaps, but none at the very bottom.
function layStorey(tile, chance, width, base) {
  for (let y = base; y < base + STOREY; y++) {
    tile(-1, y);
    tile(width, y);
  }
  for (let x = 0; x < width; ) {
    const end = x + Math.floor(chance(5, 15));
    const stairs = chance(0, 1) < 0.3;
    for (let i = 0; x < end && x < width; x++, i++) {
      tile(x, base);
      for (let step = 1; stairs && step <= i && step <= 3; step++) tile(x, base + step);
    }
    const gap = Math.floor(chance(2, 5));
    for (let i = 0; i < gap && x < width; i++, x++) if (base === 0) tile(x, base);
  }
}
