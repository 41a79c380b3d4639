/** What a game tells in words: its figures at the top, and its message. */
import type { Paint } from "../scene/scene";
import { byId, make } from "./dom";
import { say } from "./messages";

export class Figures {
  readonly #root = byId("figures");
  readonly #line = byId("message");
  #shown = "";

  reset(): void {
    this.#root.hidden = this.#line.hidden = true;
    this.#shown = "";
  }

  /** True where the figures came or went: what stands under them has moved. */
  show(paint: Paint | null): boolean {
    const { figures = [], message = "" } = paint ?? {};
    const moved = this.#root.hidden !== (figures.length === 0);
    this.#root.hidden = figures.length === 0;
    const text = JSON.stringify([figures, message]);
    if (text === this.#shown) return moved;
    this.#shown = text;
    this.#root.replaceChildren(
      ...figures.map(({ label, value }) =>
        make("div", {}, make("dt", {}, label), make("dd", {}, value)),
      ),
    );
    this.#line.hidden = message === "";
    if (message !== this.#line.textContent) {
      this.#line.textContent = message;
      if (message) say(message);
    }
    return moved;
  }
}
