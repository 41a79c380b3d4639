/**
 * Reads the outlines of objects, moves, flips and scales them, and makes bodies of them. The same
 * arithmetic as demo/level/forms.c.
 */
import type { LevelShape, Reader } from "../level.js";
import { FAR, type Form, form, RADIANS, turn } from "./form.js";
import { approximated, readPolygon, toGround } from "./polygon.js";
import { grid, isRecord, type Json, type JsonRecord, type Physics, type Values } from "./values.js";
import type { Vec2 } from "../types.js";

/**
 * The range of half extents, and the largest offset of a shape from its body, length scales: within
 * that of the engine (1e-4 to 16384) with a margin for rounding.
 */
const SMALLEST = 2e-4;
const LARGEST = 16000;

/** The largest coordinate of a body, length scales, and of a terrain's vertex, units. */
const FARTHEST = 1e9;

/**
 * The maximum number of shapes and vertices of lines that are read of a map. Chosen, as in
 * demo/level/reader.h.
 */
export const MOST_PARTS = 2 ** 20;
export const TOO_MANY = `this map has more shapes and vertices than are read, ${MOST_PARTS} in all`;

/** Follows "its place is" or "the places are" in reports of places that the engine does not accept. */
export const TOO_FAR = "further from the map's lower left corner than 1e9 length scales";

/**
 * The upper bits of a tile number: flips in x, in y, and along the diagonal; the rest is the
 * number.
 */
export const FLIP_X = 0x80000000;
export const FLIP_Y = 0x40000000;
export const FLIP_TURN = 0x20000000;
export const NUMBER = 0x0fffffff;

/** Whether two lengths differ by at most a thousandth, since the editor rounds what it writes. */
function nearlyEqual(a: number, b: number): boolean {
  return Math.abs(a - b) <= 1e-3 * Math.max(Math.abs(a), Math.abs(b));
}

// ---- reading ----

/**
 * The forms of an object that is no tile, point or text, relative to the object's place and without
 * its rotation; null, with a problem in the report.
 */
export function readForms(v: Values, object: JsonRecord): Form[] | null {
  if (object.polyline !== undefined) return readLine(v, object.polyline, false);
  if (object.polygon !== undefined) return readLine(v, object.polygon, true);
  const width = v.optional(object, "width", 0, 0, FAR);
  const height = v.optional(object, "height", 0, 0, FAR);
  if (v.bad) return null;
  const round = object.ellipse === true;
  if (round && !nearlyEqual(width, height)) {
    const axes = `${width} by ${height}`;
    v.complain("skip", `an ellipse of unequal axes, ${axes}, cannot be modelled; only circles`);
    return null;
  }
  const [hx, hy] = [width * 0.5, height * 0.5];
  return [form(round ? "circle" : "box", { x: hx, y: hy, hx, hy })];
}

/** The forms of a polyline, or of a polygon (`closed`); null, with a problem in the report. */
function readLine(v: Values, list: Json, closed: boolean): Form[] | null {
  if (!Array.isArray(list) || list.length < (closed ? 3 : 2)) {
    const what = closed ? "a polygon needs three" : "a line needs two";
    v.complain("skip", `${what} points at least`);
    return null;
  }
  const points: Vec2[] = [];
  for (const item of list) {
    const json = isRecord(item) ? item : {};
    const x = v.required(json, "x", -FAR, FAR);
    const y = v.required(json, "y", -FAR, FAR);
    if (v.bad) return null;
    points.push([x, y]);
  }
  return closed ? readPolygon(points) : [form("line", { points })];
}

// ---- motion ----

/**
 * Turns a form about the origin of its frame, clockwise by degrees, then moves the origin to (x,
 * y).
 */
export function turnForm(f: Form, x: number, y: number, degrees: number): void {
  const { c, s } = turn(degrees);
  [f.x, f.y] = [x + (c * f.x - s * f.y), y + (s * f.x + c * f.y)];
  if (f.points) f.points = f.points.map(([px, py]) => [c * px - s * py, s * px + c * py]);
  else f.rotation = turn(f.rotation + degrees).r;
}

