/** Objects of a Tiled map: rectangles, circles, terrain lines and spawn points. */
import type { Layer, Reader } from "./level.js";
import { grid, isRecord, type Json, type JsonRecord, readPhysics, Values } from "./level-values.js";
import type { Vec2 } from "./types.js";

/** Pixels beyond which a map is absurd, and the same for degrees. */
const FAR = 1e9;
const DEGREES = 1e6;

/** Sizes, in length scales, between which the engine takes them with room for rounding. */
const SMALLEST = 2e-4;
const LARGEST = 16000;

const RADIANS = 0.017453292519943295;

interface Placement {
  x: number;
  y: number;
  width: number;
  height: number;
  c: number;
  s: number;
  /** Degrees, in [-180, 180). */
  rotation: number;
}

/**
 * Cosine and sine of a rotation in degrees by Taylor series on the nearest quarter turn: the same
 * bits as level_turn in demo/level/turn.c, which Math.cos does not promise.
 */
export function turn(degrees: number): { r: number; c: number; s: number } {
  const r = degrees - 360 * Math.floor(degrees / 360 + 0.5);
  const q = Math.floor(r / 90 + 0.5);
  const a = (r - 90 * q) * RADIANS;
  const z = a * a;
  const series = (divisors: number[]) => divisors.reduceRight((sum, d) => 1 / d + z * sum, 0);
  const sine = a * series([1, -6, 120, -5040, 362880, -39916800, 6227020800, -1307674368000]);
  const cosine = series([1, -2, 24, -720, 40320, -3628800, 479001600, -87178291200]);
  if (q === 0) return { r, c: cosine, s: sine };
  if (q === 1) return { r, c: -sine, s: cosine };
  if (q === -1) return { r, c: sine, s: -cosine };
  return { r, c: -cosine, s: -sine };
}

export function readObject(reader: Reader, layer: Layer, object: JsonRecord): void {
  const { id } = object;
  if (typeof id !== "number" || !(id >= 1 && id <= 0xffffffff)) {
    reader.report.add("skip", 0, `layer '${layer.name}': an object has no valid id`);
    return;
  }
  const v = new Values(reader.report, [...layer.chain, object], Math.floor(id), "");
  reader.report.noteUnknown(object, v.object, "");
  const what = unsupported(object);
  if (what) {
    reader.report.add("skip", v.object, `${what} cannot be modelled`);
    return;
  }
  const place = readPlacement(v, layer, object);
  if (v.bad) return;
  if (object.point === true) readPoint(reader, v, place, object);
  else if (object.polyline !== undefined) addTerrain(reader, v, place, object.polyline);
  else if (object.ellipse === true) addEllipse(reader, v, place);
  else addBoxOrCircle(reader, v, place, false);
}

/** What an object is that no shape of the engine can be. */
function unsupported(object: JsonRecord): string | null {
  if (object.template !== undefined) return "an object from a template";
  if (object.gid !== undefined) return "a tile object";
  if (object.text !== undefined) return "a text";
  if (object.polygon !== undefined) return "a polygon";
  if (object.capsule !== undefined) return "a capsule";
  return null;
}

function readPlacement(v: Values, layer: Layer, object: JsonRecord): Placement {
  const optional = (name: string, low: number, high: number) =>
    object[name] === undefined ? 0 : v.required(object, name, low, high);
  const x = layer.ox + v.required(object, "x", -FAR, FAR);
  const y = layer.oy + v.required(object, "y", -FAR, FAR);
  const width = optional("width", 0, FAR);
  const height = optional("height", 0, FAR);
  const { r, c, s } = turn(optional("rotation", -DEGREES, DEGREES));
  return { x, y, width, height, c, s, rotation: r };
}

