/**
 * Levels: maps of the Tiled editor, .tmj and .tmx, with the tilesets (.tsj, .tsx) and templates
 * (.tj, .tx) that they refer to.
 *
 *     import { buildLevel, readLevel } from "thud/level";
 *     const open = async (path) => (await fetch(`levels/${path}`)).text();
 *     const level = await readLevel("quarry", await open("quarry.tmx"), { open });
 *     const world = buildLevel(thud, level);
 *
 * What of a map means what stands in assets/levels/README.md. The C reader in demo/level builds
 * the same world to the bit; its head has the arithmetic that both follow.
 */
import type { Engine } from "./engine.js";
import { messageOf, ThudError } from "./error.js";
import type { AnyJointOptions } from "./joint-types.js";
import { MOST_CELLS } from "./level/cells.js";
import { type FileContent, type FileOpener, Library, parseDocument } from "./level/library.js";
import type { Tie } from "./level/joints.js";
import { readObjects } from "./level/objects.js";
import { type Placed, tieJoints } from "./level/tie.js";
import { readTiles } from "./level/tiles.js";
import { listTilesets, type Tileset } from "./level/tilesets.js";
import {
  isRecord,
  type Json,
  type JsonRecord,
  type Problem,
  Report,
  Values,
} from "./level/values.js";
import { checkNames } from "./checks/names.js";
import type { BodyId, BodyOptions, JointId, ShapeOptions, Vec2, WorldOptions } from "./types.js";
import type { World } from "./world.js";

export type { FileContent, FileOpener } from "./level/library.js";
export type { Problem } from "./level/values.js";

/** A shape in its body's frame. Lists of points run from left to right. */
export type LevelShape = { material: ShapeOptions } & (
  | { kind: "circle"; offset: Vec2; radius: number }
  | { kind: "aabb"; offset: Vec2; halfWidth: number; halfHeight: number }
  | { kind: "obb"; offset: Vec2; halfWidth: number; halfHeight: number; angle: number }
  | { kind: "terrain"; points: Vec2[] }
);

/**
 * A body with its shapes, none where a joint holds to the world; `body.userData` is the object's
 * id, none of a tile.
 */
export interface LevelBody {
  body: BodyOptions;
  shapes: LevelShape[];
}

type Untied<T> = T extends unknown ? Omit<T, "bodyA" | "bodyB" | "jointA" | "jointB"> : never;

/** A joint, by the places of its bodies in `Level.bodies`; of a gear of joints in `Level.joints`. */
export interface LevelJoint {
  a: number;
  b: number;
  /** What World.createJoint takes beside them. */
  options: Untied<AnyJointOptions>;
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
  joints: LevelJoint[];
  /** Classes of objects that mean nothing here, and how many objects have each: for your own use. */
  classes: Record<string, number>;
  /** What the world does without; see `ReadOptions.skip`. */
  problems: Problem[];
}

