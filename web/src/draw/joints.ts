/**
 * Draws joints over the bodies of either engine. Each end is drawn where that engine's body has it,
 * so that a joint that is open is drawn open.
 *
 * Sizes follow those of the dynamic bodies that a joint ties: "half" is half the width of the
 * thinner one, "length" is the length of the shorter one, both in world units. All sizes here are
 * chosen.
 */
import { JOINT_KINDS } from "thud";
import {
  ALONG,
  ANCHOR_A,
  ANCHOR_B,
  AXIS,
  BEARING,
  JOINT,
  KIND,
  SLOT_A,
  SLOT_B,
  SPRUNG,
} from "../scene/joint-rows";
import type { Shapes } from "../scene/frame";
import { BODY, DYNAMIC, HALF, ROW, SLOT } from "../scene/shape-table";
import type { Camera, Pane } from "./camera";
import { addRope, addSpring, addSquare, JointPaths } from "./joint-paths";
import type { JointInks } from "./palette";
import { poseBetween, type Poses } from "./poses";

/** Half the width of a pin, and the width of a line: shares of "half". */
const PIN = 0.42;
const BAR = 0.55;
/** Bounds of half a pin's width and of a line's width, in CSS pixels. */
const PINS = [1.6, 7] as const;
const BARS = [1.2, 5] as const;
/** A pin with a smaller half width, in CSS pixels, is drawn as a dot without an edge. */
const EDGED = 2.4;
/**
 * Largest half width of a pin, and largest radius of a ring around a joint that is open: shares of
 * "length", so that in a chain of short bodies they do not touch.
 */
const ROOM = 0.2;
const RING_ROOM = 0.45;
/**
 * Width of a spring's line (share of "half", and bounds in CSS pixels), and its amplitude (share of
 * "half").
 */
const WIRE = 0.2;
const WIRES = [1, 2.5] as const;
const COIL = 0.3;
/** "half" of a joint without a dynamic body that has shapes, in world units. */
const USUAL_HALF = 0.25;
/** A joint is marked as open from this gap on, a share of "length". */
const OPEN_PART = 0.01;
/** A joint is marked as open from this angle on, in radians. */
const OPEN_ANGLE = 0.01;
/**
 * Length of the arrow of the largest force: bounds in CSS pixels, and the share of the bodies'
 * average "length". The share is below 1, so that the arrows of neighbouring joints do not overlap.
 */
const FORCES = [8, 48] as const;
const FORCE = 0.8;
/** A wheel with a smaller radius, in CSS pixels, is drawn without its spring. */
const SPRUNG_WHEEL = 5;
/** Joints further outside of the pane than this, in CSS pixels, are not drawn. */
const MARGIN = 200;

/**
 * The places of a joint's ends on the screen, in CSS pixels: a in the first body, b in the second.
 */
interface Ends {
  ax: number;
  ay: number;
  bx: number;
  by: number;
  /** The joint's axis, a unit vector that is fixed in the first body. */
  ux: number;
  uy: number;
  /** The first body's origin. */
  cx: number;
  cy: number;
}

type Draw = (paths: JointPaths, joint: Joint, ends: Ends, scale: number) => void;

/** A joint, its row of the table (joint-rows.ts), and how it is drawn. */
interface Joint {
  draw: Draw;
  slotA: number;
  slotB: number;
  row: Float32Array;
  /** "half" and "length", as above. */
  half: number;
  length: number;
}

