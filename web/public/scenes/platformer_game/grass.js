// Grass on the tiles of a level, where nothing else that stands still lies on them.
import { findBodies } from "./bodies.js";

const ONE_WAY = 2; // the category of planks, which have a picture of their own
const NEAR = 0.01; // metres

// Marks to draw; to be called once, as the world begins.
export function grassOn(world) {
  const tops = findBodies(world, isTile)
    .map(({ position: [x, y], shape: { halfWidth, halfHeight } }) => ({
      x,
      y: y + halfHeight,
      left: x - halfWidth,
      right: x + halfWidth,
    }))
    .filter(({ x, y }) => isFree(world, [x, y + 5 * NEAR]));
  return joined(tops).map(({ left, right, y }) => ({
    kind: "line",
    points: [[left, y], [right, y]],
    ink: "good",
    width: 3,
  }));
}

function isTile({ kind, shape }) {
  const { sensor, category } = shape;
  return kind === "static" && shape.kind === "aabb" && !sensor && category !== ONE_WAY;
}

function isFree(world, center) {
  return world
    .overlap({ kind: "circle", center, radius: NEAR })
    .map((id) => world.shapeStateOf(id))
    .every(({ body, category }) =>
      category === ONE_WAY || world.bodyStateOf(body).kind !== "static");
}

// Those that follow each other at one height are one.
function joined(tops) {
  const lines = [];
  for (const top of tops.sort((a, b) => a.y - b.y || a.left - b.left)) {
    const last = lines.at(-1);
    if (last?.y === top.y && top.left - last.right < NEAR) last.right = top.right;
    else lines.push({ ...top });
  }
  return lines;
}
