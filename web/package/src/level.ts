/**
 * "thud/level": reads levels, which are maps of the Tiled editor (.tmj and .tmx) with the tilesets
 * (.tsj, .tsx) and templates (.tj, .tx) that they refer to, and makes worlds of them.
 *
 *     import { buildLevel, readLevel } from "thud/level";
 *     const open = async (path) => (await fetch(`levels/${path}`)).text();
 *     const level = await readLevel("quarry", await open("quarry.tmx"), { open });
 *     const world = buildLevel(thud, level);
 *
 * assets/levels/README.md says what the parts of a map mean. The C reader in demo/level makes the
 * same world, bit for bit; its head describes the arithmetic that both use. In the code "pixels"
 * are the map's coordinates, with y down, and "units" those of the world, with y up.
 */
import type { Engine } from "./engine.js";
import { messageOf, ThudError } from "./error.js";
import type { AnyJointOptions } from "./joint-types.js";
import { MOST_CELLS } from "./level/cells.js";
import { type FileContent, type FileOpener, Library, parseDocument } from "./level/library.js";
import { MOST_PARTS } from "./level/forms.js";
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
import { checkOptions } from "./checks/names.js";
import type { BodyId, BodyOptions, JointId, ShapeOptions, Vec2, WorldOptions } from "./types.js";
import type { World } from "./world.js";

export type { FileContent, FileOpener } from "./level/library.js";
export type { Problem } from "./level/values.js";

/** A shape in its body's frame, in world units. The points of a terrain run from left to right. */
export type LevelShape = { material: ShapeOptions } & (
  | { kind: "circle"; offset: Vec2; radius: number }
  | { kind: "aabb"; offset: Vec2; halfWidth: number; halfHeight: number }
  | { kind: "obb"; offset: Vec2; halfWidth: number; halfHeight: number; angle: number }
  | { kind: "terrain"; points: Vec2[] }
);

/**
 * A body with its shapes. A body without shapes is the anchor of a joint to the world.
 * `body.userData` is the id of the object in the map; undefined for a tile of a layer.
 */
export interface LevelBody {
  body: BodyOptions;
  shapes: LevelShape[];
}

/** The options of a joint without its bodies or joints. */
type Untied<T> = T extends unknown ? Omit<T, "bodyA" | "bodyB" | "jointA" | "jointB"> : never;

/** A joint between two bodies, or a gear between two joints. */
export interface LevelJoint {
  /** The index of body a in `Level.bodies`, of a gear that of joint a in `Level.joints`. */
  a: number;
  /** The same of b. */
  b: number;
  /** The options of World.createJoint beside the two bodies or joints. */
  options: Untied<AnyJointOptions>;
}

/** A map as it was read, in world units: plain data for `buildLevel`. */
export interface Level {
  /** The name that readLevel was given. */
  name: string;
  /** The map's property `title`. Default its name. */
  title: string;
  /** The map's property `about`, a description. Default "". */
  about: string;
  gravity: Vec2;
  lengthScale: number;
  /** The centre of the first view. */
  camera: Vec2;
  /** The height of the first view. */
  cameraHeight: number;
  /** The place at which new bodies are created. */
  spawn: Vec2;
  /** Whether the level is played with a character, which starts at `spawn`. */
  character: boolean;
  bodies: LevelBody[];
  joints: LevelJoint[];
  /** The number of objects of each class that has no meaning here: for your own use. */
  classes: Record<string, number>;
  /** What was left out or has no effect; see `ReadOptions.skip`. */
  problems: Problem[];
}

/** The options of readLevel. */
export interface ReadOptions {
  /** Whether what cannot be modelled is left out; false: the level is refused. Default false. */
  skip?: boolean;
  /**
   * Returns the tilesets and templates that the map refers to. Default: none, the map must contain
   * all that it uses.
   */
  open?: FileOpener;
  /**
   * The engine that approximates polygons by shapes, for maps with the property `approximate`; they
   * need it. Default: none.
   */
  engine?: Engine;
}

/** The error of a level that cannot be used; its message has the first three problems. */
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

/** The state of reading one map, which all its layers share. */
export interface Reader {
  readonly level: Level;
  readonly report: Report;
  /** What approximates polygons. */
  readonly engine: Engine | undefined;
  readonly tileWidth: number;
  readonly tileHeight: number;
  /** The height of the map, pixels. */
  readonly mapHeight: number;
  readonly pixelsPerUnit: number;
  /**
   * The engine's own length scale: the greatest power of two that is not above the level's. The
   * engine's ranges are multiples of it.
   */
  readonly unit: number;
  readonly tilesets: Tileset[];
  readonly library: Library;
  /** Whether every tile collides, because nothing in the map says which do. */
  readonly allSolid: boolean;
  /** The number of cells that may still be read in all layers, since a small file can claim any. */
  cells: number;
  /**
   * The number of shapes, and of vertices of lines, that may still be added: tiles and templates
   * repeat those of a small file any number of times.
   */
  parts: number;
  /** The number of tiles of which nothing says whether they collide. */
  unmarked: number;
  /** The first body of each object, by its id. */
  readonly placed: Map<number, Placed>;
  /** Objects that are joints. */
  readonly ties: Tie[];
}

