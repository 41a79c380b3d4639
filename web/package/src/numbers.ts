/** How options become the numbers that the module takes, and numbers from it become handles. */
import { ThudError } from "./error.js";
import type { QueryFilter, SolidShape } from "./query-types.js";
import {
  type BodyId,
  type Detection,
  DETECTIONS,
  QUALITIES,
  type Quality,
  type QualityOptions,
  SHAPE_KINDS,
  type ShapeId,
} from "./types.js";

export function detectionIndex(detection: Detection | undefined): number | undefined {
  return detection && indexOf(DETECTIONS, detection, "detection");
}

/** A quality's own numbers where it is no more than a name, and what an object changes of them. */
export function qualityNumbers(quality: Quality | QualityOptions) {
  const options: QualityOptions = typeof quality === "string" ? { base: quality } : quality;
  const { base = "default", substeps, contactStiffness, contactDamping, islands } = options;
  return {
    base: indexOf(QUALITIES, base, "quality"),
    substeps,
    contactStiffness,
    contactDamping,
    detection: detectionIndex(options.detection),
    islands: islands === undefined ? undefined : Number(islands),
  };
}

export function bodyId(index1: number, generation: number): BodyId {
  return Object.freeze({ kind: "body", index: index1 - 1, generation });
}

export function shapeId(index1: number, generation: number): ShapeId {
  return Object.freeze({ kind: "shape", index: index1 - 1, generation });
}

/** Kind, half extents (a circle's radius is the first) and angle, as the module takes them. */
export type SolidNumbers = [kind: number, hx: number, hy: number, angle: number];

export function solidNumbers(shape: SolidShape): SolidNumbers {
  const kind = indexOf(SHAPE_KINDS, shape.kind, "shape kind");
  if (shape.kind === "circle") return [kind, shape.radius, 0, 0];
  return [kind, shape.halfWidth, shape.halfHeight, shape.kind === "obb" ? shape.angle : 0];
}

/** Overwrites the slots whose option is given. */
export function fill(slots: Float64Array, options: (number | boolean | undefined)[]): void {
  options.forEach((value, i) => {
    if (value !== undefined) slots[i] = Number(value);
  });
}

export function indexOf<T extends string>(names: readonly T[], name: T, what: string): number {
  const index = names.indexOf(name);
  if (index < 0)
    throw new ThudError("invalid", `${what} "${name}" is none of ${names.join(", ")}`);
  return index;
}

export function userData(value: number | undefined): number | undefined {
  if (value !== undefined && !(Number.isSafeInteger(value) && value >= 0))
    throw new ThudError("invalid", `userData must be a whole number from 0 to 2^53 - 1: ${value}`);
  return value;
}

export function filterNumbers(filter: QueryFilter): [number, number, number] {
  const { category = 0xffffffff, mask = 0xffffffff, sensors = false } = filter;
  return [category, mask, Number(sensors)];
}

interface ViewClass<T> {
  new (buffer: ArrayBuffer, address: number, length: number): T;
}

/** A view into memory; where there is nothing to see, its address may be anything. */
export function view<T>(
  View: ViewClass<T>,
  buffer: ArrayBuffer,
  address: number,
  length: number,
): T {
  return new View(buffer, length === 0 ? 0 : address, length);
}
