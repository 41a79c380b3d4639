/**
 * Explains errors of the engine: of a call that the engine refused it finds the option or argument
 * that is out of range, and makes an error that names it with its range. explainErrors hands these
 * functions to hook.ts, through which the rest of the package calls them.
 */
import { ThudError } from "../error.js";
import type { SolidShape } from "../query-types.js";
import type { Terrain, Texture, Vec2 } from "../types.js";
import { blameArguments } from "./arguments.js";
import { explainWith, isRefusal } from "./hook.js";
import { blameJoint, checkTogether } from "./joints.js";
import { tellNearest } from "./nearest.js";
import { show } from "./show.js";
import { checkElapsed, checkStep } from "./time.js";
import { checkValue } from "./values.js";
import {
  ASKER_RANGES,
  blame,
  BODY_RANGES,
  EXPLOSION_RANGES,
  MOVE_RANGES,
  MOVER_RANGES,
  QUALITY_RANGES,
  QUERY_RANGES,
  type Ranges,
  RULE_RANGES,
  SHAPE_RANGES,
  TERRAIN_RANGES,
  TEXTURE_RANGES,
  TYRE_RANGES,
  WALK_RANGES,
  WATER_RANGES,
  whyNot,
  WORLD_RANGES,
} from "./ranges.js";

/** The ranges of calls whose options reach the explainer as the caller gave them, by the call. */
const PLAIN: Readonly<Record<string, Ranges>> = {
  createBody: BODY_RANGES,
  createCircle: SHAPE_RANGES.circle,
  createAabb: SHAPE_RANGES.aabb,
  createObb: SHAPE_RANGES.obb,
  setRule: RULE_RANGES,
  explode: EXPLOSION_RANGES,
  applyBuoyancy: WATER_RANGES,
  applyTyre: TYRE_RANGES,
  setQuality: QUALITY_RANGES,
  move: MOVE_RANGES,
  walk: WALK_RANGES,
  Mover: MOVER_RANGES,
};

/** What a call hands to the explainer beside plain options. */
interface Given {
  quality?: unknown;
  terrain?: Terrain;
  texture?: Texture;
  shape?: SolidShape;
  rays?: ArrayLike<number>;
  joint?: object;
  /** The largest length that a joint may have, in length units. */
  furthest?: number;
}

/**
 * From now on errors name the option that was wrong and its range, and the types of options are
 * checked. `load` of "thud" calls this itself; call it after `load` of "thud/first".
 */
export function explainErrors(): void {
  explainWith({
    explain,
    nearest: tellNearest,
    shown: show,
    checkValue,
    checkJoint: checkTogether,
    checkElapsed,
    checkStep,
  });
}

/**
 * The Explainer of hook.ts. A list is the arguments of the module's function `call`, by position.
 */
function explain(error: ThudError, call: string, given: object, scale: number): unknown {
  if (Array.isArray(given)) return blameArguments(error, call, given, scale);
  const { quality, terrain, texture, shape, rays, joint, furthest = 0 } = given as Given;
  if (joint) {
    blameJoint(error, call, joint, furthest);
    return error;
  }
  if (call === "castRays" && rays) return blameRays(error, rays, scale);
  if (terrain)
    return blameTerrain(blame(error, call, given, SHAPE_RANGES.terrain, scale), terrain);
  if (texture) return blameTexture(error, texture);
  if (call === "createWorld") {
    const told = blame(error, call, given, WORLD_RANGES);
    return blame(told, call, Object(quality), QUALITY_RANGES, 1, "quality.");
  }
  if (call === "Mover") {
    const told = blame(error, call, given, MOVER_RANGES);
    return shape ? blame(told, call, shape, ASKER_RANGES[shape.kind], 1, "shape.") : told;
  }
  if (call in PLAIN) return blame(error, call, given, PLAIN[call], scale);
  return blameQuery(error, call, given, scale, shape);
}


