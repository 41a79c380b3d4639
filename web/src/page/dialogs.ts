/** The dialogs and the buttons that open them. */
import { byId } from "./dom";

const NAMES = ["scenes", "help"] as const;
export type DialogName = (typeof NAMES)[number];

export function openDialog(name: DialogName): void {
  const dialog = byId<HTMLDialogElement>(name);
  if (dialog.open) return;
  dialog.showModal();
  byId(`${name}-button`).setAttribute("aria-expanded", "true");
  dialog.dispatchEvent(new Event("open"));
  showCurrent(dialog);
}

/** Where one is: arrows and Enter go on from there, and no keyboard comes up on a phone. */
export function showCurrent(dialog: HTMLDialogElement): void {
  const current = dialog.querySelector<HTMLElement>('[aria-current="true"]');
  current?.focus({ preventScroll: true });
  current?.scrollIntoView({ block: "nearest" });
}

export function addDialogs(): void {
  for (const name of NAMES) {
    const dialog = byId<HTMLDialogElement>(name);
    const opener = byId(`${name}-button`);
    opener.addEventListener("click", () => openDialog(name));
    dialog.addEventListener("close", () => {
      opener.setAttribute("aria-expanded", "false");
      // Opened by key with nothing in focus, a dialog would keep it and hear the page's keys.
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
