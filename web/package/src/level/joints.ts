/**
 * Objects of a Tiled map that are joints: what they are, where, and how they are driven. Which
 * bodies they tie is found by tie.ts, when all of the map is read. Follows demo/level/joints.c.
 */
import type { Direction, Drive, JointKind } from "../joint-types.js";
import type { Reader } from "../level.js";
import type { Vec2 } from "../types.js";
import { FAR, turn } from "./form.js";
import { KINDS } from "./joint-names.js";
import { direction } from "./polygon.js";
import { grid, isRecord, type Json, type JsonRecord, type Values } from "./values.js";

/** Length scales; the engine takes 1e6, give or take what single precision rounds. */
const LONGEST = 999999;
const SHORTEST = 1e-6;
const LARGEST_TURN = 3.1415927;
const LARGEST_FORCE = 1e30;

/** The options of World.createJoint that stand in a map. */
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

/** An object that is a joint, until all that it may refer to is read. */
export interface Tie {
  kind: JointKind;
  options: TieOptions;
  /** Of objects; a is 0 if it holds to the world. */
  id: number;
  a: number;
  b: number;
  /** Pixels: where it is in a and in b. */
  places: [Vec2, Vec2];
  /** Of its axis, degrees, clockwise. */
  rotation: number;
}

/** Whether the engine takes a length of either sign. */
export function jointFits({ level }: Reader, length: number): boolean {
  return Math.abs(length) <= LONGEST * level.lengthScale;
}

/** Where a side of a joint is, in the world. */
export function jointPlace({ pixelsPerUnit: ppu, mapHeight }: Reader, tie: Tie, side: 0 | 1): Vec2 {
  const [x, y] = tie.places[side];
  return [grid(x / ppu), grid((mapHeight - y) / ppu)];
}

function isDrawnFit({ gid, polygon, polyline }: JsonRecord): boolean {
  const isLine = polyline !== undefined;
  const fits = !isLine || (Array.isArray(polyline) && polyline.length === 2);
  return gid === undefined && polygon === undefined && fits;
}

/** A line is from one place to the other, or from the only place along the axis. */
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
  // A wheel's suspension is upright.
  if (tie.kind === "wheel") tie.rotation = tie.rotation - 90;
}

function lengthAsDrawn(reader: Reader, tie: Tie): number {
  const [x0, y0] = jointPlace(reader, tie, 0);
  const [x1, y1] = jointPlace(reader, tie, 1);
  const [dx, dy] = [x1 - x0, y1 - y0];
  return Math.sqrt(dx * dx + dy * dy);
}

/** A distance's drive is about `length`; of other kinds that is undefined. */
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

function readOptions(reader: Reader, v: Values, tie: Tie): void {
  const { kind, options } = tie;
  const scale = reader.level.lengthScale;
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

/** Keeps the joint that an object at (x, y) pixels is, or reports why it is none. */
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
  if (!v.bad && length < SHORTEST * reader.level.lengthScale)
    v.refuse("its line is too short, and no length is given");
  const needsBoth = kind === "filter" || kind === "gear";
  if (!v.bad && (tie.b === 0 || (tie.a === 0 && needsBoth)))
    v.refuse(`a ${kind} needs ${needsBoth ? "both a and b" : "b, the body that it holds"}`);
  if (!v.bad && tie.a === tie.b) v.refuse("a and b are the same object");
  if (!v.bad) reader.ties.push(tie);
}
