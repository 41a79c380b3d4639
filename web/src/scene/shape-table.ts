/**
 * The layout of the package's ShapeTable: positions of the numbers in a row, and the handles beside
 * it.
 */
import { BODY_KINDS, type BodyId, SHAPE_KINDS, type ShapeId } from "thud";

/** Numbers per row. */
export const ROW = 10;
/**
 * Positions of the numbers in a row; of a pair, of its first number. OFFSET is the shape's place in
 * the body's frame, HALF its half extents, TURN its rotation in the body as cosine and sine.
 */
export const SLOT = 0;
export const SHAPE = 1;
export const BODY = 2;
export const SENSOR = 3;
export const OFFSET = 4;
export const HALF = 6;
export const TURN = 8;

/** Values at SHAPE. */
export const CIRCLE = SHAPE_KINDS.indexOf("circle");
export const TERRAIN = SHAPE_KINDS.indexOf("terrain");
/** Values at BODY. */
export const STATIC = BODY_KINDS.indexOf("static");
export const KINEMATIC = BODY_KINDS.indexOf("kinematic");
export const DYNAMIC = BODY_KINDS.indexOf("dynamic");

/**
 * The shape of a row. The table's handles have four numbers per row: index + 1 and generation of
 * the shape, then those of its body.
 */
export function shapeAt(handles: Uint32Array, row: number): ShapeId {
  return { kind: "shape", index: handles[4 * row] - 1, generation: handles[4 * row + 1] };
}

/** The body of a row. */
export function bodyAt(handles: Uint32Array, row: number): BodyId {
  return { kind: "body", index: handles[4 * row + 2] - 1, generation: handles[4 * row + 3] };
}
