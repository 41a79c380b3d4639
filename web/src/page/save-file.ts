/** Gives the visitor a file. */
import type { App } from "./app";
import { make } from "./dom";

/** Milliseconds for which a file that is saved stays there for the browser. Chosen. */
const KEPT = 60_000;

/** Saves a file that is named after the scene. */
export function saveFile({ title }: App, blob: Blob, ending: string): void {
  const url = URL.createObjectURL(blob);
  make("a", { href: url, download: `${title.replace(/[^\p{L}\p{N}]+/gu, "-")}.${ending}` }).click();
  // The browser may read it later.
  setTimeout(() => URL.revokeObjectURL(url), KEPT);
}
