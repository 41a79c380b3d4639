/** What a call that failed throws. A call that fails has changed nothing. */
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

export class ThudError extends Error {
  readonly code: ErrorCode;

  constructor(code: ErrorCode, message: string, options?: ErrorOptions) {
    super(message, options);
    this.name = "ThudError";
    this.code = code;
  }
}
