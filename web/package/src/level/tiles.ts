/**
 * Reads the tile layers of a Tiled map: each tile that collides becomes a static body. Whether it
 * does is decided by the property `solid` of the layer, else of the tile, else of its tileset.
 * Where none has it, a tile with shapes from Tiled's collision editor collides with these, and a
 * tile without is decoration. The same arithmetic as demo/level/tiles.c.
 */
import type { Layer, Reader } from "../level.js";
import { type Cells, readCells } from "./cells.js";
import type { Form } from "./form.js";
import { addBody, NUMBER, settleForms, TOO_FAR, TOO_MANY } from "./forms.js";
import { findTile, isTurned, readTileForms, type Tile } from "./tilesets.js";
import { flagOf, ownProperty, type Physics, Values } from "./values.js";

/** What a tile number of this layer stands for. Lengths are pixels. */
interface TileKind {
  /** Whether the number is that of a tile in a tileset that can be used. */
  known: boolean;
  /** See TileForms. */
  solid: "open" | "unmarked" | "solid";
  physics: Physics | null;
  forms: Form[];
  /** Whether a box of the tile that is no sensor covers the whole cell. */
  full: boolean;
  /** Whether a form of the tile is a ground line. */
  hasGround: boolean;
  /** The smallest y, from the cell's lower edge, of the lower sides of its ground polygons. */
  foot: number;
  /** From the cell's lower left corner to the tile's middle. */
  dx: number;
  dy: number;
}

/** Reads all tiles of a layer. */
export async function readTiles(reader: Reader, layer: Layer): Promise<void> {
  if (flagOf(ownProperty(layer.json, "solid")) === false) return;
  const cells = await readCells(reader, layer);
  if (!cells) return;
  const kinds = new Map<number, TileKind>();
  const kindAt = (i: number, j: number): TileKind | null => {
    const gid = cells.at[j * cells.width + i];
    if ((gid & NUMBER) === 0) return null;
    let kind = kinds.get(gid);
    if (!kind) kinds.set(gid, (kind = readKind(reader, layer, gid)));
    return kind;
  };
  let used = 0;
  let colliding = 0;
  let unknown = 0;
  let unmarked = 0;
  let ungrounded = 0;
  let far = 0;
  let many = 0;
  let floors: number[] | null = null;
  for (let j = 0; j < cells.height; j++) {
    for (let i = 0; i < cells.width; i++) {
      const kind = kindAt(i, j);
      if (!kind) continue;
      used++;
      if (!kind.known) unknown++;
      if (kind.known && kind.solid === "unmarked") unmarked++;
      if (kind.solid === "solid") colliding++;
      if (kind.hasGround) floors ??= findFloors(layer, cells, kindAt);
      const onFloor = kind.hasGround && floors !== null && j + 1 >= floors[i];
      const grounded = onFloor && kind.foot >= -1e-3 * reader.tileHeight;
      if (kind.hasGround && !grounded) ungrounded++;
      const left = addTile(reader, layer, kind, cells.column + i, cells.row + j, grounded);
      if (left === "far") far++;
      if (left === "many") many++;
    }
  }
  reader.unmarked += unmarked;
  const say = (severity: "skip" | "note", what: string) =>
    reader.report.add(severity, 0, `layer '${layer.name}': ${what}`);
  if (ungrounded > 0) {
    const rule = "all below them, down to the map's lower edge, would have to be solid";
    say("skip", `the polygons of ${ungrounded} tiles are no ground: ${rule}`);
  }
  if (far > 0) say("skip", `the places of ${far} tiles are ${TOO_FAR}`);
  if (many > 0) say("skip", `${many} tiles are left out: ${TOO_MANY}`);
  if (unknown > 0) say("skip", `${unknown} tiles belong to no tileset that can be used`);
  if (used > 0 && colliding === 0 && unknown < used)
    say("note", `none of its ${used} tiles is solid`);
}

/**
 * Adds the body of a tile in a cell of the map, if it has one. `grounded`: with its ground lines.
 * Returns why something of it is left out, as addBody does.
 */
