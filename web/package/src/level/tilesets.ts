/**
 * What a tile number stands for, and what of that tile collides. Follows demo/level/tilesets.c.
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
  /** The first tile number. */
  first: number;
  /** Itself, or what tells its file. */
  json: JsonRecord;
  /** Of the file that this stands in, "" for the map's own. */
  path: string;
}

/** A tile as it lies in a map. */
export interface Tile {
  tileset: JsonRecord;
  /** The tile's own entry. */
  json: JsonRecord | undefined;
  id: number;
  /** Of its picture, pixels. */
  width: number;
  height: number;
  /** Of the tileset, likewise. */
  offsetX: number;
  offsetY: number;
  /** Of tile objects, as a fraction of the picture. */
  anchorX: number;
  anchorY: number;
  /** In a layer drawn as large as a cell of the map. */
  fillsCell: boolean;
  /** But no wider or higher than the picture is. */
  keepsAspect: boolean;
}

export function listTilesets(list: Json, path: string): Tileset[] {
  if (!Array.isArray(list)) return [];
  return list.filter(isRecord).flatMap((json): Tileset[] => {
    const first = json.firstgid;
    return typeof first === "number" && first >= 1 ? [{ first: Math.floor(first), json, path }] : [];
  });
}

/** Null: there is none, or it cannot be used, which is reported. */
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

/** The tileset itself, wherever it stands; null after a report. */
function contentOf({ library, report }: Reader, { json, path }: Tileset): JsonRecord | null {
  if (json.source === undefined) return json;
  return library.open(report, path, json.source, "tileset")?.json ?? null;
}

/** The entry of a tile in its tileset, which only tiles with something to say have. */
function entryOf(tileset: JsonRecord, id: number): JsonRecord | undefined {
  const tiles = Array.isArray(tileset.tiles) ? tileset.tiles : [];
  return tiles.filter(isRecord).find((tile) => tile.id === id);
}

/** A length in pixels, or 0. */
function lengthOf(json: Json, name: string): number {
  const value = isRecord(json) ? json[name] : undefined;
  return typeof value === "number" && value >= 1e-3 && value <= 1e6 ? value : 0;
}

/** Of a part of a picture, a picture of its own, or a piece of the tileset's; 0 if nothing tells. */
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

function shiftOf({ tileoffset }: JsonRecord, axis: string): number {
  const value = isRecord(tileoffset) ? tileoffset[axis] : undefined;
  return typeof value === "number" && Math.abs(value) <= 1e6 ? value : 0;
}

// ---- what collides ----

export interface TileForms {
  /**
   * open: something says that it does not collide; unmarked: nothing says whether it does, so that
   * it does not; solid: it does, with no forms if all of them were reported.
   */
  solid: "open" | "unmarked" | "solid";
  /** Of the body. */
  physics: Physics | null;
  forms: Form[];
}

/**
 * The forms of a tile drawn as large as told, about its middle: its collision shapes, else a box if
 * something says that it is solid. The chain of `v` has the layer, the tileset, the tile's own
 * entry if it has one (`outer` links up to here), and, of a tile object, what it is.
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
    // A collision shape knows better than its tile; what a tile object says goes before both.
    const own = v.within([...chain.slice(0, outer), object, ...chain.slice(outer)]);
    return readShape(own, object, gid, tile, width, height);
  });
  return { solid: "solid", physics, forms };
}

/** What says whether a tile is solid: the object, else its layer, the tile, its tileset. */
function solidOf(chain: readonly JsonRecord[], tile: Tile, outer: number): Json {
  const layer = chain[outer - (tile.json ? 3 : 2)];
  const places = [...chain.slice(outer).reverse(), layer, tile.json, tile.tileset];
  for (const place of places) {
    const solid = place && ownProperty(place, "solid");
    if (solid !== undefined) return solid;
  }
  return undefined;
}

/** What an object of a tile's collision shapes is that none can be. */
function noShape(object: JsonRecord): string | null {
  if (object.gid !== undefined) return "a tile";
  if (object.template !== undefined) return "an object from a template";
  if (object.text !== undefined) return "a text";
  if (object.capsule !== undefined) return "a capsule";
  return object.point !== undefined ? "a point" : null;
}

/** One collision shape as the tile lies. */
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
  const { material } = readPhysics(v);
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
    return true;
  });
}

/** Whether a tile's number says that its width and height change places. */
export function isTurned(gid: number): boolean {
  return (gid & 0x20000000) !== 0;
}
