/**
 * The canvas behind the bodies: sky, grid and ground. It is drawn again only when the view, the
 * theme or the ground has changed.
 */
import type { PlacedTerrain } from "../scene/frame";
import type { Camera, Pane } from "./camera";
import { Layer } from "./layer";
import type { Theme } from "./palette";
import { drawTerrain } from "./terrain";

/**
 * Thickness of the grass: its share of the typical body's half width, and its bounds in CSS pixels.
 * Chosen.
 */
const GRASS = { part: 0.35, least: 2.5, most: 9 };

export class Backdrop {
  readonly #layer: Layer;
  /** What the present picture was drawn for, as text; "" where it must be drawn again. */
  #drawn = "";
  #terrains: PlacedTerrain[] = [];

  constructor(canvas: HTMLCanvasElement) {
    this.#layer = new Layer(canvas);
  }

  resize(width: number, height: number, ratio: number): void {
    this.#layer.resize(width, height, ratio);
    this.#drawn = "";
  }

  setTerrains(terrains: PlacedTerrain[]): void {
    this.#terrains = terrains;
    this.#drawn = "";
  }

  /** `typicalSize` is that of Shapes. */
  draw(camera: Camera, theme: Theme, typicalSize: number): void {
    const { x, y, scale, panes } = camera;
    const view = JSON.stringify([x, y, scale, panes, theme.dark, typicalSize]);
    if (view === this.#drawn) return;
    this.#drawn = view;
    const wanted = GRASS.part * (typicalSize || 1) * scale;
    const grass = Math.min(GRASS.most, Math.max(GRASS.least, wanted));
    for (const pane of panes)
      this.#layer.inPane(pane, (context) => {
        drawSky(context, pane, theme);
        drawGrid(context, camera, pane, theme);
        for (const terrain of this.#terrains)
          drawTerrain(context, camera, pane, theme, terrain, grass);
      });
  }
}

function drawSky(context: CanvasRenderingContext2D, pane: Pane, theme: Theme): void {
  const sky = context.createLinearGradient(0, pane.top, 0, pane.top + pane.height);
  sky.addColorStop(0, theme.skyTop);
  sky.addColorStop(1, theme.skyBottom);
  context.fillStyle = sky;
  context.fillRect(pane.left, pane.top, pane.width, pane.height);
}

/**
 * Lines every 1, 2 or 5 times a power of ten, in world units: the smallest of these that is at
 * least 30 CSS pixels. Every fifth line is stronger.
 */
function drawGrid(
  context: CanvasRenderingContext2D,
  camera: Camera,
  pane: Pane,
  theme: Theme,
): void {
  const wanted = 30 / camera.scale;
  const power = 10 ** Math.floor(Math.log10(wanted));
  const step = power * ([1, 2, 5, 10].find((factor) => factor * power >= wanted) ?? 10);
  const { x0, x1, y0, y1 } = camera.visibleIn(pane);
  for (const strong of [false, true]) {
    context.beginPath();
    for (let i = Math.ceil(x0 / step); i * step <= x1; i++) {
      if ((i % 5 === 0) !== strong) continue;
      const x = Math.round(camera.toScreen(i * step, 0, pane)[0]) + 0.5;
      context.moveTo(x, pane.top);
      context.lineTo(x, pane.top + pane.height);
    }
    for (let i = Math.ceil(y0 / step); i * step <= y1; i++) {
      if ((i % 5 === 0) !== strong) continue;
      const y = Math.round(camera.toScreen(0, i * step, pane)[1]) + 0.5;
      context.moveTo(pane.left, y);
      context.lineTo(pane.left + pane.width, y);
    }
    context.lineWidth = 1;
    context.strokeStyle = strong ? theme.gridStrong : theme.grid;
    context.stroke();
  }
}
