/**
 * What a scene used in its first seconds, at the visitor's settings: which bodies turned, bounced
 * and slept, what detection held back and what islands were solved directly. thud-run counts the
 * same (`thud-run --uses`).
 */
import { type BodyId, SHAPE_KINDS, type ShapeId, type World } from "thud";
import { BODY, bodyAt, DYNAMIC, ROW, SENSOR, SHAPE, SLOT } from "../scene/shape-table";
import { type Laboratory, Trial } from "./measure-trial";
import type { SceneRequest } from "./protocol";

export interface SceneUses {
  /** Dynamic bodies with shapes that were ever in the scene, and those of them that … */
  bodies: number;
  /** … turned by more than TURNED, */
  turned: number;
  /** … turned and have an oriented box: a circle that turns changes no contact, */
  turnedBoxes: number;
  /** … met something at more than 1 length scale a second in a pair with restitution, */
  bounced: number;
  /** … fell asleep. */
  slept: number;
  /**
   * The largest number of shapes of each kind that existed at one time, sensors included, in the
   * order of SHAPE_KINDS.
   */
  shapes: number[];
  sensors: number;
  joints: number;
  /** Bodies that detection held back, a body once in each step. */
  held: number;
  /** Collisions that "bisect" or "swept" resolved within a step. */
  impacts: number;
  /** Steps that solved an island directly. */
  directSteps: number;
  /**
   * The largest motion of a body in a step over the thickness of the thinnest shape: from 1 on it
   * may pass through that shape within a step.
   */
  speed: number;
  steps: number;
}

/** Radians. */
const TURNED = 0.001;
const OBB = SHAPE_KINDS.indexOf("obb");

/** What a body did. */
interface Deeds {
  box: boolean;
  cosine: number;
  sine: number;
  x: number;
  y: number;
  turned: boolean;
  bounced: boolean;
  slept: boolean;
}

/**
 * Runs the scene for so many steps, or until so many milliseconds have passed, and counts. Bodies
 * may sleep.
 */
export async function countUses(
  laboratory: Laboratory,
  request: SceneRequest,
  seconds: number,
  patience: number,
): Promise<SceneUses> {
  const trial = await Trial.open({ ...laboratory, box2d: null }, request, undefined, true);
  try {
    const count = new UseCount(trial.world, trial.timeStep);
    const end = performance.now() + patience;
    const steps = Math.round(seconds / trial.timeStep);
    count.look();
    do {
      trial.step();
      count.stepped();
    } while (count.uses.steps < steps && performance.now() < end);
    return count.finish();
  } finally {
    trial.close();
  }
}

export class UseCount {
  readonly uses: SceneUses = {
    bodies: 0,
    turned: 0,
    turnedBoxes: 0,
    bounced: 0,
    slept: 0,
    shapes: SHAPE_KINDS.map(() => 0),
    sensors: 0,
    joints: 0,
    held: 0,
    impacts: 0,
    directSteps: 0,
    speed: 0,
    steps: 0,
  };
  readonly #world: World;
  readonly #timeStep: number;
  /** By index and generation of the body. */
  readonly #deeds = new Map<string, Deeds>();

  constructor(world: World, timeStep: number) {
    this.#world = world;
    this.#timeStep = timeStep;
  }

  /** Counts a step that the world has made. */
  stepped(): void {
    const { uses } = this;
    const { heldBodies, impacts, directIslands, softIslands } = this.#world.stats();
    uses.held += heldBodies;
    uses.impacts += impacts;
    if (directIslands > softIslands) uses.directSteps++;
    uses.steps++;
    this.look();
    for (const { a, b } of this.#world.events().hit) this.#meet(a, b);
  }

  /** Reads all shapes and the rotations of their bodies, and updates the counts. */
  look(): void {
    const { uses } = this;
    const world = this.#world;
    uses.joints = Math.max(uses.joints, world.jointTable().count);
    const thickness = world.bisectionLimit() * this.#timeStep;
    const table = world.shapeTable();
    // Views into wasm memory are valid until the next call.
    const { count, rows, handles } = { ...table, rows: table.rows.slice(), handles: table.handles.slice() };
    const awake = world.shapeTableAwake().slice();
    const poses = world.poses();
    const shapes = SHAPE_KINDS.map(() => 0);
    let sensors = 0;
    for (let row = 0; row < count; row++) {
      const at = row * ROW;
      const sensor = rows[at + SENSOR] !== 0;
      shapes[rows[at + SHAPE]]++;
      if (sensor) sensors++;
      if (rows[at + BODY] !== DYNAMIC) continue;
      const slot = 4 * rows[at + SLOT];
      const [x, y, cosine, sine] = [poses[slot], poses[slot + 1], poses[slot + 2], poses[slot + 3]];
      const deeds = this.#deedsOf(bodyAt(handles, row), { x, y, cosine, sine });
      deeds.box ||= rows[at + SHAPE] === OBB && !sensor;
      // The sine of the angle between both rotations, and its cosine.
      const across = deeds.cosine * sine - deeds.sine * cosine;
      const along = deeds.cosine * cosine + deeds.sine * sine;
      deeds.turned ||= Math.abs(Math.atan2(across, along)) > TURNED;
      deeds.slept ||= awake[row] === 0;
      const moved = Math.hypot(x - deeds.x, y - deeds.y);
      if (thickness > 0 && Number.isFinite(moved / thickness))
        uses.speed = Math.max(uses.speed, moved / thickness);
      deeds.x = x;
      deeds.y = y;
    }
    uses.shapes = uses.shapes.map((most, kind) => Math.max(most, shapes[kind]));
    uses.sensors = Math.max(uses.sensors, sensors);
  }

  finish(): SceneUses {
    const all = [...this.#deeds.values()];
    const count = (is: (deeds: Deeds) => boolean) => all.filter(is).length;
    return {
      ...this.uses,
      bodies: all.length,
      turned: count(({ turned }) => turned),
      turnedBoxes: count(({ turned, box }) => turned && box),
      bounced: count(({ bounced }) => bounced),
      slept: count(({ slept }) => slept),
    };
  }

  #deedsOf({ index, generation }: BodyId, pose: Pick<Deeds, "x" | "y" | "cosine" | "sine">): Deeds {
    const key = `${index} ${generation}`;
    let deeds = this.#deeds.get(key);
    if (!deeds) {
      deeds = { ...pose, box: false, turned: false, bounced: false, slept: false };
      this.#deeds.set(key, deeds);
    }
    return deeds;
  }

  /** A hit of two shapes; either may be gone by now. A pair bounces by the larger restitution. */
  #meet(a: ShapeId, b: ShapeId): void {
    const world = this.#world;
    if (!world.isValid(a) || !world.isValid(b)) return;
    const states = [world.shapeStateOf(a), world.shapeStateOf(b)];
    if (!states.some(({ restitution }) => restitution > 0)) return;
    for (const { body } of states) {
      const deeds = this.#deeds.get(`${body.index} ${body.generation}`);
      if (deeds) deeds.bounced = true;
    }
  }
}
