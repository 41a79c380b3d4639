/**
 * Texts of scenes that the visitor has changed, kept for as long as the tab is open: another scene,
 * an endless loop or loading the page again loses nothing.
 */

const PREFIX = "thud draft ";

/** Null where there is none, or where the browser keeps nothing. */
export function readDraft(scene: string): string | null {
  try {
    return sessionStorage.getItem(PREFIX + scene);
  } catch {
    return null;
  }
}

/** Null: the text is the file's again. */
export function keepDraft(scene: string, text: string | null): void {
  try {
    if (text === null) sessionStorage.removeItem(PREFIX + scene);
    else sessionStorage.setItem(PREFIX + scene, text);
  } catch {
    // Storage is switched off or full: the text is still in the editor.
  }
}
