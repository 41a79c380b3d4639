// What is drawn: of each detection some of its balls, and rings where the closed form has them.

import { BALLS, LANES, MOTIONS, RADIUS, ROOM } from "./motions.js";

/** One ball of so many is drawn, so far from the next; a lane is so wide. */
const [EVERY, PITCH, LANE] = [6, 0.42, 3.1];
const DRAWN = Array.from({ length: Math.ceil(BALLS / EVERY) }, (_, i) => i * EVERY);
const WIDTH = ROOM + 2 * RADIUS;
const HOP_PITCH = (WIDTH - 2 * RADIUS) / (DRAWN.length - 1);

export function paintLanes({ motion, time }, { lanes }) {
  const { at } = MOTIONS[motion];
  /** A place of a ball, which is one metre from the next, where it is drawn. */
  const drawn = (lane, i, [x, y], ball) => {
    const left = LANE * (lane - 0.5 * (LANES.length - 1)) - 0.5 * WIDTH;
    return motion === "shuttle" ? [left + x, PITCH * i + y - ball] : [left + RADIUS + HOP_PITCH * i + x - ball, y];
  };
  return LANES.flatMap((name, lane) => {
    const left = LANE * (lane - 0.5 * (LANES.length - 1)) - 0.5 * WIDTH;
    const top = PITCH * (DRAWN.length - 0.3);
    const edges =
      motion === "shuttle"
        ? [left, left + WIDTH].map((x) => [[x, -0.4], [x, top]])
        : [[[left - 0.2, 0], [left + WIDTH + 0.2, 0]]];
    const balls = DRAWN.flatMap((ball, i) => {
      const [x, y] = drawn(lane, i, lanes[name].world.bodyStateOf(lanes[name].balls[ball]).position, ball);
      const [u, v] = drawn(lane, i, at(ball, time), ball);
      return [
        { kind: "line", points: [[x, y], [u, v]], ink: "bad" },
        { kind: "circle", x, y, radius: RADIUS, ink: "accent", filled: true },
        { kind: "circle", x: u, y: v, radius: RADIUS, ink: "ink" },
      ];
    });
    return [
      ...edges.map((points) => ({ kind: "line", points, ink: "ink", width: 3 })),
      ...balls,
      { kind: "text", x: left + 0.5 * WIDTH, y: -0.8, text: name, ink: "ink" },
    ];
  });
}
