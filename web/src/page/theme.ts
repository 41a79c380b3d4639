/** The page's theme, light or dark: that of the system unless the visitor has chosen one. */

export const THEMES = ["system", "dark", "light"] as const;
export type ThemeChoice = (typeof THEMES)[number];

/** The key of the visitor's choice in the local storage. */
const KEY = "thud-theme";
const systemIsLight = matchMedia("(prefers-color-scheme: light)");
/** In this mode the browser replaces the page's colours by the system's, so that the drawing must
 * be as light or dark as the system. */
const systemColours = matchMedia("(forced-colors: active)");
const listeners = new Set<(dark: boolean) => void>();

/** The visitor's choice, where the browser could not store it; null: it is stored, or none. */
let notStored: ThemeChoice | null = null;

/** The visitor's choice; "system" if there is none. */
export function chosenTheme(): ThemeChoice {
  if (notStored) return notStored;
  let stored: string | null = null;
  try {
    stored = localStorage.getItem(KEY);
  } catch {
    // Storage is switched off: the choice lasts as long as the page.
  }
  return THEMES.find((theme) => theme === stored) ?? "system";
}

/** Stores the visitor's choice; `applyTheme` makes it visible. */
export function chooseTheme(theme: ThemeChoice): void {
  notStored = null;
  try {
    localStorage.setItem(KEY, theme);
  } catch {
    notStored = theme;
  }
}

/** While the page is printed its theme is light. */
let printing = false;

/** Whether the theme that applies now is the dark one. */
export function isDark(): boolean {
  if (printing) return false;
  if (systemColours.matches) return !systemIsLight.matches;
  const choice = chosenTheme();
  return choice === "system" ? !systemIsLight.matches : choice === "dark";
}

/** Sets the document's theme and calls the listeners. */
export function applyTheme(): void {
  const dark = isDark();
  document.documentElement.dataset.theme = dark ? "dark" : "light";
  for (const listener of listeners) listener(dark);
}

/** Calls `listener` at every change of the theme, also when the system's changes. */
export function onTheme(listener: (dark: boolean) => void): void {
  listeners.add(listener);
}

systemIsLight.addEventListener("change", applyTheme);
systemColours.addEventListener("change", applyTheme);

/** Calls `draw` before the page is printed, with the light theme, and again afterwards. */
export function onPrint(draw: () => void): void {
  const turn = (on: boolean) => () => {
    printing = on;
    applyTheme();
    draw();
  };
  window.addEventListener("beforeprint", turn(true));
  window.addEventListener("afterprint", turn(false));
}
