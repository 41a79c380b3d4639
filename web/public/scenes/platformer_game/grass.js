// Grass on the upper sides of what stands still, where nothing else lies on them.
import { findBodies } from "./bodies.js";

const ONE_WAY = 2; // the category of planks, which have a picture of their own
const APART = 0.01; // of a box' height: tiles nearer to each other than this touch

// Marks to draw; to be called once, as the world begins.
export function grassOn(world) {
  const boxes = findBodies(
    world,
    ({ kind, shape: { kind: form, sensor, category } }) =>
      kind === "static" && form === "aabb" && !sensor && category !== ONE_WAY,
  ).map(({ position: [x, y], shape: { halfExtents: [halfWidth, halfHeight] } }) => ({
    left: x - halfWidth,
    right: x + halfWidth,
    bottom: y - halfHeight,
    top: y + halfHeight,
  }));
  return joined(boxes.flatMap((box) => openTops(box, boxes))).map(({ left, right, top }) => ({
    kind: "line",
    points: [[left, top], [right, top]],
    ink: "good",
    width: 3,
  }));
}

// The parts of a box' upper side that no other box covers.
function openTops({ left, right, bottom, top }, boxes) {
  const above = top + APART * (top - bottom);
  return boxes
    .filter((other) => other.bottom < above && other.top > above)
    .reduce((parts, other) => parts.flatMap((part) => without(part, other)), [{ left, right, top }]);
}

function without({ left, right, top }, other) {
  return [
    { left, right: Math.min(right, other.left), top },
    { left: Math.max(left, other.right), right, top },
  ].filter((part) => part.left < part.right);
}

// Those that follow each other at one height are one.
function joined(parts) {
  const lines = [];
  for (const part of parts.sort((a, b) => a.top - b.top || a.left - b.left)) {
    const last = lines.at(-1);
    const gap = APART * (part.right - part.left);
    if (last?.top === part.top && part.left - last.right < gap)
      last.right = Math.max(last.right, part.right);
    else lines.push({ ...part });
  }
  return lines;
}
