// What is drawn of the line: its vertices and texture, and what is ticked in the panel.

import { SOLE, STRIPE } from "./look.js";

const line = (points, ink, more = {}) => ({ kind: "line", points, ink, ...more });
const dot = ([x, y], radius, ink) => ({ kind: "circle", x, y, radius, ink, filled: true });
const text = (x, y, words, ink, size = 14) => ({ kind: "text", x, y, text: words, ink, size });

export function paintAll(state, seen, box) {
  const marks = seen.stripes.map(stripe);
  marks.push(line(seen.points, "ink", { width: 2.5 }));
  if (state.box) paintBox(marks, box);
  if (state.foot) paintFeet(marks, seen);
  paintVertices(marks, state, seen);
  if (state.weights) paintWeights(marks, seen);
  return { marks };
}

/** The texture under the line: the denser, the more friction. */
function stripe({ at, height, normal: [nx, ny], friction }) {
  const depth = 0.3;
  return {
    kind: "box",
    x: at - (nx * depth) / 2,
    y: height - (ny * depth) / 2,
    halfWidth: 0.42 * STRIPE,
    halfHeight: depth / 2,
    angle: Math.atan2(-nx, ny),
    ink: "good",
    filled: true,
    opacity: 0.08 + 0.8 * Math.min(1, friction),
  };
}

/** The vertices are dragged; the one that the pointer would take is larger. */
function paintVertices(marks, { near, grip }, { points }) {
  points.forEach((point, i) => {
    const radius = i === (grip ?? near) ? 0.24 : 0.16;
    marks.push(dot(point, radius, "accent"), { ...dot(point, radius, "ink"), filled: false });
  });
}

/** The place, and the two vertices beside it with their weights. */
function paintWeights(marks, { x, ground: { height, weights }, beside, u, friction }) {
  const place = [x, height];
  beside.forEach(([vx, vy], i) => {
    marks.push(line([[vx, vy], [vx, vy + 1.5]], "gold", { dashed: true, width: 1.5 }));
    marks.push(text(vx, vy + 1.8, weights[i].toFixed(2), "gold"));
    const part = Math.min(1, Math.max(0, weights[i]));
    marks.push({ ...dot([vx, vy], 0.2 + 0.3 * part, "gold"), filled: false });
  });
  marks.push(line([[x, height + 2.6], [x, height - 1]], "gold", { width: 2 }));
  marks.push(dot(place, 0.14, "gold"));
  marks.push(text(x, height - 1.3, `u ${u.toFixed(2)}, friction ${friction.toFixed(2)}`, "ink", 13));
}

/** Two soles on the ground, legs, and a back that leans by the slope. */
function paintFeet(marks, { x, feet, stance: { normal: [nx, ny] } }) {
  const middle = (feet[0].height + feet[1].height) / 2;
  const hip = [x + 0.9 * nx, middle + 0.9 * ny];
  const head = [hip[0] + 0.9 * nx, hip[1] + 0.9 * ny];
  for (const { at, height } of feet) {
    const halfHeight = 0.06;
    marks.push({ kind: "box", x: at, y: height + halfHeight, halfWidth: SOLE / 2, halfHeight, ink: "player", filled: true });
    marks.push(line([[at, height + 2 * halfHeight], hip], "player", { width: 4 }));
  }
  marks.push(line([hip, head], "player", { width: 6 }), dot(head, 0.26, "player"));
  // The straight line between the ground under both ends of the stance, by which it leans.
  const half = Math.abs(feet[1].at - feet[0].at) / 2;
  const [tx, ty] = [half, (-nx / ny) * half];
  marks.push(line([[x - tx, middle - ty], [x + tx, middle + ty]], "player", { dashed: true, width: 1.5 }));
}

function paintBox(marks, { position: [x, y], ground }) {
  marks.push(text(x, y + 0.65, ground.toFixed(2), "ink", 13));
}
