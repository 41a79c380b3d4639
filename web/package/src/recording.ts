/**
 * "thud/recording": recordings of worlds (thud_recording.h): a snapshot, every call that changes the
 * world from then on, answers of callbacks, and hashes; and players, which repeat them to the same
 * bits, in C, too. The engine has to be loaded from thud-recorded.wasm, the only module that
 * records:
 *
 *     const thud = await load(recordedUrl);
 *     const recorder = new Recorder(world);
 *     ... steps and calls, as ever
 *     const bytes = recorder.bytes();
 *     const player = new Player(thud, bytes);
 *     while (player.step()) draw(player.world);
 */
import { checkOptions } from "./checks/names.js";
import type { Engine } from "./engine.js";
import { type ErrorCode, RESULT_CODES, ThudError } from "./error.js";
import { ListAt } from "./generated/slots.js";
import { bodyId, shapeId } from "./numbers.js";
import type { RayHit } from "./query-types.js";
import type { BodyId } from "./types.js";
import { World } from "./world.js";

/** Numbers of steps are whole, from 0 to 10⁹; 0, the default, selects what is said. */
export interface RecorderOptions {
  /** Steps from one hash to the next; 0: 60. */
  hashSteps?: number;
  /** With each hash 16 bits for every body, by which a player names the body that differs. */
  bodyHashes?: boolean;
  /**
   * Steps from one keyframe to the next, from which a player can start; 0: none but the first, or
   * with `ringSteps` a quarter of it.
   */
  keyframeSteps?: number;
  /** Keeps the last so many steps, up to a keyframe more; 0: all. */
  ringSteps?: number;
  /**
   * Also records casts, overlaps and `closest`, with what they found, to be listed and drawn: of an
   * overlap, and of a cast that calls a function for each hit, the first 64.
   */
  queries?: boolean;
}

const NAMES: readonly (keyof RecorderOptions)[] = [
  "hashSteps",
  "bodyHashes",
  "keyframeSteps",
  "ringSteps",
  "queries",
];
/** THUD_RECORDING_STEPS_MAX. */
const STEPS_MAX = 1e9;

/** Bytes before the name of a call, and of a hit, in what api_player_calls lists. */
const HEAD = 24;
const HIT = 64;

/** The hit whose eight numbers begin at a byte. */
function hitAt(numbers: DataView, at: number): RayHit {
  const [index1, generation, x, y, normalX, normalY, fraction, depth] = Array.from({ length: 8 }, (_, i) =>
    numbers.getFloat64(at + 8 * i, true),
  );
  return { shape: shapeId(index1, generation), point: [x, y], normal: [normalX, normalY], fraction, depth };
}

/** Throws unless the engine is that of thud-recorded.wasm. */
function demand(engine: Engine): Engine {
  if (!engine.exports.api_recorder_begin)
    throw new ThudError("invalid", "recording: load the engine from thud-recorded.wasm");
  return engine;
}

/** A copy, outside of wasm memory, of the bytes that a call listed. */
function listedBytes(engine: Engine): Uint8Array<ArrayBuffer> {
  const { [ListAt.address]: address, [ListAt.count]: count } = engine.slots;
  return new Uint8Array(engine.buffer, address, count).slice();
}

/** A copy of bytes in wasm memory, to be freed, with a zero behind it. */
function lend(engine: Engine, bytes: Uint8Array): number {
  const address = engine.exports.malloc(bytes.length + 1);
  if (address === 0) throw new ThudError("memory", "out of memory");
  new Uint8Array(engine.buffer, address, bytes.length + 1).set(bytes);
  new Uint8Array(engine.buffer)[address + bytes.length] = 0;
  return address;
}

/** The recording of one world. End it by `end`; the world may be closed before. */
export class Recorder {
  readonly #engine: Engine;
  #address: number;