function addTile(
  reader: Reader,
  layer: Layer,
  { physics, forms, dx, dy }: TileKind,
  column: number,
  row: number,
  grounded: boolean,
): ReturnType<typeof addBody> {
  const x = layer.ox + column * reader.tileWidth + dx;
  const y = layer.oy + (row + 1) * reader.tileHeight + dy;
  return physics && addBody(reader, physics, 0, forms, grounded, x, y, 0);
}

/** Reads what a tile number stands for; problems are in the report. */
function readKind(reader: Reader, layer: Layer, gid: number): TileKind {
  const none = { solid: "open" as const, physics: null, forms: [], full: false };
  const kind: TileKind = { ...none, known: false, hasGround: false, foot: Infinity, dx: 0, dy: 0 };
  const tile = findTile(reader, reader.tilesets, gid);
  if (!tile) return kind;
  kind.known = true;
  const { tileset, json } = tile;
  const name = typeof tileset.name === "string" ? tileset.name : "";
  const where = json ? `layer '${layer.name}', tile ${tile.id} of '${name}'` : `layer '${layer.name}'`;
  const chain = json ? [...layer.chain, tileset, json] : [...layer.chain, tileset];
  const v = new Values(reader.report, chain, 0, where);
  const turned = isTurned(gid);
  const [w, h] = turned ? [tile.height, tile.width] : [tile.width, tile.height];
  const width = tile.fillsCell ? reader.tileWidth : w;
  const height = tile.fillsCell ? reader.tileHeight : h;
  if (isSqueezed(tile, width, height, w, h)) {
    v.complain("skip", "its picture neither fills the cell nor has its own size");
    return kind;
  }
  const read = readTileForms(reader, v, tile, gid, width, height, chain.length);
  kind.solid = read.solid;
  kind.dx = tile.offsetX * (width / w) + width * 0.5;
  kind.dy = tile.offsetY * (height / h) - height * 0.5;
  if (!read.physics) return kind;
  const { velocity: _, angularVelocity: __, ...body } = read.physics.body;
  kind.physics = { ...read.physics, kind: "static", body: { ...body, kind: "static" } };
  kind.forms = settleForms(reader, v, kind.physics, read.forms, 0, -Infinity);
  for (const f of kind.forms) {
    if (!f.points && covers(reader, f, kind)) kind.full = true;
    if (f.ground) kind.foot = Math.min(kind.foot, f.y + f.foot + kind.dy);
    if (f.ground) kind.hasGround = true;
  }
  return kind;
}

/**
 * Whether a tile is to fill its cell and to keep its aspect ratio although the two differ. `w`,
 * `h`: the size of its picture.
 */
function isSqueezed(tile: Tile, width: number, height: number, w: number, h: number): boolean {
  const askew = Math.abs(width * h - height * w) > 1e-3 * (width * h);
  return tile.fillsCell && tile.keepsAspect && askew;
}

/** Whether a form of a tile is a box that covers the tile's cell, within a thousandth of it. */
function covers({ tileWidth, tileHeight }: Reader, f: Form, { dx, dy }: TileKind): boolean {
  const near = 1e-3 * Math.max(tileWidth, tileHeight);
  const x = f.x + (dx - tileWidth * 0.5);
  const y = f.y + (dy + tileHeight * 0.5);
  return (
    f.kind === "box" &&
    f.rotation === 0 &&
    f.material.sensor !== true &&
    Math.abs(x) + tileWidth * 0.5 <= f.hx + near &&
    Math.abs(y) + tileHeight * 0.5 <= f.hy + near
  );
}

/**
 * For each column the first row from which all cells down to the last row are full. Ground lines
 * are allowed directly above that row only, since all below a terrain's line is solid.
 */
function findFloors(
  layer: Layer,
  { at, width, height }: Cells,
  kindAt: (i: number, j: number) => TileKind | null,
): number[] {
  let last = height;
  const isEmpty = (row: number) => at.subarray(row * width, (row + 1) * width).every((gid) => gid === 0);
  if (Array.isArray(layer.json.chunks)) while (last > 0 && isEmpty(last - 1)) last--;
  return Array.from({ length: width }, (_, i) => {
    let row = last;
    while (row > 0 && kindAt(i, row - 1)?.full) row--;
    return row;
  });
}
