/**
 * A mover: a character controller that slides along shapes, walks on slopes and steps, and moves
 * with the body that it stands on. `walk` adds gravity and jumps; with `move` both are up to the
 * caller. Call one of them once a step, after the step. thud_mover.h describes movers in full.
 *
 *     const mover = new Mover(world, { shape: circle(0.5), position: [0, 3] });
 *     const { position, ground } = mover.walk({ speed: 5, jump: 9 });
 */
import { explained } from "./checks/hook.js";
import { ThudError } from "./error.js";
import {
  HandleAt,
  ListAt,
  MOVER_OPTIONS,
  MoverHitAt,
  MoverOptionsAt,
  MoverReportAt,
  MoverStateAt,
} from "./generated/slots.js";
import {
  bodyAt,
  fill,
  filterNumbers,
  numbersOf,
  rowsOf,
  shapeAt,
  solidNumbers,
  vecAt,
  view,
} from "./numbers.js";
import { generationOf, index1Of, Kind } from "./plain/handles.js";
import type { MoverHit, MoverOptions, MoverReport, Walk } from "./query-types.js";
import type { BodyId, ShapeId, Vec2 } from "./types.js";
import type { World } from "./world.js";

/** Options that the constructor reads itself; MOVER_OPTIONS has the others. */
const OTHERS = ["shape", "position", "body", "filter", "gravityScale"] as const;

/** The state of a mover from one move to the next, as plain data. */
export interface MoverState {
  position: Vec2;
  /**
   * The ground that it stood on, null in the air: its unit normal, shape and body; the point of
   * contact, and the body's origin (`place`), cosine and sine at that time. From these the next
   * move finds how far the ground has moved.
   */
  ground: {
    normal: Vec2;
    shape: ShapeId;
    body: BodyId;
    point: Vec2;
    place: Vec2;
    cosine: number;
    sine: number;
  } | null;
  /** Of `walk`: the speed along `up` that gravity, jumps and the ground gave it, length/s. */
  rise: number;
  /** Of `walk`: the speed to the right that it took over from the ground, length/s. */
  drift: number;
}

/** Throws a ThudError "invalid" if one of the numbers is not finite. */
function checkFinite(call: string, numbers: readonly number[]): void {
  if (!numbers.every(Number.isFinite))
    throw new ThudError("invalid", `${call}: numbers must be finite: ${numbers.join(", ")}`);
}

/** A mover of one world. Only `close` frees its memory; closing the world does not. */
export class Mover {
  readonly #world: World;
  readonly #up: Vec2;
  readonly #gravityScale: number;
  #address: number;
  #rise = 0;
  #drift = 0;

