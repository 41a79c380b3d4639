/** What the world knows of one body, for the card of a body that the visitor points at. */
import type { BodyState, JointKind, ShapeState, Vec2, World } from "thud";
import { shapesOf } from "./lookup";

/** Plain data: everything that stands on the card. */
export interface BodyReport {
  /** Steps made when this was so. */
  step: number;
  slot: number;
  state: BodyState;
  shapes: ShapeState[];
  contacts: Touch[];
  joints: Tie[];
}

/** A joint of the body. */
export interface Tie {
  kind: JointKind;
  /** The slot of the other body. */
  other: number;
  enabled: boolean;
  /** By how much it is open, a length and radians. */
  gap: number;
  angleGap: number;
  /** What it bears, without a direction. */
  force: number;
  torque: number;
}

/** A contact as seen from the body. */
export interface Touch {
  /** The slot of the other body. */
  other: number;
  /** Out of the other body, into this one. */
  normal: Vec2;
  points: number;
  /** Of the deepest point; negative while it is apart. */
  depth: number;
  /** Of all points: mass times speed that the step gave along the normal, and across it. */
  impulse: number;
  friction: number;
  /** Its island was solved at once. */
  direct: boolean;
}

/** Null if no body has the slot any more. */
export function inspect(world: World, step: number, slot: number): BodyReport | null {
  const shapes = shapesOf(world, slot).map((shape) => world.shapeState(shape));
  if (shapes.length === 0) return null;
  const { body } = shapes[0];
  // Without points a pair is only about to touch again.
  const touching = world.contactsOf(body).filter(({ points }) => points.length > 0);
  const contacts = touching.map((contact): Touch => {
    const { bodyA, bodyB, normal, points, tangentImpulse, direct } = contact;
    const isA = bodyA.index === slot;
    return {
      other: (isA ? bodyB : bodyA).index,
      normal: isA ? [-normal[0], -normal[1]] : normal,
      points: points.length,
      depth: Math.max(...points.map(({ separation }) => -separation)),
      impulse: points.reduce((sum, { normalImpulse }) => sum + normalImpulse, 0),
      friction: Math.abs(tangentImpulse),
      direct,
    };
  });
  const joints = world.jointsOf(body).map((joint): Tie => {
    const { kind, bodyA, bodyB, enabled, gap, angleGap, force, torque } = world.jointState(joint);
    const other = (bodyA.index === slot ? bodyB : bodyA).index;
    const bears = { force: Math.hypot(...force), torque: Math.abs(torque) };
    return { kind, other, enabled, gap, angleGap, ...bears };
  });
  return { step, slot, state: world.bodyState(body), shapes, contacts, joints };
}