/** As `blame`, for the line of a terrain: also names the first height or point that is wrong. */
function blameTerrain(error: unknown, terrain: Terrain): unknown {
  const needed = Object.entries(TERRAIN_RANGES).filter(([name]) =>
    terrain.kind === "flat" ? name === "slope" : terrain.kind === "uniform" && name !== "slope",
  );
  const told = blame(error, "createTerrain", terrain, Object.fromEntries(needed));
  if (!isRefusal(told) || terrain.kind === "flat") return told;
  const why = terrain.kind === "uniform" ? whyNotHeights(terrain.heights) : whyNotPoints(terrain.points);
  return why ? new ThudError("invalid", `createTerrain: ${why}`, { cause: error }) : told;
}

/** Names the first number of a texture that is out of range. */
function blameTexture(error: ThudError, { vertices, table }: Texture): ThudError {
  const values = table ? TEXTURE_RANGES.coordinate : TEXTURE_RANGES.friction;
  const lists = [["vertices", vertices, values], ["table", table ?? [], TEXTURE_RANGES.friction]] as const;
  for (const [name, list, range] of lists)
    for (let i = 0; i < list.length; i++) {
      const entry = `${name}[${i}]`;
      const why = whyNot({ [entry]: list[i] }, { [entry]: { ...range, needed: true } }, 1);
      if (why) return new ThudError("invalid", `setTexture: ${why}`, { cause: error });
    }
  return error;
}

/** Why the heights are refused: too few, or one that is not finite; null where they are right. */
function whyNotHeights(heights: ArrayLike<number>): string | null {
  if (heights.length < 2) return `heights must be two or more: ${heights.length}`;
  const wrong = Array.from(heights).findIndex((height) => !Number.isFinite(Number(height)));
  return wrong < 0 ? null : `heights[${wrong}] must be a finite number: ${heights[wrong]}`;
}

/** Why the points are refused: too few, not finite, or x does not increase; null where right. */
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

/** As `blame`, for a query's arguments and the shape that is cast or tested. */
function blameQuery(
  error: unknown,
  call: string,
  args: object,
  scale: number,
  shape?: SolidShape,
): unknown {
  const told = blame(error, call, args, QUERY_RANGES, scale);
  const shown = shape ? blame(told, call, shape, ASKER_RANGES[shape.kind]) : told;
  if (!isRefusal(shown)) return shown;
  const why = whereTo(args, shown.message);
  return why ? new ThudError("invalid", `${call}: ${why}`, { cause: error }) : shown;
}

/** Whether `blameQuery` would refuse this ray: origin, translation or end is out of range. */
function isQueryWrong(args: { origin: number[]; translation: number[] }, scale: number): boolean {
  if (whyNot(args, QUERY_RANGES, scale) !== null) return true;
  const end = args.origin.map((x, i) => x + args.translation[i]);
  return whyNot({ point: end }, QUERY_RANGES, scale) !== null;
}

/**
 * Why arguments are refused that are each in range but do not fit together, or null. `told`: the
 * engine's message.
 */
function whereTo(args: object, told: string): string | null {
  if (told.includes("category and mask")) return "filter: category and mask are both 0, so that it meets nothing";
  if ("translation" in args) return "translation leads out of the world; it is the way from the origin, not the end";
  if ("lower" in args && "upper" in args) return "lower must be below upper";
  return null;
}

/** As blameQuery, for castRays: also names the number of the first ray that is wrong. */
function blameRays(error: ThudError, rays: ArrayLike<number>, scale: number): unknown {
  const ends = Array.from({ length: Math.floor(rays.length / 4) }, (_, i) => ({
    origin: [rays[4 * i], rays[4 * i + 1]],
    translation: [rays[4 * i + 2], rays[4 * i + 3]],
  }));
  const wrong = Math.max(0, ends.findIndex((ray) => isQueryWrong(ray, scale)));
  return blameQuery(error, `castRays: ray ${wrong}`, ends[wrong], scale);
}