  /**
   * Begins to record, from the present state of the world.
   * @throws {ThudError} "invalid" for an unknown option or a value out of range, for a world that is
   * being recorded or has a time budget, and where the engine is not that of thud-recorded.wasm;
   * "locked" inside a callback; "memory".
   */
  constructor(world: World, options: RecorderOptions = {}) {
    this.#engine = demand(world.engine);
    checkOptions("recorder", options, NAMES);
    const { hashSteps = 0, bodyHashes = false, keyframeSteps = 0, ringSteps = 0, queries = false } = options;
    for (const steps of [hashSteps, keyframeSteps, ringSteps])
      if (!Number.isInteger(steps) || steps < 0 || steps > STEPS_MAX)
        throw new ThudError("invalid", `recorder: steps must be a whole number from 0 to ${STEPS_MAX}: ${steps}`);
    const { api_recorder_begin } = this.#engine.exports;
    this.#engine.check(
      api_recorder_begin(world.address, hashSteps, +bodyHashes, keyframeSteps, ringSteps, +queries),
    );
    this.#address = this.#engine.slots[ListAt.address];
  }

  /** The recording so far, whole, a copy. The recording goes on. @throws {ThudError} "locked" inside a callback; "memory". */
  bytes(): Uint8Array<ArrayBuffer> {
    this.#engine.check(this.#engine.exports.api_recorder_bytes(this.#open()));
    return listedBytes(this.#engine);
  }

  /**
   * Adds bytes of the program's own under a name: inputs, a message, the state of a game.
   * @throws {ThudError} "invalid" for anything but a Uint8Array; "locked" inside a callback; "memory".
   */
  chunk(name: string, bytes: Uint8Array): void {
    const { exports } = this.#engine;
    const recorder = this.#open();
    if (!(bytes instanceof Uint8Array)) throw new ThudError("invalid", "recorder: a chunk is a Uint8Array");
    const named = lend(this.#engine, new TextEncoder().encode(name));
    try {
      const given = lend(this.#engine, bytes);
      try {
        this.#engine.check(exports.api_recorder_chunk(recorder, named, given, bytes.length));
      } finally {
        exports.free(given);
      }
    } finally {
      exports.free(named);
    }
  }

  /** Ends the recording and frees its memory. Every later call throws "stale". @throws {ThudError} "locked" inside a callback. */
  end(): void {
    this.#engine.check(this.#engine.exports.api_recorder_end(this.#open()));
    this.#address = 0;
  }

  #open(): number {
    if (this.#address === 0) throw new ThudError("stale", "the recording has been ended");
    return this.#address;
  }
}

/** A chunk of a recording. */
export interface Chunk {
  name: string;
  bytes: Uint8Array;
}

export interface PlayerOptions {
  /** `calls` has the calls of each step; without it they cost nothing. */
  calls?: boolean;
}

/**
 * A call of a recording, by the function of the C library that the JavaScript method called in the
 * end.
 */
export interface PlayedCall {
  /** As `thud_body_set_velocity`; `thud_world_restore` also for what was not recorded. */
  name: string;
  /**
   * Why the call was refused when it was recorded; null: it was not refused. A refused call has no
   * `values`.
   */
  refused: ErrorCode | null;
  /**
   * The numbers and handles of its arguments, those in structs and arrays included, in C's order. A
   * handle is told by its `index`, the null handle by -1.
   */
  values: { number: number; handle: boolean }[];
  /** The `index` of the handle that it returned, if any. */
  returned: number | null;
  /** What a query found when it was recorded; null: it is no query. */
  found: RayHit[] | null;
}

/** What a player has played, by steps since the recording began. */
export interface PlayerProgress {
  /** The first step that a ring has kept, else 0. */
  first: number;
  /** Steps in all. */
  end: number;
  /** Steps made so far. */
  steps: number;
  /** Hashes that were compared, and equal. */
  hashes: number;
  /**
   * Where the state became another one than was recorded: at a step after `after`, up to `at`;
   * `body` is the first body that differs, where that is known. Null: it is the same.
   */
  difference: { after: number; at: number; body: BodyId | null } | null;
}

/** The world of a player, which alone closes it. */
class PlayedWorld extends World {
  override close(): void {
    throw new ThudError("invalid", "close: this world belongs to its player; close that");
  }
}

/** A recording that is played, with a world of its own. Free it by `close`. */
export class Player {
  /** The world as it was. It belongs to the player, with which it is closed; `close` of it is refused. */
  readonly world: World;
  readonly #engine: Engine;
  #address: number;

  /**
   * Opens a recording at its first step.
   * @throws {ThudError} "invalid" for bytes that are damaged, cut short or of another version, and
   * where the engine is not that of thud-recorded.wasm; "memory".
   */
  constructor(engine: Engine, bytes: Uint8Array, options: PlayerOptions = {}) {
    this.#engine = demand(engine);
    checkOptions("player", options, ["calls"]);
    if (!(bytes instanceof Uint8Array)) throw new ThudError("invalid", "player: a recording is a Uint8Array");
    engine.check(engine.exports.api_player_create(lend(engine, bytes), bytes.length, +(options.calls ?? false)));
    this.#address = engine.slots[ListAt.address];
    this.world = new PlayedWorld(engine, {}, engine.exports.api_player_world(this.#address));
  }

  /**
   * Plays the calls up to the next step, and this step. False at the end of the recording.
   * @throws {ThudError} "invalid" where the state differs from what was recorded; "memory".
   */
  step(): boolean {
    const result = this.#engine.exports.api_player_step(this.#open());
    const { [ListAt.address]: changed, [ListAt.count]: stepped } = this.#engine.slots;
    if (changed !== 0) World.noteChanges(this.world);
    this.#engine.check(result);
    return stepped !== 0;
  }

  /**
   * Goes to a step, from `first` to `end` of `progress`: back from the last keyframe before it.
   * @throws {ThudError} as `step`, and "invalid" for another step.
   */
  seek(step: number): void {
    const result = this.#engine.exports.api_player_seek(this.#open(), step);
    World.noteChanges(this.world);
    this.#engine.check(result);
  }

  get progress(): PlayerProgress {
    const address = this.#engine.exports.api_player_progress(this.#open());
    const [first, end, steps, hashes, differs, after, at, index1, generation] = new Float64Array(
      this.#engine.buffer,
      address,
      9,
    );
    const body = index1 === 0 ? null : bodyId(index1, generation);
    return { first, end, steps, hashes, difference: differs ? { after, at, body } : null };
  }

  /**
   * The last keyframe at or before a step: there a seek that goes back begins to play.
   * @throws {ThudError} "invalid" for a step that the recording does not have.
   */
  keyframeBefore(step: number): number {
    this.#engine.check(this.#engine.exports.api_player_keyframe(this.#open(), step));
    return this.#engine.slots[ListAt.count];
  }

  /** The calls of the last `step`, and the step itself; none after a `seek`, nor without `calls`. */
  get calls(): PlayedCall[] {
    this.#engine.exports.api_player_calls(this.#open());
    const bytes = listedBytes(this.#engine);
    const numbers = new DataView(bytes.buffer);
    const calls: PlayedCall[] = [];
    for (let at = 0; at < bytes.length; ) {
      const [length, result, returned, count, isQuery, hits] = [0, 4, 8, 12, 16, 20].map((from) =>
        numbers.getUint32(at + from, true),
      );
      const code = RESULT_CODES[result];
      const first = at + HEAD + length;
      const name = new TextDecoder().decode(bytes.subarray(at + HEAD, first));
      const values = Array.from({ length: count }, (_, i) => {
        const handle = bytes[first + 9 * i + 8] !== 0;
        return { number: numbers.getFloat64(first + 9 * i, true) - +handle, handle };
      });
      at = first + 9 * count;
      const found = Array.from({ length: hits }, (_, i) => hitAt(numbers, at + HIT * i));
      calls.push({
        name,
        refused: code === "ok" ? null : code,
        values,
        returned: returned === 0 ? null : returned - 1,
        found: isQuery ? found : null,
      });
      at += HIT * hits;
    }
    return calls;
  }

  /** The chunks that the last `step` or `seek` came upon. */
  get chunks(): Chunk[] {
    this.#engine.exports.api_player_chunks(this.#open());
    const bytes = listedBytes(this.#engine);
    const numbers = new DataView(bytes.buffer);
    const chunks: Chunk[] = [];
    for (let at = 0; at < bytes.length; ) {
      const named = at + 8 + numbers.getUint32(at, true);
      const end = named + numbers.getUint32(at + 4, true);
      chunks.push({ name: new TextDecoder().decode(bytes.subarray(at + 8, named)), bytes: bytes.slice(named, end) });
      at = end;
    }
    return chunks;
  }

  /** Frees the player and its world. Every later call of either throws "stale". */
  close(): void {
    this.#engine.exports.api_player_destroy(this.#open());
    this.#address = 0;
    World.disown(this.world);
  }

  #open(): number {
    if (this.#address === 0) throw new ThudError("stale", "the player has been closed");
    return this.#address;
  }
}
