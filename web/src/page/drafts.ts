/**
 * Drafts: the visitor's edited texts of scenes, in the browser's session storage. They last as long
 * as the tab, so that opening another scene, terminating an endless loop or reloading the page
 * loses nothing.
 */

/** Beginning of the storage's keys; the scene's name follows. */
const PREFIX = "thud draft ";

/** The draft of a scene; null if there is none or the browser denies access to the storage. */
export function readDraft(scene: string): string | null {
  try {
    return sessionStorage.getItem(PREFIX + scene);
  } catch {
    return null;
  }
}

/** Stores a draft; null removes it, since the text equals the file's again. */
export function keepDraft(scene: string, text: string | null): void {
  try {
    if (text === null) sessionStorage.removeItem(PREFIX + scene);
    else sessionStorage.setItem(PREFIX + scene, text);
  } catch {
    // Storage is switched off or full: the text is still in the editor.
  }
}
