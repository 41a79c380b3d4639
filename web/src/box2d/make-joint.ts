/**
 * Makes Box2D's joints of thud's. Both look at body b from body a, with the x axis of a frame in each;
 * springs of both are tuned by frequency about the mass that the bodies have there. What needs
 * translation:
 *
 * - A distance gives way only with its spring on, so that a rope has one of no stiffness.
 * - A wheel's and a target's spring have their rest at 0: where thud's have it elsewhere, the frame
 *   is moved there. A target pulls alike along and across, as the axis has it.
 * - A weld that gives way does so by a spring alone, along and across alike.
 *
 * Box2D has no gears, no limits and motors of welds and targets, no springs and limits of a wheel's
 * axle, and no greatest force of other springs than a target's.
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

/** All but gears. */
export type Tie = Exclude<AnyJointOptions, { kind: "gear" }>;

type Kind<K extends Tie["kind"]> = Extract<Tie, { kind: K }>;

/** Box2D keeps numbers of 32 bits. */
const MOST = 1e30;
/** Metres, of a spring without limits: those that Box2D's own definition has. */
const LONGEST = 1e5;

/** What differs between the definitions of springs, motors and limits. */
interface DriveDef {
  enableSpring: boolean;
  enableLimit: boolean;
  enableMotor: boolean;
  hertz: number;
  dampingRatio: number;
  motorSpeed: number;
}

export function isDriven(drive: Drive = {}): boolean {
  const { frequency = 0, motorForce = 0 } = drive;
  return frequency > 0 || motorForce > 0 || isLimited(drive);
}

function isLimited({ lower = -Infinity, upper = Infinity }: Drive): boolean {
  return lower > -Infinity || upper < Infinity;
}

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

/** Where Box2D is to have it in body a: its springs rest at 0. */
export function frameOfA(tie: Tie): JointFrame | undefined {
  if (tie.kind === "filter") return undefined;
  if (tie.kind === "wheel") return restingFrame(tie.frameA, tie.along?.target ?? 0, 0);
  if (tie.kind !== "target") return tie.frameA;
  const { along, across, turn } = tie;
  const frame = restingFrame(tie.frameA, along?.target ?? 0, across?.target ?? 0);
  return { ...frame, angle: (frame.angle ?? 0) + (turn?.target ?? 0) };
}

/** A frame moved along its axis, and across. */
function restingFrame(
  { position = [0, 0], angle = 0 }: JointFrame = {},
  along: number,
  across: number,
): JointFrame {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const [x, y] = position;
  return { position: [x + along * c - across * s, y + along * s + across * c], angle };
}

export function setFrame(
  { unit }: Common,
  transform: b2Transform,
  { position = [0, 0], angle = 0 }: JointFrame = {},
): void {
  transform.p.Set(position[0] / unit, position[1] / unit);
  transform.q.c = Math.cos(angle);
  transform.q.s = Math.sin(angle);
}

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

/** `unit` is 1 of turns. */
function setDrive(def: DriveDef, drive: Drive, unit: number): void {
  def.enableSpring = (drive.frequency ?? 0) > 0;
  def.hertz = drive.frequency ?? 0;
  def.dampingRatio = drive.damping ?? 0;
  def.enableLimit = isLimited(drive);
  def.enableMotor = (drive.motorForce ?? 0) > 0;
  def.motorSpeed = (drive.motorSpeed ?? 0) / unit;
}

/** Limits are about where the spring rests. */
function setRange(
  def: { lowerTranslation: number; upperTranslation: number },
  { lower = -Infinity, upper = Infinity }: Drive,
  unit: number,
  rest: number,
): void {
  def.lowerTranslation = Math.max(-LONGEST, (lower - rest) / unit);
  def.upperTranslation = Math.min(LONGEST, (upper - rest) / unit);
}

function made(def: { delete(): void }, make: () => b2JointId): b2JointId {
  const joint = make();
  def.delete();
  return joint;
}
