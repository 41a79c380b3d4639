/**
 * Makes the frames that the page draws: copies of the world's state. Shapes, terrains and joints
 * are in a frame only when they changed; the flags that tell which bodies sleep are in a frame
 * every few steps.
 */
import type { Stats, StepError, World } from "thud";
import { settingsOf } from "../scene/controls";
import type { Drawing, Frame, PlacedTerrain, Shapes, Sum } from "../scene/frame";
import type { OverlayName } from "../scene/overlays";
import { BODY, DYNAMIC, HALF, ROW, SHAPE, SLOT, TERRAIN } from "../scene/shape-table";
import { checkPaint } from "./check";
import { inWorld } from "./hands";
import type { JointFrames } from "./joint-frames";
import { groundLines } from "./lookup";
import type { Look } from "./protocol";
import type { Session } from "./session";
import type * as Sums from "./sums";

/**
 * Steps from one frame that tells which bodies sleep to the next. Chosen: a tenth of a second at 60
 * steps a second.
 */
const AWAKE_EVERY = 6;

/** Imported when a scene first has a joint. */
let jointReader: typeof JointFrames | null = null;

async function bringJoints(): Promise<void> {
  jointReader = (await import("./joint-frames")).JointFrames;
}

/** Imported after the first picture, or when a scene first shows sums. */
let sums: typeof Sums | null = null;

export async function bringSums(): Promise<void> {
  sums ??= await import("./sums");
}

/**
 * Imports what the first frame of a scene needs. It cannot wait for the next frame, because a
 * paused scene may have only one.
 */
export async function readyFor({ tied, scene }: Session): Promise<void> {
  if (tied && !jointReader) await bringJoints();
  if (scene.sums) await bringSums();
}

/** Makes the frames of one session, and remembers what the page has already got. */
export class Frames {
  #shapeRevision = -1;
  #terrainRevision = -1;
  /** For each row of shapes that the page has, its row in the world's shape table. */
  #source: Uint32Array = new Uint32Array(0);
  /** The number of dynamic bodies that the page draws; hidden ones are not counted. */
  #moving = 0;
  /** The step of the last frame. */
  #step = 0;
  /** The step of the last frame that told which bodies sleep. */
  #awakeStep = 0;
  #joints: JointFrames | null = null;

  constructor(private readonly session: Session) {}

  /** The frame of the world's present state, with what `look` asks for. */
  make(look: Look): Frame {
    const { session } = this;
    const { world } = session;
    if (session.paint) checkPaint(session.paint);
    const [x, y] = look.origin;
    const pull = session.pull;
    const samples = session.samples;
    session.samples = [];
    const frame: Frame = {
      run: session.run,
      step: session.step,
      origin: look.origin,
      before: world.poses(0, x, y).slice(),
      now: world.poses(1, x, y).slice(),
      pull:
        pull && world.isValid(pull.body)
          ? [inWorld(world.bodyStateOf(pull.body), pull.anchor), pull.target]
          : null,
      paint: session.paint,
      stats: this.#stats(),
      error: this.#error(),
      samples,
      history: { first: session.history.first, last: session.history.last },
      ended: session.step >= session.end,
    };
    const { controls, state } = session.scene;
    if (controls) frame.settings = settingsOf(controls, state);
    frame.calls = session.calls;
    this.#addShapes(frame);
    // A paused scene needs few frames, so each of them tells which bodies sleep.
    const standing = session.step === this.#step;
    this.#step = session.step;
    if (standing || Math.abs(this.#step - this.#awakeStep) >= AWAKE_EVERY || frame.shapes) {
      frame.awake = this.#awake();
      this.#awakeStep = this.#step;
    }
    const on = new Set(look.overlays);
    frame.drawing = draw(world, look, on);
    if (on.has("sums")) frame.sums = this.#sums(look);
    if (session.tied) this.#addJoints(frame, standing, on.has("joints"));
    frame.box2d = session.companion?.poses(look.origin);
    frame.box2dTrouble = session.box2dTrouble ?? undefined;
    return frame;
  }

  /** The body that holds the other end of the visitor's pull is not counted. */
  #stats(): Stats {
    const { world, pull } = this.session;
    const stats = world.stats();
    if (pull) stats.bodies--;
    return stats;
  }

  /**
   * The engine's error of a step covers awake bodies only. Where some bodies sleep, the depth is
   * measured over all of them.
   */
  #error(): StepError {
    const { world } = this.session;
    const error = world.stepError();
    if (world.stats().awakeBodies < this.#moving)
      error.penetrationMax = world.measure().penetrationMax;
    return error;
  }

