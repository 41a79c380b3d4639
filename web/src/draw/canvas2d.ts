/**
 * Draws the bodies by Canvas 2D, where WebGL2 is not available. Rows of similar colour share a
 * path.
 */
import type { Shapes } from "../scene/frame";
import {
  BODY,
  CIRCLE,
  DYNAMIC,
  HALF,
  OFFSET,
  ROW,
  SHAPE,
  SLOT,
  STATIC,
  TURN,
} from "../scene/shape-table";
import type { Camera, Pane } from "./camera";
import { cssColour, mix, type Rgb } from "./palette";
import { CONTOURS } from "./paths";
import { poseBetween, type Poses } from "./poses";
import { type Look, OUTLINE, type Renderer } from "./renderer";

/** Step to which colour channels (of 255) are rounded to group rows. Chosen. */
const STEP = 24;
/**
 * Bounds on half widths in device pixels: a smaller body is drawn as an upright square; where the
 * typical body is smaller, bodies get no rim; a smaller circle gets no bead. (The bead is a dot
 * near the rim that shows how the circle is turned.)
 */
const LEAST_SHAPE = 2;
const LEAST_RIM = 2.5;
const LEAST_BEAD = 5;

/** Rows that are drawn in one colour, with CSS colours of their fill, rim and bead. */
interface Batch {
  fill: string;
  rim: string;
  /**
   * Colour of the dot that shows how a round body turns; null where the bodies are not dynamic,
   * which have no dots.
   */
  bead: string | null;
  rows: number[];
}

export class CanvasRenderer implements Renderer {
  readonly name = "canvas2d";
  readonly canvas: HTMLCanvasElement;
  readonly #context: CanvasRenderingContext2D;
  #ratio = 1;
  #shapes: Shapes | null = null;
  #batches: Record<"state" | "plain", Batch[]> = { state: [], plain: [] };
  /** Rows of shapes whose bodies are not static. */
  #movingRows: number[] = [];

  static create(canvas: HTMLCanvasElement): CanvasRenderer | null {
    const context = canvas.getContext("2d");
    return context && new CanvasRenderer(canvas, context);
  }

  private constructor(canvas: HTMLCanvasElement, context: CanvasRenderingContext2D) {
    this.canvas = canvas;
    this.#context = context;
  }

  resize(width: number, height: number, ratio: number): void {
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    this.#ratio = ratio;
  }

  setShapes(shapes: Shapes): void {
    this.#shapes = shapes;
    this.#movingRows = [];
    for (let row = 0; row < shapes.all; row++)
      if (shapes.rows[row * ROW + BODY] !== STATIC) this.#movingRows.push(row);
  }

  setColours(state: Uint8Array, plain: Uint8Array): void {
    if (!this.#shapes) return;
    const { count, all } = this.#shapes;
    this.#batches = {
      state: sort(this.#shapes, count, state),
      plain: sort(this.#shapes, all, plain),
    };
  }

  clear(): void {
    this.#context.setTransform(1, 0, 0, 1, 0, 0);
    this.#context.clearRect(0, 0, this.canvas.width, this.canvas.height);
  }

  draw(poses: Poses, camera: Camera, pane: Pane, look: Look): void {
    const shapes = this.#shapes;
    if (!shapes) return;
    const context = this.#context;
    const ratio = this.#ratio;
    const pixels = camera.scale * ratio;
    context.save();
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.beginPath();
    context.rect(pane.left, pane.top, pane.width, pane.height);
    context.clip();
    context.setTransform(1, 0, 0, 1, pane.middleX * ratio, pane.middleY * ratio);
    if (look.kind === "outline") {
      context.fillStyle = cssColour(look.colour);
      context.strokeStyle = cssColour(look.colour);
      const wanted = OUTLINE.part * shapes.typicalSize * camera.scale;
      context.lineWidth = ratio * Math.min(OUTLINE.most, Math.max(OUTLINE.least, wanted));
      this.#trace(this.#movingRows, shapes, poses, pixels, () => context.stroke());
    } else {
      context.lineWidth = ratio;
      for (const batch of this.#batches[look.kind]) this.#fill(batch, shapes, poses, pixels);
    }
    context.restore();
  }

  /** Draws the rows of a batch: fill, rim and beads. */
  #fill(batch: Batch, shapes: Shapes, poses: Poses, pixels: number): void {
    const context = this.#context;
    const rims = pixels * (shapes.typicalSize || 1) > LEAST_RIM;
    context.fillStyle = batch.fill;
    context.strokeStyle = batch.rim;
    const beads = this.#trace(batch.rows, shapes, poses, pixels, () => {
      context.fill();
      if (rims) context.stroke();
    });
    if (batch.bead === null || beads.length === 0) return;
    context.fillStyle = batch.bead;
    for (let i = 0; i < beads.length; i += 3) {
      const [x, y, radius] = [beads[i], beads[i + 1], beads[i + 2]];
      context.beginPath();
      context.arc(x, y, radius, 0, 2 * Math.PI);
      context.fill();
    }
  }

