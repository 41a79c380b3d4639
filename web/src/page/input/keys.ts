/** The page's own keys, and the list of them in the help. */
import { byId, make } from "../dom";

export interface Key {
  /** As the help shows them. */
  caps: string[];
  /** As event.key gives them, in lower case. */
  codes: string[];
  what: string;
  act(): void;
}

export function key(caps: string, codes: string[], what: string, act: () => void): Key {
  return { caps: caps.split(" "), codes, what, act };
}

export function listenToKeys(keys: readonly Key[]): void {
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
    if (!byId("failure").hidden || document.querySelector("dialog[open]")) return;
    const target = event.target as HTMLElement;
    if (isTypedInto(target)) return;
    // A button's own are Space and Enter, a slider's and a radio button's the arrows.
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

function isTypedInto(target: HTMLElement): boolean {
  // A dialog that has just been closed gives the focus back a moment later.
  if (target.closest("dialog:not([open])")) return false;
  return (
    target.isContentEditable ||
    target.matches("textarea, select, input:not([type=radio], [type=checkbox], [type=range])") ||
    // The editor lives in a shadow tree of its own, whose host is all that is seen from here.
    target.matches("[data-typed]")
  );
}
