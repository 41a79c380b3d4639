/** The classes of objects in a map that are joints, and the properties of joints. */
import type { Direction, JointKind } from "../joint-types.js";
import type { Json } from "./values.js";

/** The directions that each kind of joint drives. */
export const KINDS: Record<JointKind, Direction[]> = {
  distance: ["along"],
  hinge: ["turn"],
  slider: ["along"],
  weld: ["along", "across", "turn"],
  wheel: ["along", "turn"],
  target: ["along", "across", "turn"],
  filter: [],
  gear: [],
};
/**
 * The properties of a drive, after the name of its direction, and those of every kind but filters.
 */
const DRIVE = "lower upper frequency damping target spring_force motor_speed motor_force".split(" ");
const COMMON = ["break_force", "break_torque", "collide_connected"];

/** The names of the properties of each kind of joint. */
const MEANINGS = new Map(
  Object.entries(KINDS).map(([kind, directions]) => {
    const drives = directions.flatMap((one) => DRIVE.map((name) => `${one}_${name}`));
    const own = kind === "distance" ? ["length"] : kind === "gear" ? ["ratio"] : [];
    const common = kind === "filter" ? [] : COMMON;
    return [kind, new Set(["a", "b", ...own, ...common, ...drives])];
  }),
);

/** The kind of joint that a class of objects names, or null. */
export function jointKind(name: Json): JointKind | null {
  return typeof name === "string" && Object.hasOwn(KINDS, name) ? (name as JointKind) : null;
}

/** Whether a kind of joint, or any kind, has a property of this name. */
export function jointKnows(kind: JointKind | "any", name: string): boolean {
  if (kind === "any") return [...MEANINGS.values()].some((names) => names.has(name));
  return MEANINGS.get(kind)?.has(name) === true;
}
