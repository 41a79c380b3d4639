// Thousands of boxes fall asleep in small stacks on their shelves, while a hundred circles on top
// never rest. What sleeps costs nothing: the step takes as long as the hundred alone.

export const title = "Twenty thousand asleep";
export const about =
  "Thousands of boxes fall asleep in small stacks; a hundred circles stay awake.";
export const menu = { group: "Crowds and extremes", place: 750 };
export const size = { means: "boxes in stacks", usual: 20000, least: 1, most: 100000 };

const ELASTIC = { friction: 0, restitution: 1 };

export default function ({ createWorld, random, grid, seed, size }) {
  const [stackSpacing, shelfSpacing, perStack] = [2, 7, 5];
  const stacks = Math.ceil(size / perStack);
  const perShelf = Math.ceil(Math.sqrt((stacks * shelfSpacing) / stackSpacing));
  const shelves = Math.ceil(stacks / perShelf);
  const world = createWorld();

  const block = (x, y, halfWidth, halfHeight, material = {}) => {
    const body = world.createBody({ position: [grid(x), grid(y)] });
    world.createAabb(body, { halfWidth, halfHeight, ...material });
  };
  for (let i = 0; i < shelves; i++)
    block(0, i * shelfSpacing - 0.5, 0.5 * stackSpacing * perShelf + 1, 0.5);

  for (let i = 0; i < size; i++) {
    const stack = Math.floor(i / perStack);
    const x = ((stack % perShelf) - 0.5 * (perShelf - 1)) * stackSpacing;
    const y = Math.floor(stack / perShelf) * shelfSpacing + (i % perStack) + 0.5;
    const box = world.createBody({ kind: "dynamic", position: [x, y] });
    world.createObb(box, { halfWidth: 0.5, halfHeight: 0.5 });
  }

  // The restless ones: elastic, and without weight.
  const top = shelves * shelfSpacing;
  const middle = top + 12;
  const [half, spacing] = [6.75, 1.25];
  block(0, middle - half - 1, half + 2, 1, ELASTIC);
  block(0, middle + half + 1, half + 2, 1, ELASTIC);
  block(-half - 1, middle, 1, half, ELASTIC);
  block(half + 1, middle, 1, half, ELASTIC);
  const chance = random(seed + 4);
  for (let i = 0; i < 100; i++) {
    const [dx, dy] = direction(chance);
    const circle = world.createBody({
      kind: "dynamic",
      position: [((i % 10) - 4.5) * spacing, middle + (Math.floor(i / 10) - 4.5) * spacing],
      velocity: [5 * dx, 5 * dy],
      gravityScale: 0,
      maySleep: false,
    });
    world.createCircle(circle, { radius: 0.25, ...ELASTIC });
  }

  const height = top + 24;
  return { world, view: { x: 0, y: 0.5 * height, height: 1.1 * height }, spawn: [0, height] };
}

// A point of the unit circle by rejection: Math.sin may differ between browsers.
function direction(chance) {
  for (;;) {
    const x = chance(-1, 1);
    const y = chance(-1, 1);
    const squared = x * x + y * y;
    if (squared > 0.01 && squared <= 1) return [x / Math.sqrt(squared), y / Math.sqrt(squared)];
  }
}
