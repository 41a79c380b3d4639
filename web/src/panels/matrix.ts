/**
 * A control of the panel Values: a matrix with a button for each pair of names, as for the
 * collision rule of two kinds of bodies. Each click gives the pair the next one of a list of words.
 */
import { make } from "../page/dom";
import type { MatrixControl } from "../scene/controls";

/**
 * The matrix is symmetric, and only its lower triangle has buttons. Its value has a digit for each
 * pair of names, row by row, which is the number of the pair's word. `set` is called when the
 * visitor changes it; `show` displays a value.
 */
export function makeMatrix(
  { name, label, names, words, alone }: MatrixControl,
  set: (name: string, value: string) => void,
) {
  let digits: string[] = [];
  const buttons = new Map<number, { button: HTMLButtonElement; title: string }>();
  const show = (value: unknown) => {
    digits = [...String(value)];
    for (const [place, { button, title }] of buttons) {
      const digit = Number(digits[place]);
      const word = words[digit];
      if (button.textContent === word) continue;
      button.textContent = word;
      button.setAttribute("aria-label", `${title}: ${word}`);
      button.setAttribute("aria-pressed", digit === 0 ? "false" : digit === 1 ? "true" : "mixed");
    }
  };
  const cell = (row: number, column: number) => {
    const button = make("button", { type: "button", "aria-pressed": "false" });
    const [place, mirror] = [names.length * row + column, names.length * column + row];
    const both = `${names[column]} and ${names[row]}`;
    buttons.set(place, { button, title: row === column ? `${names[row]} among itself` : both });
    button.addEventListener("click", () => {
      const next = (Number(digits[place]) + 1) % (row === column ? alone : words.length);
      digits[place] = digits[mirror] = String(next);
      const value = digits.join("");
      show(value);
      set(name, value);
    });
    return make("td", {}, button);
  };
  const head = make("tr", {}, make("td"), ...names.map((one) => make("th", { scope: "col" }, one)));
  const rows = names.map((one, row) =>
    make(
      "tr",
      {},
      make("th", { scope: "row" }, one),
      ...names.map((_, column) => (column > row ? make("td") : cell(row, column))),
    ),
  );
  const element = make("table", { class: "matrix", "aria-label": label }, head, ...rows);
  return { element, show };
}
