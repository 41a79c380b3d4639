/** `TroubleLine`: shows an error of the code below the editor, with a button that leads to the
 * error's line. */
import { make } from "../../page/dom";
import type { Trouble } from "../../worker/protocol";

export class TroubleLine {
  readonly element = make("div", { class: "code-trouble", role: "alert" });
  readonly #goTo: (line: number, column?: number) => void;

  constructor(goTo: (line: number, column?: number) => void) {
    this.#goTo = goTo;
    this.hide();
  }

  hide(): void {
    this.element.hidden = true;
    this.element.replaceChildren();
  }

  /** Shows an error. `name`: the file's name if it is not the scene's module. */
  show({ message, line, column, details = [] }: Trouble, name = ""): void {
    this.element.hidden = false;
    this.element.replaceChildren(make("p", {}, message));
    if (line !== undefined) {
      const place = make("button", {}, `${name ? `${name}, line` : "Line"} ${line}`);
      place.addEventListener("click", () => this.#goTo(line, column));
      this.element.prepend(place);
    }
    if (details.length > 0)
      this.element.append(make("ul", {}, ...details.map((text) => make("li", {}, text))));
  }
}
