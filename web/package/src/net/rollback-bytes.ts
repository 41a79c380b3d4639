/** The game of a rollback as bytes, for who joins it: a mark, plain data as JSON, and a checksum. */
import { ThudError } from "../error.js";
import type { MoverState } from "../mover.js";

const MARK_BYTES = 4;
const LENGTH_BYTES = 4;
const SUM_BYTES = 4;

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

/** Writes a mark of four letters, plain data, and further bytes. */
export function pack(mark: string, data: unknown, more: Uint8Array = new Uint8Array()): Uint8Array<ArrayBuffer> {
  const text = new TextEncoder().encode(textOf(data));
  const from = MARK_BYTES + LENGTH_BYTES;
  const bytes = new Uint8Array(from + text.length + more.length + SUM_BYTES);
  const view = new DataView(bytes.buffer);
  bytes.set(new TextEncoder().encode(mark));
  view.setUint32(MARK_BYTES, text.length, true);
  bytes.set(text, from);
  bytes.set(more, from + text.length);
  const end = bytes.length - SUM_BYTES;
  view.setUint32(end, sumOf(bytes.subarray(0, end)), true);
  return bytes;
}

/**
 * The plain data and the further bytes.
 * @throws {ThudError} "invalid" for bytes that are damaged, or have another mark.
 */
export function unpack(mark: string, bytes: Uint8Array): { data: unknown; more: Uint8Array } {
  const from = MARK_BYTES + LENGTH_BYTES;
  const fault = () => new ThudError("invalid", `rollback: no bytes of ${mark}, or damaged ones`);
  if (!(bytes instanceof Uint8Array) || bytes.length < from + SUM_BYTES) throw fault();
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const [end, length] = [bytes.length - SUM_BYTES, view.getUint32(MARK_BYTES, true)];
  const isMarked = new TextEncoder().encode(mark).every((letter, i) => bytes[i] === letter);
  if (!isMarked || from + length > end) throw fault();
  if (view.getUint32(end, true) !== sumOf(bytes.subarray(0, end))) throw fault();
  try {
    const text = new TextDecoder("utf-8", { fatal: true }).decode(bytes.subarray(from, from + length));
    return { data: JSON.parse(text, read) as unknown, more: bytes.slice(from + length, end) };
  } catch {
    throw fault();
  }
}

export const isStep = (value: unknown): value is number =>
  Number.isSafeInteger(value) && (value as number) >= 0;

/** Two numbers, which may be infinite. */
export const isPair = (value: unknown): value is [number, number] =>
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
