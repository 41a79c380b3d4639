/** How a game is played, in words: by the keys there are, or the buttons of a touch screen. */
import { KEY_NAMES, type KeyName, type KeyWords } from "../scene/scene";

/** What is on a key, or on a button of the screen, and the key that does the same. */
const CAPS: Readonly<Record<KeyName, readonly [cap: string, other?: string]>> = {
  left: ["←", "A"],
  right: ["→", "D"],
  up: ["↑", "W"],
  down: ["↓", "S"],
  fire: ["Space"],
  restart: ["Enter"],
};

/** Fingers, and probably no keys. */
export function isTouch(): boolean {
  return matchMedia("(hover: none) and (pointer: coarse)").matches;
}

/** "Keys: ← → or A D to walk, ↑ or W or Space to jump."; "" where nothing is told of the keys. */
export function howToPlay(keys: KeyWords): string {
  const touch = isTouch();
  const names = KEY_NAMES.filter((name) => keys[name] && !(touch && name === "restart"));
  const words = [...new Set(names.map((name) => keys[name]))];
  const parts = words.map((word) => {
    const alike = names.filter((name) => keys[name] === word);
    const caps = alike.map((name) => (touch && name === "fire" ? "✸" : CAPS[name][0]));
    const others = alike.flatMap((name) => CAPS[name][1] ?? []);
    // Where nothing is fired, Space is the key up; see pad.ts.
    const space = alike.includes("up") && !("fire" in keys) ? ["Space"] : [];
    const ways = touch ? [caps.join(" ")] : [caps.join(" "), others.join(" "), ...space];
    return `${ways.filter(Boolean).join(" or ")} to ${word}`;
  });
  return parts.length > 0 ? `${touch ? "Buttons" : "Keys"}: ${parts.join(", ")}.` : "";
}
