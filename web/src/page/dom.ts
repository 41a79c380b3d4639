/** Helpers that find and create the page's elements. */

/** The element with an id, which must exist. */
export function byId<T extends HTMLElement = HTMLElement>(id: string): T {
  return document.getElementById(id) as T;
}

type Attributes = Record<string, string | number | boolean | undefined>;

/** An element with attributes and children; `undefined` and `false` leave an attribute out. */
export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === false) continue;
    element.setAttribute(name, value === true ? "" : String(value));
  }
  element.append(...children);
  return element;
}

/** A button of a choice bar. */
export interface Choice<T extends string> {
  value: T;
  label: string;
  title?: string;
}

/** A set of radio buttons that looks like one bar. `act` is called when the visitor chooses; `show`
 * selects a value without calling it. */
export function choiceBar<T extends string>(
  name: string,
  legend: string,
  hint: string,
  choices: readonly Choice<T>[],
  act: (value: T) => void,
): { element: HTMLFieldSetElement; show(value: T): void } {
  const inputs = choices.map(({ value }) =>
    make("input", { type: "radio", name, value }),
  );
  inputs.forEach((input, i) => input.addEventListener("change", () => act(choices[i].value)));
  const labels = choices.map(({ label, title }, i) =>
    make("label", { title }, inputs[i], make("span", {}, label)),
  );
  const element = make(
    "fieldset",
    {},
    make("legend", {}, `${legend} `, make("small", {}, hint)),
    make("div", { class: "choices" }, ...labels),
  );
  return {
    element,
    show(value) {
      inputs.forEach((input, i) => (input.checked = choices[i].value === value));
    },
  };
}
