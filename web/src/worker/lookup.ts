/** Finds bodies and shapes of a world by its shape table. */
import type { BodyId, ShapeId, World } from "thud";
import { bodyAt, ROW, SHAPE, shapeAt, TERRAIN } from "../scene/shape-table";

/** The body in a slot that has shapes; null if there is none. */
export function bodyInSlot(world: World, slot: number): BodyId | null {
  const { count, handles } = world.shapeTable();
  for (let row = 0; row < count; row++) {
    const body = bodyAt(handles, row);
    if (body.index === slot) return body;
  }
  return null;
}

/** The shapes of the body in a slot; empty if the slot has none. */
export function shapesOf(world: World, slot: number): ShapeId[] {
  const { count, handles } = world.shapeTable();
  const shapes: ShapeId[] = [];
  for (let row = 0; row < count; row++)
    if (bodyAt(handles, row).index === slot) shapes.push(shapeAt(handles, row));
  return shapes;
}

/** Every terrain, and the body that it belongs to. */
export function groundLines(world: World): { shape: ShapeId; body: BodyId }[] {
  const { count, rows, handles } = world.shapeTable();
  const found: { shape: ShapeId; body: BodyId }[] = [];
  for (let row = 0; row < count; row++)
    if (rows[row * ROW + SHAPE] === TERRAIN)
      found.push({ shape: shapeAt(handles, row), body: bodyAt(handles, row) });
  return found;
}
