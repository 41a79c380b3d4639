/** How the options of joints become the numbers that the module takes, and back. */
import { FRAME_RANGES, JOINT_RANGES, whyNot } from "./checks/ranges.js";
import type { Engine } from "./engine.js";
import { ThudError } from "./error.js";
import {
  DRIVE_OPTIONS,
  DriveOptionsAt,
  FRAME_OPTIONS,
  FrameOptionsAt,
  JOINT_OPTIONS,
  JointMakingAt,
  JointOptionsAt,
} from "./generated/slots.js";
import {
  type AnyJointOptions,
  DIRECTIONS,
  type Drive,
  JOINT_KINDS,
  type JointFrame,
  type JointKind,
} from "./joint-types.js";
import { bodyAt, fill, indexOf, jointAt, numbersOf, vecAt } from "./numbers.js";
import type { BodyId, JointId, Vec2 } from "./types.js";

const PAIR = ["kind", "bodyA", "bodyB"];
const PLACED = [...PAIR, "frameA", "frameB", "at", "axis", "angle"];

/** What each kind has beside JOINT_OPTIONS. */
const OWN: Readonly<Record<JointKind, readonly string[]>> = {
  distance: [...PAIR, "frameA", "frameB", "from", "to", "length", "along"],
  hinge: [...PLACED, "turn"],
  slider: [...PLACED, "along"],
  weld: [...PLACED, ...DIRECTIONS],
  wheel: [...PLACED, "along", "turn"],
  target: [...PLACED, ...DIRECTIONS],
  filter: PAIR,
  gear: ["kind", "jointA", "jointB", "ratio"],
};

/** Any kind's. */
interface Given {
  kind: JointKind;
  bodyA?: BodyId;
  bodyB?: BodyId;
  jointA?: JointId;
  jointB?: JointId;
  frameA?: JointFrame;
  frameB?: JointFrame;
  at?: Vec2;
  from?: Vec2;
  to?: Vec2;
  axis?: Vec2;
  angle?: number;
  length?: number;
  ratio?: number;
  along?: Drive;
  across?: Drive;
  turn?: Drive;
}

const MAKING = JointOptionsAt.making;

/** Fills the slots of api_joint_create. */
export function writeJoint(engine: Engine, options: AnyJointOptions): void {
  const given: Given = options;
  const kind = indexOf(JOINT_KINDS, given.kind, "joint kind");
  const numbers = numbersOf(given.kind, given, JOINT_OPTIONS, OWN[given.kind]);
  engine.exports.api_joint_defaults(kind);
  const s = engine.slots;
  fill(s, numbers);
  const what = given.kind === "gear" ? "joint" : "body";
  [`${what}A` as const, `${what}B` as const].forEach((name, side) => {
    const id = given[name];
    if (id?.kind !== what) refuse(given.kind, `${name} must be a ${what}`);
    s.set([id.index + 1, id.generation], JointOptionsAt.pairA + 2 * side);
  });
  (["frameA", "frameB"] as const).forEach((name, side) => {
    const frame = numbersOf(`${given.kind}, ${name}`, given[name] ?? {}, FRAME_OPTIONS);
    fill(s, frame, JointOptionsAt.frameA + FrameOptionsAt.length * side);
  });
  DIRECTIONS.forEach((name, i) => writeDrive(s, i, given[name] ?? {}, `${given.kind}, ${name}`));
  fill(s, [given.length, given.ratio], MAKING + JointMakingAt.rod);
  writePlaces(s, given);
}

function writePlaces(s: Float64Array, given: Given): void {
  const { kind, at, axis, angle, from = at, to = at } = given;
  const told = at ? "at" : "a place in the world";
  if (from && given.frameA) refuse(kind, `${told} and frameA exclude each other`);
  if (to && given.frameB) refuse(kind, `${told} and frameB exclude each other`);
  const turned = axis ? "axis" : "angle";
  if ((axis || angle !== undefined) && !at) refuse(kind, `${turned} goes with at`);
  if (axis && angle !== undefined) refuse(kind, "axis and angle exclude each other");
  if (axis && !(Math.hypot(axis[0], axis[1]) > 0)) refuse(kind, "axis points nowhere");
  const usual = kind === "wheel" ? Math.PI / 2 : 0;
  const workedOut = [from, to, given.length === undefined, axis];
  const numbers = [
    workedOut.reduce((sum: number, one, i) => sum + (one ? 1 << i : 0), 0),
    ...[from, to].flatMap((place) => [place?.[0] ?? NaN, place?.[1] ?? NaN]),
    angle ?? usual,
    axis?.[0] ?? 0,
    axis?.[1] ?? 0,
  ];
  s.set(numbers, MAKING + JointMakingAt.workedOut);
}

/** Overwrites what is named of a direction among the slots of a joint. */
export function writeDrive(s: Float64Array, direction: number, drive: Drive, what: string): void {
  const numbers = numbersOf(what, drive, DRIVE_OPTIONS);
  fill(s, numbers, JointOptionsAt.along + DriveOptionsAt.length * direction);
}

