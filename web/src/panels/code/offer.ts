/** `Offer`: the question whether to run the code that came with a link. */
import { make } from "../../page/dom";

const OFFER = "This link brings code by somebody else. Read it, then run it.";
const UNCONFINED =
  "Nothing keeps this code from reaching other hosts here: this page's host sends no policy for " +
  "it, and the browser has no service worker. Run it only if you trust whoever sent it.";

export class Offer {
  readonly element: HTMLElement;
  readonly #text = make("p", {});
  readonly #run = make("button", {});

  constructor({ run, leave }: { run(): void; leave(): void }) {
    this.#run.addEventListener("click", run);
    const leaveOut = make("button", {}, "Leave it out");
    leaveOut.addEventListener("click", leave);
    this.element = make(
      "div",
      { class: "code-offer", role: "group", "aria-label": "Code from a link" },
      this.#text,
      make("div", {}, this.#run, leaveOut),
    );
    this.element.hidden = true;
  }

  show(offered: boolean): void {
    if (this.element.hidden !== offered) return;
    this.element.hidden = !offered;
    this.#text.textContent = OFFER;
    this.#run.textContent = "Run it";
  }

  /** Asks a second time, since no policy keeps the code from reaching other hosts. */
  warn(): void {
    this.#text.textContent = UNCONFINED;
    this.#run.textContent = "Run it all the same";
    this.#run.focus();
  }

  /** Whether the second question is shown. */
  get warned(): boolean {
    return this.#text.textContent === UNCONFINED;
  }
}
