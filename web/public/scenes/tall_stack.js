// One column of boxes, which must neither sag nor lean: its height tells how soft the contacts are.

export const title = "Tall stack";
export const about = "A single column of boxes: how far it sinks tells how soft its contacts are.";
export const menu = { group: "Piles and stacks", place: 370 };
export const size = { means: "boxes", usual: 30, least: 1, most: 1000 };

export default function ({ createWorld, size }) {
  const world = createWorld();
  const ground = world.createBody({ position: [0, -1] });
  world.createAabb(ground, { halfWidth: 20, halfHeight: 1 });

  for (let i = 0; i < size; i++) {
    const box = world.createBody({ kind: "dynamic", position: [0, i + 0.5] });
    world.createObb(box, { halfWidth: 0.5, halfHeight: 0.5 });
  }

  return { world, view: { x: 0, y: 0.5 * size, height: 1.2 * size + 4 }, spawn: [5, size] };
}
