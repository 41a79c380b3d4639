/** Everything that measuring needs. The worker imports it when it is first asked to measure. */
import type { Engine } from "thud";
import { type Box2D, loadBox2D } from "../box2d/load";
import { messageOf } from "../shared/error";
import type { Laboratory } from "./measure-trial";

export { measure } from "./measure";
export { findHoldings } from "./measure-heavier";

/**
 * Loads Box2D for measuring. If that fails, thud is measured alone, and `withoutBox2D` says why;
 * else it is "".
 */
export async function prepare(
  engine: Engine,
  open: Laboratory["open"],
): Promise<{ laboratory: Laboratory; withoutBox2D: string }> {
  let box2d: Box2D | null = null;
  let withoutBox2D = "";
  try {
    box2d = await loadBox2D();
  } catch (error) {
    withoutBox2D = messageOf(error);
  }
  return { laboratory: { engine, box2d, open }, withoutBox2D };
}
