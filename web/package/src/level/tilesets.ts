/**
 * Finds the tile of a tile number, and the forms with which it collides. The same arithmetic as
 * demo/level/tilesets.c.
 */
import type { Reader } from "../level.js";
import { DEGREES, FAR, type Form, form } from "./form.js";
import { flipForm, NUMBER, readForms, scaleForm, turnForm } from "./forms.js";
import {
  flagOf,
  isRecord,
  type Json,
  type JsonRecord,
  ownProperty,
  type Physics,
  readPhysics,
  type Values,
} from "./values.js";

/** An entry of a map's or a template's list of tilesets. */
export interface Tileset {
  /** The tile number of its first tile. */
  first: number;
  /** The tileset, or an object with the path of its file in `source`. */
  json: JsonRecord;
  /** The path of the file with this entry, "" for the map. */
  path: string;
}

/** A tile of a map. */
export interface Tile {
  tileset: JsonRecord;
  /** The tile's entry in the tileset; undefined where it has none. */
  json: JsonRecord | undefined;
  /** Its number in the tileset. */
  id: number;
  /** The size of its picture, pixels. */
  width: number;
  height: number;
  /** The offset at which the tileset's tiles are drawn, pixels. */
  offsetX: number;
  offsetY: number;
  /** The point of the picture that lies at a tile object's place, as fractions of its size. */
  anchorX: number;
  anchorY: number;
  /** Whether a layer draws the tile as large as a cell of the map. */
  fillsCell: boolean;
  /** Whether it keeps the aspect ratio of its picture then. */
  keepsAspect: boolean;
}

/** The entries of a list of tilesets in the file `path`; wrong entries are left out. */
export function listTilesets(list: Json, path: string): Tileset[] {
  if (!Array.isArray(list)) return [];
  return list.filter(isRecord).flatMap((json): Tileset[] => {
    const first = json.firstgid;
    return typeof first === "number" && first >= 1 ? [{ first: Math.floor(first), json, path }] : [];
  });
}

/** The tile of a number; null where there is none, or it cannot be used, which is in the report. */
export function findTile(reader: Reader, tilesets: Tileset[], gid: number): Tile | null {
  const number = gid & NUMBER;
  let best: Tileset | null = null;
  for (const one of tilesets)
    if (one.first <= number && (!best || one.first > best.first)) best = one;
  const tileset = best && contentOf(reader, best);
  if (!best || !tileset) return null;
  const id = number - best.first;
  const json = entryOf(tileset, id);
  const width = sideOf(tileset, json, "width", "imagewidth", "tilewidth");
  const height = sideOf(tileset, json, "height", "imageheight", "tileheight");
  if (width === 0 || height === 0) {
    const name = typeof tileset.name === "string" ? tileset.name : "";
    reader.report.add("skip", 0, `tileset '${name}': tile ${id} has no size`);
    return null;
  }
  const text = (name: string) => {
    const value = tileset[name];
    return typeof value === "string" ? value : "";
  };
  let anchor = text("objectalignment") || "bottomleft";
  if (anchor === "unspecified") anchor = "bottomleft";
  return {
    tileset,
    json,
    id,
    width,
    height,
    offsetX: shiftOf(tileset, "x"),
    offsetY: shiftOf(tileset, "y"),
    anchorX: anchor.includes("left") ? 0 : anchor.includes("right") ? 1 : 0.5,
    anchorY: anchor.includes("top") ? 0 : anchor.includes("bottom") ? 1 : 0.5,
    fillsCell: text("tilerendersize") === "grid",
    keepsAspect: text("fillmode") === "preserve-aspect-fit",
  };
}

/** The tileset, from its entry or its own file; null, with a problem in the report. */
function contentOf({ library, report }: Reader, { json, path }: Tileset): JsonRecord | null {
  if (json.source === undefined) return json;
  return library.open(report, path, json.source, "tileset")?.json ?? null;
}

/** The entry of a tile in its tileset, which only tiles with properties or shapes have. */
function entryOf(tileset: JsonRecord, id: number): JsonRecord | undefined {
  const tiles = Array.isArray(tileset.tiles) ? tileset.tiles : [];
  return tiles.filter(isRecord).find((tile) => tile.id === id);
}

/** A field that is a length in pixels, 0.001 to a million; else 0. */
function lengthOf(json: Json, name: string): number {
  const value = isRecord(json) ? json[name] : undefined;
  return typeof value === "number" && value >= 1e-3 && value <= 1e6 ? value : 0;
}

/**
 * Width or height of a tile: of the part of a picture that it shows, of its own picture, or of the
 * tiles of the tileset's picture; 0 where no field says it. The last three arguments are the names
 * of these fields.
 */
