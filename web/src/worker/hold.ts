/**
 * The visitor's hand: a target joint that pulls the place where a body was taken to the pointer,
 * softly, and no harder than the body's own weight allows. Another body without shapes holds the
 * joint's other end, so that it is as exact wherever the scene is. All of it is in the world, and so
 * in every snapshot of it.
 */
import type { BodyId, JointId, Vec2, World } from "thud";
import type { Command } from "./commands";
import { inWorld } from "./hands";
import { bodyInSlot } from "./lookup";

/** Plain data. */
export interface Pull {
  body: BodyId;
  /** Where it was taken, in the body's frame. */
  anchor: Vec2;
  /** The pointer, now and when the body was taken. */
  target: Vec2;
  start: Vec2;
  holder: BodyId;
  joint: JointId;
}

/** Hz; critically damped, it comes soon and not too far. */
const FREQUENCY = 5;
/** The most that it pulls in each direction: so many length scales/s² for the body's mass. */
const STRENGTH = 400;
/** Length scales from which on it pulls as hard as it can. */
const FAR = STRENGTH / (2 * Math.PI * FREQUENCY) ** 2;
/** A damper of its turning, 5 times its inertia: a body on a short line swings for ever without. */
const TURNING = { frequency: 0.05, damping: 8 } as const;

/** Null if the slot has no body that can be pulled. */
export function takeHold(
  world: World,
  { slot, anchor, x, y }: Extract<Command, { kind: "grab" }>,
  lengthScale: number,
): Pull | null {
  const body = bodyInSlot(world, slot);
  if (!body || !canMove(world, body)) return null;
  const { mass, angle } = world.bodyState(body);
  const start: Vec2 = [x, y];
  const spring = {
    frequency: FREQUENCY,
    damping: 1,
    springForce: Math.min(1e30, STRENGTH * lengthScale * mass),
  };
  const holder = world.createBody({ position: start });
  const joint = world.createJoint({
    kind: "target",
    bodyA: holder,
    bodyB: body,
    frameA: { position: [0, 0] },
    frameB: { position: anchor, angle: -angle },
    along: spring,
    across: spring,
    turn: TURNING,
  });
  return { body, anchor, target: start, start, holder, joint };
}

export function moveHold(world: World, pull: Pull, [x, y]: Vec2): void {
  if (x === pull.target[0] && y === pull.target[1]) return;
  pull.target = [x, y];
  if (!world.isValid(pull.joint)) return;
  const [x0, y0] = pull.start;
  world.setJointFrame(pull.joint, "a", { position: [x - x0, y - y0] });
}

/**
 * Before each step. Force is limited along and across by itself: where the pointer is far, along is
 * turned towards it, so that the body comes straight. Near by nothing is touched, and the body may
 * fall asleep in the hand.
 */
export function aimHold(world: World, { body, anchor, target, joint }: Pull, lengthScale: number): void {
  const [x, y] = inWorld(world.bodyState(body), anchor);
  const [dx, dy] = [target[0] - x, target[1] - y];
  if (Math.hypot(dx, dy) < FAR * lengthScale) return;
  world.setJointFrame(joint, "a", { angle: Math.atan2(dy, dx) });
}

export function letGo(world: World, { holder, joint }: Pull): void {
  if (world.isValid(joint)) world.destroy(joint);
  if (world.isValid(holder)) world.destroy(holder);
}

/** Whether there is still something to be pulled. */
export function holds(world: World, { body, joint }: Pull): boolean {
  return world.isValid(joint) && canMove(world, body);
}

function canMove(world: World, body: BodyId): boolean {
  if (!world.isValid(body)) return false;
  const { kind, enabled, quarantined } = world.bodyState(body);
  return kind === "dynamic" && enabled && !quarantined;
}
