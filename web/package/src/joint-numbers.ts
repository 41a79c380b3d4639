/** How the options of joints become the numbers that the module takes, and back. */
import { explained } from "./checks/hook.js";
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
  type Numbered,
} from "./joint-types.js";
import { bodyAt, fill, indexOf, jointAt, numbersOf, vecAt } from "./numbers.js";
import { generationOf, index1Of, Kind } from "./plain/handles.js";
import type { BodyRef, JointRef, Vec2 } from "./types.js";

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
  bodyA?: BodyRef;
  bodyB?: BodyRef;
  jointA?: JointRef;
  jointB?: JointRef;
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
export function writeJoint(engine: Engine, options: AnyJointOptions | Numbered<AnyJointOptions>): void {
  const given = options as Given;
  const kind = indexOf(JOINT_KINDS, given.kind, "joint kind");
  const numbers = numbersOf(given.kind, given, JOINT_OPTIONS, OWN[given.kind]);
  engine.exports.api_joint_defaults(kind);
  const s = engine.slots;
  fill(s, numbers);
  const isGear = given.kind === "gear";
  const [what, wanted] = isGear ? (["joint", Kind.joint] as const) : (["body", Kind.body] as const);
  [`${what}A` as const, `${what}B` as const].forEach((name, side) => {
    const id = given[name];
    if (typeof id !== "number" && id?.kind !== what) refuse(given.kind, `${name} must be a ${what}`);
    s.set([index1Of(id, wanted), generationOf(id) >>> 0], JointOptionsAt.pairA + 2 * side);
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

/** Does what may be refused; if it is, tells the option of a drive or of breaking that is wrong. */
export function named<T>(what: string, options: object, furthest: number, act: () => T): T {
  try {
    return act();
  } catch (error) {
    throw explained(error, what, { joint: options, furthest });
  }
}

function refuse(what: string, why: string): never {
  throw new ThudError("invalid", `${what}: ${why}`);
}
