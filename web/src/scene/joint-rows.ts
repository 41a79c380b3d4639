/** Joints as a frame has them: what the page needs to draw them where it draws their bodies. */

/** Numbers a joint. */
export const JOINT = 14;
/** Where they stand; of pairs the first. The kind is a place in JOINT_KINDS of the package. */
export const KIND = 0;
export const SLOT_A = 1;
export const SLOT_B = 2;
/** 1 if its spring acts along it. */
export const SPRUNG = 3;
/** Where it is in each body, and its axis in the first: cosine and sine. */
export const ANCHOR_A = 4;
export const ANCHOR_B = 6;
export const AXIS = 8;
/** The least and the most along it, and of its turn; equal where it is locked. */
export const ALONG = 10;
export const TURN_RANGE = 12;

/** Numbers a joint of what each bears: gap, angle, and the force on its second body. */
export const BEARING = 4;

/** What all joints come to, asleep or not; lengths and radians. */
export interface Gaps {
  joints: number;
  worst: number;
  mean: number;
  angle: number;
}
