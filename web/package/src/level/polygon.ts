/**
 * Converts polygons to shapes of the engine: to boxes, where its edges are parallel to the axes or
 * it is a rectangle, to a ground line, or to shapes that approximate it. The same arithmetic as
 * demo/level/polygon.c.
 */
import type { Engine } from "../engine.js";
import { ThudError } from "../error.js";
import { approximate } from "../geometry/approximate.js";
import { type Form, form, RADIANS, turn } from "./form.js";
import type { Values } from "./values.js";
import type { Vec2 } from "../types.js";

/** The maximum number of corners of a polygon that is cut into boxes. Chosen. */
const MOST_CORNERS = 64;

/** The larger of width and height of the points' bounds. */
function extent(points: Vec2[]): number {
  let [[x0, y0]] = points;
  let [x1, y1] = [x0, y0];
  for (const [x, y] of points) {
    [x0, x1] = [Math.min(x0, x), Math.max(x1, x)];
    [y0, y1] = [Math.min(y0, y), Math.max(y1, y)];
  }
  return Math.max(x1 - x0, y1 - y0);
}

/**
 * The direction of (x, y), which is not (0, 0), in degrees, clockwise with y down. It uses only
 * operations that give the same bits in every language: it starts from the nearest quarter turn,
 * and each of six iterations adds the sine of the angle that is left, which triples the correct
 * digits.
 */
export function direction(x: number, y: number): number {
  const length = Math.sqrt(x * x + y * y);
  let degrees = Math.abs(x) >= Math.abs(y) ? (x > 0 ? 0 : 180) : y > 0 ? 90 : -90;
  for (let i = 0; i < 6; i++) {
    const { c, s } = turn(degrees);
    degrees += (c * y - s * x) / length / RADIANS;
  }
  return turn(degrees).r;
}

/** The box of four corners with right angles, at any rotation; null where they are none. */
function readTurnedBox(points: Vec2[], near: number): Form[] | null {
  if (points.length !== 4) return null;
  const [[x0, y0], [x1, y1], [x2, y2], [x3, y3]] = points;
  const [ax, ay, bx, by] = [x1 - x0, y1 - y0, x2 - x1, y2 - y1];
  const a = Math.sqrt(ax * ax + ay * ay);
  const b = Math.sqrt(bx * bx + by * by);
  const closes = Math.abs(x0 + bx - x3) <= near && Math.abs(y0 + by - y3) <= near;
  if (!closes || a <= near || b <= near || Math.abs(ax * bx + ay * by) > 1e-3 * (a * b))
    return null;
  const [x, y] = [(x0 + x2) * 0.5, (y0 + y2) * 0.5];
  return [form("box", { x, y, hx: a * 0.5, hy: b * 0.5, rotation: direction(ax, ay) })];
}

/** The numbers in ascending order without those that are within `near` of the one before. */
function sorted(values: number[], near: number): number[] {
  const kept: number[] = [];
  for (const value of values.sort((a, b) => a - b))
    if (kept.length === 0 || value - kept[kept.length - 1] > near) kept.push(value);
  return kept;
}

/** Adds a box, or extends the box of the same width directly above it. */
function addSlab(forms: Form[], [x0, x1]: Vec2, [y0, y1]: Vec2, near: number): void {
  const x = (x0 + x1) * 0.5;
  const hx = (x1 - x0) * 0.5;
  for (const above of forms) {
    const top = above.y - above.hy;
    const alike = Math.abs(above.x - x) <= near && Math.abs(above.hx - hx) <= near;
    if (!alike || Math.abs(above.y + above.hy - y0) > near) continue;
    above.y = (top + y1) * 0.5;
    above.hy = (y1 - top) * 0.5;
    return;
  }
  forms.push(form("box", { x, hx, y: (y0 + y1) * 0.5, hy: (y1 - y0) * 0.5 }));
}

/**
 * The boxes of a polygon with vertical and horizontal edges; null for another polygon. It is cut at
 * the height of each corner into slabs; slabs of the same width above each other become one box.
 */
