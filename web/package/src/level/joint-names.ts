/** The names in a map that mean a joint or something of one. */
import type { Direction, JointKind } from "../joint-types.js";
import type { Json } from "./values.js";

/** Which directions each kind drives. */
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
const DRIVE = "lower upper frequency damping target spring_force motor_speed motor_force".split(" ");
const COMMON = ["break_force", "break_torque", "collide_connected"];

/** What the properties of an object mean something to. */
const MEANINGS = new Map(
  Object.entries(KINDS).map(([kind, directions]) => {
    const drives = directions.flatMap((one) => DRIVE.map((name) => `${one}_${name}`));
    const own = kind === "distance" ? ["length"] : kind === "gear" ? ["ratio"] : [];
    const common = kind === "filter" ? [] : COMMON;
    return [kind, new Set(["a", "b", ...own, ...common, ...drives])];
  }),
);

/** The kind that a class of objects is, or null. */
export function jointKind(name: Json): JointKind | null {
  return typeof name === "string" && Object.hasOwn(KINDS, name) ? (name as JointKind) : null;
}

/** Whether a property means something to a kind, or to any. */
export function jointKnows(kind: JointKind | "any", name: string): boolean {
  if (kind === "any") return [...MEANINGS.values()].some((names) => names.has(name));
  return MEANINGS.get(kind)?.has(name) === true;
}
