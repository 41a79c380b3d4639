/** `Work`: a button that starts a measurement in the laboratory, its progress, and a button that
 * cancels it. */
import { make } from "../../page/dom";
import { say } from "../../page/messages";
import { messageOf } from "../../shared/error";
import type { Laboratory } from "./laboratory";

export class Work {
  readonly element: HTMLElement;
  readonly #start: HTMLButtonElement;
  readonly #cancel = make("button", { class: "wide" }, "Cancel");
  readonly #bar = make("progress", { max: 1 });
  readonly #line = make("p", { class: "explained" });
  readonly #running: HTMLElement;
  readonly #laboratory: Laboratory;
  readonly #act: (work: Work) => Promise<string>;

  /** `act` does the work and resolves to the text that is shown at its end; "" for none. */
  constructor(label: string, laboratory: Laboratory, act: (work: Work) => Promise<string>) {
    this.#laboratory = laboratory;
    this.#act = act;
    this.#start = make("button", { class: "wide go" }, label);
    this.#start.addEventListener("click", () => void this.#run());
    this.#cancel.addEventListener("click", () => laboratory.cancel());
    this.#bar.setAttribute("aria-label", label);
    this.#running = make("div", { class: "running", hidden: true }, this.#bar, this.#cancel);
    this.element = make("div", { class: "work" }, this.#start, this.#running, this.#line);
  }

  /** Shows progress: `done` from 0 to 1, or null to leave the bar as it is; `doing` as text. */
  report(done: number | null, doing: string): void {
    if (done !== null) this.#bar.value = done;
    this.#line.textContent = doing;
  }

  /** Runs `act`, and shows its text or its error. */
  async #run(): Promise<void> {
    if (this.#laboratory.busy) {
      this.#line.textContent = "Something is being measured already.";
      return;
    }
    this.#bar.removeAttribute("value");
    this.#line.textContent = "Starting…";
    this.#start.hidden = true;
    this.#running.hidden = false;
    this.#cancel.focus();
    try {
      this.#line.textContent = await this.#act(this);
    } catch (error) {
      this.#line.textContent = `That did not work: ${messageOf(error)}`;
    }
    if (this.#line.textContent) say(this.#line.textContent);
    const hadFocus = this.#running.contains(document.activeElement);
    this.#start.hidden = false;
    this.#running.hidden = true;
    if (hadFocus) this.#start.focus();
  }
}
