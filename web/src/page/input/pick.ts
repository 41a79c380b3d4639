/** Finds the body under the pointer from the frame that is shown, without asking the worker. */
import type { Vec2 } from "thud";
import type { Frame, Shapes } from "../../scene/frame";
import { CIRCLE, DYNAMIC, ROW } from "../../scene/shape-table";

/** Poses of bodies: those of a frame, or Box2D's poses relative to the same origin. */
export type Placed = Pick<Frame, "origin" | "now">;

/**
 * The slot of the body (its index in `Frame.now`) whose shape has the smallest signed distance to
 * the point (x, y) of the world, negative inside the shape; null if that exceeds `reach`, a length
 * in world units. Only circles and boxes are searched; `dynamicOnly`: only dynamic bodies.
 */
export function pick(
  shapes: Shapes,
  frame: Placed,
  x: number,
  y: number,
  reach: number,
  dynamicOnly: boolean,
): number | null {
  let best: number | null = null;
  let least = reach;
  for (let i = 0; i < shapes.count; i++) {
    const [slot, kind, bodyKind, , ox, oy, hx, hy, cosine, sine] = shapes.rows.subarray(
      i * ROW,
      i * ROW + ROW,
    );
    if (dynamicOnly && bodyKind !== DYNAMIC) continue;
    const [px, py, c, s] = frame.now.subarray(4 * slot, 4 * slot + 4);
    const dx = x - frame.origin[0] - (px + c * ox - s * oy);
    const dy = y - frame.origin[1] - (py + s * ox + c * oy);
    let distance: number;
    if (kind === CIRCLE) distance = Math.hypot(dx, dy) - hx;
    else {
      const [wc, ws] = [c * cosine - s * sine, s * cosine + c * sine];
      const ax = Math.abs(wc * dx + ws * dy) - hx;
      const ay = Math.abs(wc * dy - ws * dx) - hy;
      distance =
        ax > 0 && ay > 0 ? Math.hypot(ax, ay) : Math.max(ax, ay);
    }
    if (distance <= least) {
      least = distance;
      best = slot;
    }
  }
  return best;
}

/** A point of the world in the local coordinates of a body. */
export function inBody({ origin, now }: Placed, slot: number, x: number, y: number): Vec2 {
  const [px, py, c, s] = now.subarray(4 * slot, 4 * slot + 4);
  const [dx, dy] = [x - origin[0] - px, y - origin[1] - py];
  return [c * dx + s * dy, c * dy - s * dx];
}
