/** The keys of a game, from the keyboard and from buttons on the screen. */
import { KEY_NAMES, type KeyName, type KeyWords, noKeys } from "../../scene/scene";
import { byId } from "../dom";

const CODES: Readonly<Record<string, KeyName>> = {
  ArrowLeft: "left",
  KeyA: "left",
  ArrowRight: "right",
  KeyD: "right",
  ArrowUp: "up",
  KeyW: "up",
  ArrowDown: "down",
  KeyS: "down",
  Space: "fire",
  Enter: "restart",
};

export class Pad {
  #wanted = new Set<KeyName>();
  readonly #held = noKeys();
  /** What the buttons say, as text; "" where they have arrows. */
  #words = "";
  readonly #changed: (held: Readonly<Record<KeyName, boolean>>) => void;

  /** Heeds keys before the page's own do, while a scene wants them. */
  constructor(changed: (held: Readonly<Record<KeyName, boolean>>) => void) {
    this.#changed = changed;
    window.addEventListener("keydown", (event) => this.#press(event), { capture: true });
    window.addEventListener("keyup", (event) => {
      const name = this.#nameOf(event);
      if (name) this.#hold(name, false);
    });
    window.addEventListener("blur", () => this.#letGo());
    // A click leaves no button in focus, where Space would press it again instead of playing, or of
    // pausing the scene.
    document.addEventListener("mousedown", (event) => {
      const button = (event.target as HTMLElement).closest(":is(#top, #pad, #controls) button");
      if (button) event.preventDefault();
    });
    for (const button of byId("pad").querySelectorAll<HTMLElement>("[data-key]"))
      this.#listenTo(button);
  }

  /** The keys of the scene that runs now. */
  show(keys: KeyWords): void {
    this.#letGo();
    this.#wanted = new Set(Object.keys(keys) as KeyName[]);
    this.name();
    byId("pad").hidden = this.#wanted.size === 0;
    for (const button of byId("pad").querySelectorAll<HTMLElement>("[data-key]")) {
      const name = button.dataset.key as KeyName;
      button.hidden = !this.#wanted.has(name);
      button.ariaLabel = keys[name] ? `${name}: ${keys[name]}` : name;
    }
  }

  /** Words on the buttons, or none; true if buttons came or went by that. */
  name(words?: KeyWords): boolean {
    const text = words ? JSON.stringify(words) : "";
    if (text === this.#words) return false;
    const changed = (text === "") !== (this.#words === "");
    this.#words = text;
    const pad = byId("pad");
    pad.toggleAttribute("data-words", text !== "");
    for (const button of pad.querySelectorAll<HTMLElement>("[data-key]")) {
      const name = button.dataset.key as KeyName;
      const word = words?.[name];
      if (word) button.dataset.word = button.ariaLabel = word;
      else delete button.dataset.word;
      // A finger that rests where a button goes no longer presses it.
      if (words && !word) this.#hold(name, false);
    }
    return changed;
  }

  #nameOf({ code }: KeyboardEvent): KeyName | undefined {
    const name = CODES[code];
    // Where nothing is fired, Space jumps.
    if (name === "fire" && !this.#wanted.has("fire")) return "up";
    return name;
  }

  #press(event: KeyboardEvent): void {
    const name = this.#nameOf(event);
    if (!name || !this.#wanted.has(name)) return;
    if (event.ctrlKey || event.metaKey || event.altKey || event.shiftKey) return;
    if (document.querySelector("dialog[open], #failure:not([hidden])")) return;
    // Whoever types, or stands on a control, means that.
    const target = event.target as HTMLElement;
    if (target.isContentEditable || target.matches("input, textarea, select")) return;
    if (target.closest("#dock")) return;
    if (target.tagName === "BUTTON" && (name === "fire" || name === "restart")) return;
    event.preventDefault();
    event.stopPropagation();
    this.#hold(name, true);
  }

  #hold(name: KeyName, held: boolean): void {
    if (this.#held[name] === held) return;
    this.#held[name] = held;
    const button = byId("pad").querySelector<HTMLElement>(`[data-key=${name}]`);
    button?.toggleAttribute("data-held", held);
    this.#changed({ ...this.#held });
  }

  #letGo(): void {
    for (const name of KEY_NAMES) this.#hold(name, false);
  }

  #listenTo(button: HTMLElement): void {
    const name = button.dataset.key as KeyName;
    button.addEventListener("pointerdown", (event) => {
      event.preventDefault();
      button.setPointerCapture(event.pointerId);
      this.#hold(name, true);
    });
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"])
      button.addEventListener(end, () => this.#hold(name, false));
    // From a keyboard or a screen reader a button is pressed and let go at once.
    button.addEventListener("click", ({ detail }) => {
      if (detail !== 0) return;
      this.#hold(name, true);
      setTimeout(() => this.#hold(name, false), 120);
    });
    button.addEventListener("contextmenu", (event) => event.preventDefault());
  }
}
