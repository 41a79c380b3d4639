/**
 * Finds the bodies and joints to which the joints of a map refer, after the whole map has been
 * read, and adds the joints to the level. The same arithmetic as demo/level/tie.c.
 */
import type { JointFrame } from "../joint-types.js";
import type { LevelJoint, Reader } from "../level.js";
import { RADIANS, turn } from "./form.js";
import { placeFits, TOO_FAR } from "./forms.js";
import { jointFits, jointPlace, type Tie } from "./joints.js";

/** The body of an object. */
export interface Placed {
  /** Its index in Level.bodies. */
  index: number;
  /** Degrees, clockwise, in [-180, 180). */
  rotation: number;
}

/** The kinds of joints that a gear can couple. */
const VALUED = ["hinge", "wheel", "slider", "distance"];

/** Reports why a joint is left out. */
function complain(reader: Reader, { id, kind }: Tie, what: string): void {
  reader.report.add("skip", id, `a ${kind} ${what}`);
}

/**
 * What a and b of a joint refer to in `found`; a is undefined for the world. Null, with a problem
 * in the report, where an object is not there. `what`: a body or a joint, for the message.
 */
function findBoth<T>(
  reader: Reader,
  tie: Tie,
  found: ReadonlyMap<number, T>,
  what: string,
): [a: T | undefined, b: T] | null {
  for (const name of ["a", "b"] as const)
    if (tie[name] !== 0 && !found.has(tie[name]))
      reader.report.add("skip", tie.id, `${name} refers to object ${tie[name]}, which is no ${what}`);
  const b = found.get(tie.b);
  const isWhole = b !== undefined && (tie.a === 0 || found.has(tie.a));
  return isWhole ? [found.get(tie.a), b] : null;
}

/** The kind of a body of the level. */
function kindOf({ level }: Reader, index: number): string | undefined {
  return level.bodies[index].body.kind;
}

/** Whether the engine allows the joint between these bodies; if not, a problem is in the report. */
function mayTie(reader: Reader, tie: Tie, a: Placed | undefined, b: Placed): boolean {
  const aMoves = a !== undefined && kindOf(reader, a.index) === "dynamic";
  const bMoves = kindOf(reader, b.index) === "dynamic";
  if ((tie.kind === "wheel" || tie.kind === "target") && !bMoves)
    complain(reader, tie, "needs a b that is dynamic");
  else if (!aMoves && !bMoves) complain(reader, tie, "needs one dynamic body, a or b");
  else return true;
  return false;
}

/**
 * The frame of a joint in the body of a side, or in its anchor where there is no body; null where
 * it is further from the body's origin than the engine accepts.
 */
function frameOf(
  reader: Reader,
  tie: Tie,
  side: 0 | 1,
  placed: Placed | undefined,
): JointFrame | null {
  const axis = 0 - turn(tie.rotation).r * RADIANS;
  if (!placed) return { position: [0, 0], angle: axis };
  const { position: [bx, by] = [0, 0], angle = 0 } = reader.level.bodies[placed.index].body;
  const [px, py] = jointPlace(reader, tie, side);
  const { c, s } = turn(placed.rotation);
  const [dx, dy] = [px - bx, py - by];
  const [x, y] = [c * dx - s * dy, s * dx + c * dy];
  const fits = jointFits(reader, x) && jointFits(reader, y);
  return fits ? { position: [x, y], angle: axis - angle } : null;
}

/** Adds a static body without shapes, the anchor of a joint to the world; returns its index. */
function addAnchor(reader: Reader, tie: Tie): number {
  const position = jointPlace(reader, tie, 0);
  reader.level.bodies.push({ body: { kind: "static", position, userData: tie.id }, shapes: [] });
  return reader.level.bodies.length - 1;
}

/** Adds a joint. Returns its index in Level.joints, or null, with a problem in the report. */
function tieBodies(reader: Reader, tie: Tie): number | null {
  const { level, placed } = reader;
  const both = findBoth(reader, tie, placed, "body");
  if (!both || !mayTie(reader, tie, ...both)) return null;
  const [a, b] = both;
  if (!a && !placeFits(reader, jointPlace(reader, tie, 0))) {
    complain(reader, tie, `is ${TOO_FAR}`);
    return null;
  }
  const frameA = frameOf(reader, tie, 0, a);
  const frameB = frameOf(reader, tie, 1, b);
  if (!frameA || !frameB) {
    complain(reader, tie, "is too far from its bodies");
    return null;
  }
  const { kind } = tie;
  const frames = kind === "filter" ? {} : { frameA, frameB };
  const own = kind === "filter" ? {} : tie.options;
  const options = { kind, ...frames, ...own } as LevelJoint["options"];
  level.joints.push({ a: a ? a.index : addAnchor(reader, tie), b: b.index, options });
  return level.joints.length - 1;
}

/**
 * The index of the body that a joint lets move, where its other body is static; -1 where a gear
 * cannot couple the joint.
 */
function movedBy(reader: Reader, { a, b, options }: LevelJoint): number {
  if (!VALUED.includes(options.kind)) return -1;
  if (kindOf(reader, a) === "static") return b;
  return kindOf(reader, b) === "static" ? a : -1;
}

/** Adds a gear, or reports why not. `made`: the indices in Level.joints by the id of the object. */
function mesh(reader: Reader, tie: Tie, made: ReadonlyMap<number, number>): void {
  const both = findBoth(reader, tie, made, "joint");
  if (!both) return;
  const { joints } = reader.level;
  const [a = 0, b] = both;
  const moved = [movedBy(reader, joints[a]), movedBy(reader, joints[b])];
  const valued = "each a hinge, a wheel, a slider or a distance";
  const between = "between a body that is static and one that is dynamic";
  if (moved.includes(-1)) complain(reader, tie, `needs two joints, ${valued} ${between}`);
  else if (moved[0] === moved[1]) complain(reader, tie, "needs joints of two bodies");
  else joints.push({ a, b, options: { kind: "gear", ...tie.options } });
}

/** Adds all joints of reader.ties to the level, gears after the others, or reports why not. */
export function tieJoints(reader: Reader): void {
  const made = new Map<number, number>();
  for (const tie of reader.ties) {
    const index = tie.kind === "gear" ? null : tieBodies(reader, tie);
    if (index !== null && !made.has(tie.id)) made.set(tie.id, index);
  }
  for (const tie of reader.ties) if (tie.kind === "gear") mesh(reader, tie, made);
}
