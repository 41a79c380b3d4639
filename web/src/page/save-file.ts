/** Gives the visitor a file. */
import type { App } from "./app";
import { make } from "./dom";

/** Milliseconds for which the URL of a saved file stays valid. Chosen. */
const KEPT = 60_000;

/** Saves a file that is named after the scene. */
export function saveFile({ title }: App, blob: Blob, ending: string): void {
  const url = URL.createObjectURL(blob);
  make("a", { href: url, download: `${title.replace(/[^\p{L}\p{N}]+/gu, "-")}.${ending}` }).click();
  // The browser may read the file only after the click has returned.
  setTimeout(() => URL.revokeObjectURL(url), KEPT);
}
