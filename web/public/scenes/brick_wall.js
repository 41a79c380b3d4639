// A heavy ball flies into a wall of loose bricks. Only weight and friction hold them: explode what
// is left standing.

export const title = "Brick wall";
export const about = "A heavy ball flies into a wall of loose bricks; explode what is left.";
export const menu = { group: "Piles and stacks", place: 330 };
export const size = { means: "rows of bricks", usual: 28, least: 2, most: 100 };

const BRICK = { halfWidth: 0.4, halfHeight: 0.2 };
const HALF_BRICK = { halfWidth: 0.2, halfHeight: 0.2 };

export default function ({ createWorld, grid, size: rows }) {
  const columns = Math.ceil(1.1 * rows);
  const width = 0.8 * columns;
  const height = 0.4 * rows;
  const world = createWorld();
  world.createTerrain(world.createBody(), { kind: "flat" });

  const lay = (x, row, shape) => {
    const position = [grid(x), grid(0.4 * row + 0.2)];
    world.createObb(world.createBody({ kind: "dynamic", position }), shape);
  };
  for (let row = 0; row < rows; row++) {
    // Every other row is shifted by half a brick, and has a half at either end.
    const shift = 0.4 * (row % 2);
    for (let i = 0; i < columns - (row % 2); i++) lay(0.8 * i + 0.4 + shift, row, BRICK);
    if (row % 2 === 1) {
      lay(0.2, row, HALF_BRICK);
      lay(width - 0.2, row, HALF_BRICK);
    }
  }

  const position = [-16, grid(0.6 * height + 2)];
  const ball = world.createBody({ kind: "dynamic", position, velocity: [26, 1] });
  world.createCircle(ball, { radius: 1.4, density: 10 });

  return {
    world,
    view: {
      x: 0.4 * width,
      y: 0.6 * height,
      height: 1.7 * height,
      width: 0.85 * width,
      low: true,
      // Upright, the side that the ball hits fills the window.
      tall: { x: 0.26 * height, y: 0.6 * height, height: 1.3 * height, width: 0.84 * height },
    },
    spawn: [0.5 * width, height + 6],
  };
}
