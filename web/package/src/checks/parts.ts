/** What was refused of options that have options of their own, and of lists. */
import { ThudError } from "../error.js";
import type { SolidShape } from "../query-types.js";
import type { Terrain, Vec2 } from "../types.js";
import { ASKER_RANGES, blame, isRefusal, QUERY_RANGES, TERRAIN_RANGES, whyNot } from "./ranges.js";

/** The same error, told as of a part of what was made. */
export function within(error: ThudError, part: string): ThudError {
  return new ThudError(error.code, `${part}: ${error.message}`, { cause: error.cause ?? error });
}

/** As `blame`, of a line of ground: the first vertex that is wrong, if one is. */
export function blameTerrain(error: unknown, terrain: Terrain): unknown {
  const needed = Object.entries(TERRAIN_RANGES).filter(([name]) =>
    terrain.kind === "flat" ? name === "slope" : terrain.kind === "uniform" && name !== "slope",
  );
  const told = blame(error, "createTerrain", terrain, Object.fromEntries(needed));
  if (!isRefusal(told) || terrain.kind === "flat") return told;
  const why = terrain.kind === "uniform" ? whyNotHeights(terrain.heights) : whyNotPoints(terrain.points);
  return why ? new ThudError("invalid", `createTerrain: ${why}`, { cause: error }) : told;
}

function whyNotHeights(heights: ArrayLike<number>): string | null {
  if (heights.length < 2) return `heights must be two or more: ${heights.length}`;
  const wrong = Array.from(heights).findIndex((height) => !Number.isFinite(Number(height)));
  return wrong < 0 ? null : `heights[${wrong}] must be a finite number: ${heights[wrong]}`;
}

function whyNotPoints(points: ArrayLike<Vec2>): string | null {
  if (points.length < 2) return `points must be two or more: ${points.length}`;
  const isPlace = (point: Vec2) => Number.isFinite(Number(point[0]) + Number(point[1]));
  for (let i = 0; i < points.length; i++) {
    if (!isPlace(points[i])) return `points[${i}] must be two finite numbers: [${points[i]}]`;
    if (i > 0 && !(points[i][0] > points[i - 1][0]))
      return `points[${i}] must be right of points[${i - 1}]: [${points[i]}]`;
  }
  return null;
}

/** As `blame`, of a query's arguments, and of the shape that asks. */
export function blameQuery(
  error: unknown,
  call: string,
  args: object,
  scale: number,
  shape?: SolidShape,
): unknown {
  const told = blame(error, call, args, QUERY_RANGES, scale);
  const shown = shape ? blame(told, call, shape, ASKER_RANGES[shape.kind]) : told;
  if (!isRefusal(shown)) return shown;
  const why = whereTo(args);
  return why ? new ThudError("invalid", `${call}: ${why}`, { cause: error }) : shown;
}

/** Whether a ray among many is one that `blameQuery` finds wrong. */
export function isQueryWrong(args: { origin: number[]; translation: number[] }, scale: number): boolean {
  if (whyNot(args, QUERY_RANGES, scale) !== null) return true;
  const end = args.origin.map((x, i) => x + args.translation[i]);
  return whyNot({ point: end }, QUERY_RANGES, scale) !== null;
}

/** Of arguments that are wrong together. */
function whereTo(args: object): string | null {
  if ("translation" in args) return "translation leads out of the world";
  if ("lower" in args && "upper" in args) return "lower must be below upper";
  return null;
}
