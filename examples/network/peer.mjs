/**
 * One player's machine: a world with the game of cars.mjs, a rollback, and the messages that players
 * send each other, the same bytes as those of peer.c, where their layout stands. What carries the
 * messages is not known here.
 */
import { Rollback } from "thud";
import { buildCars, CARS_MAX, carsStep, createField, IDLE, INPUTS } from "./cars.mjs";

const MARK = 0x32504e54; // "TNP2"
const [FIRST_AT, HEARD_AT, LEAD_AT, HASH_STEP_AT, HASH_AT, INPUTS_AT] = [6, 10, 14, 18, 22, 30];
const SUM = 4;
const INPUTS_MAX = 255;
/** Inputs of so many steps are kept of each player; hashes are told of every so many steps, and so many are kept. */
const [KEPT, HASH_STEPS, HASHES] = [512, 4, 64];
/** The largest lead that a player can have, steps. */
const DEEPEST = 1000;

/** FNV-1a of 32 bits (Fowler, Noll, Vo). */
export const sumOf = (bytes) =>
  bytes.reduce((sum, byte) => Math.imul(sum ^ byte, 0x01000193) >>> 0, 0x811c9dc5);

const viewOf = (bytes) => new DataView(bytes.buffer, bytes.byteOffset, bytes.length);

/** Writes the checksum to the last four bytes. */
export function seal(bytes) {
  const end = bytes.length - SUM;
  viewOf(bytes).setUint32(end, sumOf(bytes.subarray(0, end)), true);
  return bytes;
}

/** Whether bytes have this mark, and the checksum at their end. */
export function isSealed(bytes, mark, least) {
  if (bytes.length < least) return false;
  const [view, end] = [viewOf(bytes), bytes.length - SUM];
  return view.getUint32(0, true) === mark && view.getUint32(end, true) === sumOf(bytes.subarray(0, end));
}

export class Peer {
  #hashes = new Map();
  /** By player who has left and is not parted with yet: the step, and its inputs before that. */
  #leaving = new Map();

  /**
   * `me`: the own number, from 0; `depth`: as in RollbackOptions; `end`: the steps of the game, 0: no
   * end; `world`: options of createWorld.
   */
  constructor(thud, { me, players, depth, end = 0, world = {} }) {
    Object.assign(this, { me, players, depth, end, told: 0, hashed: 0, refused: 0, waits: 0 });
    this.world = createField(thud, world);
    this.bodies = buildCars(this.world, players);
    const step = carsStep(this.world, this.bodies);
    this.rollback = new Rollback(this.world, { idle: Array(players).fill(IDLE), step, depth });
    this.others = Array.from({ length: CARS_MAX }, () => ({
      inputs: new Uint8Array(KEPT), // by step
      heard: 0, // the inputs are known before this step
      confirmed: 0, // it has the own inputs before this step
      isGone: false,
      told: { step: -1, hash: 0n }, // the last hash that it told
      differsFrom: -1, // the first step whose hash it told differently
    }));
  }

  close() {
    this.world.close();
  }

  get steps() {
    return this.rollback.steps;
  }

