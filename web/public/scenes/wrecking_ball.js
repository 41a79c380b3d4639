// A ball of 1,000 times a brick’s mass swings on its chain into a wall.

import { NOTHING, partsOf, PI } from "./joints/parts.js";

export const title = "Wrecking ball";
export const about =
  "A ball of 1,000 times a brick’s mass swings into a wall on a chain that does not stretch.";
export const menu = { group: "Joints", place: 533 };
export const size = { means: "bricks", usual: 100, least: 1, most: 2000 };

const [HALF_BRICK, HALF_COURSE, COLUMNS] = [0.4, 0.2, 5];
const [PIVOT, RADIUS, LINKS] = [14, 1.1, 16];

export default function ({ createWorld, grid, size }) {
  const world = createWorld();
  const parts = partsOf(world, grid);
  world.createTerrain(parts.fixed().body, { kind: "flat", slope: 0 });
  const crane = addCrane(parts);
  addChain(parts, crane, 4 * HALF_BRICK * HALF_COURSE);

  for (let i = 0; i < size; i++) {
    const row = Math.floor(i / COLUMNS);
    const x = 2.2 + 2 * HALF_BRICK * (i % COLUMNS) + (row % 2 ? HALF_BRICK : 0);
    parts.box([x, HALF_COURSE + 2 * HALF_COURSE * row], HALF_BRICK, HALF_COURSE);
  }
  return { world, view: { x: -3.5, y: 8, height: 23, width: 30 }, spawn: [4, 16] };
}

// A mast with a jib that reaches to the chain. Nothing meets it: it stands behind.
function addCrane({ fixed, addBar }) {
  const [mast, width] = [-13, 1];
  const crane = fixed();
  const bar = (a, b, half) => addBar(crane, a, b, half, { group: -1, mask: NOTHING });
  for (const side of [-1, 1])
    bar([mast + side * width, 0], [mast + side * width, PIVOT + 1], 0.12);
  for (let i = 0; i < 7; i++) {
    const [low, left, right] = [2 * i, mast - width, mast + width];
    bar([i % 2 ? right : left, low], [i % 2 ? left : right, low + 2], 0.06);
  }
  bar([mast - 5, PIVOT + 0.3], [0.3, PIVOT + 0.3], 0.14);
  bar([mast, PIVOT + 4], [0, PIVOT + 0.4], 0.06);
  bar([mast, PIVOT + 4], [mast - 5, PIVOT + 0.4], 0.06);
  bar([mast, PIVOT + 1], [mast, PIVOT + 4], 0.12);
  bar([mast - 4.3, PIVOT - 1.6], [mast - 4.3, PIVOT + 0.1], 0.8);
  return crane;
}

// Drawn up to the left, at 60 degrees from where it hangs.
function addChain({ bar, circle, hinge }, crane, brick) {
  const [length, sine, cosine] = [0.62, 0.8660254037844386, 0.5];
  const group = -1; // links do not meet each other, nor the ball
  const awake = { maySleep: false };
  let last = crane;
  let end = [0, PIVOT];
  for (let i = 0; i < LINKS; i++) {
    const from = end;
    end = [-(i + 1) * length * sine, PIVOT - (i + 1) * length * cosine];
    const link = bar(from, end, 0.09, { group }, awake);
    hinge(last, link, from);
    last = link;
  }
  const density = (1000 * brick) / (PI * RADIUS * RADIUS);
  const center = [end[0] - RADIUS * sine, end[1] - RADIUS * cosine];
  hinge(last, circle(center, RADIUS, { density, group }, awake), end);
}
