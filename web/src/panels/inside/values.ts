/** Texts of numbers, and lists of names and values, for the panels Inside and Values. */
import type { Vec2 } from "thud";
import { make } from "../../page/dom";

/** A number with about four significant digits; very small or large ones in exponential form. */
export function numberText(value: number): string {
  const size = Math.abs(value);
  if (!Number.isFinite(value)) return String(value);
  if (size === 0) return "0";
  if (size < 1e-4 || size >= 1e6) return value.toExponential(2);
  return value.toFixed(Math.max(0, Math.min(5, 3 - Math.floor(Math.log10(size)))));
}

export function placeText([x, y]: Vec2): string {
  return `${numberText(x)}, ${numberText(y)}`;
}

export function degreesText(radians: number): string {
  const degrees = ((radians * 180) / Math.PI).toFixed(1);
  return `${degrees === "-0.0" ? "0.0" : degrees}°`;
}

export function bytesText(bytes: number): string {
  return bytes < 1e6 ? `${(bytes / 1e3).toFixed(0)} kB` : `${(bytes / 1e6).toFixed(1)} MB`;
}

export type Row = readonly [name: string, value: string];

/** Fills a list with names and values. If the names are the same as before, only texts of values
 * change and the elements stay. */
export function fillList(list: HTMLDListElement, rows: readonly Row[]): void {
  const names = [...list.querySelectorAll("dt")];
  const same =
    names.length === rows.length && rows.every(([name], i) => names[i].textContent === name);
  if (!same)
    list.replaceChildren(
      ...rows.map(([name, value]) => make("div", {}, make("dt", {}, name), make("dd", {}, value))),
    );
  else
    list.querySelectorAll("dd").forEach((element, i) => {
      if (element.textContent !== rows[i][1]) element.textContent = rows[i][1];
    });
}
