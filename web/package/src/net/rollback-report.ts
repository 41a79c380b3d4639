/**
 * The report of a rollback as bytes: those that thud_rollback_report of the C library writes for the
 * same game, so that a peer in one language compares itself with one in the other. The layout stands
 * in engine/src/sessions/rollback_report.c.
 */
import { ThudError } from "../error.js";
import { isStep, textOf } from "./rollback-bytes.js";

/** "tdR2". */
const MARK = 0x32526474;
const HEAD_BYTES = 36;
const HASH_BYTES = 8;
const BODY_BYTES = 12;
const SUM_BYTES = 8;

/** What a report tells. */
export interface Report {
  players: number;
  first: number;
  /** By step, from `first` on: 16 hexadecimal digits. */
  hashes: string[];
  /** The step of the bodies; -1: none. */
  step: number;
  /** Of the step before, by player, see inputNumber; null: not kept. */
  inputs: bigint[] | null;
  /** By body, in the order of slots: its slot and hash. */
  bodies: [number, bigint][];
}

const MIX_START = 0xcbf29ce484222325n;

/** FNV-1a by words of 64 bits in place of bytes, with high bits folded into low ones. */
const mix = (hash: bigint, word: bigint): bigint => {
  const mixed = BigInt.asUintN(64, (hash ^ word) * 0x100000001b3n);
  return mixed ^ (mixed >> 29n);
};

const sumOf = (bytes: Uint8Array): bigint =>
  bytes.reduce((sum, byte) => mix(sum, BigInt(byte)), MIX_START);

/** The bits of doubles, and of floats in pairs. */
const words = (numbers: Float64Array | Float32Array): bigint[] => [...new BigUint64Array(numbers.buffer)];

/** The hash of a body: of its x, y, angle, velocity and angular velocity. */
export function hashOfBody(motion: readonly number[]): bigint {
  const place = words(Float64Array.from(motion.slice(0, 3)));
  const speed = words(Float32Array.from([...motion.slice(3, 6), 0]));
  return [...place, ...speed].reduce(mix, MIX_START);
}

/**
 * An input as 64 bits: a whole number or a BigInt is itself, as in C, where inputs are uint64_t; of
 * anything else a hash.
 */
export function inputNumber(input: unknown): bigint {
  if (typeof input === "bigint" || Number.isSafeInteger(input))
    return BigInt.asUintN(64, BigInt(input as bigint | number));
  return sumOf(new TextEncoder().encode(String(textOf(input))));
}

export function writeReport({ players, first, hashes, step, inputs, bodies }: Report): Uint8Array<ArrayBuffer> {
  const told = inputs ?? [];
  const numbers = HASH_BYTES * (hashes.length + told.length);
  const bytes = new Uint8Array(HEAD_BYTES + numbers + BODY_BYTES * bodies.length + SUM_BYTES);
  const view = new DataView(bytes.buffer);
  view.setUint32(0, MARK, true);
  view.setUint32(4, players, true);
  view.setBigInt64(8, BigInt(first), true);
  view.setUint32(16, hashes.length, true);
  view.setUint32(20, bodies.length, true);
  view.setBigInt64(24, BigInt(step), true);
  view.setUint32(32, inputs ? 1 : 0, true);
  let at = HEAD_BYTES;
  for (const one of [...hashes.map((hash) => BigInt(`0x${hash}`)), ...told]) {
    view.setBigUint64(at, one, true);
    at += HASH_BYTES;
  }
  for (const [slot, hash] of bodies) {
    view.setUint32(at, slot, true);
    view.setBigUint64(at + 4, hash, true);
    at += BODY_BYTES;
  }
  view.setBigUint64(at, sumOf(bytes.subarray(0, at)), true);
  return bytes;
}

/** @throws {ThudError} "invalid" for bytes that are no report of a game with so many players. */
export function readReport(bytes: Uint8Array, players: number): Report {
  const fault = () => new ThudError("invalid", "rollback: no report, or a damaged one");
  if (!(bytes instanceof Uint8Array) || bytes.length < HEAD_BYTES + SUM_BYTES) throw fault();
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const end = bytes.length - SUM_BYTES;
  const number = (at: number) => view.getUint32(at, true);
  if (number(0) !== MARK || number(4) !== players) throw fault();
  if (view.getBigUint64(end, true) !== sumOf(bytes.subarray(0, end))) throw fault();
  const [first, step] = [8, 24].map((at) => Number(view.getBigInt64(at, true)));
  const [hashCount, bodyCount, inputCount] = [number(16), number(20), number(32) * players];
  const bodiesAt = HEAD_BYTES + HASH_BYTES * (hashCount + inputCount);
  const isWhole = bodiesAt + BODY_BYTES * bodyCount === end && number(32) <= 1;
  if (!isWhole || !isStep(first) || !(isStep(step) || (step === -1 && bodyCount === 0))) throw fault();
  const list = (at: number, count: number) =>
    Array.from({ length: count }, (_, i) => view.getBigUint64(at + HASH_BYTES * i, true));
  const bodies = Array.from({ length: bodyCount }, (_, i): [number, bigint] => {
    const at = bodiesAt + BODY_BYTES * i;
    return [number(at), view.getBigUint64(at + 4, true)];
  });
  if (bodies.some(([slot], i) => slot >= 2 ** 31 - 1 || (i > 0 && slot <= bodies[i - 1][0]))) throw fault();
  return {
    ...{ players, first, step, bodies },
    hashes: list(HEAD_BYTES, hashCount).map((hash) => hash.toString(16).padStart(16, "0")),
    inputs: inputCount > 0 ? list(HEAD_BYTES + HASH_BYTES * hashCount, inputCount) : null,
  };
}
