/**
 * The outline of a shape in the map's pixels, and rotation by degrees. forms.ts has the operations.
 */
import type { ShapeOptions, Vec2 } from "../types.js";

/** The largest coordinate and size, pixels. Chosen. */
export const FAR = 1e9;
/** The largest rotation either way, degrees. Chosen. */
export const DEGREES = 1e6;
/** Radians of a degree. */
export const RADIANS = 0.017453292519943295;

/** A shape in pixels, y down. */
export interface Form {
  kind: "box" | "circle" | "line" | "polygon";
  /** The centre; of a line or polygon the origin of its points. */
  x: number;
  y: number;
  /** Half extents; of a circle the radius in both. */
  hx: number;
  hy: number;
  /** Degrees, clockwise, in [-180, 180). */
  rotation: number;
  /** The points of a line or polygon, relative to (x, y); null for other kinds. */
  points: Vec2[] | null;
  /**
   * Whether the line is the upper side of a polygon. It stands for the polygon only where all below
   * it is solid, since a terrain is solid below its line.
   */
  ground: boolean;
  /** The highest point of that polygon's lower side, pixels below y. */
  foot: number;
  material: ShapeOptions;
  /** Of a polygon: the greatest count of shapes that approximate it; 0: none do. */
  approximate: number;
}

/** A form of this kind; fields that are not given are 0, false, null or empty. */
export function form(kind: Form["kind"], more: Partial<Form> = {}): Form {
  const none = { x: 0, y: 0, hx: 0, hy: 0, rotation: 0, ground: false, foot: 0, approximate: 0 };
  return { kind, ...none, points: null, material: {}, ...more };
}

/**
 * Cosine and sine of a rotation in degrees, and `r`, the rotation in [-180, 180). By Taylor series
 * around the nearest quarter turn: the result has the same bits as that of level_turn in
 * demo/level/turn.c; Math.cos may differ between platforms.
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
