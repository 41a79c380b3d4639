// A crowd collapses in one spot of a world ten kilometres wide. A grid over the whole world would
// put all of it into a single cell.

export const title = "All in one spot";
export const about = "A crowd collapses in one spot of a world 10 km wide.";
export const menu = { group: "Crowds and extremes", place: 740 };
export const size = { means: "circles in the spot", usual: 4000, least: 1, most: 100000 };

export default function ({ createWorld, grid, size }) {
  const spacing = 0.6;
  const columns = Math.ceil(Math.sqrt(size));
  const world = createWorld();

  const ground = world.createBody({ position: [0, -1] });
  world.createAabb(ground, { halfWidth: 5000, halfHeight: 1 });
  for (const side of [-1, 1]) {
    const farAway = world.createBody({ kind: "dynamic", position: [4990 * side, 0.5] });
    world.createObb(farAway, { halfWidth: 0.5, halfHeight: 0.5 });
  }

  for (let i = 0; i < size; i++) {
    const row = Math.floor(i / columns);
    const x = ((i % columns) - 0.5 * (columns - 1) + 0.25 * (row % 2)) * spacing;
    const y = (row + 0.5) * spacing;
    const circle = world.createBody({ kind: "dynamic", position: [grid(x), grid(y)] });
    world.createCircle(circle, { radius: 0.25 });
  }

  const width = spacing * columns;
  return {
    world,
    view: { x: 0, y: 0.3 * width, height: 1.3 * width + 4 },
    spawn: [0, width + 2],
  };
}
