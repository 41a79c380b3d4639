/** What both ways of drawing bodies, WebGL2 and Canvas 2D, have in common. */
import type { Camera } from "../camera";
import { rampColour, type Rgb, type Theme } from "./palette";
import { ROW, type Shapes, STATIC } from "./shapes";

export interface Renderer {
  readonly name: "webgl2" | "canvas2d";
  resize(width: number, height: number, ratio: number): void;
  /** After shapes came or went, or the theme changed. */
  setShapes(shapes: Shapes, theme: Theme): void;
  /** For each row 1 if it is awake. */
  setAwake(awake: Uint8Array): void;
  /** Poses are relative to the camera's middle. */
  draw(poses: Float32Array, camera: Camera): void;
}

/** Moving bodies run through the ramp in the order of their creation, so that mixing shows. */
export function rowColour(shapes: Shapes, row: number, theme: Theme): Rgb {
  const at = row * ROW;
  const [slot, , bodyKind, sensor] = shapes.rows.subarray(at, at + 4);
  if (sensor !== 0) return theme.sensor;
  if (bodyKind === STATIC) return theme.fixed;
  if (bodyKind === 1) return theme.kinematic;
  return rampColour(theme, rampPlace(shapes.order[slot], shapes.moving));
}

/** A little jitter keeps neighbours apart. */
function rampPlace(order: number, moving: number): number {
  const jitter = ((order * 0.618034) % 1) - 0.5;
  const spread = moving > 40 ? 0.07 : 0.12;
  return (order + 0.5) / Math.max(1, moving) + spread * jitter;
}
