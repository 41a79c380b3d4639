/** Draws terrain: soil with a line of grass on top. Only the visible part is computed. */
import type { Terrain } from "thud";
import type { PlacedTerrain } from "../scene/frame";
import type { Camera, Pane } from "./camera";
import type { Theme } from "./palette";

/**
 * A vertex nearer than this to the last one, in CSS pixels, is left out, as no difference is
 * visible. Chosen.
 */
const LEAST_DISTANCE = 0.6;
/** Depths below the ground at which layers of soil begin, in CSS pixels. Chosen. */
const LAYERS = [26, 64, 118, 190];

/** `grass` is the thickness of the grass in CSS pixels. */
export function drawTerrain(
  context: CanvasRenderingContext2D,
  camera: Camera,
  pane: Pane,
  theme: Theme,
  placed: PlacedTerrain,
  grass: number,
): void {
  const line = screenLine(camera, pane, placed);
  if (line.length < 4) return;
  const bottom = pane.top + pane.height + grass + 4;
  let top = bottom;
  for (let i = 1; i < line.length; i += 2) top = Math.min(top, line[i]);
  if (top >= bottom) return;

  const ground = new Path2D();
  for (let i = 0; i < line.length; i += 2) ground.lineTo(line[i], line[i + 1]);
  const soil = new Path2D(ground);
  soil.lineTo(line[line.length - 2], bottom);
  soil.lineTo(line[0], bottom);
  soil.closePath();
  const start = Math.max(pane.top, top);
  const shade = context.createLinearGradient(0, start, 0, Math.max(start + 1, bottom));
  shade.addColorStop(0, theme.soilTop);
  shade.addColorStop(1, theme.soilBottom);
  context.fillStyle = shade;
  context.fill(soil);
  context.fillStyle = theme.layer;
  for (const depth of LAYERS) {
    context.translate(0, depth);
    context.fill(soil);
    context.translate(0, -depth);
  }

  context.save();
  context.clip(soil);
  context.lineJoin = "round";
  context.lineWidth = 2 * grass;
  context.strokeStyle = theme.turf;
  context.stroke(ground);
  context.restore();
  context.lineJoin = "round";
  context.lineWidth = Math.min(2.5, Math.max(1.5, 0.35 * grass));
  context.strokeStyle = theme.grass;
  context.stroke(ground);
}

/**
 * The visible part of a terrain, with one more vertex on each side, on the screen: x and y in turn.
 */
function screenLine(camera: Camera, pane: Pane, { x, y, terrain }: PlacedTerrain): number[] {
  const { x0, x1 } = camera.visibleIn(pane);
  const line: number[] = [];
  const add = (worldX: number, worldY: number, always: boolean) => {
    const [screenX, screenY] = camera.toScreen(worldX, worldY, pane);
    const near =
      Math.abs(screenX - line[line.length - 2]) < LEAST_DISTANCE &&
      Math.abs(screenY - line[line.length - 1]) < LEAST_DISTANCE;
    if (always || !near) line.push(screenX, screenY);
  };
  if (terrain.kind === "flat") {
    const slope = terrain.slope ?? 0;
    // The line goes beyond the pane's edges, so that its ends are not visible.
    const beyond = 0.05 * (x1 - x0);
    for (const at of [x0 - beyond, x1 + beyond]) add(at, y + slope * (at - x), true);
    return line;
  }
  const count = vertexCount(terrain);
  const first = Math.max(0, firstBeyond(terrain, x0 - x) - 1);
  const last = Math.min(count - 1, firstBeyond(terrain, x1 - x));
  for (let i = first; i <= last; i++) {
    const [vertexX, vertexY] = vertex(terrain, i);
    add(x + vertexX, y + vertexY, i === first || i === last);
  }
  return line;
}

type Vertices = Exclude<Terrain, { kind: "flat" }>;

function vertexCount(terrain: Vertices): number {
  return terrain.kind === "uniform" ? terrain.heights.length : terrain.points.length;
}

function vertex(terrain: Vertices, i: number): readonly [number, number] {
  if (terrain.kind === "irregular") return terrain.points[i];
  return [terrain.x0 + i * terrain.spacing, terrain.heights[i]];
}

/** Index of the first vertex at or beyond x, by bisection: vertices are sorted by x. */
function firstBeyond(terrain: Vertices, x: number): number {
  let low = 0;
  let high = vertexCount(terrain);
  while (low < high) {
    const middle = (low + high) >> 1;
    if (vertex(terrain, middle)[0] < x) low = middle + 1;
    else high = middle;
  }
  return low;
}
