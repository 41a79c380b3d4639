/** What both ways of drawing bodies, WebGL2 and Canvas 2D, have in common. */
import type { Shapes } from "../scene/frame";
import type { Camera, Pane } from "./camera";
import type { Rgb } from "./palette";
import type { Poses } from "./poses";

/** Filled, with or without what is known of thud's bodies (who sleeps), or an outline only. */
export type Look = { kind: "state" } | { kind: "plain" } | { kind: "outline"; colour: Rgb };

/** How wide an outline is: its part of a body's half width, and its bounds in CSS pixels. */
export const OUTLINE = { part: 0.2, least: 0.8, most: 1.75 } as const;

export interface Renderer {
  readonly name: "webgl2" | "canvas2d";
  readonly canvas: HTMLCanvasElement;
  resize(width: number, height: number, ratio: number): void;
  setShapes(shapes: Shapes): void;
  /** As rowColours gives them: of thud's bodies as they are, and of any engine's. */
  setColours(state: Uint8Array, plain: Uint8Array): void;
  /** Before the first `draw` of a picture. */
  clear(): void;
  draw(poses: Poses, camera: Camera, pane: Pane, look: Look): void;
}
