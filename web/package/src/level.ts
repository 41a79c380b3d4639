/**
 * Levels: maps of the Tiled editor in its JSON format (.tmj).
 *
 *     import { buildLevel, readLevel } from "thud/level";
 *     const level = readLevel("quarry", await (await fetch("quarry.tmj")).text());
 *     const world = buildLevel(thud, level);
 *
 * What of a map means what stands in assets/levels/README.md. The C reader in demo/level builds
 * the same world to the bit; its head has the arithmetic that both follow.
 */
import type { Engine } from "./engine.js";
import { messageOf, ThudError } from "./error.js";
import { readObject } from "./level-objects.js";
import {
  isRecord,
  type Json,
  type JsonRecord,
  type Problem,
  Report,
  Values,
} from "./level-values.js";
import { readTiles } from "./level-tiles.js";
import { checkNames } from "./names.js";
import type { BodyOptions, ShapeOptions, Vec2, WorldOptions } from "./types.js";
import type { World } from "./world.js";

export type { Problem } from "./level-values.js";

/** A body with its one shape. Lists of points run from left to right. */
export interface LevelBody {
  body: BodyOptions;
  material: ShapeOptions;
  shape:
    | { kind: "circle"; radius: number }
    | { kind: "aabb"; halfWidth: number; halfHeight: number }
    | { kind: "obb"; halfWidth: number; halfHeight: number }
    | { kind: "terrain"; points: Vec2[] };
}

/** A map as it was read, in world units: plain data for `buildLevel`. */
export interface Level {
  name: string;
  title: string;
  about: string;
  gravity: Vec2;
  lengthScale: number;
  /** The middle of the first view, and how much of the world it shows from top to bottom. */
  camera: Vec2;
  cameraHeight: number;
  /** Where new bodies are dropped. */
  spawn: Vec2;
  /** Whether it is played with a character, which starts there. */
  character: boolean;
  bodies: LevelBody[];
  /** What the world does without; see `ReadOptions.skip`. */
  problems: Problem[];
}

export interface ReadOptions {
  /** Leave out what cannot be modelled instead of refusing the level. Default false. */
  skip?: boolean;
}

/** Why a level cannot be used; the message tells the first three problems. */
export class LevelError extends ThudError {
  readonly problems: readonly Problem[];

  constructor(name: string, problems: readonly Problem[]) {
    const worst = problems.filter((problem) => problem.severity !== "note");
    const first = worst.slice(0, 3).map((problem) => problem.text);
    const more = worst.length > 3 ? `; and ${worst.length - 3} more` : "";
    super("invalid", `level ${name}: ${first.join("; ")}${more}`);
    this.name = "LevelError";
    this.problems = problems;
  }
}

/** What a map has in common while its layers are read. */
export interface Reader {
  readonly level: Level;
  readonly report: Report;
  readonly tileWidth: number;
  readonly tileHeight: number;
  /** Pixels. */
  readonly mapHeight: number;
  readonly pixelsPerUnit: number;
  readonly tilesets: Json;
}

/** A layer on the way from the map, through its groups. */
export interface Layer {
  readonly json: JsonRecord;
  /** Where properties are looked up, the layer itself last. */
  readonly chain: readonly JsonRecord[];
  /** Offset in pixels, with that of the groups. */
  readonly ox: number;
  readonly oy: number;
  readonly name: string;
}

/** As deep as the C reader goes; an object, or a tileset and a tile, still come on top. */
const DEEPEST_CHAIN = 16 - 3;

/** Reads a map. Throws a LevelError if it cannot be used, or something would have to be skipped. */
export function readLevel(name: string, text: string, options: ReadOptions = {}): Level {
  checkNames("readLevel", options, ["skip"]);
  const report = new Report();
  const level = readMap(name, parse(text, report), report);
  if (!level || report.fatal > 0 || (report.skipped > 0 && !options.skip))
    throw new LevelError(name, report.problems);
  return level;
}

/** Makes a world of a level. Throws, and leaves nothing behind, if the engine refuses a body. */
export function buildLevel(engine: Engine, level: Level, options: WorldOptions = {}): World {
  const { gravity, lengthScale } = level;
  const world = engine.createWorld({ ...options, gravity, lengthScale });
  try {
    for (const item of level.bodies) addBody(world, item);
  } catch (error) {
    world.close();
    throw error;
  }
  return world;
}

function addBody(world: World, { body, material, shape }: LevelBody): void {
  const id = world.createBody(body);
  switch (shape.kind) {
    case "circle":
      world.createCircle(id, { ...material, radius: shape.radius });
      break;
    case "aabb":
      world.createAabb(id, { ...material, ...shape });
      break;
    case "obb":
      world.createObb(id, { ...material, ...shape });
      break;
    case "terrain":
      world.createTerrain(id, { kind: "irregular", points: shape.points }, material);
  }
}

