/**
 * The canvas of the bodies: WebGL2 where there, Canvas 2D otherwise. While a WebGL context is lost
 * a canvas with Canvas 2D takes the place of its own, because a canvas has one kind of context for
 * life; if the context comes back, so does its canvas.
 */
import type { Shapes } from "../scene/frame";
import { CanvasRenderer } from "./canvas2d";
import { type Colouring, rowColours } from "./row-colours";
import type { Renderer } from "./renderer";
import { WebglRenderer } from "./webgl";

/** Told when another renderer has taken over; its canvas and size must be set up again. */
export type RendererChange = (name: Renderer["name"]) => void;

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

  #watch(canvas: HTMLCanvasElement): void {
    canvas.addEventListener("webglcontextlost", (event) => {
      // Without this the browser would not bring it back.
      event.preventDefault();
      const spare = canvas.cloneNode() as HTMLCanvasElement;
      this.#take(CanvasRenderer.create(spare));
    });
    canvas.addEventListener("webglcontextrestored", () => {
      this.#take(WebglRenderer.create(canvas));
    });
  }

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
