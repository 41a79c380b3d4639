/** The package's ShapeTable: where the numbers of a row stand, and the handles beside it. */
import { BODY_KINDS, type BodyId, SHAPE_KINDS, type ShapeId } from "thud";

/** Numbers a row. */
export const ROW = 10;
/** Where in a row they stand; of pairs the first. */
export const SLOT = 0;
export const SHAPE = 1;
export const BODY = 2;
export const SENSOR = 3;
export const OFFSET = 4;
export const HALF = 6;
export const TURN = 8;

/** What stands at SHAPE. */
export const CIRCLE = SHAPE_KINDS.indexOf("circle");
export const TERRAIN = SHAPE_KINDS.indexOf("terrain");
/** What stands at BODY. */
export const STATIC = BODY_KINDS.indexOf("static");
export const KINEMATIC = BODY_KINDS.indexOf("kinematic");
export const DYNAMIC = BODY_KINDS.indexOf("dynamic");

/** The shape of a row, by the table's handles: index + 1 and generation of it, and of its body. */
export function shapeAt(handles: Uint32Array, row: number): ShapeId {
  return { kind: "shape", index: handles[4 * row] - 1, generation: handles[4 * row + 1] };
}

export function bodyAt(handles: Uint32Array, row: number): BodyId {
  return { kind: "body", index: handles[4 * row + 2] - 1, generation: handles[4 * row + 3] };
}
