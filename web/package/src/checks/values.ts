/**
 * What no range tells of the value of an option: whether it is of the right type. Numbers are passed to
 * the module as they are, and it refuses those out of range; bits and flags it would take of anything.
 */
import { ThudError } from "../error.js";
import {
  BODY_OPTIONS,
  DRIVE_OPTIONS,
  EXPLOSION_OPTIONS,
  FRAME_OPTIONS,
  MOVER_OPTIONS,
  RULE_OPTIONS,
  SHAPE_OPTIONS,
  TYRE_OPTIONS,
  WATER_OPTIONS,
  WORLD_OPTIONS,
} from "../generated/slots.js";
import { show } from "./show.js";

/** A switch over numbers takes half the time of calls through a table. */
const enum Type {
  number,
  flag,
  word,
  pair,
  bits,
  group,
  /** What is not finite has a range that tells. */
  count,
  /** Of a drive a number, of a box its corner. */
  end,
}

const WORDS: Readonly<Record<Type, string>> = {
  [Type.number]: "a number",
  [Type.flag]: "true or false",
  [Type.word]: "a word",
  [Type.pair]: "two numbers",
  [Type.bits]: "bits, a whole number from 0 to 0xffffffff",
  [Type.group]: "a whole number from -2147483648 to 2147483647",
  [Type.count]: "a whole number",
  [Type.end]: "a number",
};

function fits(value: unknown, type: Type): boolean {
  const number = value as number;
  switch (type) {
    case Type.number:
      return typeof value === "number";
    case Type.flag:
      return typeof value === "boolean";
    case Type.word:
      return typeof value === "string";
    case Type.pair:
      return isPair(value);
    case Type.bits: // the negative ones are those that ~ gives
      return (number | 0) === value || number >>> 0 === value;
    case Type.group:
      return (number | 0) === value;
    case Type.count:
      return typeof value === "number" && (Number.isInteger(value) || !Number.isFinite(value));
    case Type.end:
      return !isText(value) && isPair(value);
  }
}

/**
 * What the module would take for two numbers and is none; it refuses the rest itself. A typed array in
 * which more is kept may be longer.
 */
function isPair(value: unknown): boolean {
  const pair = value as readonly unknown[] | null;
  return !(Array.isArray(value) && value.length > 2) && !isText(pair?.[0]) && !isText(pair?.[1]);
}

function isText(value: unknown): boolean {
  return typeof value === "string" || typeof value === "boolean";
}

const TYPES: Record<string, Type | undefined> = Object.create(null);
for (const names of [
  WORLD_OPTIONS,
  BODY_OPTIONS,
  SHAPE_OPTIONS,
  DRIVE_OPTIONS,
  FRAME_OPTIONS,
  RULE_OPTIONS,
  EXPLOSION_OPTIONS,
  WATER_OPTIONS,
  TYRE_OPTIONS,
  MOVER_OPTIONS,
] as readonly (readonly string[])[])
  names.forEach((name, i) => {
    TYPES[name] = names[i + 1] === "." ? Type.pair : Type.number;
  });
const OTHERS: readonly (readonly [Type, string])[] = [
  [Type.number, "radius halfWidth halfHeight angle length ratio x0 spacing slope speed jump drag lift"],
  [Type.number, "breakForce breakTorque mass inertia"],
  [Type.pair, "offset center origin at from to axis"],
  [Type.end, "lower upper"],
  [Type.count, "substeps rays"],
  [Type.bits, "category mask oneWay"],
  [Type.group, "group"],
  [Type.word, "kind detection broadphase base cover meeting"],
  [Type.flag, "sleeping contactEvents timed islands fixedRotation maySleep sensor events sensors drop x y"],
  [Type.flag, "collideConnected onlyReports enabled skip"],
];
for (const [type, names] of OTHERS) for (const name of names.split(" ")) TYPES[name] = type;
// Those are looked at where they are read.
for (const name of ["quality", "userData", "."]) delete TYPES[name];

/** Throws for a value that its option cannot have. */
export function checkValue(what: string, name: string, options: object): void {
  const type = TYPES[name];
  if (type === undefined) return;
  const value = (options as Readonly<Record<string, unknown>>)[name];
  if (value === undefined || fits(value, type)) return;
  const told = `${what}: ${name} must be ${WORDS[type]}: ${show(value)}`;
  throw new ThudError("invalid", told + hintOf(type, value));
}

/** What is likely to be meant. */
function hintOf(type: Type, value: unknown): string {
  if (type === Type.pair && Array.isArray(value) && value.length === 3)
    return "; the third is none of a place, and an angle is told by itself";
  return typeof value === "string" && type !== Type.word ? "; in quotes it is a text" : "";
}
