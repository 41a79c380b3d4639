/**
 * The game of a rollback as bytes, for who joins it: those that thud_rollback_snapshot of the C library
 * writes. The layout stands in engine/src/sessions/rollback_join.c.
 */
import { ThudError } from "../error.js";
import type { MoverState } from "../mover.js";

/** "tdJ2". */
const MARK = 0x324a6474;
const [HEAD_BYTES, PLAYER_BYTES, SUM_BYTES] = [32, 24, 4];

/** FNV-1a of 32 bits (Fowler, Noll, Vo). */
export function sumOf(bytes: Uint8Array): number {
  let sum = 0x811c9dc5;
  for (const byte of bytes) sum = Math.imul(sum ^ byte, 0x01000193);
  return sum >>> 0;
}

/** Numbers that JSON does not have. */
const NUMBERS: Record<string, number> = { "-0": -0, NaN, Infinity, "-Infinity": -Infinity };

const write = (_name: string, value: unknown): unknown => {
  if (typeof value !== "number" || (Number.isFinite(value) && !Object.is(value, -0))) return value;
  return { $number: Object.is(value, -0) ? "-0" : String(value) };
};

const read = (_name: string, value: unknown): unknown => {
  const name = (value as { $number?: unknown } | null)?.$number;
  return typeof name === "string" && name in NUMBERS ? NUMBERS[name] : value;
};

/** Plain data as JSON, numbers that JSON does not have included; undefined for what is no data. */
export const textOf = (data: unknown): string | undefined => JSON.stringify(data, write);

/** A game that is joined. */
export interface Game {
  step: number;
  /** By player: its input in the step before, and when it is absent; Infinity: never. */
  players: { input: bigint; gone: number; back: number }[];
  world: Uint8Array;
  /** The program's own. */
  state: Uint8Array;
}

/** In place of a step: never. */
const NEVER = 2n ** 63n - 1n;
const stepOf = (value: bigint) => (value === NEVER ? Infinity : Number(value));
const numberOf = (step: number) => (step === Infinity ? NEVER : BigInt(step));

/** The bytes of a game. */
export function packGame({ step, players, world, state }: Game): Uint8Array<ArrayBuffer> {
  const from = HEAD_BYTES + PLAYER_BYTES * players.length;
  const bytes = new Uint8Array(from + world.length + state.length + SUM_BYTES);
  const view = new DataView(bytes.buffer);
  view.setUint32(0, MARK, true);
  view.setUint32(4, players.length, true);
  view.setBigInt64(8, BigInt(step), true);
  view.setBigUint64(16, BigInt(world.length), true);
  view.setBigUint64(24, BigInt(state.length), true);
  players.forEach(({ input, gone, back }, i) => {
    const at = HEAD_BYTES + PLAYER_BYTES * i;
    view.setBigUint64(at, input, true);
    view.setBigInt64(at + 8, numberOf(gone), true);
    view.setBigInt64(at + 16, numberOf(back), true);
  });
  bytes.set(world, from);
  bytes.set(state, from + world.length);
  const end = bytes.length - SUM_BYTES;
  view.setUint32(end, sumOf(bytes.subarray(0, end)), true);
  return bytes;
}

/**
 * The game in bytes.
 * @throws {ThudError} "invalid" for bytes that are damaged, or no game.
 */
export function unpackGame(bytes: Uint8Array): Game {
  const fault = () => new ThudError("invalid", "rollback: no bytes of a game, or damaged ones");
  if (!(bytes instanceof Uint8Array) || bytes.length < HEAD_BYTES + SUM_BYTES) throw fault();
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const end = bytes.length - SUM_BYTES;
  if (view.getUint32(0, true) !== MARK || view.getUint32(end, true) !== sumOf(bytes.subarray(0, end)))
    throw fault();
  const [count, step] = [view.getUint32(4, true), Number(view.getBigInt64(8, true))];
  const [worldBytes, stateBytes] = [16, 24].map((at) => Number(view.getBigUint64(at, true)));
  const from = HEAD_BYTES + PLAYER_BYTES * count;
  if (from + worldBytes + stateBytes !== end || !isStep(step)) throw fault();
  const players = Array.from({ length: count }, (_, i) => {
    const at = HEAD_BYTES + PLAYER_BYTES * i;
    const [gone, back] = [8, 16].map((place) => stepOf(view.getBigInt64(at + place, true)));
    if (!isStepOrNever(gone) || !isStepOrNever(back)) throw fault();
    return { input: view.getBigUint64(at, true), gone, back };
  });
  return {
    ...{ step, players, world: bytes.slice(from, from + worldBytes) },
    state: bytes.slice(from + worldBytes, end),
  };
}

const isStepOrNever = (value: number) => value === Infinity || isStep(value);

/** State, movers, and inputs that are no numbers, as bytes: none where there is nothing to tell. */
export function writeState(own: { state: unknown; movers: MoverState[]; inputs: readonly unknown[] | null }): Uint8Array {
  if (own.state === undefined && own.movers.length === 0 && !own.inputs) return new Uint8Array();
  return new TextEncoder().encode(textOf(own));
}

/** @throws {ThudError} "invalid" for other bytes. */
export function readState(bytes: Uint8Array): { state?: unknown; movers: unknown; inputs: unknown } {
  if (bytes.length === 0) return { movers: [], inputs: null };
  try {
    const own = JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(bytes), read) as object | null;
    return { movers: null, inputs: null, ...own };
  } catch {
    throw new ThudError("invalid", "rollback: the bytes are of a game with another state");
  }
}

export const isStep = (value: unknown): value is number =>
  Number.isSafeInteger(value) && (value as number) >= 0;

/** Two numbers. */
const isPair = (value: unknown): value is [number, number] =>
  Array.isArray(value) && value.length === 2 && value.every((one) => typeof one === "number");

/** Whether all these properties of a value are as they should be. */
const has = (value: unknown, names: readonly string[], is: (one: unknown) => boolean): boolean =>
  typeof value === "object" &&
  value !== null &&
  names.every((name) => is((value as Record<string, unknown>)[name]));

const isPoint = (value: unknown) => isPair(value) && value.every((one) => Number.isFinite(one));
const isHandle = (value: unknown) => has(value, ["index", "generation"], isStep);

/** Whether a value can be the state of a mover. */
export const isMoverState = (value: unknown): value is MoverState =>
  has(value, ["position"], isPoint) &&
  has(value, ["rise", "drift"], Number.isFinite) &&
  has(value, ["ground"], (ground) => ground === null || isGround(ground));

const isGround = (value: unknown) =>
  has(value, ["normal", "point", "place"], isPoint) &&
  has(value, ["cosine", "sine"], Number.isFinite) &&
  has(value, ["shape", "body"], isHandle);
