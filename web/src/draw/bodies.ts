/**
 * Draws the bodies, by WebGL2 where it is available and by Canvas 2D otherwise. While a WebGL
 * context is lost, a second canvas with a 2D context takes the place of the first one in the page,
 * because a canvas can never have two kinds of context. When the context is restored, the first
 * canvas comes back.
 */
import type { Shapes } from "../scene/frame";
import { type Colouring, rowColours } from "./row-colours";
import { type Renderer, WEBGL } from "./renderer";

/** Called when another renderer has taken over. Its canvas has to be sized again. */
export type RendererChange = (name: Renderer["name"]) => void;

// A browser needs one of the two renderers, and loads that alone.

async function webglRenderer(canvas: HTMLCanvasElement): Promise<Renderer | null> {
  return (await import("./webgl")).WebglRenderer.create(canvas);
}

async function canvasRenderer(canvas: HTMLCanvasElement): Promise<Renderer | null> {
  return (await import("./canvas2d")).CanvasRenderer.create(canvas);
}

/** The renderer that this browser has for a canvas, and that the page's address asks for. */
export async function createRenderer(canvas: HTMLCanvasElement): Promise<Renderer> {
  const wanted = new URLSearchParams(location.search).get("renderer");
  const hasWebgl = wanted !== "canvas2d" && canvas.getContext("webgl2", WEBGL) !== null;
  const renderer = (hasWebgl && (await webglRenderer(canvas))) || (await canvasRenderer(canvas));
  if (!renderer) throw new Error("this browser can draw on no canvas");
  canvas.dataset.renderer = renderer.name;
  return renderer;
}

/** The bodies' canvas, with whichever renderer draws on it. */
export class Bodies {
  #renderer: Renderer;
  #shapes: Shapes | null = null;
  #colouring: Colouring | null = null;
  readonly #changed: RendererChange;

  /** `renderer` is that of createRenderer. */
  constructor(renderer: Renderer, changed: RendererChange) {
    this.#changed = changed;
    this.#renderer = renderer;
    if (renderer.name === "webgl2") this.#watch(renderer.canvas);
  }

  get renderer(): Renderer {
    return this.#renderer;
  }

  setShapes(shapes: Shapes): void {
    this.#shapes = shapes;
    this.#renderer.setShapes(shapes);
  }

  setColours(colouring: Colouring): void {
    this.#colouring = colouring;
    if (!this.#shapes) return;
    const plain = rowColours(this.#shapes, { theme: colouring.theme, awake: null });
    const state = colouring.awake ? rowColours(this.#shapes, colouring) : plain;
    this.#renderer.setColours(state, plain);
  }

  /** Changes the renderer when the WebGL context is lost or restored. */
  #watch(canvas: HTMLCanvasElement): void {
    let lost = false;
    canvas.addEventListener("webglcontextlost", (event) => {
      // Without this the browser would never restore the context.
      event.preventDefault();
      lost = true;
      void canvasRenderer(canvas.cloneNode() as HTMLCanvasElement).then((spare) => {
        if (lost) this.#take(spare);
      });
    });
    canvas.addEventListener("webglcontextrestored", () => {
      lost = false;
      void webglRenderer(canvas).then((renderer) => this.#take(renderer));
    });
  }

  /** Puts a renderer and its canvas in place of the present ones. */
  #take(renderer: Renderer | null): void {
    if (!renderer) return;
    this.#renderer.canvas.replaceWith(renderer.canvas);
    renderer.canvas.dataset.renderer = renderer.name;
    this.#renderer = renderer;
    if (this.#shapes) renderer.setShapes(this.#shapes);
    if (this.#colouring) this.setColours(this.#colouring);
    this.#changed(renderer.name);
  }
}
