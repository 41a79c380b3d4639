/** What the engine's debug drawing gives, drawn on a canvas whose origin is the lists'. */
import { DRAW_STYLES, type DrawLists } from "thud";
import { islandColour, type Theme } from "./palette";

/** Those of the overlays that the engine draws. */
export const DRAWN = [
  "contacts",
  "normals",
  "bounds",
  "cells",
  "islands",
  "axes",
  "pairs",
  "motions",
] as const;

type Style = (typeof DRAW_STYLES)[number];

/** Outlines and lines, from the lowest to the highest. */
function strokes(
  theme: Theme,
  scale: number,
): [style: Style, colour: string, width: number][] {
  // From afar an outline must not fill what it goes around.
  const thin = Math.min(1.5, Math.max(0.7, 0.06 * scale));
  return [
    ["cell", theme.cell, 1],
    ["bounds", theme.bounds, 1],
    ["interval", theme.interval, 2.5],
    ["interval overlapping", theme.touching, 2.5],
    ["motion", theme.motion, thin],
    ["pair", theme.pair, 1],
    ["pair touching", theme.touching, 1],
    ["normal", theme.normal, 1.5],
  ];
}

export function drawLists(
  context: CanvasRenderingContext2D,
  { shapes, lines, points }: DrawLists,
  scale: number,
  theme: Theme,
  on: ReadonlySet<string>,
): void {
  const paths = DRAW_STYLES.map(() => new Path2D());
  const islands = new Map<number, Path2D>();
  for (let i = 0; i < shapes.length; i += 9) {
    const [style, island] = [shapes[i + 7], shapes[i + 8]];
    let path = paths[style];
    if (island >= 0) {
      path = islands.get(island) ?? new Path2D();
      islands.set(island, path);
    }
    addOutline(path, shapes, i, scale);
  }
  for (const [island, path] of islands) {
    context.fillStyle = islandColour(island, theme.dark);
    context.fill(path);
  }
  for (let i = 0; i < lines.length; i += 5) {
    const path = paths[lines[i + 4]];
    path.moveTo(lines[i] * scale, -lines[i + 1] * scale);
    path.lineTo(lines[i + 2] * scale, -lines[i + 3] * scale);
  }
  for (const [style, colour, width] of strokes(theme, scale)) {
    if (style === "normal" && !on.has("normals")) continue;
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.stroke(paths[DRAW_STYLES.indexOf(style)]);
  }
  if (on.has("contacts")) drawContacts(context, points, scale, theme);
}

function drawContacts(
  context: CanvasRenderingContext2D,
  points: Float32Array,
  scale: number,
  theme: Theme,
): void {
  const radius = Math.min(3.5, Math.max(1.2, 0.08 * scale));
  context.beginPath();
  for (let i = 0; i < points.length; i += 3) {
    const [x, y] = [points[i] * scale, -points[i + 1] * scale];
    context.moveTo(x + radius, y);
    context.arc(x, y, radius, 0, 2 * Math.PI);
  }
  context.fillStyle = theme.contact;
  context.fill();
}

function addOutline(path: Path2D, shapes: Float32Array, at: number, scale: number): void {
  const [x, y, hx, hy, c, s, round] = shapes.subarray(at, at + 7);
  if (round !== 0) {
    path.moveTo((x + hx) * scale, -y * scale);
    path.arc(x * scale, -y * scale, hx * scale, 0, 2 * Math.PI);
    return;
  }
  const corner = (a: number, b: number): [number, number] => [
    (x + a * c * hx - b * s * hy) * scale,
    -(y + a * s * hx + b * c * hy) * scale,
  ];
  path.moveTo(...corner(-1, -1));
  path.lineTo(...corner(1, -1));
  path.lineTo(...corner(1, 1));
  path.lineTo(...corner(-1, 1));
  path.closePath();
}
