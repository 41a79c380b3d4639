/**
 * "thud/canvas": draws a world on a plain canvas. Paths are in the world's units, with y up or, if you choose so, down;
 * the view transforms them to pixels.
 */
import { trace } from "./draw/debug.js";
import { Drag, type DragOptions, partsOf } from "./draw/drag.js";
import { Sprites } from "./draw/sprites.js";
import type { BodyRef, Vec2 } from "./types.js";
import type { DrawOptions } from "./view-types.js";
import type { World } from "./world.js";

/** Paints a body in its own frame: its origin is at [0, 0], y is the world's, and lengths are, too. */
export type Paint = (context: CanvasRenderingContext2D) => void;
export { Drag, type DragOptions };

export interface ViewOptions {
  /** Pixels of the canvas for each length unit. Default 32. */
  scale?: number;
  /** The place of the world in the middle of the canvas. Default [0, 0]. */
  center?: Vec2;
  /** Whether the world's y axis points down on the canvas, for a world whose gravity is to +y. Default false. */
  yDown?: boolean;
}

/** What is painted of a world on a canvas. `scale` and `center` may be changed between two calls of `draw`. */
export class CanvasView {
  scale: number;
  center: Vec2;
  readonly context: CanvasRenderingContext2D;
  readonly canvas: HTMLCanvasElement;
  readonly #world: World;
  readonly #sprites: Sprites<Paint>;
  /** The direction of the world's y axis on the canvas: -1 upwards, 1 downwards. */
  readonly #down: number;

  /** Takes the canvas's context "2d"; its width and height may change at any time. */
  constructor(world: World, canvas: HTMLCanvasElement, { scale = 32, center = [0, 0], yDown = false }: ViewOptions = {}) {
    this.#down = yDown ? 1 : -1;
    const context = canvas.getContext("2d")!;
    [this.#world, this.canvas, this.context, this.scale, this.center] = [world, canvas, context, scale, center];
    this.#sprites = new Sprites<Paint>(world, (paint, x, y, cosine, sine) => {
      context.save();
      context.transform(cosine, sine, -sine, cosine, x, y);
      paint(context);
      context.restore();
    });
  }

  /**
   * Paints a body in every `draw` from now on, above those of earlier calls, until it is destroyed.
   * @throws {ThudError} "stale" for a body that does not exist.
   */
  add(body: BodyRef, paint: Paint): void {
    this.#sprites.add(body, paint);
  }

  /** Clears the canvas and paints all bodies at their poses; `alpha`: what `World.advance` returned. */
  draw(alpha: number): void {
    const { context, canvas } = this;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, canvas.width, canvas.height);
    this.#onto(() => this.#sprites.update(alpha, this.center));
  }

  /** Draws what the engine sees, above what is drawn: `view.debug({ shapes: true, contacts: true })`. */
  debug(flags: Omit<DrawOptions, "origin" | "lower" | "upper">): void {
    const { context, center, canvas, scale } = this;
    const [w, h] = [canvas.width / 2 / scale, canvas.height / 2 / scale];
    const [lower, upper] = [-1, 1].map((side): Vec2 => [center[0] + side * w, center[1] + side * h]);
    this.#onto(() => {
      context.lineWidth = 1.5 / scale;
      trace(this.#world, { ...flags, origin: center, lower, upper }, 3 / scale, (points, closed, colour) => {
        context.strokeStyle = `#${colour.toString(16).padStart(6, "0")}`;
        context.beginPath();
        for (let i = 0; i < points.length; i += 2) context.lineTo(points[i], points[i + 1]);
        if (closed) context.closePath();
        context.stroke();
      });
    });
  }

  /** The place in the world of a pointer. */
  placeOf(pointer: { clientX: number; clientY: number }): Vec2 {
    const { canvas, center, scale } = this;
    const [right, down] = partsOf(canvas, pointer);
    const [x, y] = [(right - 0.5) * canvas.width, this.#down * (down - 0.5) * canvas.height];
    return [center[0] + x / scale, center[1] + y / scale];
  }

  /** Lets pointers drag dynamic bodies from now on, until `end` of what is returned. */
  drag(options: DragOptions = {}): Drag {
    return new Drag(this.#world, this.canvas, (event) => this.placeOf(event), options);
  }

  /** Draws with the canvas's transform to lengths relative to the view's centre. */
  #onto(draw: () => void): void {
    const { context, canvas, scale } = this;
    context.save();
    context.setTransform(scale, 0, 0, this.#down * scale, canvas.width / 2, canvas.height / 2);
    draw();
    context.restore();
  }
}