function addBoxOrCircle(reader: Reader, v: Values, p: Placement, circle: boolean): void {
  const { pixelsPerUnit: ppu, level } = reader;
  const hw = p.width * 0.5;
  const hh = p.height * 0.5;
  const dx = p.c * hw - p.s * hh;
  const dy = p.s * hw + p.c * hh;
  const halfWidth = hw / ppu;
  const halfHeight = hh / ppu;
  const { kind, body, material } = readPhysics(v);
  if (v.bad) return;
  const low = SMALLEST * level.lengthScale;
  const high = LARGEST * level.lengthScale;
  if (!(halfWidth >= low && halfHeight >= low && halfWidth <= high && halfHeight <= high)) {
    const size = `${2 * halfWidth} by ${2 * halfHeight}`;
    reader.report.add("skip", v.object, `its size, ${size} units, is out of range`);
    return;
  }
  const upright = p.rotation === 0 && (kind === "static" || body.fixedRotation === true);
  level.bodies.push({
    body: {
      ...body,
      fixedRotation: upright || body.fixedRotation,
      position: [grid((p.x + dx) / ppu), grid((reader.mapHeight - (p.y + dy)) / ppu)],
      angle: 0 - p.rotation * RADIANS,
      userData: v.object,
    },
    material,
    shape: circle
      ? { kind: "circle", radius: halfWidth }
      : { kind: upright ? "aabb" : "obb", halfWidth, halfHeight },
  });
}

/** Two axes count as equal within a thousandth: the editor rounds what it writes. */
function addEllipse(reader: Reader, v: Values, p: Placement): void {
  if (Math.abs(p.width - p.height) <= 1e-3 * Math.max(p.width, p.height)) {
    addBoxOrCircle(reader, v, p, true);
    return;
  }
  const axes = `${p.width} by ${p.height}`;
  const text = `an ellipse of unequal axes, ${axes}, cannot be modelled; only circles`;
  reader.report.add("skip", v.object, text);
}

function addTerrain(reader: Reader, v: Values, p: Placement, line: Json): void {
  if (!Array.isArray(line) || line.length < 2) {
    reader.report.add("skip", v.object, "a line needs two points at least");
    return;
  }
  const { kind, body, material } = readPhysics(v);
  if (!v.bad && kind !== "static") {
    reader.report.add("skip", v.object, "a line is terrain, which is static");
    return;
  }
  const points = v.bad ? null : readPolyline(reader, v, p, line);
  if (!points) return;
  const { pixelsPerUnit: ppu } = reader;
  reader.level.bodies.push({
    body: {
      ...body,
      position: [grid(p.x / ppu), grid((reader.mapHeight - p.y) / ppu)],
      userData: v.object,
    },
    material,
    shape: { kind: "terrain", points },
  });
}

/** The points from left to right, or null after a report. */
function readPolyline(reader: Reader, v: Values, p: Placement, line: Json[]): Vec2[] | null {
  const { pixelsPerUnit: ppu } = reader;
  const points: Vec2[] = [];
  for (const item of line) {
    const json = isRecord(item) ? item : {};
    const x = v.required(json, "x", -FAR, FAR);
    const y = v.required(json, "y", -FAR, FAR);
    if (v.bad) return null;
    points.push([(p.c * x - p.s * y) / ppu, 0 - (p.s * x + p.c * y) / ppu]);
  }
  if (points[points.length - 1][0] < points[0][0]) points.reverse();
  for (let i = 1; i < points.length; i++) {
    if (points[i][0] > points[i - 1][0]) continue;
    const where = `vertices ${i} and ${i + 1} of ${points.length}, from the left`;
    const rule = "terrain must go on from left to right";
    reader.report.add("skip", v.object, `its line turns back: ${rule} (${where})`);
    return null;
  }
  return points;
}

function readPoint(reader: Reader, v: Values, p: Placement, object: JsonRecord): void {
  const name = object.type === undefined ? object.class : object.type; // `class` in Tiled 1.9
  if (name === "spawn") {
    const { pixelsPerUnit: ppu } = reader;
    reader.level.spawn = [p.x / ppu, (reader.mapHeight - p.y) / ppu];
    return;
  }
  const text = "a point has no meaning here, unless its class is 'spawn'";
  reader.report.add("note", v.object, text);
}
