/**
 * Makes Box2D's joints from thud's. Both engines measure body b relative to body a, along the x
 * axis of a frame in each, and both tune springs by a frequency. The differences:
 *
 * - Box2D's distance joint keeps its length exactly unless its spring is on. So a rope (limits
 *   alone) has a spring of frequency 0.
 * - The springs of Box2D's wheel and motor joint (thud's target) are at rest at 0. Where thud's are
 *   at rest elsewhere, the frame in body a is moved there.
 * - Box2D's motor joint has one spring for along and across: it gets that of along.
 * - Box2D's weld joint has one spring for along and across, too.
 *
 * Box2D has no gears, no limits and motors of welds and targets, no springs and limits of a wheel's
 * rotation, and no force limit of springs but a target's.
 */
import type { AnyJointOptions, Drive, JointFrame } from "thud";
import type {
  b2BodyId,
  b2JointDef,
  b2JointId,
  b2Transform,
  b2WorldId,
} from "../../node_modules/box2d3-wasm/build/dist/es/deluxe/Box2D.deluxe";
import type { Common } from "./make";

/** The options of any joint but a gear. */
export type Tie = Exclude<AnyJointOptions, { kind: "gear" }>;

type Kind<K extends Tie["kind"]> = Extract<Tie, { kind: K }>;

/**
 * Largest force or torque that Box2D is given, where thud has no limit: Box2D's numbers are floats.
 */
const MOST = 1e30;
/** Largest length in metres, where thud has no limit: that of Box2D's own default definition. */
const LONGEST = 1e5;

/** The fields that the definitions of joints have in common. */
interface DriveDef {
  enableSpring: boolean;
  enableLimit: boolean;
  enableMotor: boolean;
  hertz: number;
  dampingRatio: number;
  motorSpeed: number;
}

/** Whether a drive has any effect. */
export function isDriven(drive: Drive = {}): boolean {
  const { frequency = 0, motorForce = 0 } = drive;
  return frequency > 0 || motorForce > 0 || isLimited(drive);
}

function isLimited({ lower = -Infinity, upper = Infinity }: Drive): boolean {
  return lower > -Infinity || upper < Infinity;
}

/** Creates a joint between two of Box2D's bodies. */
export function makeJoint(
  common: Common,
  world: b2WorldId,
  bodies: readonly [b2BodyId, b2BodyId],
  tie: Tie,
): b2JointId {
  const { box2d } = common;
  switch (tie.kind) {
    case "distance":
      return makeDistance(common, world, bodies, tie);
    case "hinge": {
      const def = box2d.b2DefaultRevoluteJointDef();
      setBase(common, def.base, bodies, tie);
      const { turn = {} } = tie;
      setDrive(def, turn, 1);
      def.targetAngle = turn.target ?? 0;
      def.lowerAngle = turn.lower ?? -Math.PI;
      def.upperAngle = turn.upper ?? Math.PI;
      def.maxMotorTorque = Math.min(MOST, (turn.motorForce ?? 0) / common.unit ** 2);
      return made(def, () => box2d.b2CreateRevoluteJoint(world, def));
    }
    case "slider": {
      const def = box2d.b2DefaultPrismaticJointDef();
      setBase(common, def.base, bodies, tie);
      const { along = {} } = tie;
      setDrive(def, along, common.unit);
      def.targetTranslation = (along.target ?? 0) / common.unit;
      setRange(def, along, common.unit, 0);
      def.maxMotorForce = Math.min(MOST, (along.motorForce ?? 0) / common.unit);
      return made(def, () => box2d.b2CreatePrismaticJoint(world, def));
    }
    case "weld": {
      const def = box2d.b2DefaultWeldJointDef();
      setBase(common, def.base, bodies, tie);
      const { along = {}, across = {}, turn = {} } = tie;
      const soft = (along.frequency ?? 0) > 0 ? along : across;
      [def.linearHertz, def.linearDampingRatio] = [soft.frequency ?? 0, soft.damping ?? 0];
      [def.angularHertz, def.angularDampingRatio] = [turn.frequency ?? 0, turn.damping ?? 0];
      return made(def, () => box2d.b2CreateWeldJoint(world, def));
    }
    case "wheel":
      return makeWheel(common, world, bodies, tie);
    case "target":
      return makeTarget(common, world, bodies, tie);
    case "filter": {
      const def = box2d.b2DefaultFilterJointDef();
      setBase(common, def.base, bodies, tie);
      return made(def, () => box2d.b2CreateFilterJoint(world, def));
    }
  }
}

function makeDistance(
  common: Common,
  world: b2WorldId,
  bodies: readonly [b2BodyId, b2BodyId],
  tie: Kind<"distance">,
): b2JointId {
  const { box2d, unit } = common;
  const { along = {} } = tie;
  const def = box2d.b2DefaultDistanceJointDef();
  setBase(common, def.base, bodies, tie);
  setDrive(def, along, unit);
  def.enableSpring = isDriven(along);
  const length = tie.length ?? 1;
  def.length = (isDriven(along) ? (along.target ?? length) : length) / unit;
  def.minLength = (along.lower ?? 0) / unit;
  def.maxLength = along.upper === undefined ? LONGEST : along.upper / unit;
  def.maxMotorForce = Math.min(MOST, (along.motorForce ?? 0) / unit);
  return made(def, () => box2d.b2CreateDistanceJoint(world, def));
}