/** How each kind is drawn. A kind that is not listed is not drawn. */
const DRAWN: Partial<Record<(typeof JOINT_KINDS)[number], Draw>> = {
  distance(paths, { row, half }, { ax, ay, bx, by }, scale) {
    const [lower, upper] = [row[ALONG], row[ALONG + 1]];
    const sprung = row[SPRUNG] !== 0;
    const width = sprung ? within(WIRE * half * scale, WIRES) : within(BAR * half * scale, BARS);
    if (sprung) addSpring(paths.line("spring", width), ax, ay, bx, by, COIL * half * scale);
    else if (lower === upper) paths.segment("metal", width, ax, ay, bx, by);
    else addRope(paths.line("rope", 0.8 * width), ax, ay, bx, by, upper * scale);
    paths.dot("metal", 0.9 * width + 0.4, ax, ay);
    paths.dot("metal", 0.9 * width + 0.4, bx, by);
  },
  hinge: (paths, joint, { bx, by }, scale) => addPin(paths, joint, PIN, bx, by, scale),
  slider(paths, { row, half, length }, { ax, ay, bx, by, ux, uy }, scale) {
    const reach = Math.max(2 * length * scale, 1.2 * Math.hypot(bx - ax, by - ay));
    const at = (value: number, open: number) => (Number.isFinite(value) ? value * scale : open);
    const [from, to] = [at(row[ALONG], -reach), at(row[ALONG + 1], reach)];
    const width = within(0.3 * half * scale, BARS);
    paths.segment("metal", width, ax + from * ux, ay + from * uy, ax + to * ux, ay + to * uy);
    const stop = within(0.5 * half * scale, [2, 8]);
    for (const end of [row[ALONG], row[ALONG + 1]]) {
      if (!Number.isFinite(end)) continue;
      const [x, y] = [ax + end * scale * ux, ay + end * scale * uy];
      paths.segment("metal", width, x - stop * uy, y + stop * ux, x + stop * uy, y - stop * ux);
    }
    addSquare(paths.plate(), bx, by, ux, uy, within(PIN * half * scale, PINS), 1.6);
  },
  weld(paths, joint, { bx, by, ux, uy }, scale) {
    const size = pinOf(joint, 0.3, scale);
    if (size < EDGED) paths.dot("metal", size, bx, by);
    else addSquare(paths.plate(), bx, by, ux, uy, size, 1.9);
  },
  wheel(paths, joint, { ax, ay, bx, by, ux, uy, cx, cy }, scale) {
    // The spring goes from a point of the first body down to the hub. That point is as far from the
    // anchor along the axis as the body's origin is, but at least 1.3 and at most 2.4 radii of the
    // wheel.
    const rise = (cx - ax) * ux + (cy - ay) * uy;
    const size = joint.half * scale;
    if (size < SPRUNG_WHEEL) return addPin(paths, joint, 0.8 * PIN, bx, by, scale);
    const high = Math.sign(rise || 1) * within(Math.abs(rise), [1.3 * size, 2.4 * size]);
    const width = within(0.16 * size, BARS);
    const [topX, topY] = [ax + high * ux, ay + high * uy];
    addSpring(paths.line("spring", width), topX, topY, bx, by, 0.5 * size);
    paths.dot("metal", width + 0.6, topX, topY);
    addPin(paths, joint, 0.8 * PIN, bx, by, scale);
  },
  target(paths, { half }, { ax, ay, bx, by }, scale) {
    const width = within(0.4 * half * scale, BARS);
    paths.segment("band", width, ax, ay, bx, by);
    paths.dot("band", width + 1, ax, ay);
    paths.dot("band", width + 1, bx, by);
  },
  gear: (paths, _, { ax, ay, bx, by }) => paths.dash(ax, ay, bx, by),
};

/** Half the width of a pin in CSS pixels; `part` is its share of "half". */
function pinOf({ half, length }: Joint, part: number, scale: number): number {
  return Math.min(within(part * half * scale, PINS), ROOM * length * scale);
}

/** Radius of the ring around a joint that is open, in CSS pixels. */
function ringOf(joint: Joint, scale: number): number {
  return Math.max(2, Math.min(pinOf(joint, PIN, scale) + 4, RING_ROOM * joint.length * scale));
}

function addPin(
  paths: JointPaths,
  joint: Joint,
  part: number,
  x: number,
  y: number,
  scale: number,
): void {
  const radius = pinOf(joint, part, scale);
  if (radius < EDGED) paths.dot("metal", radius, x, y);
  else paths.pin(radius, x, y);
}

export class Joints {
  #rows: Float32Array | null = null;
  #shapes: Shapes | null = null;
  #joints: Joint[] = [];
  /** Mean "length" of all joints. */
  #length = 0;

