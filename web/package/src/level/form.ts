/** One outline in pixels, and turning by degrees. What is done with outlines is in forms.ts. */
import type { ShapeOptions, Vec2 } from "../types.js";

/** Pixels beyond which a map is absurd. */
export const FAR = 1e9;
export const DEGREES = 1e6;
export const RADIANS = 0.017453292519943295;

/** One shape in pixels, y down. */
export interface Form {
  kind: "box" | "circle" | "line" | "polygon";
  /** Centre; of a line or polygon the place that its points start from. */
  x: number;
  y: number;
  /** Half extents; of a circle its radius, twice. */
  hx: number;
  hy: number;
  /** Degrees, clockwise, in [-180, 180). */
  rotation: number;
  /** Of a line or polygon. */
  points: Vec2[] | null;
  /** A line that was a polygon: stands for it only where all below it is solid. */
  ground: boolean;
  /** How far down that polygon reached, below y. */
  foot: number;
  material: ShapeOptions;
}

export function form(kind: Form["kind"], more: Partial<Form> = {}): Form {
  const none = { x: 0, y: 0, hx: 0, hy: 0, rotation: 0, ground: false, foot: 0 };
  return { kind, ...none, points: null, material: {}, ...more };
}

/**
 * Cosine and sine of a rotation in degrees by Taylor series on the nearest quarter turn: the same
 * bits as level_turn in demo/level/turn.c, which Math.cos does not promise.
 */
export function turn(degrees: number): { r: number; c: number; s: number } {
  const r = degrees - 360 * Math.floor(degrees / 360 + 0.5);
  const q = Math.floor(r / 90 + 0.5);
  const a = (r - 90 * q) * RADIANS;
  const z = a * a;
  const series = (divisors: number[]) => divisors.reduceRight((sum, d) => 1 / d + z * sum, 0);
  const sine = a * series([1, -6, 120, -5040, 362880, -39916800, 6227020800, -1307674368000]);
  const cosine = series([1, -2, 24, -720, 40320, -3628800, 479001600, -87178291200]);
  if (q === 0) return { r, c: cosine, s: sine };
  if (q === 1) return { r, c: -sine, s: cosine };
  if (q === -1) return { r, c: sine, s: -cosine };
  return { r, c: -cosine, s: -sine };
}
