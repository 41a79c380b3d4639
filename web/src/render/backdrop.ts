/** What lies behind the bodies: sky, grid and terrain. Drawn again only when the view changes. */
import type { Terrain } from "thud";
import type { Camera } from "../camera";
import type { Theme } from "./palette";
import type { PlacedTerrain } from "./shapes";

export class Backdrop {
  readonly #context: CanvasRenderingContext2D;
  #ratio = 1;
  #drawn = "";
  #terrains: PlacedTerrain[] = [];

  constructor(context: CanvasRenderingContext2D) {
    this.#context = context;
  }

  resize(width: number, height: number, ratio: number): void {
    this.#context.canvas.width = Math.round(width * ratio);
    this.#context.canvas.height = Math.round(height * ratio);
    this.#ratio = ratio;
    this.#drawn = "";
  }

  setTerrains(terrains: PlacedTerrain[]): void {
    this.#terrains = terrains;
    this.#drawn = "";
  }

  draw(camera: Camera, theme: Theme): void {
    const { x, y, scale, middleX, middleY } = camera;
    const view = [x, y, scale, middleX, middleY, theme.dark].join();
    if (view === this.#drawn) return;
    this.#drawn = view;
    const context = this.#context;
    context.setTransform(this.#ratio, 0, 0, this.#ratio, 0, 0);
    const sky = context.createLinearGradient(0, 0, 0, camera.height);
    sky.addColorStop(0, theme.skyTop);
    sky.addColorStop(1, theme.skyBottom);
    context.fillStyle = sky;
    context.fillRect(0, 0, camera.width, camera.height);
    drawGrid(context, camera, theme);
    for (const terrain of this.#terrains) drawTerrain(context, camera, theme, terrain);
  }
}

/** Lines at 1, 2 or 5 times a power of ten, some 30 to 75 pixels apart; every fifth stands out. */
function drawGrid(context: CanvasRenderingContext2D, camera: Camera, theme: Theme): void {
  const wanted = 30 / camera.scale;
  const power = 10 ** Math.floor(Math.log10(wanted));
  const step = power * ([1, 2, 5, 10].find((factor) => factor * power >= wanted) ?? 10);
  const { x0, x1, y0, y1 } = camera.visible;
  for (const strong of [false, true]) {
    context.beginPath();
    for (let i = Math.ceil(x0 / step); i * step <= x1; i++) {
      if ((i % 5 === 0) !== strong) continue;
      const x = Math.round(camera.toScreen(i * step, 0)[0]) + 0.5;
      context.moveTo(x, 0);
      context.lineTo(x, camera.height);
    }
    for (let i = Math.ceil(y0 / step); i * step <= y1; i++) {
      if ((i % 5 === 0) !== strong) continue;
      const y = Math.round(camera.toScreen(0, i * step)[1]) + 0.5;
      context.moveTo(0, y);
      context.lineTo(camera.width, y);
    }
    context.lineWidth = 1;
    context.strokeStyle = strong ? theme.gridStrong : theme.grid;
    context.stroke();
  }
}

function drawTerrain(
  context: CanvasRenderingContext2D,
  camera: Camera,
  theme: Theme,
  placed: PlacedTerrain,
): void {
  const line = screenLine(camera, placed);
  if (line.length < 2) return;
  const bottom = camera.height + 4;
  const top = Math.min(...line.map(([, y]) => y));
  const trace = () => {
    context.beginPath();
    line.forEach(([x, y]) => context.lineTo(x, y));
  };
  trace();
  context.lineTo(line[line.length - 1][0], bottom);
  context.lineTo(line[0][0], bottom);
  context.closePath();
  const start = Math.max(0, Math.min(top, camera.height - 1));
  const ground = context.createLinearGradient(0, start, 0, Math.max(start + 1, camera.height));
  ground.addColorStop(0, theme.groundTop);
  ground.addColorStop(1, theme.groundBottom);
  context.fillStyle = ground;
  context.fill();
  trace();
  context.lineJoin = "round";
  context.lineWidth = 2.5;
  context.strokeStyle = theme.groundLine;
  context.stroke();
}

/** The part of a ground line that can be seen, one point beyond on either side. */
function screenLine(camera: Camera, { x, y, terrain }: PlacedTerrain): [number, number][] {
  const { x0, x1 } = camera.visible;
  if (terrain.kind === "flat") {
    const slope = terrain.slope ?? 0;
    return [x0 - 1, x1 + 1].map((at) => camera.toScreen(at, y + slope * (at - x)));
  }
  const line: [number, number][] = [];
  const count = vertexCount(terrain);
  for (let i = 0; i < count; i++) {
    const before = vertex(terrain, Math.max(0, i - 1))[0] + x;
    const after = vertex(terrain, Math.min(count - 1, i + 1))[0] + x;
    if (after < x0 || before > x1) continue;
    const [vertexX, vertexY] = vertex(terrain, i);
    line.push(camera.toScreen(x + vertexX, y + vertexY));
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