  /** Sets the joints. Does nothing if both arguments are the same objects as before. */
  set(rows: Float32Array, shapes: Shapes | null): void {
    if (rows === this.#rows && shapes === this.#shapes) return;
    [this.#rows, this.#shapes] = [rows, shapes];
    const sizes = sizesOf(shapes);
    this.#joints = [];
    for (let at = 0; at < rows.length; at += JOINT) {
      const row = rows.subarray(at, at + JOINT);
      const [slotA, slotB] = [row[SLOT_A], row[SLOT_B]];
      const draw = DRAWN[JOINT_KINDS[row[KIND]]] ?? drawNothing;
      const two = [slotA, slotB].flatMap((slot) => sizes.get(slot) ?? []);
      const half = two.length > 0 ? Math.min(...two.map((size) => size.half)) : USUAL_HALF;
      const length = two.length > 0 ? Math.min(...two.map((size) => size.length)) : 2 * half;
      this.#joints.push({ draw, slotA, slotB, row, half, length });
    }
    this.#length = this.#joints.reduce((sum, { length }) => sum + length, 0) / this.#joints.length;
  }

  /**
   * Draws on a canvas in CSS pixels. With `bearings` (BEARING in joint-rows.ts), gaps and forces
   * are drawn, too.
   */
  draw(
    context: CanvasRenderingContext2D,
    camera: Camera,
    pane: Pane,
    inks: JointInks,
    poses: Poses,
    bearings?: Float32Array,
  ): void {
    const paths = new JointPaths();
    const ends: Ends = { ax: 0, ay: 0, bx: 0, by: 0, ux: 1, uy: 0, cx: 0, cy: 0 };
    const { scale } = camera;
    const known = bearings?.length === BEARING * this.#joints.length ? bearings : null;
    const largest = known ? largestForce(known) : 1;
    const reach = within(FORCE * this.#length * scale, FORCES);
    this.#joints.forEach((joint, i) => {
      if (!endsOf(joint, poses, scale, pane, ends)) return;
      joint.draw(paths, joint, ends, scale);
      if (!known) return;
      const [gap, angle, x, y] = known.subarray(BEARING * i, BEARING * (i + 1));
      paths.force(ends.bx, ends.by, x / largest, -y / largest, reach);
      if (gap > OPEN_PART * joint.length || angle > OPEN_ANGLE)
        paths.gap(ringOf(joint, scale), ends);
    });
    paths.draw(context, inks);
  }
}

function largestForce(bearings: Float32Array): number {
  let most = Number.MIN_VALUE;
  for (let at = 0; at < bearings.length; at += BEARING)
    most = Math.max(most, Math.hypot(bearings[at + 2], bearings[at + 3]));
  return most;
}

function drawNothing(): void {}

/**
 * Computes the ends of a joint. False if a body is missing, or both ends are far outside of the
 * pane.
 */
function endsOf(joint: Joint, poses: Poses, scale: number, pane: Pane, ends: Ends): boolean {
  const { row, slotA, slotB } = joint;
  if (!poseBetween(poses, slotB, POSE)) return false;
  const { middleX, middleY } = pane;
  place(POSE, row[ANCHOR_B], row[ANCHOR_B + 1]);
  ends.bx = middleX + PLACE[0] * scale;
  ends.by = middleY - PLACE[1] * scale;
  if (!poseBetween(poses, slotA, POSE)) return false;
  place(POSE, row[ANCHOR_A], row[ANCHOR_A + 1]);
  ends.ax = middleX + PLACE[0] * scale;
  ends.ay = middleY - PLACE[1] * scale;
  const [x, y, c, s] = POSE;
  ends.cx = middleX + x * scale;
  ends.cy = middleY - y * scale;
  ends.ux = c * row[AXIS] - s * row[AXIS + 1];
  ends.uy = -(s * row[AXIS] + c * row[AXIS + 1]);
  const { left, top, width, height } = pane;
  const [x0, x1] = [Math.min(ends.ax, ends.bx), Math.max(ends.ax, ends.bx)];
  const [y0, y1] = [Math.min(ends.ay, ends.by), Math.max(ends.ay, ends.by)];
  return (
    x1 > left - MARGIN && x0 < left + width + MARGIN && y1 > top - MARGIN && y0 < top + height + MARGIN
  );
}

/** Scratch values of `endsOf`. */
const POSE = new Float64Array(4);
const PLACE = new Float64Array(2);

/** Transforms a point of a body to the world, into PLACE. */
function place([x, y, c, s]: Float64Array, px: number, py: number): void {
  PLACE[0] = x + c * px - s * py;
  PLACE[1] = y + s * px + c * py;
}

/** "half" and "length" of each dynamic body, by slot. */
function sizesOf(shapes: Shapes | null): Map<number, { half: number; length: number }> {
  const sizes = new Map<number, { half: number; length: number }>();
  if (!shapes) return sizes;
  for (let at = 0; at < shapes.rows.length; at += ROW) {
    if (shapes.rows[at + BODY] !== DYNAMIC) continue;
    const [hx, hy] = [shapes.rows[at + HALF], shapes.rows[at + HALF + 1] || Infinity];
    const slot = shapes.rows[at + SLOT];
    const known = sizes.get(slot);
    const half = Math.min(hx, hy, known?.half ?? Infinity);
    const longer = 2 * Math.max(hx, hy < Infinity ? hy : 0);
    sizes.set(slot, { half, length: Math.max(longer, known?.length ?? 0) });
  }
  return sizes;
}

function within(value: number, [least, most]: readonly [number, number]): number {
  return Math.min(most, Math.max(least, value));
}
