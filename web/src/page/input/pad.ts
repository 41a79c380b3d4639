/** `Pad`: the keys of a game (left, up, fire, …), pressed on the keyboard or by on-screen
 * buttons. */
import { KEY_NAMES, type KeyName, type KeyWords, noKeys } from "../../scene/scene";
import { byId } from "../dom";

/** The game's key for each key of the keyboard, by event.code. */
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
  /** The keys that the running scene uses. */
  #wanted = new Set<KeyName>();
  readonly #held = noKeys();
  /** The labels of the buttons as JSON; "" while the buttons show arrows. */
  #words = "";
  readonly #changed: (held: Readonly<Record<KeyName, boolean>>) => void;

  /** Handles the scene's keys before the page's shortcuts do. `changed` is called with the state of
   * all keys when one is pressed or released. */
  constructor(changed: (held: Readonly<Record<KeyName, boolean>>) => void) {
    this.#changed = changed;
    window.addEventListener("keydown", (event) => this.#press(event), { capture: true });
    window.addEventListener("keyup", (event) => {
      const name = this.#nameOf(event);
      if (name) this.#hold(name, false);
    });
    window.addEventListener("blur", () => this.#letGo());
    // A click does not focus these buttons: Space would then press the button again, in place of
    // playing the game or pausing the scene.
    document.addEventListener("mousedown", (event) => {
      const button = (event.target as HTMLElement).closest(":is(#top, #pad, #controls) button");
      if (button) event.preventDefault();
    });
    for (const button of byId("pad").querySelectorAll<HTMLElement>("[data-key]"))
      this.#listenTo(button);
  }

  /** A scene with these keys begins: shows a button for each. */
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

  /** Labels the buttons with words, or without `words` with arrows. True if that switched between
   * words and arrows, which changes the layout. */
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
      // A button without a word is hidden, and a finger that is still on it must not hold its key.
      if (words && !word) this.#hold(name, false);
    }
    return changed;
  }

  /** The game's key that a key of the keyboard stands for; undefined for none. */
  #nameOf({ code }: KeyboardEvent): KeyName | undefined {
    const name = CODES[code];
    const second = `${name}2` as KeyName;
    if (code.startsWith("Key") && this.#wanted.has(second)) return second;
    // In a scene without the key "fire", Space acts as "up" (jump).
    if (name === "fire" && !this.#wanted.has("fire")) return "up";
    return name;
  }

  /** A key of the keyboard goes down: holds the game's key, and keeps the event from the page. */
  #press(event: KeyboardEvent): void {
    const name = this.#nameOf(event);
    if (!name || !this.#wanted.has(name)) return;
    if (event.ctrlKey || event.metaKey || event.altKey || event.shiftKey) return;
    if (document.querySelector("dialog[open], #failure:not([hidden])")) return;
    // Keys that go to a text field, a panel or a focused button are not the game's.
    const target = event.target as HTMLElement;
    if (target.isContentEditable || target.matches("input, textarea, select")) return;
    if (target.closest("#dock")) return;
    if (target.tagName === "BUTTON" && (name === "fire" || name === "restart")) return;
    event.preventDefault();
    event.stopPropagation();
    this.#hold(name, true);
  }

  /** Sets whether a key is held, on its button too, and reports a change. */
  #hold(name: KeyName, held: boolean): void {
    if (this.#held[name] === held) return;
    this.#held[name] = held;
    const button = byId("pad").querySelector<HTMLElement>(`[data-key=${name}]`);
    button?.toggleAttribute("data-held", held);
    this.#changed({ ...this.#held });
  }

  /** Releases all keys. */
  #letGo(): void {
    for (const name of KEY_NAMES) this.#hold(name, false);
  }

  /** An on-screen button holds its key while a pointer presses it. */
  #listenTo(button: HTMLElement): void {
    const name = button.dataset.key as KeyName;
    button.addEventListener("pointerdown", (event) => {
      event.preventDefault();
      button.setPointerCapture(event.pointerId);
      this.#hold(name, true);
    });
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"])
      button.addEventListener(end, () => this.#hold(name, false));
    // A click with detail 0 comes from a keyboard or a screen reader, and has no duration of its
    // own: it holds the key for 120 ms.
    button.addEventListener("click", ({ detail }) => {
      if (detail !== 0) return;
      this.#hold(name, true);
      setTimeout(() => this.#hold(name, false), 120);
    });
    button.addEventListener("contextmenu", (event) => event.preventDefault());
  }
}
