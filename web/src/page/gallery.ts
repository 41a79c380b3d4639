/**
 * The gallery: the dialog that lists all scenes with picture and description, searches them, and
 * opens levels from files. Imported after the first picture, or when the dialog is opened.
 */
import "../style/gallery.css";
import "../style/print.css";
import { ABOUTS } from "../scene/abouts";
import { KEYWORDS, PARTS } from "../scene/keywords";
import { GROUPS, type SceneEntry, SCENES, thumbnailFile } from "../scene/registry";
import type { App } from "./app";
import { showCurrent } from "./dialogs";
import type { Dock } from "./dock";
import { byId, make } from "./dom";
import type { Brought } from "./own-level";

export { ABOUTS };
export { describeScene } from "./describe";
export { howToPlay, isTouch } from "./how";
export { Score } from "./score";

interface Card {
  button: HTMLButtonElement;
  /** The text that a search looks through, in lower case. */
  text: string;
}

interface GroupOfCards {
  heading: HTMLElement;
  grid: HTMLElement;
  cards: Card[];
}

/** Builds the dialog. `openFiles` gets the files that the visitor chooses, and the file-system
 * entries of files and folders that are dropped on the page. */
export function addGallery(app: App, dock: Dock, openFiles: (brought: Brought[]) => void): void {
  const dialog = byId<HTMLDialogElement>("scenes");
  const run = async (entry: SceneEntry) => {
    const part = partFor(entry, typedWords());
    dialog.close();
    if (!(await app.open(entry.name))) return;
    // The visitor has paused the scene before, not the one that is chosen now.
    if (app.state.paused && !matchMedia("(prefers-reduced-motion: reduce)").matches)
      app.setPaused(false);
    if (!part) return;
    await dock.show(part.panel);
    document.getElementById(part.id)?.scrollIntoView({ block: "center" });
  };
  const groups = GROUPS.map((name): GroupOfCards => {
    const entries = SCENES.filter((entry) => entry.group === name);
    const cards = entries.map((entry) => ({
      button: cardOf(entry, () => void run(entry)),
      text: textOf(entry).toLowerCase(),
    }));
    const heading = make("h3", {}, name);
    const grid = make("div", { class: "cards" }, ...cards.map(({ button }) => button));
    byId("scene-list").append(heading, grid);
    return { heading, grid, cards };
  });
  addSearch(dialog, groups);
  addJumps(dialog, groups);
  addArrows(dialog);

  const file = byId<HTMLInputElement>("level-file");
  byId("open-level").addEventListener("click", () => file.click());
  file.addEventListener("change", () => {
    if (file.files?.length) openFiles([...file.files]);
    file.value = "";
    dialog.close();
  });
  listenToDrops(openFiles);
  const mark = () => markScene(app.state.scene);
  app.listen({ run: mark });
  mark();
  if (dialog.open) showCurrent(dialog);
}

/** What a search looks through. */
function textOf(entry: SceneEntry): string {
  return `${ownTextOf(entry)} ${PARTS[entry.name]?.words ?? ""}`;
}

/** The same without the words for a part of a panel. */
function ownTextOf({ name, title, group }: SceneEntry): string {
  return [group, title, ABOUTS[name], name, KEYWORDS[name]].join(" ");
}

/**
 * The part of a panel (PARTS) that the search was for; null where the scene's own words contain all
 * typed words.
 */
function partFor(entry: SceneEntry, words: readonly string[]): (typeof PARTS)[string] | null {
  const own = ownTextOf(entry).toLowerCase();
  return words.every((word) => own.includes(word)) ? null : (PARTS[entry.name] ?? null);
}

/** The words in the search field, in lower case. */
function typedWords(): string[] {
  return byId<HTMLInputElement>("scene-search").value.toLowerCase().split(/\s+/).filter(Boolean);
}

/** The button of a scene, with its picture, title and description. */
function cardOf(entry: SceneEntry, run: () => void): HTMLButtonElement {
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
    make("span", {}, ABOUTS[entry.name]),
  );
  button.addEventListener("click", run);
  return button;
}

/** The search shows the cards that contain every typed word; Enter runs the one whose title is what
 * was typed, or the first. */
