/**
 * The state of one body as the world reports it, for the card of the body that the visitor points
 * at.
 */
import type { BodyState, JointKind, ShapeState, Vec2, World } from "thud";
import { shapesOf } from "./lookup";

/** Everything that the card shows. Plain data. */
export interface BodyReport {
  /** The number of steps made at the time of the report. */
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
  /** How far the joint is open: a length, and radians. See JointState. */
  gap: number;
  angleGap: number;
  /** Magnitudes of the force and of the torque that the joint bears. */
  force: number;
  torque: number;
}

/** A contact as seen from the body. */
export interface Touch {
  /** The slot of the other body. */
  other: number;
  /** The normal, out of the other body into this one. */
  normal: Vec2;
  points: number;
  /** Overlap of the deepest point, a length; negative while the shapes are apart. */
  depth: number;
  /**
   * Impulses of the step, summed over all points: along the normal, and the magnitude across it.
   */
  impulse: number;
  friction: number;
  /** Whether the contact's island was solved by the direct solver. */
  direct: boolean;
}

/** The report of the body in a slot; null if the slot has no body with shapes. */
export function inspect(world: World, step: number, slot: number): BodyReport | null {
  const shapes = shapesOf(world, slot).map((shape) => world.shapeStateOf(shape));
  if (shapes.length === 0) return null;
  const { body } = shapes[0];
  // A contact without points does not touch at present.
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
    const { kind, bodyA, bodyB, enabled, gap, angleGap, force, torque } = world.jointStateOf(joint);
    const other = (bodyA.index === slot ? bodyB : bodyA).index;
    const bears = { force: Math.hypot(...force), torque: Math.abs(torque) };
    return { kind, other, enabled, gap, angleGap, ...bears };
  });
  return { step, slot, state: world.bodyStateOf(body), shapes, contacts, joints };
}
