/** Light or dark: as the system says, unless the visitor says otherwise. */

export const THEMES = ["system", "dark", "light"] as const;
export type ThemeChoice = (typeof THEMES)[number];

const KEY = "thud-theme";
const systemIsLight = matchMedia("(prefers-color-scheme: light)");
/** Then the system's are the only colours, and the drawing must fit them. */
const systemColours = matchMedia("(forced-colors: active)");
const listeners = new Set<(dark: boolean) => void>();

export function chosenTheme(): ThemeChoice {
  let stored: string | null = null;
  try {
    stored = localStorage.getItem(KEY);
  } catch {
    // Storage is switched off: the choice lasts as long as the page.
  }
  return THEMES.find((theme) => theme === stored) ?? "system";
}

export function chooseTheme(theme: ThemeChoice): void {
  try {
    localStorage.setItem(KEY, theme);
  } catch {
    notStored = theme;
  }
}
let notStored: ThemeChoice | null = null;

/** Paper is white. */
let printing = false;

export function isDark(): boolean {
  if (printing) return false;
  if (systemColours.matches) return !systemIsLight.matches;
  const choice = notStored ?? chosenTheme();
  return choice === "system" ? !systemIsLight.matches : choice === "dark";
}

export function applyTheme(): void {
  const dark = isDark();
  document.documentElement.dataset.theme = dark ? "dark" : "light";
  for (const listener of listeners) listener(dark);
}

/** Hears of every change, the system's too. */
export function onTheme(listener: (dark: boolean) => void): void {
  listeners.add(listener);
}

systemIsLight.addEventListener("change", applyTheme);
systemColours.addEventListener("change", applyTheme);

/** Calls `draw` for what is printed, and again for the screen. */
export function onPrint(draw: () => void): void {
  const turn = (on: boolean) => () => {
    printing = on;
    applyTheme();
    draw();
  };
  window.addEventListener("beforeprint", turn(true));
  window.addEventListener("afterprint", turn(false));
}