  /**
   * Makes a mover, not on ground.
   * @throws {ThudError} "invalid" for an unknown option or a value out of range (with "thud/first",
   * until `explainErrors` is called, each move throws for a value out of range instead); "memory".
   */
  constructor(world: World, options: MoverOptions) {
    const { exports, slots } = world.engine;
    const [kind, hx, hy, angle] = solidNumbers(options.shape);
    const { filter = {}, body, up = [0, 1], gravityScale = 1 } = options;
    const numbers = numbersOf("Mover", options, MOVER_OPTIONS, OTHERS);
    // The engine checks the options in each move only; the explainer, where loaded, does so here.
    const unknown = new ThudError("invalid", "Mover");
    const wrong = explained(unknown, "Mover", options);
    if (wrong !== unknown) throw wrong;
    const filtered = filterNumbers(filter);
    exports.api_mover_defaults(kind, hx, hy, angle);
    fill(slots, numbers);
    fill(slots, filtered, MoverOptionsAt.filter);
    const [index1, generation] = body ? [index1Of(body, Kind.body), generationOf(body)] : [0, 0];
    this.#world = world;
    this.#up = [up[0], up[1]];
    this.#gravityScale = gravityScale;
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
   * Moves by `velocity * dt` (length/s and seconds), and by the motion of the ground since the last
   * move. A velocity with a part along `up` leaves the ground. `drop` (default false): the mover
   * falls through one-way platforms.
   * @throws {ThudError} "invalid" for dt outside (0, 1], a way above 10⁶, a value that is not
   * finite or an option of the mover out of range; "stale" where its body was destroyed, or after
   * `close`; "memory".
   */
  move(velocity: Vec2, dt: number, options: { drop?: boolean } = {}): MoverReport {
    const { engine, address } = this.#world;
    const [drop = 0] = numbersOf("move", options, ["drop"]);
    const [vx, vy] = velocity;
    try {
      engine.check(engine.exports.api_mover_move(address, this.address, vx, vy, dt, drop));
    } catch (refused) {
      throw explained(refused, "move", { velocity, dt });
    }
    const { buffer, slots: s } = engine;
    const hits = rowsOf(Float64Array, buffer, s, MoverReportAt.hits, MoverHitAt.length, readHit);
    const behind = s[MoverReportAt.hits + ListAt.address] + 8 * MoverHitAt.length * hits.length;
    const count = s[MoverReportAt.sensorCount];
    const sensors = view(Float64Array, buffer, behind, HandleAt.length * count);
    return {
      position: vecAt(s, MoverReportAt.position),
      ground:
        s[MoverReportAt.onGround] === 0
          ? null
          : {
              normal: vecAt(s, MoverReportAt.normal),
              shape: shapeAt(s, MoverReportAt.shape),
              body: bodyAt(s, MoverReportAt.body),
              velocity: vecAt(s, MoverReportAt.groundVelocity),
            },
      velocity: vecAt(s, MoverReportAt.velocity),
      depth: s[MoverReportAt.depth],
      hits,
      sensors: Array.from({ length: count }, (_, i) => shapeAt(sensors, HandleAt.length * i)),
    };
  }

  /**
   * Moves as the hero of a platformer in a step of the world: it walks at a speed, falls by the
   * world's gravity, and jumps where it stands on ground, whose velocity it keeps in the air.
   * @throws {ThudError} as `move`; "invalid" also where the mover's `up` is [0, 0].
   * @example hero.walk({ speed: 5, jump: isPressed ? 9 : 0 })
   */
  walk(walk: Walk = {}): MoverReport {
    const [speed = 0, jump = 0, drop = 0] = numbersOf("walk", walk, ["speed", "jump", "drop"]);
    const [ux, uy] = this.#up;
    if (!Number.isFinite(speed) || !(jump >= 0 && jump < Infinity))
      throw explained(new ThudError("invalid", "walk: speed or jump"), "walk", walk);
    if (ux === 0 && uy === 0)
      throw new ThudError("invalid", "walk: a mover whose up is [0, 0] has no ground; move it");
    const { gravity, timeStep } = this.#world.stepSettings();
    const stands = this.state().ground !== null;
    const pull = this.#gravityScale * (gravity[0] * ux + gravity[1] * uy) * timeStep;
    const rise = !stands ? this.#rise + pull : jump > 0 ? this.#rise + jump : 0;
    // On the ground `move` itself adds the velocity of the ground.
    const way = stands && rise <= 0 ? speed : speed + this.#drift;
    const velocity: Vec2 = [way * uy + rise * ux, rise * uy - way * ux];
    const report = this.move(velocity, timeStep, { drop: drop !== 0 });
    const [vx, vy] = report.ground?.velocity ?? report.velocity;
    this.#rise = vx * ux + vy * uy;
    const left = vx * uy - vy * ux;
    // Where a wall stopped the mover, it loses the speed that it took over from the ground.
    if (report.ground) this.#drift = left;
    else if (Math.abs(left - way) > 1e-3 * Math.abs(way)) this.#drift = 0;
    return report;
  }

  /** The centre of its shape, in the world. */
  get position(): Vec2 {
    return this.state().position;
  }

  /**
   * Puts the mover at a place, in the air and at rest.
   * @throws {ThudError} "invalid" for a number that is not finite. A place too far away is refused by the
   * next `move`.
   */
  place([x, y]: Vec2): void {
    checkFinite("place", [x, y]);
    this.#world.engine.exports.api_mover_place(this.address, x, y);
    this.#rise = 0;
    this.#drift = 0;
  }

  /** A copy of its state. Keep it together with a snapshot of the world, and restore both. */
  state(): MoverState {
    const { engine } = this.#world;
    engine.exports.api_mover_get_state(this.address);
    const s = engine.slots;
    return {
      position: vecAt(s, MoverStateAt.position),
      ground:
        s[MoverStateAt.onGround] === 0
          ? null
          : {
              normal: vecAt(s, MoverStateAt.normal),
              shape: shapeAt(s, MoverStateAt.shape),
              body: bodyAt(s, MoverStateAt.body),
              point: vecAt(s, MoverStateAt.point),
              place: vecAt(s, MoverStateAt.place),
              cosine: s[MoverStateAt.cosine],
              sine: s[MoverStateAt.sine],
            },
      rise: this.#rise,
      drift: this.#drift,
    };
  }

  /**
   * Restores a state that `state` returned. The world is restored by its own snapshot.
   * @throws {ThudError} "invalid" for a number that is not finite; nothing has changed then.
   */
  restore({ position, ground, rise = 0, drift = 0 }: MoverState): void {
    const { normal = [], point = [], place = [], cosine = 0, sine = 0 } = ground ?? {};
    checkFinite("restore", [...position, ...normal, ...point, ...place, cosine, sine, rise, drift]);
    const { address } = this;
    const { engine } = this.#world;
    const s = engine.slots;
    s.fill(0, 0, MoverStateAt.length);
    s.set(position, MoverStateAt.position);
    if (ground) {
      s[MoverStateAt.onGround] = 1;
      s.set(ground.normal, MoverStateAt.normal);
      s.set([ground.shape.index + 1, ground.shape.generation], MoverStateAt.shape);
      s.set([ground.body.index + 1, ground.body.generation], MoverStateAt.body);
      s.set(ground.point, MoverStateAt.point);
      s.set(ground.place, MoverStateAt.place);
      s[MoverStateAt.cosine] = ground.cosine;
      s[MoverStateAt.sine] = ground.sine;
    }
    engine.exports.api_mover_set_state(address);
    this.#rise = rise;
    this.#drift = drift;
  }

  /** Its address in wasm memory. Throws "stale" after `close`. */
  get address(): number {
    if (this.#address === 0) throw new ThudError("stale", "the mover has been closed");
    return this.#address;
  }

  /** Frees its memory. Throws "stale" where it is closed already. */
  close(): void {
    this.#world.engine.exports.api_mover_destroy(this.address);
    this.#address = 0;
  }

  /** Closes the mover unless it is closed, for `using`. */
  [Symbol.dispose](): void {
    if (this.#address !== 0) this.close();
  }
}

function readHit(rows: Float64Array, at: number): MoverHit {
  return {
    shape: shapeAt(rows, at + MoverHitAt.shape),
    body: bodyAt(rows, at + MoverHitAt.body),
    point: vecAt(rows, at + MoverHitAt.point),
    normal: vecAt(rows, at + MoverHitAt.normal),
    depth: rows[at + MoverHitAt.depth],
  };
}
