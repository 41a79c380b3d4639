/** What the world knows of one body, for the card of a body that the visitor points at. */
import type { BodyId, BodyState, ShapeId, ShapeState, World } from "thud";

/** Plain data: everything that stands on the card. */
export interface BodyReport {
  /** Steps made when this was so. */
  step: number;
  slot: number;
  state: BodyState;
  shapes: ShapeState[];
}

/** Null if no body has the slot any more. */
export function inspect(world: World, step: number, slot: number): BodyReport | null {
  const { count, handles } = world.shapeTable();
  const shapes: ShapeId[] = [];
  let body: BodyId | null = null;
  for (let i = 0; i < count; i++) {
    const [shape1, shapeGeneration, body1, generation] = handles.subarray(4 * i, 4 * i + 4);
    if (body1 - 1 !== slot) continue;
    body = { kind: "body", index: slot, generation };
    shapes.push({ kind: "shape", index: shape1 - 1, generation: shapeGeneration });
  }
  if (!body) return null;
  return {
    step,
    slot,
    state: world.bodyState(body),
    shapes: shapes.map((shape) => world.shapeState(shape)),
  };
}