/** Flips a form within a tile of this size (pixels), by the upper bits of the tile number `gid`. */
export function flipForm(f: Form, gid: number, width: number, height: number): void {
  const mirror = (change: (point: Vec2) => Vec2) => {
    f.rotation = turn(0 - f.rotation).r;
    if (f.points) f.points = f.points.map(change);
  };
  if (gid & FLIP_TURN) {
    [f.x, f.y] = [f.y, f.x];
    [f.hx, f.hy] = [f.hy, f.hx];
    [width, height] = [height, width];
    mirror(([x, y]) => [y, x]);
  }
  if (gid & FLIP_X) {
    f.x = width - f.x;
    mirror(([x, y]) => [0 - x, y]);
  }
  if (gid & FLIP_Y) {
    f.y = height - f.y;
    mirror(([x, y]) => [x, 0 - y]);
  }
}

/**
 * Scales a form. False, with a problem in the report, where a circle would become an ellipse or a
 * box would no longer have right angles.
 */
export function scaleForm(v: Values, f: Form, sx: number, sy: number): boolean {
  const across = f.rotation === 90 || f.rotation === -90;
  const along = f.rotation === 0 || f.rotation === -180;
  if (!f.points && !nearlyEqual(sx, sy) && (f.kind === "circle" || !(along || across))) {
    const turned = f.kind === "circle" ? "circle into an ellipse" : "box askew";
    v.complain("skip", `a tile drawn ${sx} times as wide and ${sy} times as high turns its ${turned}`);
    return false;
  }
  f.x *= sx;
  f.y *= sy;
  f.hx *= across ? sy : sx;
  f.hy *= f.kind === "circle" || across ? sx : sy;
  if (f.points) f.points = f.points.map(([x, y]) => [x * sx, y * sy]);
  return true;
}

// ---- what the engine accepts ----

/** Whether the engine accepts a body at this place, in units. */
export function placeFits({ unit }: Reader, [x, y]: Vec2): boolean {
  return Math.abs(x) <= FARTHEST * unit && Math.abs(y) <= FARTHEST * unit;
}

/**
 * Whether a form's size, and its offset from its body, are in range; if not, a problem is in the
 * report.
 */
function sizeFits({ pixelsPerUnit: ppu, unit }: Reader, v: Values, f: Form): boolean {
  const [hx, hy] = [f.hx / ppu, f.hy / ppu];
  const [x, y] = [f.x / ppu, f.y / ppu];
  const low = SMALLEST * unit;
  const high = LARGEST * unit;
  const fits = hx >= low && hy >= low && hx <= high && hy <= high;
  if (!fits) v.complain("skip", `its size, ${2 * hx} by ${2 * hy} units, is out of range`);
  else if (Math.abs(x) > high || Math.abs(y) > high)
    v.complain("skip", "a shape is further from its body than 16000 length scales");
  else return true;
  return false;
}

/** Whether the vertices of a line are in range; if not, a problem is in the report. */
function verticesFit({ pixelsPerUnit: ppu }: Reader, v: Values, points: Vec2[]): boolean {
  const fits = ([x, y]: Vec2) => Math.abs(x / ppu) <= FARTHEST && Math.abs(y / ppu) <= FARTHEST;
  if (points.every(fits)) return true;
  const rule = "no vertex may be further from its object's place than 1e9 units";
  v.complain("skip", `its line is too long: ${rule}`);
  return false;
}

/**
 * Whether x increases strictly along a line, in units; if not, a problem is in the report. A line
 * from right to left is reversed first.
 */
function lineFits({ pixelsPerUnit: ppu }: Reader, v: Values, points: Vec2[]): boolean {
  if (points[points.length - 1][0] < points[0][0]) points.reverse();
  for (let i = 1; i < points.length; i++) {
    if (points[i][0] / ppu > points[i - 1][0] / ppu) continue;
    const where = `vertices ${i} and ${i + 1} of ${points.length}, from the left`;
    const rule = "terrain must go on from left to right";
    v.complain("skip", `its line turns back: ${rule} (${where})`);
    return false;
  }
  return true;
}

/**
 * Whether a polygon has to be approximated: its properties say so, and it is no ground. The
 * arguments are those of settleForms.
 */
function isApproximated(physics: Physics, f: Form, degrees: number, lowest: number): boolean {
  if (f.kind !== "polygon" || f.approximate === 0) return false;
  const copy = { ...f, points: [...(f.points as Vec2[])] };
  turnForm(copy, 0, 0, degrees);
  return !(physics.kind === "static" && toGround(copy) && copy.y + copy.foot >= lowest);
}

/**
 * The forms of a body that the engine accepts; problems of the others are in the report. Polygons
 * become ground lines or shapes that approximate them, and lines run from left to right. `degrees`: the body's rotation, by which
 * lines and polygons are turned, since terrain cannot be. A polygon is ground only where its lower
 * side is at `lowest`, pixels below the body, or lower.
 */
