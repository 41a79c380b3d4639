/**
 * Draws the bodies, by WebGL2 where it is available and by Canvas 2D otherwise. While a WebGL
 * context is lost, a second canvas with a 2D context takes the place of the first one in the page,
 * because a canvas can never have two kinds of context. When the context is restored, the first
 * canvas comes back.
 */
import type { Shapes } from "../scene/frame";
import { CanvasRenderer } from "./canvas2d";
import { type Colouring, rowColours } from "./row-colours";
import type { Renderer } from "./renderer";
import { WebglRenderer } from "./webgl";

/** Called when another renderer has taken over. Its canvas has to be sized again. */
export type RendererChange = (name: Renderer["name"]) => void;

/** The bodies' canvas, with whichever renderer draws on it. */
export class Bodies {
  #renderer: Renderer;
  #shapes: Shapes | null = null;
  #colouring: Colouring | null = null;
  readonly #changed: RendererChange;

  constructor(canvas: HTMLCanvasElement, changed: RendererChange) {
    this.#changed = changed;
    const wanted = new URLSearchParams(location.search).get("renderer");
    const webgl = wanted === "canvas2d" ? null : WebglRenderer.create(canvas);
    const renderer = webgl ?? CanvasRenderer.create(canvas);
    if (!renderer) throw new Error("this browser can draw on no canvas");
    this.#renderer = renderer;
    canvas.dataset.renderer = renderer.name;
    if (webgl) this.#watch(canvas);
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
    canvas.addEventListener("webglcontextlost", (event) => {
      // Without this the browser would never restore the context.
      event.preventDefault();
      const spare = canvas.cloneNode() as HTMLCanvasElement;
      this.#take(CanvasRenderer.create(spare));
    });
    canvas.addEventListener("webglcontextrestored", () => {
      this.#take(WebglRenderer.create(canvas));
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
