/** The engine's debug drawing as lines, which every renderer can draw. */
import type { Vec2 } from "../types.js";
import type { DrawOptions } from "../view-types.js";
import { DRAW_STYLES } from "../view-types.js";
import type { World } from "../world.js";

/**
 * Draws a line through points, x and y of each, in the world's units relative to `origin`. `closed`: whether it
 * goes back to the first point. `colour`: 0xRRGGBB.
 */
export type Pen = (points: readonly number[], closed: boolean, colour: number) => void;

/** Corners of the polygon that stands for a circle. Chosen: at usual sizes it looks round. */
const CORNERS = 24;
const CIRCLE = Array.from({ length: CORNERS }, (_, i) => (2 * Math.PI * i) / CORNERS);
const RING = CIRCLE.map((angle) => [Math.cos(angle), Math.sin(angle)] as const);
const BOX = [[1, 1], [-1, 1], [-1, -1], [1, -1]] as const;

const COLOURS: Partial<Record<(typeof DRAW_STYLES)[number], number>> = {
  static: 0x8a93a3,
  kinematic: 0x3d7dd8,
  dynamic: 0x2f9e5a,
  sleeping: 0x5f8f74,
  sensor: 0xb8860b,
  contact: 0xe03131,
  normal: 0xe03131,
  manifold: 0xe03131,
  joint: 0x9c5fd0,
  "joint axis": 0x9c5fd0,
  "joint limit": 0xd05f9c,
};
/** The colours of all other styles, in turn. */
const OTHERS = [0xe8590c, 0x1098ad, 0x5c940d, 0xc2255c, 0x4263eb, 0x868e96];
const colourOf = (style: number) => COLOURS[DRAW_STYLES[style]] ?? OTHERS[style % OTHERS.length];

/**
 * Draws what `World.draw` lists: shapes as outlines, circles with a radius that shows their angle, and points as
 * crosses of the half width `cross`, a length. It shows the state after the last step, which `Sprites.update`
 * approaches from the step before.
 * @throws {ThudError} as `World.draw`.
 */
export function trace(world: World, options: DrawOptions, cross: number, pen: Pen): void {
  const { shapes, lines, points } = world.draw(options);
  for (let at = 0; at < shapes.length; at += 9) {
    const [x, y, halfWidth, halfHeight, cosine, sine, round, style] = shapes.subarray(at, at + 9);
    const outline = (round ? RING : BOX).flatMap(([u, v]): Vec2 => {
      const [dx, dy] = [u * halfWidth, v * halfHeight];
      return [x + cosine * dx - sine * dy, y + sine * dx + cosine * dy];
    });
    pen(outline, true, colourOf(style));
    if (round) pen([x, y, x + cosine * halfWidth, y + sine * halfWidth], false, colourOf(style));
  }
  for (let at = 0; at < lines.length; at += 5)
    pen([...lines.subarray(at, at + 4)], false, colourOf(lines[at + 4]));
  for (let at = 0; at < points.length; at += 3) {
    const [x, y, style] = points.subarray(at, at + 3);
    pen([x - cross, y, x + cross, y], false, colourOf(style));
    pen([x, y - cross, x, y + cross], false, colourOf(style));
  }
}
