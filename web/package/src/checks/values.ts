/**
 * Checks the types of options. The module receives numbers as they are and refuses those out of
 * range; but JavaScript would convert any value to bits or a flag, so types are checked here.
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

/**
 * The types of options. Numbers, since a switch over them takes half the time of calls through a
 * table of functions.
 */
const enum Type {
  number,
  flag,
  word,
  pair,
  bits,
  group,
  /** A whole number. NaN and infinities pass, since the message about the range says more. */
  count,
  /** `lower` and `upper`: of a drive a number, of bounds a pair. */
  end,
}

/** The types as error messages name them. */
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

/** Whether the value is of the type. */
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
    case Type.bits: // also negative whole numbers, which the operator ~ gives
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
 * Whether the value may be a pair of numbers. False only for what would be converted to numbers by
 * mistake: longer lists, strings and booleans; the module refuses the rest. A typed array may be
 * longer, since programs keep further numbers in it.
 */
function isPair(value: unknown): boolean {
  const pair = value as readonly unknown[] | null;
  return !(Array.isArray(value) && value.length > 2) && !isText(pair?.[0]) && !isText(pair?.[1]);
}

/** Whether Number() would convert the value although it is no number. */
function isText(value: unknown): boolean {
  return typeof value === "string" || typeof value === "boolean";
}

/** The type of each option by its name; undefined for options that are not checked here. */
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
/** Options that are not in those lists, or of another type than a number or pair. */
const OTHERS: readonly (readonly [Type, string])[] = [
  [Type.number, "radius halfWidth halfHeight angle length ratio x0 spacing slope speed jump drag lift"],
  [Type.number, "breakForce breakTorque mass inertia"],
  [Type.pair, "offset center origin at from to axis"],
  [Type.end, "lower upper"],
  [Type.count, "substeps rays"],
  [Type.bits, "category mask oneWay"],
  [Type.group, "group"],
  [Type.word, "kind detection broadphase base cover"],
  [Type.flag, "sleeping contactEvents timed islands fixedRotation maySleep sensor events sensors drop x y"],
  [Type.flag, "collideConnected onlyReports enabled skip"],
];
for (const [type, names] of OTHERS) for (const name of names.split(" ")) TYPES[name] = type;
// These are checked where they are read (numbers.ts); "." marks the second number of a pair.
for (const name of ["quality", "userData", "."]) delete TYPES[name];

/** Throws "invalid" where the value of the option `name` is not of its type; `what`: the call. */
export function checkValue(what: string, name: string, options: object): void {
  const type = TYPES[name];
  if (type === undefined) return;
  const value = (options as Readonly<Record<string, unknown>>)[name];
  if (value === undefined || fits(value, type)) return;
  const told = `${what}: ${name} must be ${WORDS[type]}: ${show(value)}`;
  throw new ThudError("invalid", told + hintOf(type, value));
}

/** What the value was probably meant to be, to add to the message; "" where that is not known. */
function hintOf(type: Type, value: unknown): string {
  if (type === Type.pair && Array.isArray(value) && value.length === 3)
    return "; the third is none of a place, and an angle is told by itself";
  return typeof value === "string" && type !== Type.word ? "; in quotes it is a text" : "";
}
