// Drag the shapes. About the first of a pair stands the sum of both: where the second's centre is
// in it, the two overlap. They pass through each other, for they are of one negative group.

export const title = "Minkowski sums";
export const about =
  "Drag the shapes: they overlap while the second’s centre is inside the sum around the first.";
export const menu = { group: "How it is done", place: 650 };
export const size = { means: "pairs of shapes", usual: 2, least: 1, most: 100 };

export default function ({ createWorld, grid, size }) {
  const row = 8;
  const world = createWorld({ gravity: [0, 0] });

  const body = (x, y, angle) =>
    world.createBody({
      kind: "dynamic",
      position: [grid(x), y],
      angle,
      linearDamping: 6, // it stays where it is put
      angularDamping: 6,
      maySleep: false,
    });
  for (let i = 0; i < size; i++) {
    const y = (0.5 * (size - 1) - i) * row;
    const box = { halfWidth: 1.5, halfHeight: 0.8, group: -1 };
    world.createObb(body(-0.8, y, i % 3 === 2 ? 0 : 0.3), box);
    if (i % 3 === 0) {
      const small = { halfWidth: 1, halfHeight: 0.6, group: -1 };
      world.createObb(body(2.3, y + 2, -0.4), small);
    } else {
      world.createCircle(body(2.3, y + 2, 0), { radius: 0.8, group: -1 });
    }
  }

  return { world, view: { x: 0.4, y: 0, height: row * size + 1 }, spawn: [6, 0], sums: size };
}
