/** The dialog with all scenes, each with a picture and what to look at; and levels from a file. */
import { GROUPS, type SceneEntry, SCENES, thumbnailFile } from "../scene/registry";
import { byId, make } from "./dom";

export interface GalleryActions {
  choose(entry: SceneEntry): void;
  openFile(file: File): void;
}

export function addGallery({ choose, openFile }: GalleryActions): void {
  const dialog = byId<HTMLDialogElement>("scenes");
  for (const group of GROUPS) {
    const entries = SCENES.filter((entry) => entry.group === group);
    if (entries.length === 0) continue;
    const cards = entries.map((entry) => {
      const picture = make("img", {
        src: thumbnailFile(entry.name),
        alt: "",
        width: 160,
        height: 100,
        loading: "lazy",
        decoding: "async",
      });
      const button = make(
        "button",
        { "data-entry": entry.name },
        picture,
        make("b", {}, entry.title),
        make("span", {}, entry.about),
      );
      button.addEventListener("click", () => {
        dialog.close();
        choose(entry);
      });
      return button;
    });
    byId("scene-list").append(
      make("h3", {}, group),
      make("div", { class: "cards" }, ...cards),
    );
  }
  const file = byId<HTMLInputElement>("level-file");
  byId("open-level").addEventListener("click", () => file.click());
  file.addEventListener("change", () => {
    if (file.files?.[0]) openFile(file.files[0]);
    file.value = "";
    dialog.close();
  });
  listenToDrops(openFile);
}

/** Marks the scene that runs. */
export function markScene(name: string): void {
  for (const button of document.querySelectorAll<HTMLElement>("[data-entry]")) {
    if (button.dataset.entry === name) button.setAttribute("aria-current", "true");
    else button.removeAttribute("aria-current");
  }
}

function listenToDrops(openFile: (file: File) => void): void {
  const sign = byId("drop");
  document.addEventListener("dragover", (event) => {
    event.preventDefault();
    sign.hidden = false;
  });
  document.addEventListener("dragleave", (event) => {
    if (!event.relatedTarget) sign.hidden = true;
  });
  document.addEventListener("drop", (event) => {
    event.preventDefault();
    sign.hidden = true;
    const file = event.dataTransfer?.files[0];
    if (file) openFile(file);
  });
}

/** Dialogs and their buttons. */
export function openDialog(dialog: HTMLDialogElement): void {
  if (dialog.open) return;
  dialog.showModal();
  byId(`${dialog.id}-button`).setAttribute("aria-expanded", "true");
  dialog.querySelector('[aria-current="true"]')?.scrollIntoView({ block: "nearest" });
}

export function addDialogs(): void {
  for (const name of ["scenes", "help"]) {
    const dialog = byId<HTMLDialogElement>(name);
    const opener = byId(`${name}-button`);
    opener.addEventListener("click", () => openDialog(dialog));
    dialog.addEventListener("close", () => opener.setAttribute("aria-expanded", "false"));
    dialog.querySelector(".close")!.addEventListener("click", () => dialog.close());
    // A click beside a dialog, on its backdrop, closes it.
    dialog.addEventListener("click", (event) => {
      if (event.target === dialog) dialog.close();
    });
  }
}
