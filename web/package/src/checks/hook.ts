/**
 * Where refusals are explained, once somebody can: explain.ts is no part of a quick first load, and
 * until it is there the engine's own words stand.
 */
import { ThudError } from "../error.js";

/** What to throw for an error, by the call and what was given. */
export type Explainer = (error: ThudError, call: string, given: object, scale: number) => unknown;

let explainer: Explainer | null = null;
/** What is told of a misspelt option. */
export let nearest: (name: string, names: readonly string[]) => string = () => "";
/** A value as a message has it. */
export let shown: (value: unknown) => string = String;

export function explainWith(one: Explainer, tellNearest: typeof nearest, show: typeof shown): void {
  explainer = one;
  nearest = tellNearest;
  shown = show;
}

/** What to throw where the engine found a value out of range: where known, which one it was. */
export function explained(error: unknown, call: string, given: object, scale = 1): unknown {
  return explainer && isRefusal(error) ? explainer(error, call, given, scale) : error;
}

/** Whether the engine found a value out of range, and nobody has told yet which. */
export function isRefusal(error: unknown): error is ThudError {
  return error instanceof ThudError && error.code === "invalid" && error.cause === undefined;
}

/** The same error, told as of a part of what was made. */
export function within(error: ThudError, part: string): ThudError {
  return new ThudError(error.code, `${part}: ${error.message}`, { cause: error.cause ?? error });
}
