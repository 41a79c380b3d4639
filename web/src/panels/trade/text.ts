/** Texts of the panel Trade: times, overlaps, settings and counts. */
import type { Choices } from "../../worker/protocol";

/** A time with its unit: "0.42 ms". */
export function timeText(milliseconds: number): string {
  return `${plainTime(milliseconds)} ms`;
}

/** A time without its unit, with about as many digits as the clock resolves. */
export function plainTime(milliseconds: number): string {
  if (milliseconds >= 100) return milliseconds.toFixed(0);
  return milliseconds.toFixed(milliseconds >= 10 ? 1 : milliseconds >= 0.1 ? 2 : 3);
}

/** An overlap in length scales. */
export function errorText(error: number): string {
  if (error <= 1e-6) return "none";
  return error >= 0.0001 ? String(Number(error.toPrecision(2))) : error.toExponential(0);
}

/** "high 12 sub swept": the quality, and the other choices that differ from the defaults. */
export function choicesText(choices: Choices): string {
  const { quality, substeps, detection, broadphase, maxError, stepRate, topSpeed } = choices;
  return [
    quality,
    substeps > 0 ? `${substeps} sub` : "",
    detection === "auto" ? "" : detection,
    broadphase === "grid" ? "" : broadphase,
    maxError > 0 && quality !== "draft" ? `≤ ${maxError}` : "",
    stepRate > 0 ? `${stepRate}/s` : "",
    topSpeed > 0 ? `up to ${topSpeed}` : "",
  ]
    .filter((part) => part !== "")
    .join(" ");
}

export const countText = (count: number): string => count.toLocaleString("en");
