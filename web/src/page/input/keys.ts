/** The page's keyboard shortcuts: listens to them, and lists them in the help. */
import { byId, make } from "../dom";

export interface Key {
  /** The keys' names in the help. */
  caps: string[];
  /** The keys as event.key gives them, in lower case. */
  codes: string[];
  what: string;
  act(): void;
}

/** A shortcut; `caps` holds the keys' names, separated by spaces. */
export function key(caps: string, codes: string[], what: string, act: () => void): Key {
  return { caps: caps.split(" "), codes, what, act };
}

/** Runs the shortcuts, except where the key belongs to a dialog or to the focused element. */
export function listenToKeys(keys: readonly Key[]): void {
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
    if (!byId("failure").hidden || document.querySelector("dialog[open]")) return;
    const target = event.target as HTMLElement;
    if (isTypedInto(target)) return;
    // Buttons and links use Space and Enter themselves, sliders and radio buttons the arrows.
    const presses = "button, a, summary, input:not([type=range])";
    if (target.matches(presses) && /^( |Enter)$/.test(event.key)) return;
    if (target.tagName === "INPUT" && /^(Arrow|Home|End|Page)/.test(event.key)) return;
    const pressed = keys.find(({ codes }) => codes.includes(event.key.toLowerCase()));
    if (!pressed) return;
    event.preventDefault();
    pressed.act();
  });
  byId("keys").replaceChildren(
    ...keys.map(({ caps, what }) =>
      make(
        "div",
        {},
        make("dt", {}, ...caps.map((cap) => make("kbd", {}, cap))),
        make("dd", {}, what),
      ),
    ),
  );
}

/** Whether keys are typed into this element: a text field, a list or the code editor. */
function isTypedInto(target: HTMLElement): boolean {
  // A field in a dialog that was just closed keeps the focus for a moment; it does not count.
  if (target.closest("dialog:not([open])")) return false;
  return (
    target.isContentEditable ||
    target.matches("textarea, select, input:not([type=radio], [type=checkbox], [type=range])") ||
    // The code editor is in a shadow tree: events that reach the document have its host as target.
    target.matches("[data-typed]")
  );
}
