/**
 * Finds out which springs, limits and motors of a thud joint are not given to Box2D's joint: those
 * whose fields makeJoint does not read. A proxy records the fields that are read, so that no list
 * of unsupported parts is needed.
 */
import type { Direction, Drive } from "thud";
import type { Tie } from "./make-joint";

const DIRECTIONS: readonly Direction[] = ["along", "across", "turn"];

/** A force of this size or more is no limit; see make-joint.ts. */
const UNBOUNDED = 1e30;

/**
 * The parts of a drive: the name, the fields of which makeJoint reads at least one if it supports
 * the part, and whether the part has an effect.
 */
const PARTS: readonly { what: string; by: readonly (keyof Drive)[]; acts(drive: Drive): boolean }[] = [
  { what: "springs", by: ["frequency"], acts: ({ frequency = 0 }) => frequency > 0 },
  {
    what: "limits",
    by: ["lower", "upper"],
    acts: ({ lower = -Infinity, upper = Infinity }) => lower > -Infinity || upper < Infinity,
  },
  { what: "motors", by: ["motorForce"], acts: ({ motorForce = 0 }) => motorForce > 0 },
  {
    what: "greatest forces of springs",
    by: ["springForce"],
    acts: ({ frequency = 0, springForce = Infinity }) => frequency > 0 && springForce < UNBOUNDED,
  },
];

/**
 * A copy of the options that records which fields are read. `lacks`, called afterwards, names the
 * parts that have an effect and were not read.
 */
export function heeding(tie: Tie): { tie: Tie; lacks(): string[] } {
  const read = new Set<string>();
  const noted = { ...tie } as Record<string, unknown>;
  for (const direction of DIRECTIONS) {
    const drive = noted[direction];
    if (!drive) continue;
    noted[direction] = new Proxy(drive, {
      get(target, name, receiver) {
        read.add(`${direction} ${String(name)}`);
        return Reflect.get(target, name, receiver) as unknown;
      },
    });
  }
  const drives = tie as Partial<Record<Direction, Drive>>;
  const wasRead = (direction: Direction, by: readonly (keyof Drive)[]) =>
    by.some((name) => read.has(`${direction} ${name}`));
  /**
   * Whether the part was read in this direction, or in another direction with the same values:
   * Box2D's welds and targets have one spring for both along and across.
   */
  const isGiven = (direction: Direction, by: readonly (keyof Drive)[]) =>
    DIRECTIONS.some(
      (one) =>
        wasRead(one, by) &&
        by.every((name) => drives[one]?.[name] === drives[direction]?.[name]),
    );
  const lacks = () =>
    DIRECTIONS.flatMap((direction) =>
      PARTS.filter(({ by, acts }) => acts(drives[direction] ?? {}) && !isGiven(direction, by)).map(
        ({ what }) => `${what} of a ${tie.kind} (${direction})`,
      ),
    );
  return { tie: noted as unknown as Tie, lacks };
}
