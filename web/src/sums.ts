/** The Minkowski sums of a scene that is there to show them, worked out by the wasm module. */
import type { Vec2 } from "thud";
import { ROW } from "./render/shapes";
import type { Simulation } from "./simulation";

export interface Sum {
  /** The first shape's centre, which the outline is about, and the second's. */
  readonly origin: Vec2;
  readonly point: Vec2;
  /** Whether the point is in the sum: the shapes overlap. */
  readonly overlaps: boolean;
  /** The place on the edge of the sum that is nearest to the point. */
  readonly edge: Vec2;
  /** Counter-clockwise, x and y in turn. */
  readonly outline: Float64Array;
}

/** A shape of the body in a slot, as numbers of api_sum_picture; null where there is none. */
function placedAt(
  { shapes }: Simulation,
  poses: Float32Array,
  slot: number,
): { at: Vec2; numbers: number[] } | null {
  for (let i = 0; i < shapes.count; i++) {
    const row = shapes.rows.subarray(i * ROW, (i + 1) * ROW);
    if (row[0] !== slot) continue;
    const [, kind, , , x, y, hx, hy, cosine, sine] = row;
    const [px, py, c, s] = poses.subarray(4 * slot, 4 * slot + 4);
    return {
      at: [px + c * x - s * y, py + s * x + c * y],
      numbers: [kind, hx, hy, c * cosine - s * sine, s * cosine + c * sine],
    };
  }
  return null;
}

/** Of the first bodies two by two, as many pairs as the scene asks for; relative to (x, y). */
export function readSums(simulation: Simulation, x: number, y: number): Sum[] {
  const { world, built, alpha } = simulation;
  const { engine } = world;
  const sums: Sum[] = [];
  if (built.sumPairs === 0) return sums;
  const poses = world.poses(alpha, x, y).slice();
  for (let i = 0; i < built.sumPairs; i++) {
    const a = placedAt(simulation, poses, 2 * i);
    const b = placedAt(simulation, poses, 2 * i + 1);
    if (!a || !b) continue;
    const way = [b.at[0] - a.at[0], b.at[1] - a.at[1]];
    [...a.numbers, ...b.numbers, ...way].forEach((value, k) => (engine.slots[k] = value));
    engine.check(engine.exports.api_sum_picture());
    const [overlaps, edgeX, edgeY, address, count] = engine.slots;
    sums.push({
      origin: a.at,
      point: b.at,
      overlaps: overlaps !== 0,
      edge: [a.at[0] + edgeX, a.at[1] + edgeY],
      outline: new Float64Array(engine.buffer, address, 2 * count).slice(),
    });
  }
  return sums;
}
