/**
 * `Dock`: the place for panels beside the scene. One panel is open at a time; its module is
 * imported when it is first opened.
 */
import { messageOf } from "../shared/error";
import type { App } from "./app";
import { byId, make } from "./dom";
import { say } from "./messages";

/** A panel builds its element once; `opened` and `closed` are called when it is shown and
 * hidden. */
export interface Panel {
  readonly element: HTMLElement;
  /** The page's first scene waits for the returned promise (at most LONGEST_WAIT in main.ts) if the
   * address opens the panel too. */
  opened?(): void | Promise<void>;
  closed?(): void;
}

export interface PanelKind {
  title: string;
  /** Imports the panel's module and returns the function that creates the panel. */
  load(): Promise<(app: App) => Panel>;
}

export class Dock {
  readonly #app: App;
  readonly #kinds: Readonly<Record<string, PanelKind>>;
  /** Panels that are made, or being made. */
  readonly #made = new Map<string, Promise<Panel>>();
  /** The open panel, once it is made. */
  #shown: Panel | null = null;
  readonly #changed: () => void;
  #open: string | null = null;
  /** Resolves when the panel that was opened last is shown. */
  #showing: Promise<void> = Promise.resolve();
  /** The element outside the dock that had the focus when a panel was opened. */
  #focusBefore: Element | null = null;

  /** `changed` is called when the part of the page that the dock covers may have changed. */
  constructor(app: App, kinds: Readonly<Record<string, PanelKind>>, changed: () => void) {
    this.#app = app;
    this.#kinds = kinds;
    this.#changed = changed;
    for (const button of this.#buttons())
      button.addEventListener("click", () => this.toggle(button.dataset.panel!));
    const dock = byId("dock");
    dock.querySelector(".close")!.addEventListener("click", () => this.close());
    document.addEventListener("keydown", (event) => {
      if (event.key !== "Escape" || event.defaultPrevented || !this.#open) return;
      // Escape closes the panel wherever the focus is: after opening by key it may be outside.
      if ((event.target as HTMLElement).closest("dialog[open], #failure")) return;
      event.preventDefault();
      this.close();
    });
  }

  /** The name of the open panel; null: none. */
  get open(): string | null {
    return this.#open;
  }

  /** Opens a panel, or closes it if it is open. */
  toggle(name: string): void {
    if (this.#open === name) this.close();
    else void this.show(name);
  }

  /**
   * Opens a panel; resolves when it is shown and its `opened` has finished. `focus`: moves the
   * focus to the panel's title. A name that is no panel's is ignored.
   */
  async show(name: string, focus = true): Promise<void> {
    // The name may come from the address, and be an inherited one such as "constructor".
    const kind = Object.hasOwn(this.#kinds, name) ? this.#kinds[name] : null;
    if (!kind) return;
    // It may be open and still be loaded.
    if (this.#open !== name) this.#showing = this.#load(name, kind, focus);
    await this.#showing;
  }

  async #load(name: string, kind: PanelKind, focus: boolean): Promise<void> {
    const { activeElement } = document;
    if (!byId("dock").contains(activeElement)) this.#focusBefore = activeElement;
    if (this.#open) this.#leave();
    this.#open = this.#app.state.panel = name;
    byId("dock-title").textContent = kind.title;
    byId("dock").hidden = false;
    byId("dock").dataset.panel = name;
    this.#mark();
    let making = this.#made.get(name);
    if (!making) {
      byId("dock-body").replaceChildren(make("p", { class: "quiet" }, "Loading…"));
      making = kind.load().then((create) => create(this.#app));
      this.#made.set(name, making);
    }
    let panel: Panel;
    try {
      panel = await making;
    } catch (error) {
      // The next time it is tried again.
      this.#made.delete(name);
      const text = `This panel cannot be loaded: ${messageOf(error)}`;
      if (this.#open === name) byId("dock-body").replaceChildren(make("p", { class: "quiet" }, text));
      return;
    }
    // Meanwhile another panel may have been opened, or this one closed and opened again.
    if (this.#open !== name || this.#shown) return;
    this.#shown = panel;
    byId("dock-body").replaceChildren(panel.element);
    this.#changed();
    const ready = panel.opened?.();
    this.#app.chosen();
    say(`${kind.title} opened`);
    // The title gets the focus and no button, so that Space still pauses the scene.
    if (focus) byId("dock-title").focus();
    await ready;
  }

  close(): void {
    if (!this.#open) return;
    this.#leave();
    this.#open = this.#app.state.panel = null;
    const hadFocus = byId("dock").contains(document.activeElement);
    byId("dock").hidden = true;
    this.#mark();
    this.#changed();
    this.#app.chosen();
    if (hadFocus) this.#giveFocusBack();
  }

  /** Focuses the element that had the focus before, or else the scene's canvas. */
  #giveFocusBack(): void {
    const before = this.#focusBefore;
    if (before instanceof HTMLElement && before !== document.body) before.focus();
    else byId("overlay").focus();
  }

  /** Tells the open panel that it is hidden. */
  #leave(): void {
    this.#shown?.closed?.();
    this.#shown = null;
  }

  /** The page's buttons that open panels. */
  #buttons(): HTMLElement[] {
    return [...document.querySelectorAll<HTMLElement>("button[data-panel]")];
  }

  /** Sets aria-expanded of the buttons: true for the open panel's. */
  #mark(): void {
    for (const button of this.#buttons())
      button.setAttribute("aria-expanded", String(button.dataset.panel === this.#open));
  }
}
