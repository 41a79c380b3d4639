// Every domino is a twentieth larger than the one that knocks it over: a small ball fells one that is
// ten times as tall as the first.

export const size = { means: "dominoes", usual: 48, least: 2, most: 80 };

export default function ({ createWorld, grid, size }) {
  const world = createWorld();
  world.createTerrain(world.createBody(), { kind: "flat" });

  const ball = world.createBody({ kind: "dynamic", position: [-1.5, 0.3], velocity: [3, 0] });
  world.createCircle(ball, { radius: 0.15, density: 4 });

  let x = 0;
  let height = 0.5;
  for (let i = 0; i < size; i++) {
    const position = [grid(x), grid(0.5 * height)];
    const domino = world.createBody({ kind: "dynamic", position });
    world.createObb(domino, { halfWidth: 0.08 * height, halfHeight: 0.5 * height });
    x += 0.55 * height;
    height *= 1.05;
  }

  const width = x + height + 3;
  return {
    world,
    view: { x: 0.5 * width - 3, y: 0.5 * height, height: 1.5 * height, width },
    spawn: [-1, 4],
  };
}
