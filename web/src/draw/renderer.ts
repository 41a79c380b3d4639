/** The interface of both renderers of bodies, WebGL2 and Canvas 2D. */
import type { Shapes } from "../scene/frame";
import type { Camera, Pane } from "./camera";
import type { Rgb } from "./palette";
import type { Poses } from "./poses";

/**
 * How bodies are drawn: "state" and "plain" are filled, in one of the two sets of colours of
 * setColours; "outline" draws only the outlines of bodies that are not static.
 */
export type Look = { kind: "state" } | { kind: "plain" } | { kind: "outline"; colour: Rgb };

/** Width of an outline: its share of a body's half width, and its bounds in CSS pixels. Chosen. */
export const OUTLINE = { part: 0.2, least: 0.8, most: 1.75 } as const;

/** Attributes of a WebGL2 context of the bodies' canvas. */
export const WEBGL: WebGLContextAttributes = { alpha: true, antialias: false, depth: false };

export interface Renderer {
  readonly name: "webgl2" | "canvas2d";
  readonly canvas: HTMLCanvasElement;
  resize(width: number, height: number, ratio: number): void;
  setShapes(shapes: Shapes): void;
  /**
   * Colours of rows, from rowColours: `state` shows the state of thud's bodies (sleep); `plain`
   * does not.
   */
  setColours(state: Uint8Array, plain: Uint8Array): void;
  /** To be called before the first `draw` of a picture. */
  clear(): void;
  draw(poses: Poses, camera: Camera, pane: Pane, look: Look): void;
}