function sideOf(
  tileset: JsonRecord,
  tile: JsonRecord | undefined,
  part: string,
  picture: string,
  piece: string,
): number {
  const own = lengthOf(tile, part) || lengthOf(tile, picture) || lengthOf(tile?.image, part);
  return own || lengthOf(tileset, piece);
}

/** The drawing offset of a tileset along an axis, pixels; 0 where it has none. */
function shiftOf({ tileoffset }: JsonRecord, axis: string): number {
  const value = isRecord(tileoffset) ? tileoffset[axis] : undefined;
  return typeof value === "number" && Math.abs(value) <= 1e6 ? value : 0;
}

// ---- what collides ----

/** The forms with which a tile collides. */
export interface TileForms {
  /**
   * open: a property says that the tile does not collide. unmarked: nothing says whether it does,
   * so that it does not. solid: it collides; `forms` is empty where all of them were refused.
   */
  solid: "open" | "unmarked" | "solid";
  /** The properties of the tile's body. */
  physics: Physics | null;
  forms: Form[];
}

/**
 * The forms of a tile that is drawn at width by height pixels, relative to its middle: its
 * collision shapes, or else a box if it is solid. The chain of `v` has the layers, the tileset, the
 * tile's entry if it has one (`outer` links up to here) and, for a tile object, template and
 * object.
 */
export function readTileForms(
  reader: Reader,
  v: Values,
  tile: Tile,
  gid: number,
  width: number,
  height: number,
  outer: number,
): TileForms {
  const { chain } = v;
  const solid = flagOf(solidOf(chain, tile, outer));
  if (solid === false) return { solid: "open", physics: null, forms: [] };
  const group = tile.json?.objectgroup;
  const objects = isRecord(group) && Array.isArray(group.objects) ? group.objects : [];
  const isObject = chain.length > outer;
  const hasBody = v.find("body") !== undefined || v.find("bodyType") !== undefined;
  if (objects.length === 0 && solid === null && !(isObject && hasBody) && !reader.allSolid)
    return { solid: "unmarked", physics: null, forms: [] };
  const whole = v.within(chain);
  const physics = readPhysics(whole);
  if (whole.bad) return { solid: "solid", physics: null, forms: [] };
  if (objects.length === 0) {
    const { material } = physics;
    const box = form("box", { hx: width * 0.5, hy: height * 0.5, material });
    return { solid: "solid", physics, forms: [box] };
  }
  const forms = objects.flatMap((value) => {
    const object = isRecord(value) ? value : {};
    // Properties of a collision shape override those of its tile; a tile object overrides both.
    const own = v.within([...chain.slice(0, outer), object, ...chain.slice(outer)]);
    return readShape(own, object, gid, tile, width, height);
  });
  return { solid: "solid", physics, forms };
}

/**
 * The property `solid` that decides for a tile: that of the object, else of its layer, the tile, or
 * its tileset.
 */
function solidOf(chain: readonly JsonRecord[], tile: Tile, outer: number): Json {
  const layer = chain[outer - (tile.json ? 3 : 2)];
  const places = [...chain.slice(outer).reverse(), layer, tile.json, tile.tileset];
  for (const place of places) {
    const solid = place && ownProperty(place, "solid");
    if (solid !== undefined) return solid;
  }
  return undefined;
}

/** What an object is that cannot be a collision shape, for the message; null where it can. */
function noShape(object: JsonRecord): string | null {
  if (object.gid !== undefined) return "a tile";
  if (object.template !== undefined) return "an object from a template";
  if (object.text !== undefined) return "a text";
  if (object.capsule !== undefined) return "a capsule";
  return object.point !== undefined ? "a point" : null;
}

/** The forms of one collision shape, turned, flipped and scaled like the tile. */
function readShape(
  v: Values,
  object: JsonRecord,
  gid: number,
  tile: Tile,
  width: number,
  height: number,
): Form[] {
  const what = noShape(object);
  if (what) {
    v.complain("skip", `${what} is no collision shape that can be modelled`);
    return [];
  }
  const x = v.required(object, "x", -FAR, FAR);
  const y = v.required(object, "y", -FAR, FAR);
  const degrees = v.optional(object, "rotation", 0, -DEGREES, DEGREES);
  const { material, approximate } = readPhysics(v);
  const forms = v.bad ? null : readForms(v, object);
  const turned = isTurned(gid);
  const [w, h] = turned ? [tile.height, tile.width] : [tile.width, tile.height];
  return (forms ?? []).filter((f) => {
    turnForm(f, x, y, degrees);
    flipForm(f, gid, tile.width, tile.height);
    if (!scaleForm(v, f, width / w, height / h)) return false;
    f.x = f.x - width * 0.5;
    f.y = f.y - height * 0.5;
    f.material = material;
    f.approximate = approximate;
    return true;
  });
}

/** Whether the tile number has the diagonal flip, which exchanges width and height. */
export function isTurned(gid: number): boolean {
  return (gid & 0x20000000) !== 0;
}
