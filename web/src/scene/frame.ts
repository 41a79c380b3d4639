/**
 * What the worker sends the page to draw: one message, arrays transferred, nothing of the world
 * itself. The page draws between `before` and `now`, so that the picture is as smooth as the
 * display, whatever the step is.
 */
import type { Stats, StepError, Terrain, Vec2 } from "thud";
import type { Settings } from "./controls";
import type { Gaps } from "./joint-rows";
import type { Paint } from "./scene";

export interface Frame {
  /** Counts the scenes run: a frame of an earlier one is dropped. */
  run: number;
  step: number;
  /** Poses are relative to it. */
  origin: Vec2;
  /** Four numbers a slot, as World.poses gives them: x, y, cosine, sine; NaN in empty slots. */
  before: Float32Array;
  now: Float32Array;
  /** When shapes came or went. */
  shapes?: Shapes;
  /** When the ground changed. */
  terrains?: PlacedTerrain[];
  /** For each row of the last shapes 1 if it is awake; now and then. */
  awake?: Uint8Array;
  /** The engine's debug drawing, relative to `origin`, when asked for. */
  drawing?: Drawing;
  sums?: Sum[];
  /** When joints came, went or were set: JOINT numbers each, as joint-rows.ts has them. */
  joints?: Float32Array;
  /** Of each of the last joints how far it is open and what it bears, BEARING numbers; if asked for. */
  bearings?: Float32Array;
  /** While there are joints. */
  gaps?: Gaps;
  /** The line from a held body to the pointer. */
  pull: readonly [Vec2, Vec2] | null;
  paint: Paint | null;
  /** Of the scene's controls, if it has some. */
  settings?: Settings;
  stats: Stats;
  /** Its largest penetration is of all pairs, asleep or not. */
  error: StepError;
  /** Of the steps made since the last frame. */
  samples: Sample[];
  /** Milliseconds of the worker: for those steps, with all that goes along, and for this frame. */
  spent?: { steps: number; picture: number };
  /** Steps that the visitor can go back to. */
  history: { first: number; last: number };
  /** The other engine's bodies at the same moment, while there is one; laid out alike. */
  box2d?: { before: Float32Array; now: Float32Array };
  /** Why there is none although one was asked for. */
  box2dTrouble?: string;
}

/** What a step took and got wrong, for plots. */
export interface Sample {
  step: number;
  /** Of the step, from a clock that may be as coarse as 0.1 ms. */
  milliseconds: number;
  /** Of the pairs that are awake. */
  penetration: number;
  /** Bodies. */
  awake: number;
  box2d?: Box2DSample;
}

/** The other engine's same step. */
export interface Box2DSample {
  milliseconds: number;
  awake: number;
  /** The step at which it began, as a copy of the world at that moment. */
  since: number;
  /** Where in the world it has its own origin. */
  origin: Vec2;
  /** What thud's world has and it is not given, in a few words each: nothing is comparable then. */
  misses: readonly string[];
  /** Both engines after this step, by the same code; every few steps where that takes long. */
  compared?: { thud: Compared; box2d: Compared };
}

export interface Compared {
  /** Of the deepest overlap, sleeping bodies included. */
  penetration: number;
  /** Kinetic and potential. */
  energy: number;
  /** Those that have shapes. */
  bodies: number;
  /** Of the joint that is open the most: a length, and radians; where there are joints. */
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

/** Circles and boxes. */
export interface Shapes {
  /** As ShapeTable.rows of the package; see shape-table.ts. */
  rows: Float32Array;
  /** Rows that the page draws. */
  count: number;
  /** With those after them, which the scene paints itself: only another engine's picture has them. */
  all: number;
  /** The slot that ends the bodies. */
  slots: number;
  /** Dynamic bodies, and by slot the place of each among them. */
  moving: number;
  order: Uint32Array;
  /** Of a typical moving body: half its width; 0 where nothing moves. */
  typicalSize: number;
}

/** A Minkowski sum, relative to `Frame.origin`. */
export interface Sum {
  /** The first shape's centre, which the outline is about, and the second's. */
  origin: Vec2;
  point: Vec2;
  /** Whether the point is in the sum: the shapes overlap. */
  overlaps: boolean;
  /** The place on the edge of the sum that is nearest to the point. */
  edge: Vec2;
  /** Counter-clockwise, x and y in turn, about the first shape's centre. */
  outline: Float64Array;
}
