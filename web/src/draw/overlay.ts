/**
 * The canvas over the bodies: joints, the engine's debug drawing, Minkowski sums, the scene's
 * marks, the outline of a body that the panel Inside shows, the line of the visitor's pull, and the
 * engines' names.
 */
import type { Vec2 } from "thud";
import type { Frame, Shapes } from "../scene/frame";
import type { OverlayName } from "../scene/overlays";
import type { Mark } from "../scene/scene";
import { CIRCLE, HALF, OFFSET, ROW, SHAPE, SLOT, TURN } from "../scene/shape-table";
import type { Camera, Pane } from "./camera";
import type { Joints } from "./joints";
import type * as Late from "./late";
import { Layer } from "./layer";
import type { Theme } from "./palette";
import { poseBetween, type Poses } from "./poses";

/** Everything that is drawn in one picture. */
export interface OverlayPicture {
  frame: Frame;
  shapes: Shapes | null;
  poses: Poses;
  /** Poses of the other engine's bodies, if these have a pane of their own. */
  otherPoses: Poses | null;
  joints: Joints | null;
  bearings?: Float32Array;
  marks: readonly Mark[];
  /** The slot of a body that gets an outline. */
  held: number | null;
  split: "none" | "side" | "over";
}

/** Imported when there is first something that it draws. */
let late: typeof Late | null = null;

export class Overlay {
  readonly #layer: Layer;
  /** Whether the canvas is empty. */
  #clean = false;

  /** `redraw` is called when the same picture has to be drawn again, because `late` has arrived. */
  constructor(
    canvas: HTMLCanvasElement,
    private readonly redraw: () => void,
  ) {
    this.#layer = new Layer(canvas);
  }

  /** Imports `late.ts`, and then has the picture drawn again. */
  async #bringLate(): Promise<void> {
    try {
      late = await import("./late");
    } catch {
      // The page is being closed, or there is no network. The next picture tries again.
      return;
    }
    this.redraw();
  }

  resize(width: number, height: number, ratio: number): void {
    this.#layer.resize(width, height, ratio);
    this.#clean = true;
  }

  draw(
    picture: OverlayPicture,
    camera: Camera,
    theme: Theme,
    on: ReadonlySet<OverlayName>,
  ): void {
    const { frame, shapes, poses, otherPoses, joints, bearings, marks, held, split } = picture;
    const { drawing, sums, pull } = frame;
    const still = !drawing && !sums?.length && !pull && !joints;
    const empty = still && marks.length === 0 && held === null && split === "none";
    if (empty && this.#clean) return;
    this.#layer.clear();
    this.#clean = empty;
    if (empty) return;
    if (drawing || sums?.length || marks.length > 0 || split !== "none")
      if (!late) void this.#bringLate();
    const [pane, otherPane] = camera.panes;
    if (joints && otherPoses)
      this.#layer.inPane(otherPane, (context) =>
        joints.draw(context, camera, otherPane, theme.joints, otherPoses),
      );
    this.#layer.inPane(pane, (context) => {
      joints?.draw(context, camera, pane, theme.joints, poses, bearings);
      const [originX, originY] = camera.toScreen(...frame.origin, pane);
      context.translate(originX, originY);
      if (drawing) late?.drawLists(context, drawing, camera.scale, theme, on);
      if (sums) late?.drawSums(context, sums, camera.scale, theme);
      context.translate(-originX, -originY);
      late?.drawMarks(context, camera, pane, theme, marks);
      if (held !== null && shapes) drawHeld(context, camera, pane, theme, shapes, poses, held);
      if (pull) drawPull(context, camera, pane, theme, pull);
    });
    if (split !== "none") late?.drawLabels(this.#layer, camera, theme, split);
  }
}

/** The outline of all shapes of one body. */
function drawHeld(
  context: CanvasRenderingContext2D,
  camera: Camera,
  pane: Pane,
  theme: Theme,
  shapes: Shapes,
  poses: Poses,
  slot: number,
): void {
  const pose = new Float64Array(4);
  if (!poseBetween(poses, slot, pose)) return;
  const [x, y, c, s] = pose;
  const { scale } = camera;
  context.save();
  context.translate(pane.middleX + x * scale, pane.middleY - y * scale);
  context.transform(c, -s, s, c, 0, 0);
  context.beginPath();
  for (let row = 0; row < shapes.count; row++) {
    if (shapes.rows[row * ROW + SLOT] !== slot) continue;
    const numbers = shapes.rows.subarray(row * ROW, row * ROW + ROW);
    const [hx, hy] = [numbers[HALF] * scale, numbers[HALF + 1] * scale];
    context.save();
    context.translate(numbers[OFFSET] * scale, -numbers[OFFSET + 1] * scale);
    context.transform(numbers[TURN], -numbers[TURN + 1], numbers[TURN + 1], numbers[TURN], 0, 0);
    if (numbers[SHAPE] === CIRCLE) {
      context.moveTo(hx, 0);
      context.arc(0, 0, hx, 0, 2 * Math.PI);
    } else context.rect(-hx, -hy, 2 * hx, 2 * hy);
    context.restore();
  }
  context.lineJoin = "round";
  context.lineWidth = 5;
  context.strokeStyle = theme.halo;
  context.stroke();
  context.lineWidth = 2;
  context.strokeStyle = theme.inks.ink;
  context.stroke();
  context.restore();
}

/** The line from the place where the visitor holds a body to the pointer. */
function drawPull(
  context: CanvasRenderingContext2D,
  camera: Camera,
  pane: Pane,
  theme: Theme,
  [from, to]: readonly [Vec2, Vec2],
): void {
  const [x0, y0] = camera.toScreen(...from, pane);
  const [x1, y1] = camera.toScreen(...to, pane);
  context.lineCap = "round";
  context.beginPath();
  context.moveTo(x0, y0);
  context.lineTo(x1, y1);
  context.lineWidth = 5;
  context.strokeStyle = theme.halo;
  context.stroke();
  context.lineWidth = 2;
  context.strokeStyle = theme.inks.ink;
  context.stroke();
  context.fillStyle = theme.inks.ink;
  context.beginPath();
  context.arc(x0, y0, 4, 0, 2 * Math.PI);
  context.moveTo(x1 + 3, y1);
  context.arc(x1, y1, 3, 0, 2 * Math.PI);
  context.fill();
}