  /** Adds shapes and terrains, if they changed since the last frame. */
  #addShapes(frame: Frame): void {
    const { world, scene } = this.session;
    const { shapes, terrains } = world.revision;
    if (shapes !== this.#shapeRevision) {
      const read = readShapes(world, new Set(scene.hidden ?? []));
      this.#source = read.source;
      this.#moving = read.shapes.moving;
      frame.shapes = read.shapes;
    }
    if (shapes !== this.#shapeRevision || terrains !== this.#terrainRevision)
      frame.terrains = readTerrains(world);
    this.#shapeRevision = shapes;
    this.#terrainRevision = terrains;
  }

  /** `open`: adds the gap and the force of each joint. */
  #addJoints(frame: Frame, standing: boolean, open: boolean): void {
    if (jointReader) this.#joints ??= new jointReader(this.session);
    else void bringJoints();
    this.#joints?.add(frame, standing, open);
  }

  /** Minkowski sums of the scene's pairs, and of the body that the visitor points at. */
  #sums({ origin, focus }: Look): Sum[] {
    const { world, scene } = this.session;
    if (!sums) return [];
    const pairs = scene.sums ? sums.sumsOfPairs(world, scene.sums, origin) : [];
    return focus === null ? pairs : [...pairs, ...sums.sumsOfBody(world, focus, origin)];
  }

  /** For each row that the page has, 1 if its body is awake. */
  #awake(): Uint8Array {
    const flags = this.session.world.shapeTableAwake();
    return Uint8Array.from(this.#source, (row) => flags[row]);
  }
}

/** The buffers of a frame that are transferred to the page. */
export function transferables(frame: Frame): ArrayBuffer[] {
  const { before, now, shapes, awake, drawing, box2d } = frame;
  const arrays = [
    before,
    now,
    shapes?.rows,
    awake,
    drawing?.shapes,
    drawing?.lines,
    drawing?.points,
    frame.joints,
    frame.bearings,
    box2d?.before,
    box2d?.now,
  ];
  return arrays.flatMap((array) => (array ? [array.buffer as ArrayBuffer] : []));
}

/**
 * The engine's debug drawing of the visible part of the world; undefined if no overlay needs it.
 */
function draw(world: World, look: Look, on: ReadonlySet<OverlayName>): Drawing | undefined {
  const flags = {
    shapes: on.has("islands"),
    islands: on.has("islands"),
    bounds: on.has("bounds"),
    cells: on.has("cells"),
    contacts: on.has("contacts") || on.has("normals"),
    pairs: on.has("pairs"),
    stages: on.has("stages"),
    colours: on.has("colours"),
    manifolds: on.has("impulses"),
    motions: on.has("motions"),
    axes: on.has("axes"),
    joints: on.has("joints"),
  };
  if (!Object.values(flags).includes(true)) return undefined;
  const { shapes, lines, points } = world.draw({
    ...flags,
    origin: look.origin,
    lower: look.lower,
    upper: look.upper,
  });
  return { shapes: shapes.slice(), lines: lines.slice(), points: points.slice() };
}

/**
 * The circles and boxes of the world, those of hidden bodies last. `source` is the row in the
 * world's shape table of each row that is returned.
 */
export function readShapes(
  world: World,
  hidden: ReadonlySet<number> = new Set(),
): { shapes: Shapes; source: Uint32Array } {
  const { rows: all, count: total } = world.shapeTable();
  const rows = new Float32Array(total * ROW);
  const source = new Uint32Array(total);
  const sizes: number[] = [];
  const painted: number[] = [];
  let drawn = 0;
  let slots = 0;
  const take = (i: number) => {
    rows.set(all.subarray(i * ROW, (i + 1) * ROW), drawn * ROW);
    source[drawn++] = i;
  };
  for (let i = 0; i < total; i++) {
    const row = all.subarray(i * ROW, (i + 1) * ROW);
    const slot = row[SLOT];
    slots = Math.max(slots, slot + 1);
    if (row[SHAPE] === TERRAIN) continue;
    if (hidden.has(slot)) {
      painted.push(i);
      continue;
    }
    if (row[BODY] === DYNAMIC) sizes.push(row[HALF]);
    take(i);
  }
  const count = drawn;
  painted.forEach(take);
  const order = new Uint32Array(slots);
  for (let at = 0; at < count * ROW; at += ROW)
    if (rows[at + BODY] === DYNAMIC) order[rows[at + SLOT]] = 1;
  let moving = 0;
  for (let slot = 0; slot < slots; slot++) if (order[slot] !== 0) order[slot] = moving++;
  sizes.sort((a, b) => a - b);
  return {
    shapes: {
      rows: rows.slice(0, drawn * ROW),
      count,
      all: drawn,
      slots,
      moving,
      order,
      typicalSize: sizes.length > 0 ? sizes[sizes.length >> 1] : 0,
    },
    source: source.slice(0, drawn),
  };
}

function readTerrains(world: World): PlacedTerrain[] {
  return groundLines(world).map(({ body, shape }) => {
    const [x, y] = world.bodyStateOf(body).position;
    return { x, y, terrain: world.terrainOf(shape) };
  });
}
