/** How to play, in one line, for whoever is here for the first time; gone for good once done. */
import type { App } from "./app";
import { byId } from "./dom";

const KEY = "thud-hint-seen";

/** True while the hint is shown. */
export function addHint(app: App): boolean {
  if (wasSeen()) return false;
  const hint = byId("hint");
  hint.querySelector("p")!.textContent = "Drag anything, and throw it.";
  hint.hidden = false;
  const goAway = () => {
    hint.hidden = true;
    stopListening();
    try {
      localStorage.setItem(KEY, "1");
    } catch {
      // Storage is switched off: the next visit is a first one again.
    }
  };
  hint.querySelector("button")!.addEventListener("click", goAway);
  const stopListening = app.listen({
    run(scene) {
      // A game tells by itself how it is played.
      hint.hidden = scene.keys.length > 0 || scene.pointer;
    },
    frame({ pull }) {
      if (pull) goAway();
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
