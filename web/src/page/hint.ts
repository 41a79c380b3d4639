/**
 * The hint of a first visit: a line that says what the page is and how to begin. It disappears for
 * good when the visitor closes it, drags a body or goes to another scene; after dragging a notice
 * says what to try next.
 */
import type { App } from "./app";
import { byId } from "./dom";
import { notice } from "./messages";

/** The key in the local storage that exists once the hint has disappeared. */
const KEY = "thud-hint-seen";
const FIRST =
  "A physics engine in which you choose between speed and accuracy, and see both measured beside " +
  "Box2D. Drag anything, and throw it.";
const NEXT =
  "Let go to throw it. Next, open Trade to set how accurate it is, or Versus to see it in Box2D.";

/** Shows the hint on a first visit; returns whether it is shown. */
export function addHint(app: App): boolean {
  if (wasSeen()) return false;
  const hint = byId("hint");
  hint.querySelector("p")!.textContent = FIRST;
  hint.hidden = false;
  const button = hint.querySelector("button")!;
  const goAway = () => {
    // The focus of the button, which is hidden now, moves to the scene.
    if (document.activeElement === button) byId("overlay").focus();
    hint.hidden = true;
    stopListening();
    try {
      localStorage.setItem(KEY, "1");
    } catch {
      // Storage is switched off: the next visit shows the hint again.
    }
  };
  button.addEventListener("click", goAway);
  let first = "";
  const stopListening = app.listen({
    run(scene) {
      // A visitor who has chosen another scene needs no hint any more. If the same scene starts
      // again, the hint stays.
      first ||= app.state.scene;
      if (app.state.scene !== first) return goAway();
      // A game shows its own instructions.
      hint.hidden = scene.pointer || Object.keys(scene.keys).length > 0;
    },
    frame({ pull }) {
      if (!pull) return;
      goAway();
      notice(NEXT, 10);
    },
  });
  return true;
}

function wasSeen(): boolean {
  try {
    return localStorage.getItem(KEY) !== null;
  } catch {
    return false;
  }
}