/** From the slots of api_joint_options. */
export function readJoint(s: Float64Array): AnyJointOptions {
  const kind = JOINT_KINDS[s[MAKING + JointMakingAt.kind]];
  const readId = kind === "gear" ? jointAt : bodyAt;
  const own: Given = {
    kind,
    [kind === "gear" ? "jointA" : "bodyA"]: readId(s, JointOptionsAt.pairA),
    [kind === "gear" ? "jointB" : "bodyB"]: readId(s, JointOptionsAt.pairB),
    frameA: frameAt(s, JointOptionsAt.frameA),
    frameB: frameAt(s, JointOptionsAt.frameB),
    length: s[MAKING + JointMakingAt.rod],
    ratio: s[MAKING + JointMakingAt.ratio],
  };
  DIRECTIONS.forEach((name, i) => {
    own[name] = driveAt(s, JointOptionsAt.along + DriveOptionsAt.length * i);
  });
  return {
    ...Object.fromEntries(Object.entries(own).filter(([name]) => OWN[kind].includes(name))),
    collideConnected: s[JointOptionsAt.collideConnected] !== 0,
    breakForce: s[JointOptionsAt.breakForce],
    breakTorque: s[JointOptionsAt.breakTorque],
    onlyReports: s[JointOptionsAt.onlyReports] !== 0,
    enabled: s[JointOptionsAt.enabled] !== 0,
    userData: s[JointOptionsAt.userData],
  } as AnyJointOptions;
}

function frameAt(s: Float64Array, at: number): JointFrame {
  return { position: vecAt(s, at), angle: s[at + FrameOptionsAt.angle] };
}

/** Limits that are none are left out. */
function driveAt(s: Float64Array, at: number): Drive {
  const entries = DRIVE_OPTIONS.map((name, i) => [name, s[at + i]] as const);
  return Object.fromEntries(entries.filter(([, value]) => Number.isFinite(value)));
}

/** Most of an option, and its negative, or 0, the least; the engine refuses without a name. */
const MOST: Readonly<Record<string, number>> = { frequency: 1e4, damping: 1e3, angle: 1e6, ratio: 1e4 };
const EITHER_WAY = ["lower", "upper", "target", "motorSpeed", "angle", "ratio"];

/** Undefined of what is no such number. */
function mostOf(name: string, direction: string, furthest: number): number | undefined {
  if (name in MOST) return MOST[name];
  if (name.endsWith("Force") || name === "breakTorque") return 1e30;
  if (name !== "length" && !EITHER_WAY.includes(name)) return undefined;
  return direction !== "turn" ? furthest : name === "motorSpeed" ? 1e6 : 3.14159;
}

/** Does what may be refused; if it is, names the option of a drive or of breaking that is wrong. */
export function named<T>(what: string, options: object, furthest: number, act: () => T): T {
  try {
    return act();
  } catch (error) {
    if (error instanceof ThudError && error.code === "invalid") {
      for (const [name, value] of Object.entries(options))
        if (DIRECTIONS.some((one) => one === name)) checkRanges(what, value as Drive, furthest, name);
      checkRanges(what, options, furthest, "");
      checkBodies(what, options, error.message);
    }
    throw error;
  }
}

function checkRanges(what: string, options: object, furthest: number, direction: string): void {
  const path = direction && `${direction}.`;
  checkPlaces(what, options, furthest);
  const { lower = -Infinity, upper = Infinity } = options as Drive;
  if (lower > upper) refuse(what, `${path}lower is above ${path}upper`);
  for (const [name, value] of Object.entries(options)) {
    const most = mostOf(name, direction, furthest);
    const isOpen = name === "lower" ? value === -Infinity : name === "upper" && value === Infinity;
    if (most === undefined || typeof value !== "number" || isOpen) continue;
    const least = EITHER_WAY.includes(name) ? -most : 0;
    // What the engine tells of itself is rounded to its floats.
    if (!(value >= least && value <= most * (1 + 1e-6)))
      refuse(what, `${path}${name} must be from ${least} to ${most}: ${value}`);
  }
}

/** Places in the world, and those in the bodies. */
function checkPlaces(what: string, options: object, furthest: number): void {
  const scale = furthest / 999_000;
  const why = whyNot(options, JOINT_RANGES, scale);
  if (why) refuse(what, why);
  for (const name of ["frameA", "frameB"] as const) {
    const frame = (options as Given)[name];
    const wrong = frame && whyNot(frame, FRAME_RANGES, scale, `${name}.`);
    if (wrong) refuse(what, wrong);
  }
}

/** What the engine tells of both bodies and of frames that it has worked out. */
function checkBodies(what: string, options: object, told: string): void {
  const places = ["at", "from", "to", "frameA", "frameB"].filter((name) => name in options);
  if (told.includes("a frame is out of range"))
    refuse(what, `${places.join(" or ")} is too far from its body`);
  if (told.includes("needs two bodies"))
    refuse(what, "bodyA and bodyB must be two bodies, one of them dynamic");
  if (told.includes("body b of a")) refuse(what, "bodyB must be dynamic");
}

function refuse(what: string, why: string): never {
  throw new ThudError("invalid", `${what}: ${why}`);
}
