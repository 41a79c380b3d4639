/**
 * Hooks for the checks of explain.ts, which a page may load later ("thud/first"). The rest of the
 * package calls the checks through this file. Until explainWith sets them, errors keep the engine's
 * message, and the types of options are not checked.
 */
import { ThudError } from "../error.js";

/**
 * Returns the error to throw in place of `error`. `call`: the method, and `given` its options; or
 * the module's function, and `given` a list of its arguments. `scale`: the world's length scale.
 */
export type Explainer = (error: ThudError, call: string, given: object, scale: number) => unknown;

let explainer: Explainer | null = null;
/** The text that the message about an unknown option `name` ends with: the nearest of `names`. */
export let nearest: (name: string, names: readonly string[]) => string = () => "";
/** A value as error messages print it. */
export let shown: (value: unknown) => string = String;
/** Throws where the value of the option `name` is not of its type; `what`: the call. */
export let checkValue: (what: string, name: string, options: object) => void = () => {};

/** Throws for joint options that exclude or need each other; `own`: the options of its kind. */
export let checkJoint: (kind: string, options: object, own: readonly string[]) => void = () => {};

/**
 * Throws where `elapsed` seems to be milliseconds; `made`: the seconds that maxSteps steps cover.
 */
export let checkElapsed: (world: object, elapsed: number, made: number) => void = () => {};
/** Throws: `step` takes no argument. */
export let checkStep: (given: unknown) => void = () => {};

interface Checks {
  explain: Explainer;
  nearest: typeof nearest;
  shown: typeof shown;
  checkValue: typeof checkValue;
  checkJoint: typeof checkJoint;
  checkElapsed: typeof checkElapsed;
  checkStep: typeof checkStep;
}

/** Sets all hooks. */
export function explainWith(checks: Checks): void {
  explainer = checks.explain;
  ({ nearest, shown, checkValue, checkJoint, checkElapsed, checkStep } = checks);
}

/**
 * The error to throw in place of `error`: the explainer's where the engine refused a value and the
 * explainer is loaded, else `error` itself.
 */
export function explained(error: unknown, call: string, given: object, scale = 1): unknown {
  return explainer && isRefusal(error) ? explainer(error, call, given, scale) : error;
}

/**
 * Whether the engine refused a value, and no explanation has replaced the error (it has no cause).
 */
export function isRefusal(error: unknown): error is ThudError {
  return error instanceof ThudError && error.code === "invalid" && error.cause === undefined;
}

/** The same error with `part`, such as "createBody: shapes[2]", before its message. */
export function within(error: ThudError, part: string): ThudError {
  return new ThudError(error.code, `${part}: ${error.message}`, { cause: error.cause ?? error });
}
