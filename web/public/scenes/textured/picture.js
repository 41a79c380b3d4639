// The ground’s texture as stripes under its line, prints, and what is under each foot now.

import { TEXTURE } from "./texture.js";

/** Metres along the ground: from stripe to stripe, and half of one; and how deep it goes. */
const STRIPE = { every: 0.5, half: 0.13, depth: 0.32 };

/** Stripes stand at equal steps of u: on slopes as close as on the level. */
export function groundMarks(bands) {
  return bands.flatMap(({ points, coordinates, row }) => {
    const { ink, name, friction } = TEXTURE[row];
    const marks = [];
    let segment = 0;
    for (let u = STRIPE.every / 2; u < coordinates.at(-1).u; u += STRIPE.every) {
      while (coordinates[segment + 1].u < u) segment++;
      const [from, to] = [coordinates[segment].u, coordinates[segment + 1].u];
      marks.push(stripe(points[segment], points[segment + 1], (u - from) / (to - from), ink));
    }
    const [x, y] = points[2];
    marks.push({ kind: "text", x, y: y - 0.75, text: `${name}, friction ${friction}`, ink });
    return marks;
  });
}

function stripe([ax, ay], [bx, by], part, ink) {
  const angle = Math.atan2(by - ay, bx - ax);
  const [x, y] = [ax + part * (bx - ax), ay + part * (by - ay)];
  return {
    kind: "box",
    x: x + Math.sin(angle) * (STRIPE.depth / 2),
    y: y - Math.cos(angle) * (STRIPE.depth / 2),
    halfWidth: STRIPE.half,
    halfHeight: STRIPE.depth / 2,
    angle,
    ink,
    filled: true,
    opacity: 0.85,
  };
}

/** A shallow mark in the ground for each, as long as the foot slid, fainter the older it is. */
export function printMarks(prints) {
  return prints.map(({ from, to, normal: [nx, ny] }, i) => {
    const [x, y] = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
    const slid = Math.hypot(to[0] - from[0], to[1] - from[1]);
    return {
      kind: "box",
      x: x - 0.04 * nx,
      y: y - 0.04 * ny,
      halfWidth: 0.12 + slid / 2,
      halfHeight: 0.06,
      angle: slid > 0.05 ? Math.atan((to[1] - from[1]) / (to[0] - from[0])) : Math.atan2(-nx, ny),
      round: 0.05,
      ink: "ink",
      filled: true,
      opacity: 0.25 + (0.6 * (i + 1)) / prints.length,
    };
  });
}

const dot = (x, y, radius, ink) => ({ kind: "circle", x, y, radius, ink, filled: true });

/** A dot of the material, and one on each vertex beside it, the larger the more it weighs. */
export function touchMarks(touches) {
  return touches.flatMap(({ x, y, row, weights, from, to }) => {
    const { ink, name } = TEXTURE[row];
    return [
      { kind: "line", points: [[x, y], [x, y - 1.15]], ink, width: 2 },
      ...[from, to].map(([vx, vy], i) => dot(vx, vy, 0.06 + 0.14 * weights[i], "accent")),
      dot(x, y, 0.16, ink),
      { ...dot(x, y, 0.16, "ink"), filled: false },
      { kind: "text", x, y: y - 1.35, text: name, ink: "ink", size: 12 },
    ];
  });
}