/** A layer with the values that it takes over from the groups around it. */
export interface Layer {
  readonly json: JsonRecord;
  /**
   * The objects in which properties are looked up, from the map to the layer itself, which wins.
   */
  readonly chain: readonly JsonRecord[];
  /** The offset in pixels, with those of the groups. */
  readonly ox: number;
  readonly oy: number;
  readonly name: string;
}

/**
 * The longest chain of map, groups and layer. The C reader has room for 16; up to three more are
 * added below a layer: a tileset, a tile and an object.
 */
const DEEPEST_CHAIN = 16 - 3;

/**
 * Reads a map, .tmj or .tmx, from its content. Rejects with a LevelError if it cannot be used, or
 * if something would have to be left out and `skip` is not set. XML needs the package
 * @rgrove/parse-xml, and layers packed by Zstandard need fzstd: both are optional, and imported
 * when a level needs them.
 */
export async function readLevel(
  name: string,
  content: FileContent,
  options: ReadOptions = {},
): Promise<Level> {
  checkOptions("readLevel", options, ["skip", "open", "engine"]);
  let report = new Report();
  let read: Reader | null = null;
  try {
    const json = await parseDocument(content);
    const library = new Library(options.open);
    if (isRecord(json)) await library.prepare(json);
    read = await readMap(name, json, report, library, false, options.engine);
    if (read && read.level.bodies.length === 0 && read.unmarked > 0) {
      report = new Report();
      library.forgetReports();
      const what = "nothing in this map says what collides, so every tile does";
      const way = "'solid' says it for a layer, a tileset, a tile or a tile object";
      report.add("note", 0, `${what}: ${way}`);
      read = await readMap(name, json, report, library, true, options.engine);
    }
  } catch (error) {
    report.add("fatal", 0, messageOf(error));
  }
  if (!read || report.fatal > 0 || (report.skipped > 0 && !options.skip))
    throw new LevelError(name, report.problems);
  return read.level;
}

/**
 * Makes a world of a level. `options`: further options of the world; gravity and length scale are
 * the level's.
 * @throws {ThudError} "invalid" where the engine refuses a part, "memory"; no world is left then.
 */
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

/** Creates a body with its shapes in a world. */
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

/** Creates the joints; a gear comes after the joints that it couples. */
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

/** Reads a whole map. Null, with a fatal problem in the report, where it cannot be used. */
async function readMap(
  name: string,
  json: Json,
  report: Report,
  library: Library,
  allSolid: boolean,
  engine: Engine | undefined,
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
  const reader = readMapValues(name, json, report, library, allSolid, engine);
  if (!reader) {
    report.add("fatal", 0, "the map's own values cannot be used");
    return null;
  }
  await readLayers(reader, { json, chain: [json], ox: 0, oy: 0, name: "map" });
  tieJoints(reader);
  return reader;
}

/** The greatest power of two that is not above x > 0. */
function powerBelow(x: number): number {
  let power = 1;
  while (power > x) power *= 0.5;
  while (power * 2 <= x) power *= 2;
  return power;
}

/**
 * Reads the map's own fields and properties. Null where one of them is wrong: all objects depend on
 * them.
 */
function readMapValues(
  name: string,
  json: JsonRecord,
  report: Report,
  library: Library,
  allSolid: boolean,
  engine: Engine | undefined,
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
    engine,
    library,
    tileWidth,
    tileHeight,
    mapHeight,
    pixelsPerUnit,
    unit: powerBelow(Math.fround(lengthScale)),
    tilesets: listTilesets(json.tilesets, ""),
    allSolid,
    cells: MOST_CELLS,
    parts: MOST_PARTS,
    unmarked: 0,
    placed: new Map(),
    ties: [],
  };
}

/** Reads the layers of the map or of a group. */
async function readLayers(reader: Reader, parent: Layer): Promise<void> {
  const layers = parent.json.layers;
  if (!Array.isArray(layers)) {
    reader.report.add("skip", 0, `'${parent.name}' has no list of layers`);
    return;
  }
  for (const json of layers) await readLayer(reader, parent, json);
}

/** Reads one layer of any type; image layers have no effect. */
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
