/**
 * What Box2D's joint is not given of thud's: whatever the maker of the joint does not read. So a
 * spring, limit or motor that make-joint.ts has no place for is told of without a list of its own.
 */
import type { Direction, Drive } from "thud";
import type { Tie } from "./make-joint";

const DIRECTIONS: readonly Direction[] = ["along", "across", "turn"];

/** More than that is no bound; see make-joint.ts. */
const UNBOUNDED = 1e30;

/** What acts in a direction: its name, the numbers that stand for it, and whether it does. */
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

/** A tie that notes what is read of it, and tells what acts and was not. */
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
  /** Read, or like one that was: Box2D's welds and targets have one spring along and across. */
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
