/**
 * Reads and checks values of a Tiled map: fields of the file format, and custom properties, which
 * objects inherit from their layer, tileset, tile and template. Collects the problems in a report.
 */
import type { JointKind } from "../joint-types.js";
import type { BodyKind, BodyOptions, ShapeOptions } from "../types.js";
import { jointKnows } from "./joint-names.js";

/** A value of JSON; undefined for a field that is missing. */
export type Json = null | boolean | number | string | Json[] | JsonRecord | undefined;
export interface JsonRecord {
  [name: string]: Json;
}

/** A part of a map that is left out or has no effect. */
export interface Problem {
  /**
   * note: it has no effect on the world. skip: the part is left out, or the level is refused (see
   * ReadOptions.skip). fatal: the level is refused.
   */
  severity: "note" | "skip" | "fatal";
  /** The id of the object, or 0 for a layer or the map. */
  object: number;
  /** What is wrong, and where. */
  text: string;
}

/** The custom properties that have a meaning, apart from those of joints. */
const KNOWN = new Set(
  (
    "body bodyType fixed_rotation sensor may_sleep velocity_x velocity_y angular_velocity gravity_scale " +
    "linear_damping angular_damping density friction restitution category mask group approximate solid " +
    "gravity_x gravity_y pixels_per_unit length_scale camera_x camera_y camera_height character " +
    "title about"
  ).split(" "),
);

export function isRecord(json: Json): json is JsonRecord {
  return typeof json === "object" && json !== null && !Array.isArray(json);
}

/**
 * The maximum number of problems that are kept; further ones are counted only. Chosen: it bounds
 * the memory that a malicious file can take.
 */
const MOST_PROBLEMS = 100000;

/** The problems of a map, and the numbers of those that leave something out and that are fatal. */
export class Report {
  readonly problems: Problem[] = [];
  skipped = 0;
  fatal = 0;

  /** Adds a problem; `object`: the id of the object, 0: none. */
  add(severity: Problem["severity"], object: number, text: string): void {
    if (severity === "skip") this.skipped++;
    if (severity === "fatal") this.fatal++;
    if (this.problems.length === MOST_PROBLEMS) return;
    this.problems.push({
      severity,
      object,
      text: object !== 0 ? `object ${object}: ${text}` : text,
    });
  }

  /**
   * Notes every custom property that has no meaning for the object, so that a misspelt name is not
   * ignored. `joint`: the kind of joint that the object is, null: no joint, "any": properties of
   * shapes and of all joints are allowed.
   */
  noteUnknown(json: JsonRecord, object: number, where: string, joint: JointKind | null | "any"): void {
    const isShape = joint === null || joint === "any";
    for (const [name] of ownProperties(json)) {
      if ((isShape && KNOWN.has(name)) || (joint && jointKnows(joint, name))) continue;
      const place = object !== 0 ? "" : `${where}: `;
      this.add("note", object, `${place}property '${name}' has no meaning here`);
    }
  }
}

/** The custom properties of one JSON object, in the order of the file. */
function ownProperties(json: JsonRecord): [name: string, value: Json][] {
  if (!Array.isArray(json.properties)) return [];
  return json.properties.map((property) => {
    if (!isRecord(property)) return ["", undefined];
    return [typeof property.name === "string" ? property.name : "", property.value];
  });
}

/** A custom property's value from this one object only. */
export function ownProperty(json: JsonRecord, name: string): Json {
  return ownProperties(json).find(([known]) => known === name)?.[1];
}

/** The syntax of numbers in JSON, and their maximum length in characters, which is chosen. */
const NUMBER = /^-?\d+(\.\d+)?([eE][-+]?\d+)?$/;
const LONGEST_NUMBER = 60;

/** The number that the whole text stands for, or null. */
export function numberOf(text: string): number | null {
  return text.length <= LONGEST_NUMBER && NUMBER.test(text) ? Number(text) : null;
}

/** The boolean of a property, which may also be a text; null for other values. */
export function flagOf(value: Json): boolean | null {
  if (value === true || value === "true") return true;
  return value === false || value === "false" ? false : null;
}

/** Reads the values of one object, tile or layer, and reports values that cannot be used. */
export class Values {
  /** Whether a value could not be used. */
  bad = false;

  /**
   * `chain`: the objects in which properties are looked up, the last of them first. `object`: the
   * id for reports, or 0, then `where` names the place.
   */
  constructor(
    readonly report: Report,
    readonly chain: readonly JsonRecord[],
    readonly object: number,
    readonly where: string,
  ) {}

  /** Values of the same object with another chain. */
  within(chain: readonly JsonRecord[]): Values {
    return new Values(this.report, chain, this.object, this.where);
  }

  /** Adds a problem to the report. */
  complain(severity: Problem["severity"], text: string): void {
    const place = this.object !== 0 ? "" : `${this.where}: `;
    this.report.add(severity, this.object, place + text);
  }

  /** Sets `bad`, and reports why the object cannot be used. */
  refuse(text: string): void {
    this.bad = true;
    this.complain("skip", text);
  }

