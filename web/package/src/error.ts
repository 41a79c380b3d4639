/**
 * Why a call failed: a missing argument ("null"), one out of range ("invalid"), a handle of what is
 * gone ("stale"), no memory, a world in the middle of a step ("locked"), no engine ("load").
 */
export type ErrorCode = "null" | "invalid" | "stale" | "memory" | "locked" | "load";

/** thud_result, in its order; the first is success. */
export const RESULT_CODES: readonly (ErrorCode | "ok")[] = [
  "ok",
  "null",
  "invalid",
  "stale",
  "memory",
  "locked",
];

/** What a call that failed throws. A call that fails has changed nothing. */
export class ThudError extends Error {
  readonly code: ErrorCode;

  constructor(code: ErrorCode, message: string, options?: { cause?: unknown }) {
    super(message, options);
    this.name = "ThudError";
    this.code = code;
  }
}

/** What was thrown, in words. */
export function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
