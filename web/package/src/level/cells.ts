/**
 * Reads the tile numbers of a layer in all forms that the file format has: a list, text with
 * commas, or base64, compressed or not; for the whole layer or, in infinite maps, in chunks.
 */
import type { Layer, Reader } from "../level.js";
import { isRecord, type Json, type JsonRecord, numberOf, Values } from "./values.js";
import { unpack } from "./unpack.js";

/**
 * The maximum number of cells of all layers of a map. Chosen: 4096 by 4096; their numbers take 64
 * MiB, and as much again while they are unpacked.
 */
export const MOST_CELLS = 2 ** 24;

/** The cells of a layer; of an infinite map the smallest rectangle that contains all its chunks. */
export interface Cells {
  /** Tile numbers with their flip bits, row by row; 0: empty. */
  at: Uint32Array;
  width: number;
  height: number;
  /** The column and row of the first cell in the map. */
  column: number;
  row: number;
}

/** A rectangle of cells. */
interface Area {
  column: number;
  row: number;
  width: number;
  height: number;
}

/** The cells of a layer, or null, with a problem in the report. */
export async function readCells(reader: Reader, layer: Layer): Promise<Cells | null> {
  const { json } = layer;
  if (Array.isArray(json.chunks)) return readChunks(reader, layer, json.chunks);
  if (!Array.isArray(json.data) && typeof json.data !== "string") {
    complain(reader, layer, "has no tiles");
    return null;
  }
  const area = readArea(reader, layer, json, false);
  const cells = area && makeRoom(reader, layer, area);
  return cells && (await readNumbers(reader, layer, json.data, cells)) ? cells : null;
}

/** Reports a problem of the layer, which is left out. */
function complain(reader: Reader, layer: Layer, what: string): void {
  reader.report.add("skip", 0, `layer '${layer.name}': ${what}`);
}

/** The cells of all chunks, or null, with a problem in the report. Wrong chunks are left out. */
async function readChunks(reader: Reader, layer: Layer, chunks: Json[]): Promise<Cells | null> {
  let all: Area | null = null;
  const areas: { chunk: JsonRecord; area: Area }[] = [];
  for (const value of chunks) {
    const chunk = isRecord(value) ? value : {};
    const area = readArea(reader, layer, chunk, true);
    if (!area) return null;
    areas.push({ chunk, area });
    all = all ? around(all, area) : area;
  }
  if (!all) return { at: new Uint32Array(0), width: 0, height: 0, column: 0, row: 0 };
  const cells = makeRoom(reader, layer, all);
  if (!cells) return null;
  for (const { chunk, area } of areas) {
    const own = makeRoom(reader, layer, area);
    if (!own || !(await readNumbers(reader, layer, chunk.data, own))) continue;
    for (let j = 0; j < own.height; j++) {
      const row = own.at.subarray(j * own.width, (j + 1) * own.width);
      const at = (own.row - cells.row + j) * cells.width + own.column - cells.column;
      cells.at.set(row, at);
    }
  }
  return cells;
}

/** The rectangle of a layer or a chunk (`placed`); null, with a problem in the report. */
function readArea(reader: Reader, layer: Layer, json: JsonRecord, placed: boolean): Area | null {
  const v = new Values(reader.report, layer.chain, 0, layer.name);
  const column = placed ? v.required(json, "x", -1e6, 1e6) : 0;
  const row = placed ? v.required(json, "y", -1e6, 1e6) : 0;
  const width = v.required(json, "width", 1, 1e6);
  const height = v.required(json, "height", 1, 1e6);
  if (v.bad) return null;
  if ([column, row, width, height].every(Number.isInteger)) return { column, row, width, height };
  complain(reader, layer, "its columns and rows are no whole numbers");
  return null;
}

/** The smallest rectangle that contains both. */
function around(a: Area, b: Area): Area {
  const column = Math.min(a.column, b.column);
  const row = Math.min(a.row, b.row);
  const width = Math.max(a.column + a.width, b.column + b.width) - column;
  const height = Math.max(a.row + a.height, b.row + b.height) - row;
  return { column, row, width, height };
}

/** Empty cells for a rectangle; null, with a problem in the report, where there are too many. */
function makeRoom(reader: Reader, layer: Layer, area: Area): Cells | null {
  const count = area.width * area.height;
  if (count > reader.cells) {
    complain(reader, layer, `this map has more cells than are read, ${MOST_CELLS} in all`);
    return null;
  }
  reader.cells -= count;
  return { ...area, at: new Uint32Array(count) };
}

/** Reads the numbers of a layer or a chunk to `at`; false, with a problem in the report. */
async function readNumbers(
  reader: Reader,
  layer: Layer,
  data: Json,
  { at, width, height }: Cells,
): Promise<boolean> {
  const { encoding = "csv", compression } = layer.json;
  if (!Array.isArray(data) && typeof data !== "string") {
    complain(reader, layer, "has no tiles");
    return false;
  }
  if (typeof data === "string" && encoding === "base64") {
    const packed = typeof compression === "string" ? compression : "";
    const bytes = await unpack(data, packed, 4 * at.length);
    if (typeof bytes === "string") {
      complain(reader, layer, `its tiles ${bytes}`);
      return false;
    }
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    for (let i = 0; i < at.length; i++) at[i] = view.getUint32(4 * i, true);
    return true;
  }
  if (typeof data === "string" && encoding !== "csv") {
    complain(reader, layer, "its tiles are written in a way that is not known");
    return false;
  }
  const cells: Json[] = typeof data === "string" ? wordsOf(data).map(numberOf) : data;
  if (cells.length !== at.length) {
    complain(reader, layer, `${cells.length} tiles do not fill its ${width} columns and ${height} rows`);
    return false;
  }
  let malformed = 0;
  cells.forEach((cell, i) => {
    if (Number.isInteger(cell) && (cell as number) >= 0 && (cell as number) <= 0xffffffff) at[i] = cell as number;
    else malformed++;
  });
  if (malformed > 0) complain(reader, layer, `${malformed} cells are no tile numbers`);
  return true;
}

/** The words of a text with commas or white space between them. */
function wordsOf(text: string): string[] {
  return text.split(/[, \t\r\n]+/).filter((word) => word !== "");
}
