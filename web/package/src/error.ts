/**
 * Why a call failed. "null": an argument is missing, or is no handle. "invalid": a value is out of
 * range or of the wrong type. "stale": the handle's object, or the world, was destroyed. "memory":
 * out of memory. "locked": the call is not allowed inside a callback of the world (a listener, a
 * pair filter or a cast listener). "load": the engine could not be loaded.
 */
export type ErrorCode = "null" | "invalid" | "stale" | "memory" | "locked" | "load";

/** The codes by the value of C's thud_result; the first is success. */
export const RESULT_CODES: readonly (ErrorCode | "ok")[] = [
  "ok",
  "null",
  "invalid",
  "stale",
  "memory",
  "locked",
];

/**
 * What a call that fails throws. The call has then changed nothing, unless its comment says
 * otherwise.
 */
export class ThudError extends Error {
  readonly code: ErrorCode;

  constructor(code: ErrorCode, message: string, options?: { cause?: unknown }) {
    super(message, options);
    this.name = "ThudError";
    this.code = code;
  }
}

/** The message of a thrown value. */
export function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
