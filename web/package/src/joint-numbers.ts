/**
 * Converts the options of joints to the numbers that the module takes in its slots, and back. The
 * places of the numbers are those of `joint_options` in web/wasm/slots.h.
 */
import { checkJoint, explained } from "./checks/hook.js";
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

/** The options of joints that only have two bodies, and of joints with a place. */
const PAIR = ["kind", "bodyA", "bodyB"];
const PLACED = [...PAIR, "frameA", "frameB", "at", "axis", "angle"];

/** The options of each kind beside those of every kind (JOINT_OPTIONS). */
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

/** The options of a joint of any kind, as the caller gave them. */
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

/**
 * Writes a joint's options to the slots, as api_joint_create takes them, over the kind's defaults.
 * Throws "invalid" for unknown options, handles of another kind, and options that exclude each
 * other.
 */
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
  checkJoint(given.kind, given, OWN[given.kind]);
  writePlaces(s, given);
}

/**
 * Writes the places in the world, from which the module computes frames. The first number has a bit
 * for each of: frame a (1), frame b (2), length (4), and the angle from `axis` (8) is computed.
 */
function writePlaces(s: Float64Array, given: Given): void {
  const { kind, at, axis, angle, from = at, to = at } = given;
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

/** Writes the options of `drive` that are given to a direction of the joint in the slots. */
export function writeDrive(s: Float64Array, direction: number, drive: Drive, what: string): void {
  const numbers = numbersOf(what, drive, DRIVE_OPTIONS);
  fill(s, numbers, JointOptionsAt.along + DriveOptionsAt.length * direction);
}

/** The options of the joint that api_joint_options has written to the slots. */
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

/** A drive's options; infinite limits and targets, which mean none, are left out. */
function driveAt(s: Float64Array, at: number): Drive {
  const entries = DRIVE_OPTIONS.map((name, i) => [name, s[at + i]] as const);
  return Object.fromEntries(entries.filter(([, value]) => Number.isFinite(value)));
}

/**
 * Returns what `act` returns; where the engine refuses it, throws an error that names the option
 * that is wrong. `what`: the call, or the kind of the joint; `furthest`: see checks/joints.ts.
 */
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
