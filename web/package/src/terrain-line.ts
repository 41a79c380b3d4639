/** Hands a terrain line, or its texture, to the module. */
import { checkOptions } from "./checks/names.js";
import type { Engine } from "./engine.js";
import { ThudError } from "./error.js";
import { flagOf, indexOf } from "./numbers.js";
import type { Terrain, Texture } from "./types.js";

export const TERRAIN_KINDS = ["flat", "uniform", "irregular"] as const;
/** The options of each kind of terrain. */
const TERRAINS = {
  flat: ["kind", "slope"],
  uniform: ["kind", "x0", "spacing", "heights"],
  irregular: ["kind", "points"],
} as const;

/** Takes a line as the module's functions do: `points` is the address of `count` vertices. */
type UseLine<T> = (
  kind: number,
  slope: number,
  x0: number,
  spacing: number,
  points: number,
  count: number,
) => T;

/**
 * Copies the vertices of a line into the module's memory for the time of `use`, and returns what it
 * returns. `call`: the name of the call, for messages. Throws "invalid" for a line of no kind, with
 * other options than those of its kind, or without its list; "memory".
 */
export function withLine<T>(engine: Engine, call: string, line: Terrain, use: UseLine<T>): T {
  const kind = indexOf(TERRAIN_KINDS, line.kind, `${call}: kind`);
  checkOptions(call, line, TERRAINS[line.kind]);
  if (line.kind === "flat") return use(kind, line.slope ?? 0, 0, 0, 0, 0);
  const uniform = line.kind === "uniform";
  const list: ArrayLike<unknown> | undefined = uniform ? line.heights : line.points;
  if (typeof list?.length !== "number")
    throw new ThudError("invalid", `${call}: ${uniform ? "heights" : "points"} must be a list`);
  const count = list.length;
  const fill = (doubles: Float64Array) => {
    for (let i = 0; i < count; i++) {
      doubles[2 * i] = uniform ? line.x0 + i * line.spacing : line.points[i][0];
      doubles[2 * i + 1] = uniform ? line.heights[i] : line.points[i][1];
    }
  };
  return engine.withDoubles(2 * count, fill, (points) =>
    uniform
      ? use(kind, 0, line.x0, line.spacing, points, count)
      : use(kind, 0, 0, 0, points, count),
  );
}

const TEXTURE = ["vertices", "table", "repeats"] as const;

/** Takes a texture as the module's functions do: `numbers` is the address of both its lists. */
type UseTexture<T> = (
  numbers: number,
  count: number,
  entries: number,
  hasTable: number,
  repeats: number,
) => T;

/** The same for a texture: throws "invalid" for unknown options and values that are no lists. */
export function withTexture<T>(
  engine: Engine,
  call: string,
  texture: Texture,
  use: UseTexture<T>,
): T {
  checkOptions(call, texture, TEXTURE);
  const { vertices, table, repeats = false } = texture;
  for (const [name, list] of [["vertices", vertices], ["table", table ?? []]] as const)
    if (typeof list?.length !== "number")
      throw new ThudError("invalid", `${call}: ${name} must be a list`);
  const [count, entries, hasTable] = [vertices.length, table?.length ?? 0, Number(table !== undefined)];
  const flag = flagOf(repeats, `${call}: repeats`);
  const fill = (doubles: Float64Array) => {
    doubles.set(vertices);
    if (table) doubles.set(table, count);
  };
  return engine.withDoubles(count + entries, fill, (at) => use(at, count, entries, hasTable, flag));
}
