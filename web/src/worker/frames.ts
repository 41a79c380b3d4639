/** Makes the frames that the page draws: copies of what the world has, and only of what is new. */
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
import { knownOf } from "./watch";

/** Sleeping bodies are looked for this often, in steps. */
const AWAKE_EVERY = 6;

/** Brought by the first joint. */
let jointReader: typeof JointFrames | null = null;

async function bringJoints(): Promise<void> {
  jointReader = (await import("./joint-frames")).JointFrames;
}

/** Brought after the first picture, or by the first scene that shows some. */
let sums: typeof Sums | null = null;

export async function bringSums(): Promise<void> {
  sums ??= await import("./sums");
}

/** Before the first frame of a scene, which may be the only one for long. */
export async function readyFor({ world, scene }: Session): Promise<void> {
  if (knownOf(world)?.tied && !jointReader) await bringJoints();
  if (scene.sums) await bringSums();
}

export class Frames {
  #shapeRevision = -1;
  #terrainRevision = -1;
  /** The rows of the world's table that the page has. */
  #source: Uint32Array = new Uint32Array(0);
  /** Dynamic bodies among them. */
  #moving = 0;
  /** Of the last frame. */
  #step = 0;
  /** The last step of which the page knows who sleeps. */
  #awakeStep = 0;
  #joints: JointFrames | null = null;

  constructor(private readonly session: Session) {}

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
          ? [inWorld(world.bodyState(pull.body), pull.anchor), pull.target]
          : null,
      paint: session.paint,
      stats: this.#stats(),
      error: this.#error(),
      samples,
      history: { first: session.history.first, last: session.history.last },
    };
    const { controls, state } = session.scene;
    if (controls) frame.settings = settingsOf(controls, state);
    this.#addShapes(frame);
    // A picture of a standing scene is asked for rarely, and should be right.
    const standing = session.step === this.#step;
    this.#step = session.step;
    if (standing || Math.abs(this.#step - this.#awakeStep) >= AWAKE_EVERY || frame.shapes) {
      frame.awake = this.#awake();
      this.#awakeStep = this.#step;
    }
    const on = new Set(look.overlays);
    frame.drawing = draw(world, look, on);
    if (on.has("sums")) frame.sums = this.#sums(look);
    if (knownOf(world)?.tied) this.#addJoints(frame, standing, on.has("joints"));
    frame.box2d = session.companion?.poses(look.origin);
    frame.box2dTrouble = session.box2dTrouble ?? undefined;
    return frame;
  }

  /** The visitor's hand, which is a body too, is not counted. */
  #stats(): Stats {
    const { world, pull } = this.session;
    const stats = world.stats();
    if (pull) stats.bodies--;
    return stats;
  }

  /** The step tells of what is awake: where some sleep, the others are looked at too. */
  #error(): StepError {
    const { world } = this.session;
    const error = world.error();
    if (world.stats().awakeBodies < this.#moving)
      error.penetrationMax = world.measure().penetrationMax;
    return error;
  }

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

  #addJoints(frame: Frame, standing: boolean, open: boolean): void {
    if (jointReader) this.#joints ??= new jointReader(this.session);
    else void bringJoints();
    this.#joints?.add(frame, standing, open);
  }

  /** What the scene is about, and the body that the visitor points at. */
  #sums({ origin, focus }: Look): Sum[] {
    const { world, scene } = this.session;
    if (!sums) return [];
    const pairs = scene.sums ? sums.sumsOfPairs(world, scene.sums, origin) : [];
    return focus === null ? pairs : [...pairs, ...sums.sumsOfBody(world, focus, origin)];
  }

  #awake(): Uint8Array {
    const flags = this.session.world.shapeTableAwake();
    return Uint8Array.from(this.#source, (row) => flags[row]);
  }
}

/** The buffers of a frame that go over to the page. */
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

/** The engine's debug drawing of what the page sees; undefined if none is asked for. */
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
  const { shapes, lines, points } = world.debugDraw({
    ...flags,
    origin: look.origin,
    lower: look.lower,
    upper: look.upper,
  });
  return { shapes: shapes.slice(), lines: lines.slice(), points: points.slice() };
}

/** Circles and boxes, the hidden bodies' last; `source` tells each row's place in the table. */
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
    const [x, y] = world.bodyState(body).position;
    return { x, y, terrain: world.terrain(shape) };
  });
}
