/**
 * Draws the lists of the engine's debug drawing (DrawLists of the package). The canvas' origin is
 * the place that the lists are relative to.
 */
import { DRAW_STYLES } from "thud";
import type { Drawing } from "../scene/frame";
import type { OverlayName } from "../scene/overlays";
import { classColour, cssColour, type Theme } from "./palette";
import { type Paths, pathsOf } from "./paths";

/** Numbers per shape, per line and per point in these lists. */
const SHAPE = 9;
const LINE = 5;
const POINT = 3;

/**
 * Styles of shapes of bodies. They are not stroked, because the bodies are drawn already; they are
 * only filled with the colour of their island.
 */
const BODIES: readonly string[] = ["static", "kinematic", "dynamic", "sleeping", "sensor"];
/**
 * Styles that are drawn before all others, in this order; and those that are drawn after all
 * others.
 */
const LOWEST: readonly string[] = ["cell", "bounds", "interval", "interval overlapping", "motion"];
const HIGHEST: readonly string[] = ["normal"];
/** Widths of lines by style, in CSS pixels. Chosen. */
const WIDTHS: Readonly<Record<string, number>> = {
  cell: 1,
  bounds: 1,
  pair: 1,
  "pair candidate": 1,
  "pair touching": 1,
  impulse: 2.5,
  interval: 2.5,
  "interval overlapping": 2.5,
};
const USUAL_WIDTH = 1.5;

/** The numbers of the styles in the order in which they are drawn. */
const ORDER: readonly number[] = DRAW_STYLES.map((_, style) => style)
  .filter((style) => !BODIES.includes(DRAW_STYLES[style]))
  .sort((a, b) => height(DRAW_STYLES[a]) - height(DRAW_STYLES[b]));

/** The place of a style in that order: negative before all others, positive after them. */
function height(style: string): number {
  if (LOWEST.includes(style)) return LOWEST.indexOf(style) - LOWEST.length;
  return HIGHEST.indexOf(style) + 1;
}

/**
 * `scale` is the camera's. `on`: contacts and normals come in one list, and each is drawn only if
 * its overlay is on.
 */
export function drawLists(
  context: CanvasRenderingContext2D,
  { shapes, lines, points }: Drawing,
  scale: number,
  theme: Theme,
  on: ReadonlySet<OverlayName>,
): void {
  const paths = new Map<number, Paths>();
  const islands = new Map<number, Paths>();
  for (let i = 0; i < shapes.length; i += SHAPE) {
    const [style, island] = [shapes[i + 7], shapes[i + 8]];
    const outlines = island >= 0 ? pathsOf(islands, island) : pathsOf(paths, style);
    addOutline(outlines.next(), shapes, i, scale);
  }
  for (const [island, outlines] of islands) {
    context.fillStyle = cssColour(classColour(island, theme.dark));
    outlines.fill(context);
  }
  for (let i = 0; i < lines.length; i += LINE) {
    const path = pathsOf(paths, lines[i + 4]).next();
    path.moveTo(lines[i] * scale, -lines[i + 1] * scale);
    path.lineTo(lines[i + 2] * scale, -lines[i + 3] * scale);
  }
  // Outlines of moving bodies get thinner as the camera moves away, so that they do not fill small
  // bodies.
  const thinnest = Math.min(USUAL_WIDTH, Math.max(0.7, 0.06 * scale));
  for (const style of ORDER) {
    const strokes = paths.get(style);
    const name = DRAW_STYLES[style];
    if (!strokes || (name === "normal" && !on.has("normals"))) continue;
    context.strokeStyle = styleColour(style, theme);
    context.lineWidth = name === "motion" ? thinnest : (WIDTHS[name] ?? USUAL_WIDTH);
    strokes.stroke(context);
  }
  drawPoints(context, points, scale, theme, on);
}

/** The points of the lists, as discs. */
function drawPoints(
  context: CanvasRenderingContext2D,
  points: Float32Array,
  scale: number,
  theme: Theme,
  on: ReadonlySet<OverlayName>,
): void {
  const radius = Math.min(3.5, Math.max(1.2, 0.08 * scale));
  const paths = new Map<number, Paths>();
  for (let i = 0; i < points.length; i += POINT) {
    const style = points[i + 2];
    if (DRAW_STYLES[style] === "contact" && !on.has("contacts")) continue;
    const path = pathsOf(paths, style).next();
    const [x, y] = [points[i] * scale, -points[i + 1] * scale];
    path.moveTo(x + radius, y);
    path.arc(x, y, radius, 0, 2 * Math.PI);
  }
  for (const [style, dots] of paths) {
    context.fillStyle = styleColour(style, theme);
    dots.fill(context);
  }
}

/** The theme's colour of a style; one by the style's number where the theme has none. */
function styleColour(style: number, theme: Theme): string {
  return theme.styles[DRAW_STYLES[style]] ?? cssColour(classColour(style, theme.dark));
}

/** Adds the outline of the shape at an index of the list. */
function addOutline(path: Path2D, shapes: Float32Array, at: number, scale: number): void {
  const x = shapes[at] * scale;
  const y = -shapes[at + 1] * scale;
  const hx = shapes[at + 2] * scale;
  const hy = shapes[at + 3] * scale;
  const c = shapes[at + 4];
  const s = shapes[at + 5];
  if (shapes[at + 6] !== 0) {
    path.moveTo(x + hx, y);
    path.arc(x, y, hx, 0, 2 * Math.PI);
    return;
  }
  if (s === 0) {
    path.rect(x - hx, y - hy, 2 * hx, 2 * hy);
    return;
  }
  const ax = c * hx;
  const ay = -s * hx;
  const bx = -s * hy;
  const by = -c * hy;
  path.moveTo(x - ax - bx, y - ay - by);
  path.lineTo(x + ax - bx, y + ay - by);
  path.lineTo(x + ax + bx, y + ay + by);
  path.lineTo(x - ax + bx, y - ay + by);
  path.closePath();
}
