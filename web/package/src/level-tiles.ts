/**
 * Tile layers of a Tiled map: a static AABB for every solid tile. The property `solid` of the
 * layer decides for all its tiles; where it has none, that of the tile decides, then that of its
 * tileset; without any a tile is decoration.
 */
import type { Layer, Reader } from "./level.js";
import {
  grid,
  isRecord,
  type Json,
  type JsonRecord,
  ownProperty,
  type Physics,
  readPhysics,
  Values,
} from "./level-values.js";

const MOST_CELLS = 2 ** 26;

/** The upper bits of a cell tell how the tile is flipped, which a box does not show. */
const GID_BITS = 0x0fffffff;

/** What one tile number stands for. */
interface TileKind {
  gid: number;
  known: boolean;
  solid: boolean;
  /** Null where its properties cannot be used. */
  physics: Physics | null;
}

export function readTiles(reader: Reader, layer: Layer): void {
  const { json } = layer;
  if (ownProperty(json, "solid") === false) return;
  const { data } = json;
  const complain = (what: string) => reader.report.add("skip", 0, `layer '${layer.name}': ${what}`);
  if (!Array.isArray(data)) {
    complain(
      "has no plain list of tiles; save the map with the tile layer format CSV, not infinite",
    );
    return;
  }
  const v = new Values(reader.report, layer.chain, 0, layer.name);
  const width = v.required(json, "width", 1, 1e6);
  const height = v.required(json, "height", 1, 1e6);
  if (v.bad) return;
  const whole = Number.isInteger(width) && Number.isInteger(height);
  if (!whole || width * height > MOST_CELLS || width * height !== data.length) {
    complain(`${data.length} tiles do not fill its ${width} columns and ${height} rows`);
    return;
  }
  readCells(reader, layer, data, width);
}

function readCells(reader: Reader, layer: Layer, data: Json[], width: number): void {
  let kind: TileKind = { gid: 0, known: false, solid: false, physics: null };
  let used = 0;
  let solid = 0;
  let unknown = 0;
  let malformed = 0;
  data.forEach((cell, at) => {
    if (typeof cell !== "number" || !(cell >= 0 && cell <= 0xffffffff)) {
      malformed++;
      return;
    }
    const gid = Math.floor(cell) & GID_BITS;
    if (gid === 0) return;
    used++;
    if (gid !== kind.gid) kind = readKind(reader, layer, gid);
    if (!kind.known) unknown++;
    if (kind.solid) solid++;
    if (kind.solid && kind.physics)
      addTile(reader, layer, kind.physics, at % width, Math.floor(at / width));
  });
  const say = (severity: "skip" | "note", what: string) =>
    reader.report.add(severity, 0, `layer '${layer.name}': ${what}`);
  if (malformed > 0) say("skip", `${malformed} cells are no tile numbers`);
  if (unknown > 0)
    say("skip", `${unknown} tiles belong to no tileset that is embedded in the map`);
  if (used > 0 && solid === 0) say("note", `none of its ${used} tiles is solid`);
}

function addTile(
  reader: Reader,
  layer: Layer,
  { body, material }: Physics,
  column: number,
  row: number,
): void {
  const { pixelsPerUnit: ppu, tileWidth, tileHeight, mapHeight } = reader;
  const x = (layer.ox + (column + 0.5) * tileWidth) / ppu;
  const y = (mapHeight - (layer.oy + (row + 0.5) * tileHeight)) / ppu;
  reader.level.bodies.push({
    body: { ...body, position: [grid(x), grid(y)] },
    material,
    shape: {
      kind: "aabb",
      halfWidth: (tileWidth * 0.5) / ppu,
      halfHeight: (tileHeight * 0.5) / ppu,
    },
  });
}

function readKind(reader: Reader, layer: Layer, gid: number): TileKind {
  const found = tilesetOf(reader.tilesets, gid);
  if (!found || found.tileset.source !== undefined)
    return { gid, known: false, solid: false, physics: null };
  const { tileset, first } = found;
  const tile = tileOf(tileset, gid - first);
  const solid =
    ownProperty(layer.json, "solid") ??
    (tile && ownProperty(tile, "solid")) ??
    ownProperty(tileset, "solid");
  if (solid !== true) return { gid, known: true, solid: false, physics: null };
  const chain = tile ? [...layer.chain, tileset, tile] : [...layer.chain, tileset];
  const v = new Values(reader.report, chain, 0, layer.name);
  const physics = readPhysics(v);
  const { velocity: _, angularVelocity: __, ...body } = physics.body;
  let bad = v.bad;
  if (tileset.tilewidth !== reader.tileWidth || tileset.tileheight !== reader.tileHeight) {
    const what = "its tiles are not of the size of the map's cells";
    reader.report.add("skip", 0, `layer '${layer.name}': ${what}`);
    bad = true;
  }
  const fixed: Physics = { ...physics, kind: "static", body: { ...body, kind: "static" } };
  return { gid, known: true, solid: true, physics: bad ? null : fixed };
}

/** The embedded tileset that a tile number belongs to: the one that begins last before it. */
function tilesetOf(tilesets: Json, gid: number): { tileset: JsonRecord; first: number } | null {
  let best: { tileset: JsonRecord; first: number } | null = null;
  for (const tileset of Array.isArray(tilesets) ? tilesets : []) {
    if (!isRecord(tileset)) continue;
    const first = tileset.firstgid;
    if (typeof first === "number" && first >= 1 && first <= gid && first > (best?.first ?? 0))
      best = { tileset, first: Math.floor(first) };
  }
  return best;
}

/** The entry of a tile in its tileset, which only tiles with something to say have. */
function tileOf(tileset: JsonRecord, local: number): JsonRecord | undefined {
  const tiles = Array.isArray(tileset.tiles) ? tileset.tiles : [];
  return tiles.filter(isRecord).find((tile) => tile.id === local);
}