function addSearch(dialog: HTMLDialogElement, groups: readonly GroupOfCards[]): void {
  const field = byId<HTMLInputElement>("scene-search");
  const filter = () => {
    const words = typedWords();
    for (const { heading, grid, cards } of groups) {
      for (const { button, text } of cards)
        button.hidden = !words.every((word) => text.includes(word));
      heading.hidden = grid.hidden = cards.every(({ button }) => button.hidden);
    }
    const found = visibleCards().length;
    const plural = found === 1 ? "One scene" : `${found} scenes`;
    byId("no-scene").textContent =
      found === 0 ? `No scene is found by “${field.value.trim()}”.` : "";
    field.setAttribute("aria-description", words.length > 0 ? `${plural} found` : "");
    dialog.scrollTop = 0;
  };
  field.addEventListener("input", filter);
  field.addEventListener("keydown", (event) => {
    if (event.key === "Enter" && field.value.trim() !== "") {
      event.preventDefault();
      const typed = field.value.trim().toLowerCase();
      const found = visibleCards();
      (found.find((card) => titleOn(card).toLowerCase() === typed) ?? found[0])?.click();
    }
  });
  dialog.addEventListener("close", () => {
    field.value = "";
    filter();
  });
}

/** Buttons that lead to the groups, in the dialog's head; a search hides those of groups without a
 * card. */
function addJumps(dialog: HTMLDialogElement, groups: readonly GroupOfCards[]): void {
  const buttons = groups.map(({ heading, cards }) => {
    const button = make("button", {}, heading.textContent!);
    button.addEventListener("click", () => {
      heading.scrollIntoView({ block: "start" });
      cards.find((card) => !card.button.hidden)?.button.focus({ preventScroll: true });
    });
    new MutationObserver(() => (button.hidden = heading.hidden)).observe(heading, {
      attributeFilter: ["hidden"],
    });
    return button;
  });
  const nav = make("nav", { class: "jumps", "aria-label": "Groups of scenes" }, ...buttons);
  dialog.querySelector(".head")!.append(nav);
}

/** Arrow keys move the focus to the neighbouring card on the page, and between the first row and
 * the search field above it. A letter or digit that is typed on a card goes to the search field. */
function addArrows(dialog: HTMLDialogElement): void {
  dialog.addEventListener("keydown", (event) => {
    const target = event.target as HTMLElement;
    const cards = visibleCards();
    const field = byId("scene-search");
    if (target === field && event.key === "ArrowDown") {
      event.preventDefault();
      cards[0]?.focus();
      return;
    }
    const at = cards.indexOf(target as HTMLButtonElement);
    if (at < 0) return;
    if (/^[\p{L}\p{N}]$/u.test(event.key) && !event.ctrlKey && !event.metaKey && !event.altKey) {
      // The key's default is to type it into what has the focus by then.
      field.focus();
      return;
    }
    const next = neighbour(cards, at, event.key);
    if (next === undefined) return;
    event.preventDefault();
    (next ?? field).focus();
  });
}

/** The card that a key leads to from card `at`; null for the search field above the first row,
 * undefined for a key that moves no focus. */
function neighbour(
  cards: readonly HTMLElement[],
  at: number,
  key: string,
): HTMLElement | null | undefined {
  if (key === "ArrowLeft") return cards[Math.max(0, at - 1)];
  if (key === "ArrowRight") return cards[Math.min(cards.length - 1, at + 1)];
  if (key === "Home") return cards[0];
  if (key === "End") return cards[cards.length - 1];
  if (key !== "ArrowUp" && key !== "ArrowDown") return undefined;
  const down = key === "ArrowDown";
  const { left, top } = cards[at].getBoundingClientRect();
  const beyond = cards
    .map((card) => ({ card, box: card.getBoundingClientRect() }))
    .filter(({ box }) => (down ? box.top > top + 1 : box.top < top - 1));
  if (beyond.length === 0) return down ? cards[at] : null;
  const distances = beyond.map(({ box }) => Math.abs(box.top - top));
  const row = Math.min(...distances);
  return beyond
    .filter((_, i) => distances[i] < row + 1)
    .sort((a, b) => Math.abs(a.box.left - left) - Math.abs(b.box.left - left))[0].card;
}

function titleOn(card: HTMLElement): string {
  return card.querySelector("b")?.textContent ?? "";
}

/** The cards that match the search, in the order of the page. */
function visibleCards(): HTMLButtonElement[] {
  return [...document.querySelectorAll<HTMLButtonElement>("[data-entry]:not([hidden])")];
}

/** Marks the scene that runs. */
function markScene(name: string): void {
  for (const button of document.querySelectorAll<HTMLElement>("[data-entry]")) {
    if (button.dataset.entry === name) button.setAttribute("aria-current", "true");
    else button.removeAttribute("aria-current");
  }
}

/**
 * Shows a message over the page while files are dragged over it, and opens the files that are
 * dropped.
 */
function listenToDrops(openFiles: (brought: Brought[]) => void): void {
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
    const items = [...(event.dataTransfer?.items ?? [])];
    const brought = items.map((item) => item.webkitGetAsEntry() ?? item.getAsFile());
    const some = brought.filter((one) => one !== null);
    if (some.length > 0) openFiles(some);
  });
}
