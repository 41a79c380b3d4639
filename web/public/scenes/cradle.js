// What Newton’s cradle does, without strings or gravity: as many balls leave on one side as arrive on
// the other, at the same speed. They come back from the wall, and so on for ever.

export const title = "Rows of elastic balls";
export const about = "In each of three rows as many balls leave as arrive, at the same speed.";
export const menu = { group: "In motion", place: 480 };
export const size = { means: "balls in a row", usual: 5, least: 4, most: 100 };

const ELASTIC = { friction: 0, restitution: 1 };

export default function ({ createWorld, size }) {
  const gap = 6;
  const half = 0.5 * size + 2 * gap;
  const world = createWorld({ gravity: [0, 0] });

  for (const side of [-1, 1]) {
    const wall = world.createBody({ position: [side * (half + 1), 0] });
    world.createAabb(wall, { halfWidth: 1, halfHeight: 8, ...ELASTIC });
  }

  // In row 1, at the top, one ball flies in; in row 2 two, in row 3 three.
  for (let row = 1; row <= 3; row++)
    for (let i = 0; i < size; i++) {
      const flying = i < row;
      const ball = world.createBody({
        kind: "dynamic",
        position: [i - 0.5 * (size - 1) - (flying ? gap : 0), 4 * (2 - row)],
        velocity: [flying ? 5 : 0, 0],
        maySleep: false,
      });
      world.createCircle(ball, { radius: 0.5, ...ELASTIC });
    }

  return { world, view: { x: 0, y: 0, height: 20, width: 2 * half + 4 }, spawn: [0, 6] };
}
