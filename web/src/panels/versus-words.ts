/** What the comparison of two engines comes to, in words. */
import { type Engine, type Figures, NAMES } from "./versus-tally";

/** What the verdict is about. */
export const MEANING =
  "Same scene, same drags, same device. Accurate: bodies sink little into each other.";

/** Two values that are nearer to each other than this count as the same. */
const SAME = 1.1;
/** Milliseconds: less is no time worth comparing. */
const NO_TIME = 0.01;
/** Length scales: less is no overlap worth comparing. */
const NO_DEPTH = 1e-5;

export function verdict(thud: Figures, box2d: Figures, lengthScale: number): string {
  if (thud.typical === null || box2d.typical === null) return "Measuring…";
  const speed = compareTimes(thud.typical, box2d.typical);
  const accuracy = compareDepths(thud.mean, box2d.mean, lengthScale);
  const parts = [
    clause(speed, "fast", "Both take next to no time"),
    clause(accuracy, "accurate", "neither lets bodies sink in"),
  ];
  const sameEngine = speed?.better === accuracy?.better && speed && accuracy;
  const second = sameEngine && speed.better ? `${accuracy.times} times as accurate` : parts[1];
  const link = !speed?.better || !accuracy?.better || sameEngine ? "and" : "but";
  return `${parts[0].replace(/^both/, "Both")}, ${link} ${second}.`;
}

/** What Box2D was given of a world so many metres from the origin; "" of one that lies there. */
export function movedText(metres: number): string {
  if (metres === 0) return "";
  const far = Math.round(metres / 1000).toLocaleString("en");
  // The last of the 24 binary digits that a number of 32 bits has.
  const apart = 2 ** (Math.floor(Math.log2(metres)) - 23);
  return (
    `This scene lies ${far} km from the origin, where numbers of 32 bits, which Box2D has for ` +
    `places, are ${Number(apart.toPrecision(1))} m apart. So Box2D was given it moved to the ` +
    "origin; thud runs it where it is."
  );
}

export interface Comparison {
  /** Null: about the same. */
  better: Engine | null;
  times: string;
}

/** Milliseconds. */
export function compareTimes(thud: number, box2d: number): Comparison | null {
  return compare(thud, box2d, NO_TIME);
}

/** In the world's lengths. */
export function compareDepths(
  thud: number,
  box2d: number,
  lengthScale: number,
): Comparison | null {
  return compare(thud, box2d, NO_DEPTH * lengthScale);
}

/** Of costs: less is better. Null if both are next to nothing. */
function compare(thud: number, box2d: number, nothing: number): Comparison | null {
  if (Math.max(thud, box2d) < nothing) return null;
  const ratio = Math.max(box2d, nothing) / Math.max(thud, nothing);
  const factor = Math.max(ratio, 1 / ratio);
  if (factor < SAME) return { better: null, times: "" };
  return {
    better: ratio > 1 ? "thud" : "box2d",
    times: factor < 9.95 ? factor.toFixed(1) : String(Math.round(Math.min(factor, 1000))),
  };
}

function clause(comparison: Comparison | null, quality: string, none: string): string {
  if (!comparison) return none;
  const { better, times } = comparison;
  if (!better) return `both are about as ${quality}`;
  return `${NAMES[better]} is ${times} times as ${quality}`;
}
