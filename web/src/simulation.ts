/**
 * The running world: time, the body that a visitor pulls, and new bodies. It knows nothing of
 * drawing, so that it can move to a worker.
 */
import { type BodyId, type Quality, type Vec2, type World } from "thud";
import type { Built } from "./catalogue";
import { Character, type Keys } from "./character";
import { readShapes, type Shapes } from "./render/shapes";

/** How hard a pulled body follows, as speed per distance (1/s). */
const PULL_RATE = 14;
/** Largest change of speed per step by pulling, in lengths a second. */
const PULL_LIMIT = 60;
/** Longest time that one frame makes up for; beyond that the world runs slower than the clock. */
const LONGEST_FRAME = 0.1;
/** Radius of a crater in half widths of a typical body. */
const CRATER = 3.5;
/** Of every world of the page, in seconds. */
const TIME_STEP = 1 / 60;

interface Pull {
  body: BodyId;
  /** Where it was taken, in the body's frame. */
  anchor: Vec2;
  target: Vec2;
}

export class Simulation {
  readonly built: Built;
  readonly world: World;
  paused = false;
  speed = 1;
  /** How far the present lies between the last two steps. */
  alpha = 1;
  /** Read again after shapes came or went. */
  shapes: Shapes;
  readonly character: Character | null;
  #pull: Pull | null = null;

  /** `keys` steer the character, where the level has one. */
  constructor(built: Built, keys: Readonly<Keys>) {
    this.built = built;
    this.world = built.world;
    this.character = built.character ? new Character(built, keys) : null;
    this.shapes = this.#readShapes();
  }

  close(): void {
    this.character?.close();
    this.world.close();
  }

