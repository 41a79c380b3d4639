/**
 * Checks of joint options: those that exclude or need each other, and, after the engine refused a
 * call, which option is out of range.
 */
import { ThudError } from "../error.js";
import { DIRECTIONS, type Drive, type JointFrame } from "../joint-types.js";
import type { Vec2 } from "../types.js";
import { FRAME_RANGES, JOINT_RANGES, whyNot } from "./ranges.js";

/** The maximum of these options in any direction, from thud_limits.h. */
const MOST: Readonly<Record<string, number>> = { frequency: 1e4, damping: 1e3, angle: 1e6, ratio: 1e4 };
/** Options whose minimum is the negative of the maximum; that of the others is 0. */
const EITHER_WAY = ["lower", "upper", "target", "motorSpeed", "angle", "ratio"];

/**
 * The maximum of an option of a direction ("" for the joint itself), undefined where it has no
 * range. `furthest`: the maximum of lengths, in length units.
 */
function mostOf(name: string, direction: string, furthest: number): number | undefined {
  if (name in MOST) return MOST[name];
  if (name.endsWith("Force") || name === "breakTorque") return 1e30;
  if (name !== "length" && !EITHER_WAY.includes(name)) return undefined;
  return direction !== "turn" ? furthest : name === "motorSpeed" ? 1e6 : 3.1415927;
}

/** The options that place a joint, of any kind. */
interface Places {
  at?: Vec2;
  from?: Vec2;
  to?: Vec2;
  axis?: Vec2;
  angle?: number;
  frameA?: JointFrame;
  frameB?: JointFrame;
}

/** Throws "invalid" where options exclude or need each other. `own`: the options of the kind. */
export function checkTogether(kind: string, options: object, own: readonly string[]): void {
  const given = options as Places;
  const { at, axis, angle, from = at, to = at } = given;
  const told = at ? "at" : "a place in the world";
  if (from && given.frameA) refuse(kind, `${told} and frameA exclude each other`);
  if (to && given.frameB) refuse(kind, `${told} and frameB exclude each other`);
  const turned = axis ? "axis" : "angle";
  if ((axis || angle !== undefined) && !at) refuse(kind, `${turned} goes with at`);
  if (axis && angle !== undefined) refuse(kind, "axis and angle exclude each other");
  if (axis && !(Math.hypot(axis[0], axis[1]) > 0)) refuse(kind, "axis points nowhere");
  const isFramed = at || given.frameA || given.frameB || kind === "target";
  if (own.includes("at") && !isFramed) refuse(kind, "at is missing, its place in the world");
}

/**
 * Throws an error that names the option of a joint, of one of its drives or of breaking that is out
 * of range; returns where it finds none. `what`: the kind or the call; `furthest`: see mostOf.
 */
export function blameJoint(error: ThudError, what: string, options: object, furthest: number): void {
  for (const [name, value] of Object.entries(options))
    if (DIRECTIONS.some((one) => one === name)) checkRanges(what, value as Drive, furthest, name);
  checkRanges(what, options, furthest, "");
  checkPlaces(what, options, furthest);
  checkBodies(what, options, error.message);
}

/** Throws for the first option of a direction ("" for the joint itself) that is out of range. */
function checkRanges(what: string, options: object, furthest: number, direction: string): void {
  const path = direction && `${direction}.`;
  const { lower = -Infinity, upper = Infinity } = options as Drive;
  if (lower > upper) refuse(what, `${path}lower is above ${path}upper`);
  for (const [name, value] of Object.entries(options)) {
    const most = mostOf(name, direction, furthest);
    const isOpen = name === "lower" ? value === -Infinity : name === "upper" && value === Infinity;
    if (most === undefined || typeof value !== "number" || isOpen) continue;
    const least = EITHER_WAY.includes(name) ? -most : 0;
    // Values that jointOptionsOf returned are rounded to single precision.
    if (!(value >= least && value <= most * (1 + 1e-6)))
      refuse(what, `${path}${name} must be from ${least} to ${most}: ${value}`);
  }
}

/**
 * Throws for a place in the world or a frame in a body that is out of range. `furthest` is 999,000
 * length scales (world-joints.ts).
 */
function checkPlaces(what: string, options: object, furthest: number): void {
  const scale = furthest / 999_000;
  const why = whyNot(options, JOINT_RANGES, scale);
  if (why) refuse(what, why);
  for (const name of ["frameA", "frameB"] as const) {
    const frame = (options as { frameA?: JointFrame; frameB?: JointFrame })[name];
    const wrong = frame && whyNot(frame, FRAME_RANGES, scale, `${name}.`);
    if (wrong) refuse(what, wrong);
  }
}

/** Throws where the engine's message `told` is about the bodies, or frames computed from places. */
function checkBodies(what: string, options: object, told: string): void {
  const places = ["at", "from", "to", "frameA", "frameB"].filter((name) => name in options);
  if (told.includes("of a frame"))
    refuse(what, `${places.join(" or ")} is too far from its body`);
  if (told.includes("needs two bodies"))
    refuse(what, "bodyA and bodyB must be two bodies, one of them dynamic");
  if (told.includes("body b of a")) refuse(what, "bodyB must be dynamic");
}

function refuse(what: string, why: string): never {
  throw new ThudError("invalid", `${what}: ${why}`);
}
