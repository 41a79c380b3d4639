// Every domino is a twelfth larger than the one that knocks it over: in the end a small ball fells
// one that is nine times as tall as the first.

export const title = "Dominoes";
export const about = "Each knocks over a slightly larger one, until a giant falls.";
export const menu = { group: "In motion", place: 410 };
export const size = { means: "dominoes", usual: 30, least: 2, most: 60 };

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
    height *= 1.08;
  }

  const width = x + height + 3;
  return {
    world,
    view: { x: 0.5 * width - 2, y: 0.8 * height, height: 2 * height, width },
    spawn: [-1, 4],
  };
}
