/**
 * A mover: a character that slides along what it meets, walks slopes and steps, and rides on what
 * it stands on. Gravity and jumps are yours; move it once a step, after the step.
 *
 *     const mover = new Mover(world, { shape: { kind: "circle", radius: 0.5 }, position: [0, 3] });
 *     const { velocity, ground } = mover.move([5, -1], 1 / 60);
 */
import { ThudError } from "./error.js";
import { bodyId, fill, FILTER, numbersOf, shapeId, solidNumbers, view } from "./numbers.js";
import type { MoverHit, MoverOptions, MoverReport } from "./query-types.js";
import type { BodyId, ShapeId, Vec2 } from "./types.js";
import type { World } from "./world.js";

/** Numbers of a hit; see api_mover_move. */
const HIT = 9;

/** As api_mover_defaults has them; the first comes last there, behind the filter's. */
const OPTIONS = [
  "oneWay",
  "up",
  ".",
  "skin",
  "maxSlope",
  "stepHeight",
  "snapDistance",
  "pushForce",
] as const;
const OTHERS = ["shape", "position", "body", "filter"] as const;

/** All that a mover keeps from one move to the next, as plain data. */
export interface MoverState {
  position: Vec2;
  /** What it stood on, and where that was; so it rides along. */
  ground: {
    normal: Vec2;
    shape: ShapeId;
    body: BodyId;
    point: Vec2;
    place: Vec2;
    cosine: number;
    sine: number;
  } | null;
}

/** Of one world, and freed by `close` alone. */
export class Mover {
  readonly #world: World;
  #address: number;

  constructor(world: World, options: MoverOptions) {
    const { exports, slots } = world.engine;
    const [kind, hx, hy, angle] = solidNumbers(options.shape);
    const { filter = {}, body } = options;
    const [oneWay, ...numbers] = numbersOf("mover", options, OPTIONS, OTHERS);
    const filtered = numbersOf("filter", filter, FILTER);
    exports.api_mover_defaults(kind, hx, hy, angle);
    fill(slots, [...numbers, ...filtered, oneWay]);
    const [index1, generation] = body ? [body.index + 1, body.generation] : [0, 0];
    this.#world = world;
    this.#address = exports.api_mover_create(
      kind,
      ...options.position,
      hx,
      hy,
      angle,
      index1,
      generation,
    );
    if (this.#address === 0) throw new ThudError("memory", "out of memory");
  }

  /**
   * Moves by `velocity * dt`, and by what the ground moved since the last move. A velocity with a
   * part along `up` leaves the ground; `drop` falls through one-way platforms. Throws, and changes
   * nothing, for what is out of range.
   */
  move(velocity: Vec2, dt: number, options: { drop?: boolean } = {}): MoverReport {
    const { engine, address } = this.#world;
    const [drop = 0] = numbersOf("move", options, ["drop"]);
    engine.check(
      engine.exports.api_mover_move(address, this.address, ...velocity, dt, drop),
    );
    const s = engine.slots;
    const rows = view(Float64Array, engine.buffer, s[14], HIT * s[15] + 2 * s[16]);
    return {
      position: [s[0], s[1]],
      ground:
        s[2] === 0
          ? null
          : {
              normal: [s[3], s[4]],
              shape: shapeId(s[5], s[6]),
              body: bodyId(s[7], s[8]),
              velocity: [s[11], s[12]],
            },
      velocity: [s[9], s[10]],
      depth: s[13],
      hits: Array.from({ length: s[15] }, (_, i) => readHit(rows.subarray(HIT * i))),
      sensors: Array.from({ length: s[16] }, (_, i) => {
        const at = HIT * s[15] + 2 * i;
        return shapeId(rows[at], rows[at + 1]);
      }),
    };
  }

  /** Puts it elsewhere, in the air. */
  place([x, y]: Vec2): void {
    this.#world.engine.exports.api_mover_place(this.address, x, y);
  }

  /** To be kept with a snapshot of the world, and given back with it. */
  state(): MoverState {
    const { engine } = this.#world;
    engine.exports.api_mover_get_state(this.address);
    const s = engine.slots;
    return {
      position: [s[0], s[1]],
      ground:
        s[2] === 0
          ? null
          : {
              normal: [s[3], s[4]],
              shape: shapeId(s[5], s[6]),
              body: bodyId(s[7], s[8]),
              point: [s[9], s[10]],
              place: [s[11], s[12]],
              cosine: s[13],
              sine: s[14],
            },
    };
  }

  /** Back to where `state` was taken; the world goes back by its own snapshot. */
  restore({ position, ground }: MoverState): void {
    const { address } = this;
    const { engine } = this.#world;
    engine.slots.fill(0, 0, 15);
    engine.slots.set(position);
    if (ground) {
      const { normal, shape, body, point, place, cosine, sine } = ground;
      const ids = [shape.index + 1, shape.generation, body.index + 1, body.generation];
      engine.slots.set([1, ...normal, ...ids, ...point, ...place, cosine, sine], 2);
    }
    engine.exports.api_mover_set_state(address);
  }

  /** In wasm memory; throws after `close`. */
  get address(): number {
    if (this.#address === 0) throw new ThudError("stale", "the mover has been closed");
    return this.#address;
  }

  /** Frees it; its world does not. */
  close(): void {
    this.#world.engine.exports.api_mover_destroy(this.address);
    this.#address = 0;
  }
}

function readHit(row: Float64Array): MoverHit {
  return {
    shape: shapeId(row[0], row[1]),
    body: bodyId(row[2], row[3]),
    point: [row[4], row[5]],
    normal: [row[6], row[7]],
    depth: row[8],
  };
}