  /**
   * Adds the outlines of rows to the current path, and calls `finish` whenever the path has
   * CONTOURS of them, and at the end. The smallest bodies are filled at once. `pixels`: device
   * pixels per world unit. Returns x, y and radius of the circles' beads.
   */
  #trace(
    rows: readonly number[],
    shapes: Shapes,
    poses: Poses,
    pixels: number,
    finish: () => void,
  ): number[] {
    const context = this.#context;
    const data = shapes.rows;
    const { width, height } = this.canvas;
    const pose = new Float64Array(4);
    const beads: number[] = [];
    let contours = 0;
    context.beginPath();
    for (const row of rows) {
      const at = row * ROW;
      if (!poseBetween(poses, data[at + SLOT], pose)) continue;
      const c = pose[2];
      const s = pose[3];
      const x = (pose[0] + c * data[at + OFFSET] - s * data[at + OFFSET + 1]) * pixels;
      const y = -(pose[1] + s * data[at + OFFSET] + c * data[at + OFFSET + 1]) * pixels;
      const hx = Math.max(0.6, data[at + HALF] * pixels);
      const hy = Math.max(0.6, data[at + HALF + 1] * pixels);
      const reach = hx + hy;
      if (!(Math.abs(x) < width + reach && Math.abs(y) < height + reach)) continue;
      if (hx < LEAST_SHAPE && hy < LEAST_SHAPE) {
        context.fillRect(x - hx, y - hx, 2 * hx, 2 * hx);
        continue;
      }
      if (data[at + SHAPE] === CIRCLE) {
        context.moveTo(x + hx, y);
        // Counter-clockwise, like the boxes: fill would leave out overlaps of opposite directions.
        context.arc(x, y, hx, 0, 2 * Math.PI, true);
        if (hx > LEAST_BEAD) beads.push(x + 0.58 * hx * c, y - 0.58 * hx * s, 0.15 * hx);
      } else {
        const cosine = c * data[at + TURN] - s * data[at + TURN + 1];
        const sine = s * data[at + TURN] + c * data[at + TURN + 1];
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
      if (++contours % CONTOURS !== 0) continue;
      finish();
      context.beginPath();
    }
    finish();
    return beads;
  }
}

/** Groups rows of nearly the same colour, dynamic bodies apart from others. */
function sort(shapes: Shapes, count: number, colours: Uint8Array): Batch[] {
  const batches = new Map<number, Batch>();
  for (let row = 0; row < count; row++) {
    const free = shapes.rows[row * ROW + BODY] === DYNAMIC;
    let key = free ? 1 : 0;
    for (let i = 4 * row; i < 4 * row + 3; i++) key = 16 * key + Math.round(colours[i] / STEP);
    key = 256 * key + colours[4 * row + 3];
    let batch = batches.get(key);
    if (!batch) {
      batch = newBatch(colours.subarray(4 * row, 4 * row + 4), free);
      batches.set(key, batch);
    }
    batch.rows.push(row);
  }
  return [...batches.values()];
}

function newBatch([red, green, blue, opacity]: Uint8Array, free: boolean): Batch {
  const colour: Rgb = [red, green, blue];
  return {
    fill: cssColour(colour, 1, opacity / 255),
    rim: cssColour(colour, free ? 0.64 : 0.85),
    bead: free ? cssColour(mix(colour, [255, 255, 255], 0.65)) : null,
    rows: [],
  };
}
