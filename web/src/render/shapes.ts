/**
 * What there is to draw: the world's shapes, read once after shapes came or went. The arrays are
 * copies, because those of the package are views that the next call may move.
 */
import { type BodyId, SHAPE_KINDS, type ShapeId, type Terrain, type World } from "thud";

/** Numbers a row, as in ShapeTable.rows of the package. */
export const ROW = 10;
export const CIRCLE = SHAPE_KINDS.indexOf("circle");
const TERRAIN = SHAPE_KINDS.indexOf("terrain");
export const STATIC = 0;
export const DYNAMIC = 2;

export interface PlacedTerrain {
  shape: ShapeId;
  x: number;
  y: number;
  terrain: Terrain;
}

export interface Shapes {
  /** Circles and boxes only. */
  rows: Float32Array;
  /** Of each row: its place in the world's own table, which its awake flags follow. */
  source: Uint32Array;
  count: number;
  /** Another array after the ground was dug. */
  terrains: PlacedTerrain[];
  /** The slot that ends the bodies. */
  slots: number;
  /** Dynamic bodies, and by slot the place of each among them. */
  moving: number;
  order: Uint32Array;
  /** Of a typical moving body: half its width; 0 where nothing moves. */
  typicalSize: number;
}

/** Of all bodies but `hidden`. */
export function readShapes(world: World, hidden?: BodyId): Shapes {
  const table = world.shapeTable();
  const all = table.rows.slice();
  const handles = table.handles.slice();
  const rows = new Float32Array(table.count * ROW);
  const source = new Uint32Array(table.count);
  const terrains: PlacedTerrain[] = [];
  const sizes: number[] = [];
  let count = 0;
  let slots = 0;
  for (let i = 0; i < table.count; i++) {
    const row = all.subarray(i * ROW, (i + 1) * ROW);
    slots = Math.max(slots, row[0] + 1);
    if (row[1] === TERRAIN) {
      terrains.push(readTerrain(world, handles.subarray(4 * i, 4 * i + 4)));
      continue;
    }
    if (row[0] === hidden?.index) continue;
    if (row[2] === DYNAMIC) sizes.push(row[6]);
    rows.set(row, count * ROW);
    source[count++] = i;
  }
  const order = new Uint32Array(slots);
  for (let i = 0; i < count; i++) if (rows[i * ROW + 2] === DYNAMIC) order[rows[i * ROW]] = 1;
  let moving = 0;
  for (let slot = 0; slot < slots; slot++) if (order[slot] !== 0) order[slot] = moving++;
  sizes.sort((a, b) => a - b);
  return {
    rows: rows.subarray(0, count * ROW),
    source: source.subarray(0, count),
    count,
    terrains,
    slots,
    moving,
    order,
    typicalSize: sizes.length > 0 ? sizes[sizes.length >> 1] : 0,
  };
}

function readTerrain(world: World, handles: Uint32Array): PlacedTerrain {
  const [shape1, shapeGeneration, body1, bodyGeneration] = handles;
  const shape = { kind: "shape", index: shape1 - 1, generation: shapeGeneration } as const;
  const body = { kind: "body", index: body1 - 1, generation: bodyGeneration } as const;
  const [x, y] = world.bodyState(body).position;
  return { shape, x, y, terrain: world.terrain(shape) };
}
