// Few bodies of many sizes drift about. What the broadphase goes by is shown: the cells of the
// grid, or, with the plane sweep, the sorted intervals below the field.

export const title = "Broadphases";
export const about =
  "How pairs are found: the grid’s cells or, once Trade sets the plane sweep, intervals sorted along x.";
export const menu = { group: "How it is done", place: 660 };
export const size = { means: "bodies", usual: 90, least: 1, most: 100000 };

const ELASTIC = { friction: 0, restitution: 1 };

export default function ({ createWorld, random, grid, seed, size }) {
  const cell = 2.6; // a body of the largest size fits into one
  const columns = Math.ceil(Math.sqrt(1.5 * size));
  const rows = Math.ceil(size / columns);
  const [halfX, halfY] = [0.5 * cell * columns + 0.5, 0.5 * cell * rows + 0.5];
  const world = createWorld({ gravity: [0, 0] });

  const wall = (x, y, halfWidth, halfHeight) => {
    const body = world.createBody({ position: [grid(x), grid(y)] });
    world.createAabb(body, { halfWidth, halfHeight, ...ELASTIC });
  };
  wall(0, -halfY - 1, halfX + 2, 1);
  wall(0, halfY + 1, halfX + 2, 1);
  wall(-halfX - 1, 0, 1, halfY);
  wall(halfX + 1, 0, 1, halfY);

  const chance = random(seed + 6);
  for (let i = 0; i < size; i++) {
    const x = ((i % columns) - 0.5 * (columns - 1)) * cell;
    const y = (Math.floor(i / columns) - 0.5 * (rows - 1)) * cell;
    const part = chance(0, 1);
    const half = 0.06 + 0.8 * part * part * part; // most are small
    const velocity = [chance(-3, 3), chance(-3, 3)];
    const position = [grid(x), grid(y)];
    const body = world.createBody({ kind: "dynamic", position, velocity, maySleep: false });
    if (i % 2 === 0) world.createCircle(body, { radius: half, ...ELASTIC });
    else world.createObb(body, { halfWidth: half, halfHeight: 0.6 * half, ...ELASTIC });
  }

  const view = { x: 0, y: -2, height: 2 * halfY + 9, width: 2 * halfX + 4 };
  return { world, view, show: ["cells", "axes"] };
}