export interface ReadOptions {
  /** Leave out what cannot be modelled instead of refusing the level. Default false. */
  skip?: boolean;
  /** Gives the tilesets and templates that the map refers to. Without it the map stands alone. */
  open?: FileOpener;
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
  readonly tilesets: Tileset[];
  readonly library: Library;
  /** Nothing in the map says what collides, so that every tile does. */
  readonly allSolid: boolean;
  /** Cells that may still be read, in all layers: a small file can claim any number. */
  cells: number;
  /** Tiles of which nothing says whether they collide. */
  unmarked: number;
  /** The first body of each object, by its id. */
  readonly placed: Map<number, Placed>;
  /** Objects that are joints. */
  readonly ties: Tie[];
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

/**
 * Reads a map, .tmj or .tmx. Rejects with a LevelError if it cannot be used, or something would
 * have to be skipped. XML needs the package @rgrove/parse-xml, and layers packed by Zstandard need
 * fzstd: both are optional, and loaded when a level comes to need them.
 */
export async function readLevel(
  name: string,
  content: FileContent,
  options: ReadOptions = {},
): Promise<Level> {
  checkNames("readLevel", options, ["skip", "open"]);
  let report = new Report();
  let read: Reader | null = null;
  try {
    const json = await parseDocument(content);
    const library = new Library(options.open);
    if (isRecord(json)) await library.prepare(json);
    read = await readMap(name, json, report, library, false);
    if (read && read.level.bodies.length === 0 && read.unmarked > 0) {
      report = new Report();
      library.forgetReports();
      const what = "nothing in this map says what collides, so every tile does";
      const way = "'solid' says it for a layer, a tileset, a tile or a tile object";
      report.add("note", 0, `${what}: ${way}`);
      read = await readMap(name, json, report, library, true);
    }
  } catch (error) {
    report.add("fatal", 0, messageOf(error));
  }
  if (!read || report.fatal > 0 || (report.skipped > 0 && !options.skip))
    throw new LevelError(name, report.problems);
  return read.level;
}

/** Makes a world of a level. Throws, and leaves nothing behind, if the engine refuses a part. */
export function buildLevel(engine: Engine, level: Level, options: WorldOptions = {}): World {
  const { gravity, lengthScale } = level;
  const world = engine.createWorld({ ...options, gravity, lengthScale });
  try {
    const bodies = level.bodies.map((item) => addBody(world, item));
    addJoints(world, level.joints, bodies);
  } catch (error) {
    world.close();
    throw error;
  }
  return world;
}

function addBody(world: World, { body, shapes }: LevelBody): BodyId {
  const id = world.createBody(body);
  for (const shape of shapes) {
    const { material } = shape;
    if (shape.kind === "terrain") {
      world.createTerrain(id, { kind: "irregular", points: shape.points }, material);
      continue;
    }
    const { offset } = shape;
    if (shape.kind === "circle") {
      world.createCircle(id, { ...material, offset, radius: shape.radius });
      continue;
    }
    const { halfWidth, halfHeight } = shape;
    if (shape.kind === "aabb") world.createAabb(id, { ...material, offset, halfWidth, halfHeight });
    else world.createObb(id, { ...material, offset, halfWidth, halfHeight, angle: shape.angle });
  }
  return id;
}

function addJoints(world: World, list: readonly LevelJoint[], bodies: readonly BodyId[]): void {
  const joints: JointId[] = [];
  for (const { a, b, options } of list) {
    const made =
      options.kind === "gear"
        ? world.createJoint({ ...options, jointA: joints[a], jointB: joints[b] })
        : world.createJoint({ ...options, bodyA: bodies[a], bodyB: bodies[b] });
    joints.push(made);
  }
}

async function readMap(
  name: string,
  json: Json,
  report: Report,
  library: Library,
  allSolid: boolean,
): Promise<Reader | null> {
  if (!isRecord(json) || json.type !== "map") {
    report.add("fatal", 0, 'this is not a Tiled map: no "type": "map"');
    return null;
  }
  if (typeof json.orientation === "string" && json.orientation !== "orthogonal") {
    report.add("fatal", 0, `the map is ${json.orientation}; only orthogonal maps are read`);
    return null;
  }
  report.noteUnknown(json, 0, "map", "any");
  const reader = readMapValues(name, json, report, library, allSolid);
  if (!reader) {
    report.add("fatal", 0, "the map's own values cannot be used");
    return null;
  }
  await readLayers(reader, { json, chain: [json], ox: 0, oy: 0, name: "map" });
  tieJoints(reader);
  return reader;
}

/** What is wrong with the map's own values is fatal: every object depends on them. */
function readMapValues(
  name: string,
  json: JsonRecord,
  report: Report,
  library: Library,
  allSolid: boolean,
): Reader | null {
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
    joints: [],
    classes: {},
    problems: report.problems,
  };
  return {
    level,
    report,
    library,
    tileWidth,
    tileHeight,
    mapHeight,
    pixelsPerUnit,
    tilesets: listTilesets(json.tilesets, ""),
    allSolid,
    cells: MOST_CELLS,
    unmarked: 0,
    placed: new Map(),
    ties: [],
  };
}

async function readLayers(reader: Reader, parent: Layer): Promise<void> {
  const layers = parent.json.layers;
  if (!Array.isArray(layers)) {
    reader.report.add("skip", 0, `'${parent.name}' has no list of layers`);
    return;
  }
  for (const json of layers) await readLayer(reader, parent, json);
}

async function readLayer(reader: Reader, parent: Layer, value: Json): Promise<void> {
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
  report.noteUnknown(json, 0, name, "any");
  if (v.bad) return;
  const layer: Layer = { json, chain, ox, oy, name };
  if (type === "objectgroup") readObjects(reader, layer);
  else if (type === "tilelayer") await readTiles(reader, layer);
  else if (type === "group") await readLayers(reader, layer);
  else report.add("skip", 0, `layer '${name}': its type '${type}' is not known`);
}
