/** Adds joints to frames: the table of joints when it changed, and how far joints are open. */
import { DIRECTIONS, JOINT_KINDS, JOINT_ROW as ROW } from "thud";
import type { Frame } from "../scene/frame";
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
  TURN_RANGE,
} from "../scene/joint-rows";
import type { Session } from "./session";

/** Milliseconds per frame that reading the joint table may take on average. Chosen. */
const LOOKING = 1;
/**
 * Largest number of frames between two readings, however long one takes. Chosen, so that a joint
 * that breaks disappears from the picture soon.
 */
const MOST_PAUSE = 10;

const DISTANCE = JOINT_KINDS.indexOf("distance");
const TURN = DIRECTIONS.indexOf("turn");

/** Numbers per joint in the handles of the joint table. */
const HANDLES = 6;

export class JointFrames {
  /** The rows that the page has, and the handles of the joint table at the last reading. */
  #rows = new Float32Array(0);
  #handles = new Uint32Array(0);
  /**
   * For each joint of the table, whether it is a distance joint that has limits and a spring as
   * well. The table does not tell; the joint's options do.
   */
  #sprung: readonly boolean[] = [];
  /** Frames until the table is read again. */
  #pause = 0;
  #last: Pick<Frame, "gaps"> = {};

  constructor(private readonly session: Session) {}

  /**
   * Adds the joints to a frame. `standing`: the scene is paused, and the table is read at once.
   * `open`: adds each joint's gap and force.
   */
  add(frame: Frame, standing: boolean, open: boolean): void {
    frame.gaps = this.#last.gaps;
    if (this.#pause-- > 0 && !standing) return;
    const start = performance.now();
    const { rows, handles } = this.session.world.jointTable();
    this.#look(rows, handles);
    const own = this.#others(handles);
    const packed = this.#pack(rows, own);
    if (!equal(packed, this.#rows)) {
      this.#rows = packed;
      frame.joints = packed.slice();
    }
    if (open) frame.bearings = bearingsOf(rows, own);
    frame.gaps = this.#last.gaps = sumUp(rows, own);
    this.#pause = Math.min(MOST_PAUSE, Math.floor((performance.now() - start) / LOOKING));
  }

  /** Finds out which joints have a spring, if joints came or went. */
  #look(rows: Float32Array, handles: Uint32Array): void {
    if (equal(handles, this.#handles)) return;
    this.#handles = handles.slice();
    const { world } = this.session;
    const known = this.#handles;
    const limited = Array.from({ length: rows.length / ROW.length }, (_, i) => {
      const at = i * ROW.length;
      const [lower, upper] = [rows[at + ROW.lower], rows[at + ROW.upper]];
      return rows[at + ROW.kind] === DISTANCE && lower !== upper && upper < Infinity;
    });
    this.#sprung = limited.map((asks, i) => {
      if (!asks) return false;
      const [index1, generation] = known.subarray(i * HANDLES);
      const joint = { kind: "joint", index: index1 - 1, generation } as const;
      const options = world.jointOptionsOf(joint);
      return options.kind === "distance" && (options.along?.frequency ?? 0) > 0;
    });
  }

  /** The rows of the table without the joint of the visitor's pull, which the page draws apart. */
  #others(handles: Uint32Array): number[] {
    const hand = this.session.pull?.joint.index;
    const own: number[] = [];
    for (let i = 0; i * HANDLES < handles.length; i++)
      if (handles[i * HANDLES] - 1 !== hand) own.push(i);
    return own;
  }

  /** The rows as joint-rows.ts lays them out. A joint that is disabled gets the kind -1. */
  #pack(rows: Float32Array, own: readonly number[]): Float32Array<ArrayBuffer> {
    const packed = new Float32Array(own.length * JOINT);
    own.forEach((i, n) => {
      const at = i * ROW.length;
      const to = n * JOINT;
      const copy = (from: number, count: number, into: number) =>
        packed.set(rows.subarray(at + from, at + from + count), to + into);
      // The page draws no joint whose kind is unknown.
      packed[to + KIND] = rows[at + ROW.enabled] === 0 ? -1 : rows[at + ROW.kind];
      packed[to + SLOT_A] = rows[at + ROW.slotA];
      packed[to + SLOT_B] = rows[at + ROW.slotB];
      const free = rows[at + ROW.upper] === Infinity && rows[at + ROW.lower] === -Infinity;
      packed[to + SPRUNG] = Number(free || this.#sprung[i]);
      copy(ROW.anchorA, 2, ANCHOR_A);
      copy(ROW.anchorB, 2, ANCHOR_B);
      copy(ROW.axis, 2, AXIS);
      packed[to + ALONG] = rows[at + ROW.lower];
      packed[to + ALONG + 1] = rows[at + ROW.upper];
      packed[to + TURN_RANGE] = rows[at + ROW.lower + TURN];
      packed[to + TURN_RANGE + 1] = rows[at + ROW.upper + TURN];
    });
    return packed;
  }
}

/** Gap, angle and force of each joint; see BEARING in joint-rows.ts. */
function bearingsOf(rows: Float32Array, own: readonly number[]): Float32Array<ArrayBuffer> {
  const bearings = new Float32Array(BEARING * own.length);
  own.forEach((i, n) => {
    const row = rows.subarray(i * ROW.length, (i + 1) * ROW.length);
    const force = [row[ROW.force], row[ROW.force + 1]] as const;
    bearings.set([row[ROW.gap], row[ROW.angleGap], ...force], BEARING * n);
  });
  return bearings;
}

/** The largest and the mean gap of all joints; undefined without joints. */
function sumUp(rows: Float32Array, own: readonly number[]): Frame["gaps"] {
  let [worst, sum, angle] = [0, 0, 0];
  for (const i of own) {
    const gap = rows[i * ROW.length + ROW.gap];
    worst = Math.max(worst, gap);
    sum += gap;
    angle = Math.max(angle, rows[i * ROW.length + ROW.angleGap]);
  }
  const joints = own.length;
  return joints > 0 ? { joints, worst, mean: sum / joints, angle } : undefined;
}

function equal(a: ArrayLike<number>, b: ArrayLike<number>): boolean {
  if (a.length !== b.length) return false;
  for (let i = 0; i < a.length; i++) if (a[i] !== b[i]) return false;
  return true;
}
