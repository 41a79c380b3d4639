/** The place for panels beside the scene: one is open at a time, loaded when first wanted. */
import { messageOf } from "../shared/error";
import type { App } from "./app";
import { byId, make } from "./dom";
import { say } from "./messages";

/** A panel fills an element of its own, once, and is told when it is seen. */
export interface Panel {
  readonly element: HTMLElement;
  /** A scene that comes with the panel waits for what is returned, for some seconds. */
  opened?(): void | Promise<void>;
  closed?(): void;
}

export interface PanelKind {
  title: string;
  load(): Promise<(app: App) => Panel>;
}

export class Dock {
  readonly #app: App;
  readonly #kinds: Readonly<Record<string, PanelKind>>;
  readonly #made = new Map<string, Panel>();
  readonly #changed: () => void;
  #open: string | null = null;
  /** What had the focus when the panel opened. */
  #focusBefore: Element | null = null;

  /** `changed` hears that the dock takes another part of the page. */
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
      // Wherever the focus is: a panel that was opened by key may not have it yet.
      if ((event.target as HTMLElement).closest("dialog[open], #failure")) return;
      event.preventDefault();
      this.close();
    });
  }

  get open(): string | null {
    return this.#open;
  }

  toggle(name: string): void {
    if (this.#open === name) this.close();
    else void this.show(name);
  }

  /** Until the panel is there with all that it needs. */
  async show(name: string, focus = true): Promise<void> {
    // A name of an address may be one that every object has.
    const kind = Object.hasOwn(this.#kinds, name) ? this.#kinds[name] : null;
    if (!kind || this.#open === name) return;
    const { activeElement } = document;
    if (!byId("dock").contains(activeElement)) this.#focusBefore = activeElement;
    if (this.#open) this.#leave();
    this.#open = this.#app.state.panel = name;
    byId("dock-title").textContent = kind.title;
    byId("dock").hidden = false;
    byId("dock").dataset.panel = name;
    this.#mark();
    let panel = this.#made.get(name);
    if (!panel) {
      byId("dock-body").replaceChildren(make("p", { class: "quiet" }, "Loading…"));
      try {
        panel = (await kind.load())(this.#app);
        this.#made.set(name, panel);
      } catch (error) {
        const text = `This panel cannot be loaded: ${messageOf(error)}`;
        byId("dock-body").replaceChildren(make("p", { class: "quiet" }, text));
        return;
      }
    }
    // Another one may have been opened while this one was loaded.
    if (this.#open !== name) return;
    byId("dock-body").replaceChildren(panel.element);
    this.#changed();
    const ready = panel.opened?.();
    this.#app.chosen();
    say(`${kind.title} opened`);
    // Not on a button: Space is the scene's pause until the panel's own controls are reached.
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

  /** To what had it before, or to the scene: on the panel's button Space would open it again. */
  #giveFocusBack(): void {
    const before = this.#focusBefore;
    if (before instanceof HTMLElement && before !== document.body) before.focus();
    else byId("overlay").focus();
  }

  #leave(): void {
    if (this.#open) this.#made.get(this.#open)?.closed?.();
  }

  #buttons(): HTMLElement[] {
    return [...document.querySelectorAll<HTMLElement>("button[data-panel]")];
  }

  #mark(): void {
    for (const button of this.#buttons())
      button.setAttribute("aria-expanded", String(button.dataset.panel === this.#open));
  }
}
