/** What the engine's debug drawing gives, drawn on a canvas whose origin is the lists'. */
import { DRAW_STYLES } from "thud";
import type { Drawing } from "../scene/frame";
import type { OverlayName } from "../scene/overlays";
import { classColour, cssColour, type Theme } from "./palette";

/** Numbers a shape, a line and a point, as in DrawLists of the package. */
const SHAPE = 9;
const LINE = 5;
const POINT = 3;

/** Of whole bodies: they are drawn already, and only their islands are of interest here. */
const BODIES: readonly string[] = ["static", "kinematic", "dynamic", "sleeping", "sensor"];
/** From the lowest to the highest; styles not named here lie between. */
const LOWEST: readonly string[] = ["cell", "bounds", "interval", "interval overlapping", "motion"];
const HIGHEST: readonly string[] = ["normal"];
/** CSS pixels. */
const WIDTHS: Readonly<Record<string, number>> = {
  cell: 1,
  bounds: 1,
  pair: 1,
  "pair touching": 1,
  interval: 2.5,
  "interval overlapping": 2.5,
};
const USUAL_WIDTH = 1.5;

/** The styles' numbers, in the order of drawing. */
const ORDER: readonly number[] = DRAW_STYLES.map((_, style) => style)
  .filter((style) => !BODIES.includes(DRAW_STYLES[style]))
  .sort((a, b) => height(DRAW_STYLES[a]) - height(DRAW_STYLES[b]));

function height(style: string): number {
  if (LOWEST.includes(style)) return LOWEST.indexOf(style) - LOWEST.length;
  return HIGHEST.indexOf(style) + 1;
}

export function drawLists(
  context: CanvasRenderingContext2D,
  { shapes, lines, points }: Drawing,
  scale: number,
  theme: Theme,
  on: ReadonlySet<OverlayName>,
): void {
  const paths = new Map<number, Path2D>();
  const islands = new Map<number, Path2D>();
  for (let i = 0; i < shapes.length; i += SHAPE) {
    const [style, island] = [shapes[i + 7], shapes[i + 8]];
    const path = island >= 0 ? pathOf(islands, island) : pathOf(paths, style);
    addOutline(path, shapes, i, scale);
  }
  for (const [island, path] of islands) {
    context.fillStyle = cssColour(classColour(island, theme.dark));
    context.fill(path);
  }
  for (let i = 0; i < lines.length; i += LINE) {
    const path = pathOf(paths, lines[i + 4]);
    path.moveTo(lines[i] * scale, -lines[i + 1] * scale);
    path.lineTo(lines[i + 2] * scale, -lines[i + 3] * scale);
  }
  // From afar an outline must not fill what it goes around.
  const thinnest = Math.min(USUAL_WIDTH, Math.max(0.7, 0.06 * scale));
  for (const style of ORDER) {
    const path = paths.get(style);
    const name = DRAW_STYLES[style];
    if (!path || (name === "normal" && !on.has("normals"))) continue;
    context.strokeStyle = styleColour(style, theme);
    context.lineWidth = name === "motion" ? thinnest : (WIDTHS[name] ?? USUAL_WIDTH);
    context.stroke(path);
  }
  drawPoints(context, points, scale, theme, on);
}

function drawPoints(
  context: CanvasRenderingContext2D,
  points: Float32Array,
  scale: number,
  theme: Theme,
  on: ReadonlySet<OverlayName>,
): void {
  const radius = Math.min(3.5, Math.max(1.2, 0.08 * scale));
  const paths = new Map<number, Path2D>();
  for (let i = 0; i < points.length; i += POINT) {
    const style = points[i + 2];
    if (DRAW_STYLES[style] === "contact" && !on.has("contacts")) continue;
    const path = pathOf(paths, style);
    const [x, y] = [points[i] * scale, -points[i + 1] * scale];
    path.moveTo(x + radius, y);
    path.arc(x, y, radius, 0, 2 * Math.PI);
  }
  for (const [style, path] of paths) {
    context.fillStyle = styleColour(style, theme);
    context.fill(path);
  }
}

function styleColour(style: number, theme: Theme): string {
  return theme.styles[DRAW_STYLES[style]] ?? cssColour(classColour(style, theme.dark));
}

function pathOf(paths: Map<number, Path2D>, key: number): Path2D {
  const known = paths.get(key);
  if (known) return known;
  const path = new Path2D();
  paths.set(key, path);
  return path;
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
