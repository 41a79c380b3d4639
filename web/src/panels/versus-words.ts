/** What the comparison of two engines comes to, in a sentence. */
import type { Figures } from "./versus-tally";

/** Two values that are nearer to each other than this count as the same. */
const SAME = 1.1;
/** Milliseconds: less is no time worth comparing. */
const NO_TIME = 0.01;
/** Length scales: less is no overlap worth comparing. */
const NO_DEPTH = 1e-5;

export function verdict(thud: Figures, box2d: Figures, lengthScale: number): string {
  if (thud.typical === null || box2d.typical === null) return "Measuring…";
  const speed = compare(thud.typical, box2d.typical, NO_TIME);
  const accuracy = compare(thud.mean, box2d.mean, NO_DEPTH * lengthScale);
  const parts = [
    clause(speed, "fast", "Both take next to no time"),
    clause(accuracy, "accurate", "neither lets bodies sink in"),
  ];
  const sameEngine = speed?.better === accuracy?.better && speed && accuracy;
  const second = sameEngine && speed.better ? `${accuracy.times} times as accurate` : parts[1];
  const link = !speed?.better || !accuracy?.better || sameEngine ? "and" : "but";
  return `${parts[0].replace(/^both/, "Both")}, ${link} ${second}.`;
}

interface Comparison {
  /** Null: about the same. */
  better: "thud" | "Box2D" | null;
  times: string;
}

/** Of costs: less is better. Null if both are next to nothing. */
function compare(thud: number, box2d: number, nothing: number): Comparison | null {
  if (Math.max(thud, box2d) < nothing) return null;
  const ratio = Math.max(box2d, nothing) / Math.max(thud, nothing);
  const factor = Math.max(ratio, 1 / ratio);
  if (factor < SAME) return { better: null, times: "" };
  return {
    better: ratio > 1 ? "thud" : "Box2D",
    times: factor < 9.95 ? factor.toFixed(1) : String(Math.round(Math.min(factor, 1000))),
  };
}

function clause(comparison: Comparison | null, quality: string, none: string): string {
  if (!comparison) return none;
  const { better, times } = comparison;
  return better ? `${better} is ${times} times as ${quality}` : `both are about as ${quality}`;
}
