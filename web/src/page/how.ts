/** Instructions of a game in words: its keys, or its buttons on a touch screen. */
import { KEY_NAMES, type KeyName, type KeyWords } from "../scene/scene";

/** The cap of each key, also shown on its on-screen button, and the other key that acts alike. */
const CAPS: Readonly<Record<KeyName, readonly [cap: string, other?: string]>> = {
  left: ["←", "A"],
  right: ["→", "D"],
  up: ["↑", "W"],
  down: ["↓", "S"],
  fire: ["Space"],
  restart: ["Enter"],
  left2: ["A"],
  right2: ["D"],
  up2: ["W"],
};

/** Whether the device's main input is a touch screen, so that it probably has no keyboard. */
export function isTouch(): boolean {
  return matchMedia("(hover: none) and (pointer: coarse)").matches;
}

/** "Keys: ← → or A D to walk, ↑ or W or Space to jump."; "" if the scene describes no key. */
export function howToPlay(keys: KeyWords): string {
  const touch = isTouch();
  const names = KEY_NAMES.filter((name) => keys[name] && !(touch && /restart|2/.test(name)));
  const words = [...new Set(names.map((name) => keys[name]))];
  const parts = words.map((word) => {
    const alike = names.filter((name) => keys[name] === word);
    const caps = alike.map((name) => (touch && name === "fire" ? "✸" : CAPS[name][0]));
    // In a scene with a second player's keys, the letters are theirs; see pad.ts.
    const others = "left2" in keys ? [] : alike.flatMap((name) => CAPS[name][1] ?? []);
    // In a scene without the key "fire", Space acts as "up"; see pad.ts.
    const space = alike.includes("up") && !("fire" in keys) ? ["Space"] : [];
    const ways = touch ? [caps.join(" ")] : [caps.join(" "), others.join(" "), ...space];
    return `${ways.filter(Boolean).join(" or ")} to ${word}`;
  });
  return parts.length > 0 ? `${touch ? "Buttons" : "Keys"}: ${parts.join(", ")}.` : "";
}
