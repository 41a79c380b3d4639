/** Figures and settings in words. */
import type { Choices } from "../../worker/protocol";

/** "0.42 ms": three digits, not more than a clock gives. */
export function timeText(milliseconds: number): string {
  return `${plainTime(milliseconds)} ms`;
}

export function plainTime(milliseconds: number): string {
  if (milliseconds >= 100) return milliseconds.toFixed(0);
  return milliseconds.toFixed(milliseconds >= 10 ? 1 : milliseconds >= 0.1 ? 2 : 3);
}

/** In length scales. */
export function errorText(error: number): string {
  if (error <= 1e-6) return "none";
  return error >= 0.0001 ? String(Number(error.toPrecision(2))) : error.toExponential(0);
}

/** "high, 12 substeps, swept": what is not the usual. */
export function choicesText(choices: Choices): string {
  const { quality, substeps, detection, broadphase, maxError } = choices;
  return [
    quality,
    substeps > 0 ? `${substeps} sub` : "",
    detection === "auto" ? "" : detection,
    broadphase === "grid" ? "" : broadphase,
    maxError > 0 && quality !== "draft" ? `≤ ${maxError}` : "",
  ]
    .filter((part) => part !== "")
    .join(" ");
}

export const countText = (count: number): string => count.toLocaleString("en");
