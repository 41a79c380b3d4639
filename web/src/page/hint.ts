/**
 * What this is and how to play, in one line, for whoever is here for the first time; gone for good
 * once done, with a line that leads on.
 */
import type { App } from "./app";
import { byId } from "./dom";
import { notice } from "./messages";

const KEY = "thud-hint-seen";
const FIRST =
  "A physics engine in which you choose between speed and accuracy, and see both measured beside " +
  "Box2D. Drag anything, and throw it.";
const NEXT =
  "Let go to throw it. Next, open Trade to set how accurate it is, or Versus to see it in Box2D.";

/** True while the hint is shown. */
export function addHint(app: App): boolean {
  if (wasSeen()) return false;
  const hint = byId("hint");
  hint.querySelector("p")!.textContent = FIRST;
  hint.hidden = false;
  const button = hint.querySelector("button")!;
  const goAway = () => {
    // The focus of a button that goes away goes to what the hint is about.
    if (document.activeElement === button) byId("overlay").focus();
    hint.hidden = true;
    stopListening();
    try {
      localStorage.setItem(KEY, "1");
    } catch {
      // Storage is switched off: the next visit is a first one again.
    }
  };
  button.addEventListener("click", goAway);
  const stopListening = app.listen({
    run(scene) {
      // A game tells by itself how it is played.
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
