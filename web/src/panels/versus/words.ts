/** The result of the comparison of thud and Box2D in words, and which of two figures is better. */
import { type Engine, ENGINES, type Figures, NAMES } from "./tally";

/** The text under the verdict, which explains it. */
export const MEANING =
  "Same scene, same drags, same device. Overlap is how deep the worst pair of bodies sinks in, " +
  "on average since both began. It does not tell how lifelike the motion is.";

/** Two values whose ratio is less than this count as the same. Chosen. */
const SAME = 1.1;
/** Milliseconds: smaller times count as this, and two smaller ones are not compared. Chosen. */
const NO_TIME = 0.01;
/** Length scales: smaller overlaps count as this, and two smaller ones are not compared. Chosen. */
const NO_DEPTH = 1e-5;

/** A sentence on speed and overlap; with another one on sleep if the engines do not do the same
 * work. "Measuring…" as long as there are no times. */
export function verdict(thud: Figures, box2d: Figures, lengthScale: number): string {
  const asleep = asleepText(thud, box2d);
  if (thud.typical === null || box2d.typical === null) return asleep || "Measuring…";
  const speed = compareTimes(thud.typical, box2d.typical);
  const accuracy = compareDepths(thud.mean, box2d.mean, lengthScale);
  const sameEngine = speed?.better === accuracy?.better;
  const link = !speed?.better || !accuracy?.better || sameEngine ? "and" : "but";
  const whose = sameEngine && speed?.better ? "its" : `${NAMES[accuracy?.better ?? "thud"]}’s`;
  const first = !speed
    ? "Both take next to no time"
    : speed.better
      ? `${NAMES[speed.better]} is ${speed.times} times as fast`
      : "Both are about as fast";
  const second = !accuracy
    ? "bodies overlap in neither"
    : accuracy.better
      ? `${whose} overlap is ${accuracy.times} times smaller`
      : "their overlap is about the same";
  return `${first}, ${link} ${second}. ${asleep}`.trim();
}

/** A sentence if all bodies sleep in an engine, or far fewer are awake in one than in the other, so
 * that times per step are not those of the same work; else "". */
function asleepText(thud: Figures, box2d: Figures): string {
  if (thud.bodies === 0) return "";
  const awake = { thud: thud.awake, box2d: box2d.awake };
  const sleeping = ENGINES.filter((engine) => awake[engine] === 0).map((engine) => NAMES[engine]);
  if (sleeping.length > 0)
    return (
      `All bodies sleep in ${sleeping.length > 1 ? "both" : sleeping[0]} now: only steps before ` +
      "that are timed."
    );
  const [few, many] = [Math.min(thud.awake, box2d.awake), Math.max(thud.awake, box2d.awake)];
  if (many <= SAME * few) return "";
  const [first, second] = ENGINES.map((engine) => awake[engine].toLocaleString("en"));
  return `Not the same work: ${first} bodies are awake in thud, ${second} in Box2D.`;
}

/** A text that explains that Box2D's world has been moved by some metres, since the scene is far
 * from the origin and Box2D's coordinates are 32-bit floats; "" if it has not been moved. */
export function movedText(metres: number): string {
  if (metres === 0) return "";
  const far = Math.round(metres / 1000).toLocaleString("en");
  // The distance of adjacent 32-bit floats of this size, whose significand has 24 bits.
  const apart = 2 ** (Math.floor(Math.log2(metres)) - 23);
  return (
    `This scene lies ${far} km from the origin, where numbers of 32 bits, which Box2D has for ` +
    `places, are ${Number(apart.toPrecision(1))} m apart. So Box2D was given it moved to the ` +
    "origin; thud runs it where it is."
  );
}

/** The result of comparing two figures. */
export interface Comparison {
  /** The engine with the smaller value; null: about the same. */
  better: Engine | null;
  /** How many times smaller, as text. */
  times: string;
}

/** Compares milliseconds; null if both are too short to compare. */
export function compareTimes(thud: number, box2d: number): Comparison | null {
  return compare(thud, box2d, NO_TIME);
}

/** Compares overlaps or gaps in world units; null if both are too small to compare. */
export function compareDepths(
  thud: number,
  box2d: number,
  lengthScale: number,
): Comparison | null {
  return compare(thud, box2d, NO_DEPTH * lengthScale);
}

/** Compares two costs, of which the smaller is better; null if both are below `nothing`. */
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