  #readShapes(): Shapes {
    return readShapes(this.world, this.character?.body);
  }

  /** Runs what a frame of `seconds` asks for. */
  frame(seconds: number): void {
    if (this.paused) return;
    const elapsed = Math.min(seconds, LONGEST_FRAME) * this.speed;
    this.#applyPull();
    // A world that cannot keep up must not be asked for ever more steps.
    const heavy = this.world.stats().stepSeconds > 0.012;
    const most = heavy ? 1 : 4;
    if (this.character) this.#advanceStepByStep(this.character, elapsed, most);
    else this.alpha = this.world.advance(elapsed, most).alpha;
  }

  step(): void {
    this.#applyPull();
    this.world.step();
    this.character?.step(TIME_STEP);
    this.alpha = 1;
  }

  /** As World.advance does it, with a move of the character after every step. */
  #advanceStepByStep(character: Character, elapsed: number, most: number): void {
    let due = this.alpha * TIME_STEP + elapsed;
    for (let i = 0; i < most && due >= TIME_STEP; i++) {
      this.world.step();
      character.step(TIME_STEP);
      due -= TIME_STEP;
    }
    this.alpha = (due % TIME_STEP) / TIME_STEP;
  }

  setQuality(quality: Quality): void {
    this.world.setQuality(quality);
  }

  // ---- pulling ----

  /** Takes the moving body at or nearest to a place, within `reach`. */
  grab(x: number, y: number, reach: number): boolean {
    const found = this.world.overlap({ kind: "circle", center: [x, y], radius: reach });
    let best: { body: BodyId; distance: number } | null = null;
    for (const shape of found) {
      const { body } = this.world.shapeState(shape);
      const state = this.world.bodyState(body);
      if (state.kind !== "dynamic") continue;
      const distance = Math.hypot(state.center[0] - x, state.center[1] - y);
      if (!best || distance < best.distance) best = { body, distance };
    }
    if (!best) return false;
    const { position, angle } = this.world.bodyState(best.body);
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const [dx, dy] = [x - position[0], y - position[1]];
    this.#pull = { body: best.body, anchor: [c * dx + s * dy, c * dy - s * dx], target: [x, y] };
    return true;
  }

  moveGrab(x: number, y: number): void {
    if (this.#pull) this.#pull.target = [x, y];
  }

  release(): void {
    this.#pull = null;
  }

  /** The line from the body to the pointer. */
  get pull(): readonly [Vec2, Vec2] | null {
    if (!this.#pull || !this.world.isValid(this.#pull.body)) return null;
    const { body, anchor, target } = this.#pull;
    const { position, angle } = this.world.bodyState(body);
    return [anchorInWorld(position, angle, anchor), target];
  }

  /**
   * An impulse at the anchor that gives it the speed of an exponential approach to the pointer:
   * J = K⁻¹·(wanted - actual), with K the inverse mass that the anchor has. It does not overshoot.
   */
  #applyPull(): void {
    if (!this.#pull) return;
    const { body, anchor, target } = this.#pull;
    if (!this.world.isValid(body)) {
      this.#pull = null;
      return;
    }
    const state = this.world.bodyState(body);
    const point = anchorInWorld(state.position, state.angle, anchor);
    const rx = point[0] - state.center[0];
    const ry = point[1] - state.center[1];
    const inverseMass = state.mass > 0 ? 1 / state.mass : 0;
    const inverseInertia = state.inertia > 0 ? 1 / state.inertia : 0;
    if (inverseMass === 0) return;
    const spin = state.angularVelocity;
    let dx = (target[0] - point[0]) * PULL_RATE - (state.velocity[0] - spin * ry);
    let dy = (target[1] - point[1]) * PULL_RATE - (state.velocity[1] + spin * rx);
    const change = Math.hypot(dx, dy);
    if (change > PULL_LIMIT) {
      dx *= PULL_LIMIT / change;
      dy *= PULL_LIMIT / change;
    }
    const kxx = inverseMass + inverseInertia * ry * ry;
    const kyy = inverseMass + inverseInertia * rx * rx;
    const kxy = -inverseInertia * rx * ry;
    const determinant = kxx * kyy - kxy * kxy;
    const impulse: Vec2 = [
      (kyy * dx - kxy * dy) / determinant,
      (kxx * dy - kxy * dx) / determinant,
    ];
    this.world.applyImpulse(body, impulse, point);
    // A body on a short line swings for ever without some friction of its own.
    const after = this.world.bodyState(body);
    this.world.setVelocity(body, after.velocity, after.angularVelocity * 0.92);
  }

  // ---- new bodies ----

  spawn(kind: "circle" | "box", x: number, y: number): void {
    const size = this.shapes.typicalSize || 0.5;
    const wobble = 0.8 + 0.4 * ((this.shapes.slots * 0.618034) % 1);
    const body = this.world.createBody({
      kind: "dynamic",
      position: [x, y],
      angle: kind === "box" ? (wobble - 1) * 2 : 0,
    });
    if (kind === "circle") this.world.createCircle(body, { radius: size * wobble });
    else this.world.createObb(body, { halfWidth: size * wobble, halfHeight: size });
    this.shapes = this.#readShapes();
  }

  // ---- digging ----

  /**
   * Digs a crater, no smaller than `least`, into every ground line that has vertices; false if
   * there is none.
   */
  dig(x: number, y: number, least: number): boolean {
    const radius = Math.max(CRATER * this.shapes.typicalSize, least);
    const lines = this.shapes.terrains.filter(({ terrain }) => terrain.kind !== "flat");
    for (const { shape } of lines) this.world.dig(shape, [x, y], radius);
    this.shapes.terrains = this.shapes.terrains.map((placed) => ({
      ...placed,
      terrain: this.world.terrain(placed.shape),
    }));
    return lines.length > 0;
  }
}

function anchorInWorld(position: Vec2, angle: number, anchor: Vec2): Vec2 {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return [
    position[0] + c * anchor[0] - s * anchor[1],
    position[1] + s * anchor[0] + c * anchor[1],
  ];
}