  #complain(name: string, what: string): void {
    this.refuse(`${name} ${what}`);
  }

  /** The value, or `low` after a report where it is no number or out of range. */
  #checked(value: Json, name: string, low: number, high: number): number {
    if (typeof value !== "number") {
      this.#complain(name, "is not a number");
      return low;
    }
    return this.#ranged(value, name, low, high);
  }

  #ranged(value: number, name: string, low: number, high: number): number {
    if (!Number.isFinite(value) || value < low || value > high) {
      this.#complain(name, "is out of range");
      return low;
    }
    return value;
  }

  /** The custom property of the innermost object of the chain that has it; undefined: none has. */
  find(name: string): Json {
    for (let i = this.chain.length - 1; i >= 0; i--) {
      const value = ownProperty(this.chain[i], name);
      if (value !== undefined) return value;
    }
    return undefined;
  }

  /** A field of `json` that must be a number in this range. */
  required(json: JsonRecord, name: string, low: number, high: number): number {
    const value = json[name];
    if (value === undefined) {
      this.#complain(name, "is missing");
      return low;
    }
    return this.#checked(value, name, low, high);
  }

  /** The same, or `fallback` where the field is missing. */
  optional(json: JsonRecord, name: string, fallback: number, low: number, high: number): number {
    return json[name] === undefined ? fallback : this.required(json, name, low, high);
  }

  /**
   * A custom property (`find`) that is a number in this range, or `fallback` where there is none.
   */
  number(name: string, fallback: number, low: number, high: number): number {
    const value = this.find(name);
    // Tiled makes a custom property a string unless its user chooses another type.
    const number = typeof value === "string" ? numberOf(value) : null;
    if (number !== null) return this.#ranged(number, name, low, high);
    return value === undefined ? fallback : this.#checked(value, name, low, high);
  }

  /** A custom property that is a boolean. */
  flag(name: string, fallback: boolean): boolean {
    const value = this.find(name);
    if (value === undefined) return fallback;
    const flag = flagOf(value);
    if (flag === null) this.#complain(name, "is neither true nor false");
    return flag === true;
  }

  /** A custom property that is a text. */
  text(name: string, fallback: string): string {
    const value = this.find(name);
    if (value === undefined) return fallback;
    if (typeof value !== "string") this.#complain(name, "is not a text");
    return typeof value === "string" ? value : fallback;
  }

  /** A custom property that is a whole number. */
  whole(name: string, fallback: number, low: number, high: number): number {
    const value = this.number(name, fallback, low, high);
    if (value !== Math.floor(value)) this.#complain(name, "is not a whole number");
    return value;
  }

  /** The kind of the body: the property `body`, or else `bodyType`; default static. */
  kind(): BodyKind {
    const kind = this.text("body", this.text("bodyType", "static"));
    if (kind === "dynamic" || kind === "kinematic" || kind === "static") return kind;
    this.#complain("body", "is none of static, kinematic, dynamic");
    return "static";
  }
}

/** The physical properties of an object or a tile. */
export interface Physics {
  kind: BodyKind;
  body: BodyOptions;
  material: ShapeOptions;
  /** The greatest count of shapes that cover a polygon; 0: none do. */
  approximate: number;
}

/** Reads the physical properties; v.bad is set where one is wrong. Units are those of the world. */
export function readPhysics(v: Values): Physics {
  const huge = 1e9; // products of larger values exceed single precision
  const kind = v.kind();
  const fixedRotation = v.flag("fixed_rotation", false);
  const sensor = v.flag("sensor", false);
  const body: BodyOptions = { kind, fixedRotation, maySleep: v.flag("may_sleep", true) };
  const velocityX = v.number("velocity_x", 0, -huge, huge);
  const velocityY = v.number("velocity_y", 0, -huge, huge);
  const angularVelocity = v.number("angular_velocity", 0, -huge, huge);
  if (kind !== "static") Object.assign(body, { velocity: [velocityX, velocityY], angularVelocity });
  body.gravityScale = v.number("gravity_scale", 1, -huge, huge);
  body.linearDamping = v.number("linear_damping", 0, 0, huge);
  body.angularDamping = v.number("angular_damping", 0, 0, huge);
  const material: ShapeOptions = {
    density: v.number("density", 1, 1e-6, huge),
    friction: v.number("friction", 0.6, 0, 1e6),
    restitution: v.number("restitution", 0, 0, 1),
    category: v.whole("category", 1, 0, 0xffffffff),
    mask: v.whole("mask", 0xffffffff, 0, 0xffffffff),
    group: v.whole("group", 0, -0x80000000, 0x7fffffff),
    sensor,
  };
  const approximate = v.whole("approximate", 0, 0, 64);
  return { kind, body, material, approximate };
}

/** The nearest multiple of 2^-16, on which all positions of bodies lie. */
export function grid(x: number): number {
  return Math.floor(x * 65536 + 0.5) / 65536;
}
