/** Bodies by Canvas 2D, where WebGL2 is missing: rows of one colour share one path. */
import type { Camera } from "../camera";
import { cssColour, type Rgb, type Theme } from "./palette";
import { type Renderer, rowColour } from "./renderer";
import { CIRCLE, ROW, type Shapes, STATIC } from "./shapes";

/** Colours are rounded to this many steps a channel, so that paths can be shared. */
const STEP = 24;

interface Batch {
  fill: string;
  rim: string;
  mark: string;
  rows: number[];
}

export class CanvasRenderer implements Renderer {
  readonly name = "canvas2d";
  readonly #context: CanvasRenderingContext2D;
  readonly #canvas: HTMLCanvasElement;
  #ratio = 1;
  #shapes: Shapes | null = null;
  #theme!: Theme;
  #awake = new Uint8Array(0);
  #batches: Batch[] = [];
  #stale = true;

  static create(canvas: HTMLCanvasElement): CanvasRenderer | null {
    const context = canvas.getContext("2d");
    return context && new CanvasRenderer(canvas, context);
  }

  private constructor(canvas: HTMLCanvasElement, context: CanvasRenderingContext2D) {
    this.#canvas = canvas;
    this.#context = context;
  }

  resize(width: number, height: number, ratio: number): void {
    this.#canvas.width = Math.round(width * ratio);
    this.#canvas.height = Math.round(height * ratio);
    this.#ratio = ratio;
  }

  setShapes(shapes: Shapes, theme: Theme): void {
    this.#shapes = shapes;
    this.#theme = theme;
    this.#awake = new Uint8Array(shapes.count).fill(1);
    this.#stale = true;
  }

  setAwake(awake: Uint8Array): void {
    this.#awake = awake.slice();
    this.#stale = true;
  }

  draw(poses: Float32Array, camera: Camera): void {
    const context = this.#context;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, this.#canvas.width, this.#canvas.height);
    if (!this.#shapes) return;
    if (this.#stale) this.#sort(this.#shapes);
    const pixels = camera.scale * this.#ratio;
    context.setTransform(1, 0, 0, 1, camera.middleX * this.#ratio, camera.middleY * this.#ratio);
    context.lineWidth = Math.max(1, this.#ratio);
    for (const batch of this.#batches) {
      const marks = this.#trace(batch.rows, this.#shapes, poses, pixels);
      context.fillStyle = batch.fill;
      context.fill();
      if (pixels * (this.#shapes.typicalSize || 1) > 2.5) {
        context.strokeStyle = batch.rim;
        context.stroke();
      }
      if (marks) {
        context.fillStyle = batch.mark;
        context.fill(marks);
      }
    }
  }

  #sort(shapes: Shapes): void {
    const batches = new Map<string, Batch>();
    for (let i = 0; i < shapes.count; i++) {
      let colour = rowColour(shapes, i, this.#theme);
      const kind = shapes.rows[i * ROW + 2];
      if (this.#awake[i] === 0 && kind !== STATIC) colour = mix(colour, this.#theme.sleep, 0.55);
      const sensor = shapes.rows[i * ROW + 3] !== 0;
      const rounded = colour.map((value) => Math.round(value / STEP)).join() + sensor + kind;
      let batch = batches.get(rounded);
      if (!batch) {
        const fill = cssColour(colour);
        batch = {
          fill: sensor ? fill.replace(")", " / 0.28)") : fill,
          rim: cssColour(colour, kind === STATIC ? 0.84 : 0.66),
          mark: kind === STATIC ? "" : cssColour(mix(colour, [255, 255, 255], 0.6)),
          rows: [],
        };
        batches.set(rounded, batch);
      }
      batch.rows.push(i);
    }
    this.#batches = [...batches.values()];
    this.#stale = false;
  }

  /** Leaves the outlines as the current path; returns the beads that show how circles turn. */
  #trace(rows: number[], shapes: Shapes, poses: Float32Array, pixels: number): Path2D | null {
    const context = this.#context;
    const { rows: data } = shapes;
    const width = this.#canvas.width;
    const height = this.#canvas.height;
    let marks: Path2D | null = null;
    context.beginPath();
    for (const row of rows) {
      const at = row * ROW;
      const pose = 4 * data[at];
      const c = poses[pose + 2];
      const s = poses[pose + 3];
      const offsetX = data[at + 4];
      const offsetY = data[at + 5];
      const x = (poses[pose] + c * offsetX - s * offsetY) * pixels;
      const y = -(poses[pose + 1] + s * offsetX + c * offsetY) * pixels;
      const hx = data[at + 6] * pixels;
      const hy = data[at + 7] * pixels;
      const reach = hx + hy;
      if (!(Math.abs(x) < width + reach && Math.abs(y) < height + reach)) continue;
      if (data[at + 1] === CIRCLE) {
        context.moveTo(x + hx, y);
        context.arc(x, y, hx, 0, 2 * Math.PI);
        if (hx > 5 && data[at + 2] !== STATIC) {
          marks ??= new Path2D();
          const markX = x + 0.56 * hx * c;
          const markY = y - 0.56 * hx * s;
          marks.moveTo(markX + 0.17 * hx, markY);
          marks.arc(markX, markY, 0.17 * hx, 0, 2 * Math.PI);
        }
        continue;
      }
      const turnC = data[at + 8];
      const turnS = data[at + 9];
      const cosine = c * turnC - s * turnS;
      const sine = s * turnC + c * turnS;
      const ax = cosine * hx;
      const ay = -sine * hx;
      const bx = -sine * hy;
      const by = -cosine * hy;
      context.moveTo(x - ax - bx, y - ay - by);
      context.lineTo(x + ax - bx, y + ay - by);
      context.lineTo(x + ax + bx, y + ay + by);
      context.lineTo(x - ax + bx, y - ay + by);
      context.closePath();
    }
    return marks;
  }
}

function mix(a: Rgb, b: Rgb, t: number): Rgb {
  return [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t];
}
