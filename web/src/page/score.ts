/** The texts of a game: its figures (score, lives, …) at the top of the page, and its message. */
import type { Paint } from "../scene/scene";
import { byId, make } from "./dom";
import { say } from "./messages";

export class Score {
  /** The id of the lowest element at the top of the page; the scene is placed below it. */
  told = "top";
  readonly #root = byId("figures");
  readonly #line = byId("message");
  /** Figures and message as shown, as JSON: an equal frame changes no element. */
  #shown = "";

  /** Hides everything, as another scene begins. */
  reset(): void {
    this.#root.hidden = this.#line.hidden = true;
    this.told = "top";
    this.#shown = "";
  }

  /** Shows a frame's figures and message. True if the layout below them has moved: the figures
   * appeared or disappeared, or a scene with readings begins, whose message stays. Messages of games
   * come and go, and move nothing under a hand. */
  show(paint: Paint | null): boolean {
    const { figures = [], message = "" } = paint ?? {};
    const begins = this.#shown === "" && message !== "" && paint?.readings !== undefined;
    if (begins) this.told = "message";
    const moved = begins || this.#root.hidden !== (figures.length === 0);
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
