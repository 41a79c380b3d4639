/**
 * The visitor's pull at a body: a target joint that pulls an anchor on the body to the pointer, by
 * a soft spring whose force is limited in proportion to the body's mass. The joint's other end is
 * on a static body without shapes at the place where the pull began, so that the joint is equally
 * exact wherever in the world it is. Both are part of the world, and so of each snapshot.
 */
import type { BodyId, JointId, Vec2, World } from "thud";
import type { Command } from "./commands";
import { inWorld } from "./hands";
import { bodyInSlot } from "./lookup";

/** A pull that is under way. Plain data, so that moments of the past can keep it. */
export interface Pull {
  body: BodyId;
  /** The place where the body was taken, in its frame. */
  anchor: Vec2;
  /** The place of the pointer in the world: now, and when the body was taken. */
  target: Vec2;
  start: Vec2;
  /** The body at the joint's other end. */
  holder: BodyId;
  joint: JointId;
}

/** Frequency of the spring in Hz. Chosen; the spring is critically damped. */
const FREQUENCY = 5;
/** Largest force along and across, per mass of the body, in length scales/s². Chosen. */
const STRENGTH = 400;
/**
 * Distance from the pointer, in length scales, from which the spring's force is the largest: at
 * rest, d (2 pi FREQUENCY)² = STRENGTH.
 */
const FAR = STRENGTH / (2 * Math.PI * FREQUENCY) ** 2;
/**
 * A damper of the body's rotation, of 2 damping (2 pi frequency) = 5 times its inertia: angular
 * velocity decays at a rate of 5/s. Without it a body that hangs from the pointer swings on and on.
 */
const TURNING = { frequency: 0.05, damping: 8 } as const;

/** Creates the joint. Null if the slot has no body that can be pulled. */
export function takeHold(
  world: World,
  { slot, anchor, x, y }: Extract<Command, { kind: "grab" }>,
  lengthScale: number,
): Pull | null {
  const body = bodyInSlot(world, slot);
  if (!body || !canMove(world, body)) return null;
  const { mass, angle } = world.bodyStateOf(body);
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

/** Moves the joint's target to the pointer. */
export function moveHold(world: World, pull: Pull, [x, y]: Vec2): void {
  if (x === pull.target[0] && y === pull.target[1]) return;
  pull.target = [x, y];
  if (!world.isValid(pull.joint)) return;
  const [x0, y0] = pull.start;
  world.setJointFrame(pull.joint, "a", { position: [x - x0, y - y0] });
}

/**
 * To be called before each step. The joint limits its force along and across separately. So where
 * the pointer is far, the axis along is turned towards it, and the body is pulled straight. Near
 * the pointer the joint is not changed, so that the body can fall asleep.
 */
export function aimHold(world: World, { body, anchor, target, joint }: Pull, lengthScale: number): void {
  const [x, y] = inWorld(world.bodyStateOf(body), anchor);
  const [dx, dy] = [target[0] - x, target[1] - y];
  if (Math.hypot(dx, dy) < FAR * lengthScale) return;
  world.setJointFrame(joint, "a", { angle: Math.atan2(dy, dx) });
}

/** Removes the joint and the body at its other end. */
export function letGo(world: World, { holder, joint }: Pull): void {
  if (world.isValid(joint)) world.destroy(joint);
  if (world.isValid(holder)) world.destroy(holder);
}

/** Whether the joint and the body still exist, and the body can still be pulled. */
export function holds(world: World, { body, joint }: Pull): boolean {
  return world.isValid(joint) && canMove(world, body);
}

/**
 * Whether a body exists, is dynamic and enabled, and is not quarantined (a body whose motion is not
 * a number).
 */
function canMove(world: World, body: BodyId): boolean {
  if (!world.isValid(body)) return false;
  const { kind, enabled, quarantined } = world.bodyStateOf(body);
  return kind === "dynamic" && enabled && !quarantined;
}