export function settleForms(
  reader: Reader,
  v: Values,
  physics: Physics,
  forms: Form[],
  degrees: number,
  lowest: number,
): Form[] {
  const added: Form[] = [];
  const smallest = SMALLEST * reader.unit * reader.pixelsPerUnit;
  const hint = "with the property 'approximate' shapes cover it";
  const kept = forms.filter((f) => {
    if (isApproximated(physics, f, degrees, lowest)) {
      added.push(...approximated(reader.engine, v, f, smallest));
      return false;
    }
    if (!f.points) return sizeFits(reader, v, f);
    turnForm(f, 0, 0, degrees);
    if (f.kind === "polygon" && !toGround(f)) {
      const what = "a polygon that neither boxes make up nor a ground line cannot be modelled";
      v.complain("skip", `${what}; ${hint}`);
      return false;
    }
    if (f.ground && !(f.y + f.foot >= lowest)) {
      const rule = "a polygon is ground only if it reaches down to the map's lower edge";
      v.complain("skip", `${rule}: all below a line is solid; ${hint}`);
      return false;
    }
    if (physics.kind !== "static") {
      v.complain("skip", "a line is terrain, which is static");
      return false;
    }
    return verticesFit(reader, v, f.points) && lineFits(reader, v, f.points);
  });
  return [...kept, ...added.filter((f) => sizeFits(reader, v, f))];
}

// ---- bodies ----

/**
 * Adds a body at (x, y) pixels with these forms to the level, and a body for each line. `id`: the
 * object in the map, 0: none; `withGround`: ground lines are added, too. Returns why something is
 * left out: the engine does not accept its place, or the map has more than MOST_PARTS; else null.
 */
export function addBody(
  reader: Reader,
  { kind, body }: Physics,
  id: number,
  forms: readonly Form[],
  withGround: boolean,
  x: number,
  y: number,
  degrees: number,
): "far" | "many" | null {
  const { pixelsPerUnit: ppu, level, mapHeight, placed } = reader;
  const { r: rotation } = turn(degrees);
  const unturned = rotation === 0 && (kind === "static" || body.fixedRotation === true);
  let left: "far" | "many" | null = null;
  const admit = (f: Form, px: number, py: number): boolean => {
    const parts = 1 + (f.points?.length ?? 0);
    const fits = placeFits(reader, [px / ppu, (mapHeight - py) / ppu]);
    if (fits && parts <= reader.parts) {
      reader.parts -= parts;
      return true;
    }
    left = fits ? "many" : "far";
    return false;
  };
  const add = (px: number, py: number, turned: number, shapes: LevelShape[]) => {
    const angle = 0 - turned * RADIANS;
    const fixed = shapes.some((shape) => shape.kind === "aabb") || body.fixedRotation;
    const position: Vec2 = [grid(px / ppu), grid((mapHeight - py) / ppu)];
    const userData = id === 0 ? undefined : id;
    if (id !== 0 && !placed.has(id)) placed.set(id, { index: level.bodies.length, rotation: turned });
    level.bodies.push({ body: { ...body, fixedRotation: fixed, position, angle, userData }, shapes });
  };
  const shapes = forms.flatMap((f): LevelShape[] => {
    if (f.points || !admit(f, x, y)) return [];
    const offset: Vec2 = [f.x / ppu, 0 - f.y / ppu];
    const { material } = f;
    if (f.kind === "circle") return [{ kind: "circle", material, offset, radius: f.hx / ppu }];
    const [halfWidth, halfHeight] = [f.hx / ppu, f.hy / ppu];
    if (unturned && f.rotation === 0)
      return [{ kind: "aabb", material, offset, halfWidth, halfHeight }];
    const angle = 0 - f.rotation * RADIANS;
    return [{ kind: "obb", material, offset, halfWidth, halfHeight, angle }];
  });
  if (shapes.length > 0) add(x, y, rotation, shapes);
  for (const f of forms) {
    const { points, material, ground, x: fx, y: fy } = f;
    if (!points || (ground && !withGround) || !admit(f, x + fx, y + fy)) continue;
    const inUnits = points.map(([px, py]): Vec2 => [px / ppu, 0 - py / ppu]);
    add(x + fx, y + fy, 0, [{ kind: "terrain", material, points: inUnits }]);
  }
  return left;
}
