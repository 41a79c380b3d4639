// A heavy box flies into a block of small ones. There is no gravity: watch the shock run through.

export const title = "Smash";
export const about = "A heavy box flies into a block of small ones: watch the shock run.";
export const menu = { group: "In motion", place: 470 };
export const size = { means: "boxes in the block", usual: 9600, least: 1, most: 100000 };

export default function ({ createWorld, grid, size }) {
  const spacing = 0.4; // the boxes touch
  const columns = Math.ceil(Math.sqrt(1.5 * size));
  const rows = Math.ceil(size / columns);
  const height = spacing * rows;
  const world = createWorld({ gravity: [0, 0] });

  const half = Math.max(0.4, height / 8);
  const position = [grid(-5 - half), 0];
  const hammer = world.createBody({ kind: "dynamic", position, velocity: [40, 0] });
  world.createObb(hammer, { halfWidth: half, halfHeight: half, density: 8 });

  for (let i = 0; i < size; i++) {
    const x = ((i % columns) + 0.5) * spacing;
    const y = (Math.floor(i / columns) - 0.5 * (rows - 1)) * spacing;
    const box = world.createBody({ kind: "dynamic", position: [grid(x), grid(y)] });
    world.createObb(box, { halfWidth: 0.5 * spacing, halfHeight: 0.5 * spacing });
  }

  const width = spacing * columns;
  return {
    world,
    view: { x: 0.4 * width, y: 0, height: 1.8 * height + 10 },
    spawn: [-10, 0],
  };
}
