/**
 * What the worker sends to the page to draw: a message with copies of the world's data, whose
 * arrays are transferred. The page interpolates between `before` and `now`, so that motion looks
 * smooth at any rate of the display and of the steps.
 */
import type { Stats, StepError, Terrain, Vec2 } from "thud";
import type { Settings } from "./controls";
import type { Gaps } from "./joint-rows";
import type { Paint } from "./scene";

export interface Frame {
  /** The number of the scene's run. Frames of earlier runs are dropped. */
  run: number;
  step: number;
  /** The place in the world that poses are relative to. */
  origin: Vec2;
  /**
   * Poses before and after the last step. Four numbers per slot, as in World.poses: x, y, cosine,
   * sine; NaN in empty slots.
   */
  before: Float32Array;
  now: Float32Array;
  /** Present if shapes came, went or changed. */
  shapes?: Shapes;
  /** Present if terrain changed. */
  terrains?: PlacedTerrain[];
  /** For each row of the last `shapes`, 1 if its body is awake. Present every few steps. */
  awake?: Uint8Array;
  /** The engine's debug drawing, relative to `origin`, if an overlay needs it. */
  drawing?: Drawing;
  sums?: Sum[];
  /** Present if joints came, went or changed: JOINT numbers per joint, see joint-rows.ts. */
  joints?: Float32Array;
  /**
   * How far each of the last `joints` is open, and the force on it: BEARING numbers per joint.
   * Present if the overlay of joints is on.
   */
  bearings?: Float32Array;
  /** Present while there are joints. */
  gaps?: Gaps;
  /** From the place where the visitor holds a body to the pointer. */
  pull: readonly [Vec2, Vec2] | null;
  paint: Paint | null;
  /** The values of the scene's controls, if it has any. */
  settings?: Settings;
  stats: Stats;
  /**
   * The errors of the last step; the largest penetration is over all pairs, also of bodies that
   * sleep.
   */
  error: StepError;
  /** The steps made since the last frame. */
  samples: Sample[];
  /**
   * Milliseconds that the worker spent on those steps (with history and Box2D), and on this frame.
   */
  spent?: { steps: number; picture: number };
  /** The first and last step that the visitor can go to. */
  history: { first: number; last: number };
  /**
   * No step can be made after this one at present: a recording ends here, or a match waits for its
   * players or is over.
   */
  ended?: boolean;
  /** The calls that led to this step, of a recording of which they are listed. */
  calls?: Calls;
  /** The other engine's poses, laid out like `before` and `now`, while it runs. */
  box2d?: { before: Float32Array; now: Float32Array };
  /** Why the other engine does not run although the page wants it. */
  box2dTrouble?: string;
}

/** The calls of a step of a recording, without the step itself. */
export interface Calls {
  count: number;
  /** The first ones, as text. */
  lines: string[];
}

/** Time and error of one step, for plots. */
export interface Sample {
  step: number;
  /** Milliseconds of the step. The resolution of the clock may be as coarse as 0.1 ms. */
  milliseconds: number;
  /** The deepest overlap of awake bodies, a length. */
  penetration: number;
  /** Number of awake bodies. */
  awake: number;
  box2d?: Box2DSample;
}

/** The other engine's step of the same number. */
export interface Box2DSample {
  milliseconds: number;
  awake: number;
  /** The step at which it was started, as a copy of the world. */
  since: number;
  /** The place in the world of its own origin. */
  origin: Vec2;
  /**
   * What the thud world has and it is not given, in a few words each. If not empty, the engines
   * cannot be compared.
   */
  misses: readonly string[];
  /**
   * Both engines after this step, measured by the same code. Missing in some steps where measuring
   * takes long.
   */
  compared?: { thud: Compared; box2d: Compared };
}

export interface Compared {
  /** The deepest overlap, also of bodies that sleep. */
  penetration: number;
  /** Kinetic plus potential energy. */
  energy: number;
  /** Number of bodies with shapes. */
  bodies: number;
  /** The largest gap of a joint: a length, and an angle in radians. Missing without joints. */
  jointGap?: readonly [length: number, angle: number];
}

/** Copies of DrawLists. */
export interface Drawing {
  shapes: Float32Array;
  lines: Float32Array;
  points: Float32Array;
}

export interface PlacedTerrain {
  x: number;
  y: number;
  terrain: Terrain;
}

/** The circles and boxes of a world. */
export interface Shapes {
  /** Rows of the shape table, ROW numbers each; see shape-table.ts. */
  rows: Float32Array;
  /** Number of rows that the page draws. */
  count: number;
  /**
   * Number of all rows. Those after the first `count` are drawn by the scene itself (`hidden`), and
   * appear only in the other engine's picture.
   */
  all: number;
  /** One more than the largest slot. */
  slots: number;
  /** Number of dynamic bodies, and the index of each among them, by slot. */
  moving: number;
  order: Uint32Array;
  /** Half the width of a typical dynamic body (the median); 0 if there is none. */
  typicalSize: number;
}

/** A Minkowski sum of two shapes. Places are relative to `Frame.origin`. */
export interface Sum {
  /** The centre of the first shape, and that of the second. */
  origin: Vec2;
  point: Vec2;
  /** Whether the shapes overlap, that is, whether `point` is within the sum. */
  overlaps: boolean;
  /** The place on the edge of the sum that is nearest to `point`. */
  edge: Vec2;
  /** The sum's outline about the first shape's centre, counter-clockwise: x and y in turn. */
  outline: Float64Array;
}
