/** Draws a simulation: three canvases on top of each other, for backdrop, bodies and overlay. */
import { Camera } from "./camera";
import { Backdrop } from "./render/backdrop";
import { CanvasRenderer } from "./render/canvas2d";
import { Overlay, type OverlayName } from "./render/overlay";
import { DARK, LIGHT, type Theme } from "./render/palette";
import type { Renderer } from "./render/renderer";
import type { PlacedTerrain, Shapes } from "./render/shapes";
import { WebglRenderer } from "./render/webgl";
import type { Simulation } from "./simulation";
import { readSums } from "./sums";

/** Sleeping bodies are looked for this often, in frames. */
const AWAKE_EVERY = 6;
/** More device pixels than this a CSS pixel cost time and show nothing. */
const MOST_PIXELS = 2;

export class View {
  readonly camera = new Camera();
  readonly shown = new Set<OverlayName>(["sleeping"]);
  readonly #backdrop: Backdrop;
  readonly #overlay: Overlay;
  #renderer: Renderer;
  #theme: Theme = DARK;
  #shapes: Shapes | null = null;
  #terrains: PlacedTerrain[] = [];
  #frame = 0;

  constructor(canvases: Record<"backdrop" | "bodies" | "overlay", HTMLCanvasElement>) {
    this.#backdrop = new Backdrop(context2d(canvases.backdrop));
    this.#overlay = new Overlay(context2d(canvases.overlay));
    this.#renderer = makeRenderer(canvases.bodies);
    canvases.bodies.dataset.renderer = this.#renderer.name;
    canvases.bodies.addEventListener("webglcontextlost", () => {
      // A canvas that had WebGL gives no other context: a new one takes its place.
      const fresh = canvases.bodies.cloneNode() as HTMLCanvasElement;
      canvases.bodies.replaceWith(fresh);
      const renderer = CanvasRenderer.create(fresh);
      if (renderer) this.#renderer = renderer;
      fresh.dataset.renderer = this.#renderer.name;
      this.#shapes = null;
      this.resize();
    });
  }

  setTheme(dark: boolean): void {
    this.#theme = dark ? DARK : LIGHT;
    this.#shapes = null;
  }

  resize(): void {
    const ratio = Math.min(MOST_PIXELS, devicePixelRatio);
    const { innerWidth: width, innerHeight: height } = window;
    this.camera.resize(width, height);
    for (const layer of [this.#backdrop, this.#renderer, this.#overlay])
      layer.resize(width, height, ratio);
  }

  draw(simulation: Simulation): void {
    const { camera } = this;
    const { world } = simulation;
    this.#frame++;
    if (this.#shapes !== simulation.shapes) {
      this.#shapes = simulation.shapes;
      this.#renderer.setShapes(this.#shapes, this.#theme);
      this.#frame = 0;
    }
    if (this.#terrains !== simulation.shapes.terrains) {
      this.#terrains = simulation.shapes.terrains;
      this.#backdrop.setTerrains(this.#terrains);
    }
    if (this.#frame % AWAKE_EVERY === 0) this.#updateAwake(simulation);
    this.#backdrop.draw(camera, this.#theme);
    this.#renderer.draw(world.poses(simulation.alpha, camera.x, camera.y), camera);
    this.#overlay.draw(
      world,
      camera,
      this.#theme,
      this.shown,
      simulation.pull,
      simulation.character,
      simulation.alpha,
      readSums(simulation, camera.x, camera.y),
    );
  }

  #updateAwake({ world, shapes }: Simulation): void {
    const awake = new Uint8Array(shapes.count).fill(1);
    if (this.shown.has("sleeping")) {
      const flags = world.shapeTableAwake();
      shapes.source.forEach((row, i) => (awake[i] = flags[row]));
    }
    this.#renderer.setAwake(awake);
  }
}

function makeRenderer(canvas: HTMLCanvasElement): Renderer {
  const wanted = new URLSearchParams(location.search).get("renderer");
  const renderer =
    (wanted === "canvas2d" ? null : WebglRenderer.create(canvas)) ?? CanvasRenderer.create(canvas);
  if (!renderer) throw new Error("this browser can draw on no canvas");
  return renderer;
}

function context2d(canvas: HTMLCanvasElement): CanvasRenderingContext2D {
  const context = canvas.getContext("2d");
  if (!context) throw new Error("this browser can draw on no canvas");
  return context;
}