function makeWheel(
  common: Common,
  world: b2WorldId,
  bodies: readonly [b2BodyId, b2BodyId],
  tie: Kind<"wheel">,
): b2JointId {
  const { box2d, unit } = common;
  const { along = {}, turn = {} } = tie;
  const def = box2d.b2DefaultWheelJointDef();
  setBase(common, def.base, bodies, tie);
  setDrive(def, along, unit);
  setRange(def, along, unit, along.target ?? 0);
  def.enableMotor = (turn.motorForce ?? 0) > 0;
  def.motorSpeed = turn.motorSpeed ?? 0;
  def.maxMotorTorque = Math.min(MOST, (turn.motorForce ?? 0) / unit ** 2);
  return made(def, () => box2d.b2CreateWheelJoint(world, def));
}

function makeTarget(
  common: Common,
  world: b2WorldId,
  bodies: readonly [b2BodyId, b2BodyId],
  tie: Kind<"target">,
): b2JointId {
  const { box2d, unit } = common;
  const { along = {}, across = {}, turn = {} } = tie;
  const def = box2d.b2DefaultMotorJointDef();
  setBase(common, def.base, bodies, tie);
  const most = (force: number | undefined, usual: number, per: number) =>
    Math.min(MOST, (force ?? usual) / per);
  def.linearHertz = along.frequency ?? 0;
  def.linearDampingRatio = along.damping ?? 0;
  def.maxSpringForce = most(along.springForce, MOST, unit);
  def.angularHertz = turn.frequency ?? 0;
  def.angularDampingRatio = turn.damping ?? 0;
  def.maxSpringTorque = most(turn.springForce, MOST, unit ** 2);
  def.linearVelocity.Set((along.motorSpeed ?? 0) / unit, (across.motorSpeed ?? 0) / unit);
  def.maxVelocityForce = most(along.motorForce, 0, unit);
  def.angularVelocity = turn.motorSpeed ?? 0;
  def.maxVelocityTorque = most(turn.motorForce, 0, unit ** 2);
  return made(def, () => box2d.b2CreateMotorJoint(world, def));
}

/** The joint's frame in body a for Box2D, whose springs are at rest at 0. */
export function frameOfA(tie: Tie): JointFrame | undefined {
  if (tie.kind === "filter") return undefined;
  if (tie.kind === "wheel") return restingFrame(tie.frameA, tie.along?.target ?? 0, 0);
  if (tie.kind !== "target") return tie.frameA;
  const { along, across, turn } = tie;
  const frame = restingFrame(tie.frameA, along?.target ?? 0, across?.target ?? 0);
  return { ...frame, angle: (frame.angle ?? 0) + (turn?.target ?? 0) };
}

/** A frame that is moved along and across its own axis. */
function restingFrame(
  { position = [0, 0], angle = 0 }: JointFrame = {},
  along: number,
  across: number,
): JointFrame {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const [x, y] = position;
  return { position: [x + along * c - across * s, y + along * s + across * c], angle };
}

/** Writes a frame to Box2D's transform, in metres. */
export function setFrame(
  { unit }: Common,
  transform: b2Transform,
  { position = [0, 0], angle = 0 }: JointFrame = {},
): void {
  transform.p.Set(position[0] / unit, position[1] / unit);
  transform.q.c = Math.cos(angle);
  transform.q.s = Math.sin(angle);
}

/** Sets what all kinds of joints have in common. */
function setBase(
  common: Common,
  base: b2JointDef,
  [a, b]: readonly [b2BodyId, b2BodyId],
  tie: Tie,
): void {
  base.bodyIdA = a;
  base.bodyIdB = b;
  base.collideConnected = tie.collideConnected ?? false;
  setFrame(common, base.localFrameA, frameOfA(tie));
  setFrame(common, base.localFrameB, tie.kind === "filter" ? undefined : tie.frameB);
}

/**
 * Sets spring, limit and motor. `unit` is the length of a metre in the world's units, or 1 for
 * rotation.
 */
function setDrive(def: DriveDef, drive: Drive, unit: number): void {
  def.enableSpring = (drive.frequency ?? 0) > 0;
  def.hertz = drive.frequency ?? 0;
  def.dampingRatio = drive.damping ?? 0;
  def.enableLimit = isLimited(drive);
  def.enableMotor = (drive.motorForce ?? 0) > 0;
  def.motorSpeed = (drive.motorSpeed ?? 0) / unit;
}

/** Sets the limits, relative to the position at which the spring is at rest. */
function setRange(
  def: { lowerTranslation: number; upperTranslation: number },
  { lower = -Infinity, upper = Infinity }: Drive,
  unit: number,
  rest: number,
): void {
  def.lowerTranslation = Math.max(-LONGEST, (lower - rest) / unit);
  def.upperTranslation = Math.min(LONGEST, (upper - rest) / unit);
}

/** Creates a joint, and frees its definition. */
function made(def: { delete(): void }, make: () => b2JointId): b2JointId {
  const joint = make();
  def.delete();
  return joint;
}