  get #isOver() {
    return this.end > 0 && this.steps >= this.end;
  }

  /** Gives the own input of the next step, unless that has been done, or there is no further step. */
  press(input) {
    const { steps } = this;
    if (this.told > steps || this.#isOver) return;
    this.rollback.input(this.me, steps, input);
    this.others[this.me].inputs[steps % KEPT] = input;
    this.told = steps + 1;
  }

  /** Whether a message to a player would tell it anything. */
  tells(player) {
    return player !== this.me && !this.others[player].isGone;
  }

  /** The message to another player. */
  write(player) {
    const { confirmed, heard } = this.others[player];
    const count = Math.min(this.told - confirmed, INPUTS_MAX);
    const bytes = new Uint8Array(INPUTS_AT + count + SUM);
    const view = viewOf(bytes);
    const hashStep = this.hashed - HASH_STEPS;
    const hash = this.#hashes.get(hashStep);
    view.setUint32(0, MARK, true);
    view.setUint8(4, this.me);
    view.setUint8(5, count);
    view.setUint32(FIRST_AT, confirmed, true);
    view.setUint32(HEARD_AT, heard, true);
    view.setInt32(LEAD_AT, this.rollback.leadOver(player), true);
    view.setUint32(HASH_STEP_AT, hash === undefined ? 0 : hashStep + 1, true);
    view.setBigUint64(HASH_AT, hash ?? 0n, true);
    for (let i = 0; i < count; i++) bytes[INPUTS_AT + i] = this.others[this.me].inputs[(confirmed + i) % KEPT];
    return seal(bytes);
  }

  #isMessage(bytes) {
    if (!isSealed(bytes, MARK, INPUTS_AT + SUM) || bytes.length !== INPUTS_AT + bytes[5] + SUM) return false;
    if (bytes.subarray(INPUTS_AT, INPUTS_AT + bytes[5]).some((input) => input >= INPUTS)) return false;
    const view = viewOf(bytes);
    const [from, first] = [bytes[4], view.getUint32(FIRST_AT, true)];
    return (
      from < this.players &&
      this.tells(from) &&
      view.getUint32(HEARD_AT, true) <= this.told &&
      first <= this.others[from].heard &&
      Math.abs(view.getInt32(LEAD_AT, true)) <= DEEPEST
    );
  }

  /** The input of a player in the first step of which it is not known. */
  hear(player, input) {
    const other = this.others[player];
    this.rollback.input(player, other.heard, input);
    other.inputs[other.heard % KEPT] = input;
    other.heard++;
  }

  /** Reads a message. What is no message, or damaged, changes nothing and is counted in `refused`. */
  read(bytes) {
    if (!this.#isMessage(bytes)) {
      this.refused++;
      return;
    }
    const view = viewOf(bytes);
    const [from, first] = [bytes[4], view.getUint32(FIRST_AT, true)];
    const other = this.others[from];
    other.confirmed = Math.max(other.confirmed, view.getUint32(HEARD_AT, true));
    // A player who waits may be sent inputs that it cannot store yet; they are sent again.
    const end = Math.min(first + bytes[5], this.steps + this.depth);
    while (other.heard < end) this.hear(from, bytes[INPUTS_AT + other.heard - first]);
    const step = view.getUint32(HASH_STEP_AT, true) - 1;
    if (step > other.told.step) other.told = { step, hash: view.getBigUint64(HASH_AT, true) };
    this.rollback.hearLead(from, view.getInt32(LEAD_AT, true));
  }

  /** Runs the next step, unless the rollback waits or the game is at its end, and compares hashes. */
  advance() {
    const { rollback } = this;
    this.#partWithThoseWhoLeft();
    if (this.#isOver) rollback.settle();
    else if (!rollback.advance()) this.waits++;
    for (; this.hashed <= rollback.confirmed; this.hashed += HASH_STEPS) {
      this.#hashes.set(this.hashed, BigInt(`0x${rollback.hashAt(this.hashed)}`));
      this.#hashes.delete(this.hashed - HASH_STEPS * HASHES);
    }
    for (const other of this.others) {
      const own = this.#hashes.get(other.told.step);
      if (own !== undefined && own !== other.told.hash && other.differsFrom < 0)
        other.differsFrom = other.told.step;
    }
  }

  /** Whether the game is at its end here: all inputs are known, and all steps were run with them. */
  get hasEnded() {
    return this.end > 0 && this.rollback.confirmed >= this.end && this.rollback.settled >= this.end;
  }

  /** Whether, besides, every other player has all own inputs: nothing is left to be sent. */
  get isDone() {
    const others = this.others.slice(0, this.players);
    return this.hasEnded && others.every(({ confirmed }, i) => !this.tells(i) || confirmed >= this.told);
  }

  /** The hash after the last step that is confirmed. */
  get hash() {
    return this.rollback.hashAt(this.rollback.confirmed);
  }

  /** The first player whose game differs; -1: none. */
  get differs() {
    return this.others.findIndex(({ differsFrom }) => differsFrom >= 0);
  }

  /**
   * The player has left before a step; `inputs`: its inputs of the steps before that one. The rollback
   * is told when it is near enough to that step.
   */
  part(player, step, inputs) {
    this.others[player].isGone = true;
    this.#leaving.set(player, { step, inputs });
  }

  #partWithThoseWhoLeft() {
    for (const [player, { step, inputs }] of this.#leaving) {
      const other = this.others[player];
      const end = Math.min(step, this.steps + this.depth);
      while (other.heard < end) this.hear(player, inputs[inputs.length - (step - other.heard)]);
      if (end < step) continue;
      this.rollback.leave(player, step);
      this.#leaving.delete(player);
    }
  }
}