function readUprightBoxes(points: Vec2[], near: number): Form[] | null {
  if (points.length > MOST_CORNERS) return null;
  const edges = points.map((p, i): [Vec2, Vec2] => [p, points[(i + 1) % points.length]]);
  if (edges.some(([p, q]) => Math.abs(q[0] - p[0]) > near && Math.abs(q[1] - p[1]) > near))
    return null;
  const heights = sorted(points.map(([, y]) => y), near);
  const forms: Form[] = [];
  for (let k = 0; k + 1 < heights.length; k++) {
    const middle = (heights[k] + heights[k + 1]) * 0.5;
    const crossed = edges.filter(([p, q]) => p[1] < middle !== q[1] < middle);
    const walls = sorted(crossed.map(([[x]]) => x), -1);
    for (let i = 0; i + 1 < walls.length; i += 2)
      if (walls[i + 1] - walls[i] > near)
        addSlab(forms, [walls[i], walls[i + 1]], [heights[k], heights[k + 1]], near);
  }
  return forms.length > 0 ? forms : null;
}

/** The boxes of a polygon, or the polygon itself where boxes cannot make it up. */
export function readPolygon(points: Vec2[]): Form[] {
  const near = 1e-3 * extent(points);
  const boxes = readUprightBoxes(points, near) ?? readTurnedBox(points, near);
  return boxes ?? [form("polygon", { points })];
}

/**
 * Replaces a polygon, which is turned already, by the line of its upper side; false where it has
 * none. The polygon must be monotone in x: once around, the upper side
 * runs to the right, then there may be a wall down, the lower side runs to the left, and there may
 * be a wall up.
 */
export function toGround(f: Form): boolean {
  const points = f.points as Vec2[];
  const count = points.length;
  const near = 1e-3 * extent(points);
  const at = (i: number) => points[i % count];
  let area = 0;
  for (let i = 0; i < count; i++) area += at(i)[0] * at(i + 1)[1] - at(i + 1)[0] * at(i)[1];
  if (area < 0) points.reverse();
  const way = (edge: number) => {
    const dx = at(edge + 1)[0] - at(edge)[0];
    return dx > near ? 1 : dx < -near ? -1 : 0;
  };
  const runOf = (edge: number, which: number) => {
    let length = 0;
    while (length < count && way(edge + length) === which) length++;
    return length;
  };
  let first = 0;
  while (first < count && !(way(first) === 1 && way(first + count - 1) !== 1)) first++;
  const upper = runOf(first, 1);
  const right = runOf(first + upper, 0);
  const foot = first + upper + right;
  const lower = runOf(foot, -1);
  const left = runOf(foot + lower, 0);
  if (first === count || lower === 0 || upper + right + lower + left !== count) return false;
  f.foot = at(foot)[1];
  for (let i = 0; i <= lower; i++) f.foot = Math.min(f.foot, at(foot + i)[1]);
  f.kind = "line";
  f.ground = true;
  f.points = Array.from({ length: upper + 1 }, (_, i) => at(first + i));
  return true;
}

/**
 * The circles and boxes that approximate a polygon, without those smaller than `smallest` pixels;
 * none, with a problem in the report, where that fails. They overlap, so that the density is reduced
 * to give them the polygon's mass.
 */
export function approximated(
  engine: Engine | undefined,
  v: Values,
  f: Form,
  smallest: number,
): Form[] {
  if (!engine) {
    v.complain("skip", "the property 'approximate' needs the option 'engine' of readLevel");
    return [];
  }
  let found;
  try {
    found = approximate(engine, f.points as Vec2[], { shapes: f.approximate });
  } catch (error) {
    if (!(error instanceof ThudError && error.code === "invalid")) throw error;
    const reason = error.message.replace("approximate: ", "");
    v.complain("skip", `${reason}, so that it cannot be approximated`);
    return [];
  }
  const { density = 1 } = f.material;
  const share = 1 + found.overlap + found.extra - found.missed;
  const material = { ...f.material, density: density / share };
  const kept = found.shapes.flatMap((shape) => {
    const [x, y] = [f.x + shape.center[0], f.y + shape.center[1]];
    const round = shape.kind === "circle";
    const [hx, hy] = round ? [shape.radius, shape.radius] : [shape.halfWidth, shape.halfHeight];
    if (hx < smallest || hy < smallest) return [];
    const rotation = shape.kind === "obb" ? turn(shape.angle / RADIANS).r : 0;
    return [form(round ? "circle" : "box", { x, y, hx, hy, rotation, material })];
  });
  if (kept.length === 0) v.complain("skip", "its polygon is smaller than any shape");
  else v.complain("note", `its polygon is approximated by ${kept.length} shapes`);
  return kept;
}
