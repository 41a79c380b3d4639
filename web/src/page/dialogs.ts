/** The dialogs in index.html (scenes, help) and the buttons that open them. */
import { byId } from "./dom";

const NAMES = ["scenes", "help"] as const;
export type DialogName = (typeof NAMES)[number];

/** Opens a dialog, and dispatches the event "open" to it. */
export function openDialog(name: DialogName): void {
  const dialog = byId<HTMLDialogElement>(name);
  if (dialog.open) return;
  dialog.showModal();
  byId(`${name}-button`).setAttribute("aria-expanded", "true");
  dialog.dispatchEvent(new Event("open"));
  showCurrent(dialog);
}

/**
 * Focuses the entry of the running scene and scrolls to it, so that arrow keys and Enter continue
 * from there. Focusing the search field instead would open the keyboard of a phone.
 */
export function showCurrent(dialog: HTMLDialogElement): void {
  const current = dialog.querySelector<HTMLElement>('[aria-current="true"]');
  current?.focus({ preventScroll: true });
  current?.scrollIntoView({ block: "nearest" });
}

/** Connects the buttons that open and close the dialogs. */
export function addDialogs(): void {
  for (const name of NAMES) {
    const dialog = byId<HTMLDialogElement>(name);
    const opener = byId(`${name}-button`);
    opener.addEventListener("click", () => openDialog(name));
    dialog.addEventListener("close", () => {
      opener.setAttribute("aria-expanded", "false");
      // A dialog that was opened by key while nothing had the focus would keep the focus when
      // closed, and would receive the keys that are meant for the page.
      const focused = document.activeElement as HTMLElement | null;
      if (focused && dialog.contains(focused)) focused.blur();
    });
    dialog.querySelector(".close")!.addEventListener("click", () => dialog.close());
    // A click beside a dialog, on its backdrop, closes it.
    dialog.addEventListener("click", (event) => {
      if (event.target === dialog) dialog.close();
    });
  }
}
