/** Keys and on-screen buttons by which a character is steered. */
import type { Keys } from "./character";

const CODES: Readonly<Record<string, keyof Keys>> = {
  ArrowLeft: "left",
  KeyA: "left",
  ArrowRight: "right",
  KeyD: "right",
  ArrowUp: "jump",
  KeyW: "jump",
  Space: "jump",
  ArrowDown: "down",
  KeyS: "down",
};

/** Heeds keys and buttons of `pad` while it is shown, before the page's own keys see them. */
export function listenToPad(pad: HTMLElement): Readonly<Keys> {
  const keys: Keys = { left: false, right: false, jump: false, down: false };
  const letGo = () => {
    keys.left = keys.right = keys.jump = keys.down = false;
  };

  const press = (event: KeyboardEvent) => {
    const key = CODES[event.code];
    if (!key || pad.hidden || event.ctrlKey || event.metaKey || event.altKey) return;
    if (document.querySelector("dialog[open], #failure:not([hidden])")) return;
    // Space on a button presses that button.
    if (event.code === "Space" && (event.target as HTMLElement).tagName === "BUTTON") return;
    keys[key] = true;
    event.preventDefault();
    event.stopPropagation();
  };
  window.addEventListener("keydown", press, { capture: true });
  window.addEventListener("keyup", (event) => {
    const key = CODES[event.code];
    if (key) keys[key] = false;
  });
  window.addEventListener("blur", letGo);
  // A click leaves no button in focus, where Space would press it again instead of jumping.
  document.addEventListener("mousedown", (event) => {
    const button = (event.target as HTMLElement).closest("#top button, #controls button");
    if (button && !pad.hidden) event.preventDefault();
  });

  for (const button of pad.querySelectorAll<HTMLElement>("[data-key]")) {
    const key = button.dataset.key as keyof Keys;
    button.addEventListener("pointerdown", (event) => {
      event.preventDefault();
      button.setPointerCapture(event.pointerId);
      keys[key] = true;
    });
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"])
      button.addEventListener(end, () => {
        keys[key] = false;
      });
    button.addEventListener("contextmenu", (event) => event.preventDefault());
  }
  return keys;
}
