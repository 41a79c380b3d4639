/**
 * Reads objects of a Tiled map that are joints: their kind, places and options. tie.ts finds their
 * bodies after the whole map has been read. The same arithmetic as demo/level/joints.c.
 */
import type { Direction, Drive, JointKind } from "../joint-types.js";
import type { Reader } from "../level.js";
import type { Vec2 } from "../types.js";
import { FAR, turn } from "./form.js";
import { KINDS } from "./joint-names.js";
import { direction } from "./polygon.js";
import { grid, isRecord, type Json, type JsonRecord, type Values } from "./values.js";

/** The largest length, length scales: the engine's 1e6 less a margin for single precision. */
const LONGEST = 999999;
/** The smallest length of a distance, length scales. Chosen. */
const SHORTEST = 1e-6;
/** The largest angle of limits and targets, radians: pi in single precision. */
const LARGEST_TURN = 3.1415927;
/** The largest force or torque (THUD_JOINT_FORCE_MAX): no maximum. */
const LARGEST_FORCE = 1e30;

/** The options of World.createJoint that a map can set. */
export interface TieOptions {
  length?: number;
  ratio?: number;
  along?: Drive;
  across?: Drive;
  turn?: Drive;
  collideConnected: boolean;
  breakForce: number;
  breakTorque: number;
}

/** An object that is a joint, kept until all objects that it may refer to have been read. */
export interface Tie {
  kind: JointKind;
  options: TieOptions;
  /** The id of the object. */
  id: number;
  /** The ids of the objects of its bodies or joints; a is 0 for a joint to the world. */
  a: number;
  b: number;
  /** The places of its anchors on a and on b, pixels. */
  places: [Vec2, Vec2];
  /** The rotation of its axis, degrees, clockwise. */
  rotation: number;
}

/** Whether a length of either sign is in the engine's range. */
export function jointFits({ unit }: Reader, length: number): boolean {
  return Math.abs(length) <= LONGEST * unit;
}

/** The place of a joint's anchor on a side, in units, on the grid of bodies. */
export function jointPlace({ pixelsPerUnit: ppu, mapHeight }: Reader, tie: Tie, side: 0 | 1): Vec2 {
  const [x, y] = tie.places[side];
  return [grid(x / ppu), grid((mapHeight - y) / ppu)];
}

/**
 * Whether an object has a form that a joint may have: no tile, no polygon, a line of two points.
 */
function isDrawnFit({ gid, polygon, polyline }: JsonRecord): boolean {
  const isLine = polyline !== undefined;
  const fits = !isLine || (Array.isArray(polyline) && polyline.length === 2);
  return gid === undefined && polygon === undefined && fits;
}

/**
 * Reads the places of a joint that is drawn as a line: of a distance both ends; of other kinds the
 * first point, from which the line is the axis.
 */
function readLine(v: Values, line: Json[], tie: Tie): void {
  const { c, s } = turn(tie.rotation);
  const [[x0, y0], [x1, y1]] = line.map((item): Vec2 => {
    const point = isRecord(item) ? item : {};
    const px = v.required(point, "x", -FAR, FAR);
    const py = v.required(point, "y", -FAR, FAR);
    return [c * px - s * py, s * px + c * py];
  });
  const [x, y] = tie.places[0];
  const [dx, dy] = [x1 - x0, y1 - y0];
  const last: Vec2 = tie.kind === "distance" ? [x1, y1] : [x0, y0];
  tie.places = [
    [x + x0, y + y0],
    [x + last[0], y + last[1]],
  ];
  tie.rotation = dx * dx + dy * dy > 0 ? direction(dx, dy) : 0;
}

/** Reads the places of a joint: from its line, or else the centre of the object. */
function readPlace(v: Values, object: JsonRecord, tie: Tie): void {
  if (Array.isArray(object.polyline)) {
    readLine(v, object.polyline, tie);
    return;
  }
  const hx = 0.5 * v.optional(object, "width", 0, 0, FAR);
  const hy = 0.5 * v.optional(object, "height", 0, 0, FAR);
  const { c, s } = turn(tie.rotation);
  const [x, y] = tie.places[0];
  const place: Vec2 = [x + (c * hx - s * hy), y + (s * hx + c * hy)];
  tie.places = [place, place];
  // The axis of a wheel, its suspension, is vertical unless the object is turned.
  if (tie.kind === "wheel") tie.rotation = tie.rotation - 90;
}

