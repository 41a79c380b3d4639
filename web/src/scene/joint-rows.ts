/** The layout of joints in a frame: what the page needs to draw them. */

/** Numbers per joint. */
export const JOINT = 14;
/**
 * Positions of the numbers; of a pair, of its first number. KIND is an index into JOINT_KINDS of
 * the package.
 */
export const KIND = 0;
export const SLOT_A = 1;
export const SLOT_B = 2;
/** 1 if a spring acts along the joint. */
export const SPRUNG = 3;
/**
 * The joint's place in each body's frame; and its axis in the first body's frame, as cosine and
 * sine.
 */
export const ANCHOR_A = 4;
export const ANCHOR_B = 6;
export const AXIS = 8;
/**
 * Lower and upper limit of the distance along the joint, and of its angle; equal where it is
 * locked.
 */
export const ALONG = 10;
export const TURN_RANGE = 12;

/**
 * Numbers per joint in `Frame.bearings`: gap, angle of the gap, and x and y of the force on its
 * second body.
 */
export const BEARING = 4;

/**
 * How far all joints are open, also those that sleep: number of joints, largest and mean gap
 * (lengths), and largest angle (radians).
 */
export interface Gaps {
  joints: number;
  worst: number;
  mean: number;
  angle: number;
}
