// Boxes stacked to a triangle. Nothing moves, everything presses: the base must not spread.

export const title = "Pyramid";
export const about = "A pyramid of boxes stands on its base and does not spread.";
export const menu = { group: "Piles and stacks", place: 320 };
export const size = { means: "boxes in the lowest row", usual: 100, least: 1, most: 1000 };

export default function ({ createWorld, size }) {
  const world = createWorld();
  const ground = world.createBody({ position: [0, -1] });
  world.createAabb(ground, { halfWidth: size, halfHeight: 1 });

  for (let row = 0; row < size; row++)
    for (let i = 0; i < size - row; i++) {
      const position = [0.5 * (2 * i + row + 1 - size), row + 0.5];
      const box = world.createBody({ kind: "dynamic", position });
      world.createObb(box, { halfWidth: 0.5, halfHeight: 0.5 });
    }

  return { world, view: { x: 0, y: 0.45 * size, height: 1.1 * size }, spawn: [0, size + 5] };
}