/** The distance of both anchors in units. */
function lengthAsDrawn(reader: Reader, tie: Tie): number {
  const [x0, y0] = jointPlace(reader, tie, 0);
  const [x1, y1] = jointPlace(reader, tie, 1);
  const [dx, dy] = [x1 - x0, y1 - y0];
  return Math.sqrt(dx * dx + dy * dy);
}

/**
 * Reads the drive of a direction from properties such as "along_frequency". `scale`:
 * Reader.unit; `length`: the length of a distance, the default of its upper limit and target; of other
 * kinds undefined.
 */
function readDrive(scale: number, v: Values, way: Direction, length: number | undefined): Drive {
  const fastest = way === "turn" ? LONGEST : LONGEST * scale;
  const most = way === "turn" ? LARGEST_TURN : LONGEST * scale;
  const least = length === undefined ? -most : 0;
  const isLimited = ["lower", "upper"].some((name) => v.find(`${way}_${name}`) !== undefined);
  const limits = isLimited
    ? {
        lower: v.number(`${way}_lower`, least, least, most),
        upper: v.number(`${way}_upper`, length ?? most, least, most),
      }
    : null;
  const drive: Drive = {
    ...limits,
    frequency: v.number(`${way}_frequency`, 0, 0, 1e4),
    damping: v.number(`${way}_damping`, 0.7, 0, 1e3),
    target: v.number(`${way}_target`, length ?? 0, least, most),
    springForce: v.number(`${way}_spring_force`, LARGEST_FORCE, 0, LARGEST_FORCE),
    motorSpeed: v.number(`${way}_motor_speed`, 0, -fastest, fastest),
    motorForce: v.number(`${way}_motor_force`, 0, 0, LARGEST_FORCE),
  };
  if (!v.bad && limits && limits.lower > limits.upper)
    v.refuse(`${way}_lower is larger than ${way}_upper`);
  return drive;
}

/** Reads the options of a joint from its properties. */
function readOptions(reader: Reader, v: Values, tie: Tie): void {
  const { kind, options } = tie;
  const scale = reader.unit;
  if (kind === "distance") {
    const drawn = lengthAsDrawn(reader, tie);
    options.length = v.number("length", drawn, SHORTEST * scale, LONGEST * scale);
  }
  if (kind === "gear") {
    options.ratio = v.number("ratio", 1, -1e4, 1e4);
    if (Math.abs(options.ratio) < 1e-4) v.refuse("ratio is too near to 0");
  }
  options.collideConnected = v.flag("collide_connected", kind === "gear");
  options.breakForce = v.number("break_force", LARGEST_FORCE, 0, LARGEST_FORCE);
  options.breakTorque = v.number("break_torque", LARGEST_FORCE, 0, LARGEST_FORCE);
  for (const way of KINDS[kind]) options[way] = readDrive(scale, v, way, options.length);
}

/**
 * Adds the joint of an object at (x, y) pixels to reader.ties, or reports why it cannot be used.
 * `rotation`: degrees, clockwise.
 */
export function readJoint(
  reader: Reader,
  v: Values,
  object: JsonRecord,
  kind: JointKind,
  x: number,
  y: number,
  rotation: number,
): void {
  if (!isDrawnFit(object)) {
    const ways = "a point, a rectangle, an ellipse or a line of two points";
    v.complain("skip", `a joint is drawn as ${ways}`);
    return;
  }
  if (kind === "distance" && object.polyline === undefined) {
    v.complain("skip", "a distance is drawn as a line of two points");
    return;
  }
  const options = { collideConnected: false, breakForce: 0, breakTorque: 0 };
  const places: Tie["places"] = [[x, y], [x, y]];
  const tie: Tie = { kind, options, id: v.object, a: 0, b: 0, places, rotation };
  readPlace(v, object, tie);
  if (v.bad) return;
  tie.a = v.whole("a", 0, 0, 0xffffffff);
  tie.b = v.whole("b", 0, 0, 0xffffffff);
  readOptions(reader, v, tie);
  const { length = Number.POSITIVE_INFINITY } = tie.options;
  if (!v.bad && length < SHORTEST * reader.unit)
    v.refuse("its line is too short, and no length is given");
  if (!v.bad && kind === "distance" && length > LONGEST * reader.unit)
    v.refuse("its line is too long, and no length is given");
  const needsBoth = kind === "filter" || kind === "gear";
  if (!v.bad && (tie.b === 0 || (tie.a === 0 && needsBoth)))
    v.refuse(`a ${kind} needs ${needsBoth ? "both a and b" : "b, the body that it holds"}`);
  if (!v.bad && tie.a === tie.b) v.refuse("a and b are the same object");
  if (!v.bad) reader.ties.push(tie);
}
