/** Errors in a scene, with their place in the scene's text. */
import type { Trouble } from "./protocol";

/** An error that the page itself found in a scene, with its message for the visitor. */
export class SceneError extends Error {
  constructor(readonly trouble: Trouble) {
    super(trouble.message);
  }
}

/**
 * A place in an error's stack: in a text that was imported from a blob URL, or in a file of the
 * scenes.
 */
const PLACE = /(?:blob:[^\s)]*?|\/(scenes\/[\w/.-]+?\.js)(?:\?[^\s:)]*)?):(\d+):(\d+)/;

/** Describes an error that was thrown while a scene was set up or ran. */
export function troubleOf(error: unknown): Trouble {
  if (error instanceof SceneError) return error.trouble;
  if (!(error instanceof Error)) return { message: `The scene threw ${String(error)}` };
  const [, file, line, column] = PLACE.exec(error.stack ?? "") ?? [];
  const details = (error as { problems?: { text: string }[] }).problems?.map(({ text }) => text);
  return {
    message: details && details.length > 0 ? "The level cannot be used:" : error.message,
    file,
    line: line ? Number(line) : undefined,
    column: column ? Number(column) : undefined,
    details,
  };
}