function parse(text: string, report: Report): Json {
  try {
    return JSON.parse(text) as Json;
  } catch (error) {
    report.add("fatal", 0, `this is not JSON: ${messageOf(error)}`);
    return null;
  }
}

function readMap(name: string, json: Json, report: Report): Level | null {
  if (report.fatal > 0) return null;
  if (!isRecord(json) || json.type !== "map") {
    report.add("fatal", 0, 'this is not a Tiled map: no "type": "map"');
    return null;
  }
  if (typeof json.orientation === "string" && json.orientation !== "orthogonal") {
    report.add("fatal", 0, `the map is ${json.orientation}; only orthogonal maps are read`);
    return null;
  }
  report.noteUnknown(json, 0, "map");
  const reader = readMapValues(name, json, report);
  if (!reader) {
    report.add("fatal", 0, "the map's own values cannot be used");
    return null;
  }
  readLayers(reader, { json, chain: [json], ox: 0, oy: 0, name: "map" });
  return reader.level;
}

/** What is wrong with the map's own values is fatal: every object depends on them. */
function readMapValues(name: string, json: JsonRecord, report: Report): Reader | null {
  const v = new Values(report, [json], 0, "map");
  const columns = v.required(json, "width", 1, 1e6);
  const rows = v.required(json, "height", 1, 1e6);
  const tileWidth = v.required(json, "tilewidth", 1e-3, 1e6);
  const tileHeight = v.required(json, "tileheight", 1e-3, 1e6);
  const mapHeight = rows * tileHeight;
  const pixelsPerUnit = v.number("pixels_per_unit", tileWidth, 1e-3, 1e6);
  const lengthScale = v.number("length_scale", 1, 1e-3, 1e3);
  const gravity: Vec2 = [
    v.number("gravity_x", 0, -1e6, 1e6),
    v.number("gravity_y", -10, -1e6, 1e6),
  ];
  const width = (columns * tileWidth) / pixelsPerUnit;
  const height = mapHeight / pixelsPerUnit;
  const camera: Vec2 = [
    v.number("camera_x", 0.5 * width, -1e9, 1e9),
    v.number("camera_y", 0.5 * height, -1e9, 1e9),
  ];
  const cameraHeight = v.number("camera_height", height, 1e-3, 1e9);
  const character = v.flag("character", false);
  const title = v.text("title", name);
  const about = v.text("about", "");
  if (v.bad) return null;
  const level: Level = {
    name,
    title,
    about,
    gravity,
    lengthScale,
    camera,
    cameraHeight,
    spawn: camera,
    character,
    bodies: [],
    problems: report.problems,
  };
  const { tilesets } = json;
  return { level, report, tileWidth, tileHeight, mapHeight, pixelsPerUnit, tilesets };
}

function readLayers(reader: Reader, parent: Layer): void {
  const layers = parent.json.layers;
  if (!Array.isArray(layers)) {
    reader.report.add("skip", 0, `'${parent.name}' has no list of layers`);
    return;
  }
  for (const json of layers) readLayer(reader, parent, json);
}

function readLayer(reader: Reader, parent: Layer, value: Json): void {
  const { report } = reader;
  const json = isRecord(value) ? value : {};
  const name = typeof json.name === "string" ? json.name : "unnamed";
  const type = typeof json.type === "string" ? json.type : "";
  if (type === "imagelayer") return;
  if (parent.chain.length > DEEPEST_CHAIN) {
    report.add("skip", 0, `layer '${name}': too deep inside groups`);
    return;
  }
  const chain = [...parent.chain, json];
  const v = new Values(report, chain, 0, name);
  const ox = parent.ox + ("offsetx" in json ? v.required(json, "offsetx", -1e9, 1e9) : 0);
  const oy = parent.oy + ("offsety" in json ? v.required(json, "offsety", -1e9, 1e9) : 0);
  report.noteUnknown(json, 0, name);
  if (v.bad) return;
  const layer: Layer = { json, chain, ox, oy, name };
  if (type === "objectgroup") readObjects(reader, layer);
  else if (type === "tilelayer") readTiles(reader, layer);
  else if (type === "group") readLayers(reader, layer);
  else report.add("skip", 0, `layer '${name}': its type '${type}' is not known`);
}

function readObjects(reader: Reader, layer: Layer): void {
  const { objects } = layer.json;
  if (!Array.isArray(objects)) {
    reader.report.add("skip", 0, `layer '${layer.name}': has no list of objects`);
    return;
  }
  for (const object of objects) readObject(reader, layer, isRecord(object) ? object : {});
}
