/**
 * Joints, drawn over the bodies of whichever engine: each where its own engine's bodies hold it, so
 * that it is open on the screen as it is there.
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

/** Of the thinner body: half a pin's width, and the width of what is drawn as a line. */
const PIN = 0.42;
const BAR = 0.55;
/** CSS pixels: pins and lines are within these. */
const PINS = [1.6, 7] as const;
const BARS = [1.2, 5] as const;
/** CSS pixels: a pin that is smaller has no edge, which would be most of it. */
const EDGED = 2.4;
/** Of a body's length, to each side: pins, and rings around what is open, do not run into a line. */
const ROOM = 0.2;
const RING_ROOM = 0.45;
/** Of the thinner body: a spring's line and how far it goes to each side; both within CSS pixels. */
const WIRE = 0.2;
const WIRES = [1, 2.5] as const;
const COIL = 0.3;
/** Of what nothing is known: a body in metres, or as the page's bodies are. */
const USUAL_HALF = 0.25;
/** Of a body: what is open further is shown. */
const OPEN_PART = 0.01;
/** Radians likewise. */
const OPEN_ANGLE = 0.01;
/** Pixels of the largest force: most of a body's length, so that one joint's ends before the next. */
const FORCES = [8, 48] as const;
const FORCE = 0.8;
/** Half a wheel that is smaller, in pixels, has no room for a spring. */
const SPRUNG_WHEEL = 5;
/** Pixels outside the pane from which on nothing is seen. */
const MARGIN = 200;

/** A joint's ends and its axis on the screen, in CSS pixels. */
interface Ends {
  ax: number;
  ay: number;
  bx: number;
  by: number;
  /** Of the first body's axis, on the screen; a unit. */
  ux: number;
  uy: number;
  /** Of the first body's origin. */
  cx: number;
  cy: number;
}

type Draw = (paths: JointPaths, joint: Joint, ends: Ends, scale: number) => void;

interface Joint {
  draw: Draw;
  slotA: number;
  slotB: number;
  row: Float32Array;
  /** Half the width of the thinner of its bodies, and how long the smaller one is. */
  half: number;
  length: number;
}

/** By kind; what is not here has nothing to be seen. */
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
    // From under the body down to the hub, as far as the body's middle is above it.
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

/** Half a pin's width in pixels: of a part of the thinner body, and narrower where that is small. */
function pinOf({ half, length }: Joint, part: number, scale: number): number {
  return Math.min(within(part * half * scale, PINS), ROOM * length * scale);
}

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
  /** Of the smaller body of each, on average. */
  #length = 0;

  /** The same ones again cost nothing. */
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

  /** On a canvas in CSS pixels; `bearings` of those joints show what is open, and forces. */
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

/** False where a body is missing, or both ends are far outside the pane. */
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

const POSE = new Float64Array(4);
const PLACE = new Float64Array(2);

/** A place of a body, to PLACE. */
function place([x, y, c, s]: Float64Array, px: number, py: number): void {
  PLACE[0] = x + c * px - s * py;
  PLACE[1] = y + s * px + c * py;
}

/** By slot, of moving bodies: half their thickness and their length. */
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
