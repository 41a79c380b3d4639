/** A canvas with a 2D context. */
import type { Pane } from "./camera";

export class Layer {
  readonly context: CanvasRenderingContext2D;
  #ratio = 1;

  constructor(canvas: HTMLCanvasElement) {
    const context = canvas.getContext("2d");
    if (!context) throw new Error("this browser can draw on no canvas");
    this.context = context;
  }

  /** Sets the size in CSS pixels. `ratio` is the number of device pixels per CSS pixel. */
  resize(width: number, height: number, ratio: number): void {
    this.context.canvas.width = Math.round(width * ratio);
    this.context.canvas.height = Math.round(height * ratio);
    this.#ratio = ratio;
  }

  clear(): void {
    this.context.setTransform(1, 0, 0, 1, 0, 0);
    this.context.clearRect(0, 0, this.context.canvas.width, this.context.canvas.height);
  }

  /** Calls `paint` with a context in CSS pixels that is clipped to the pane. */
  inPane(pane: Pane, paint: (context: CanvasRenderingContext2D) => void): void {
    const { context } = this;
    context.save();
    context.setTransform(this.#ratio, 0, 0, this.#ratio, 0, 0);
    context.beginPath();
    context.rect(pane.left, pane.top, pane.width, pane.height);
    context.clip();
    paint(context);
    context.restore();
  }
}
