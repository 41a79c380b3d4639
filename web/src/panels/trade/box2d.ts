/**
 * The check box with which Box2D gets a point in the plot of the panel Trade. While it is ticked
 * and the panel is open, Box2D runs in the worker beside the scene, without being drawn.
 */
import type { App } from "../../page/app";
import { make } from "../../page/dom";
import { messageOf } from "../../shared/error";
import { askForBox2D, endBox2D } from "../box2d-wish";
import { missesText } from "../misses";

export class Box2DChoice {
  readonly element: HTMLElement;
  readonly #app: App;
  readonly #input = make("input", { type: "checkbox", id: "trade-box2d" });
  readonly #line = make("p", { class: "explained", role: "status" });
  #open = false;

  constructor(app: App) {
    this.#app = app;
    this.#input.addEventListener("change", () => {
      if (this.#input.checked) void this.#ask();
      else this.#end();
    });
    this.element = make(
      "div",
      { class: "with-box2d" },
      make("label", {}, this.#input, " Box2D’s point too"),
      this.#line,
    );
    app.listen({
      // Asked again for each scene: it may run in a new worker, in which Box2D is not loaded.
      run: () => this.#wanted && void this.#ask(),
      frame: ({ box2dTrouble }) => this.#wanted && box2dTrouble && this.#fail(box2dTrouble),
      samples: (samples) => this.#wanted && this.#tellMisses(samples.at(-1)?.box2d?.misses ?? []),
    });
  }

  opened(): void {
    this.#open = true;
    if (this.#wanted) void this.#ask();
  }

  closed(): void {
    if (this.#wanted) this.#end();
    this.#open = false;
  }

  /** Whether Box2D should run: the panel is open and the box is ticked. */
  get #wanted(): boolean {
    return this.#open && this.#input.checked;
  }

  /** Starts Box2D. */
  async #ask(): Promise<void> {
    this.#line.textContent = "Loading Box2D…";
    try {
      await askForBox2D(this.#app);
      this.#line.textContent = "";
    } catch (error) {
      this.#fail(messageOf(error));
    }
  }

  /** Says why Box2D has no point, if it lacks parts of the scene. */
  #tellMisses(misses: readonly string[]): void {
    const text = missesText(misses);
    if (text !== "" && this.#line.textContent !== text) this.#line.textContent = text;
  }

  /** Box2D does not run: clears the box and shows why. */
  #fail(trouble: string): void {
    if (this.#input.checked) this.#end();
    this.#input.checked = false;
    this.#line.textContent = trouble;
  }

  /** Ends Box2D. */
  #end(): void {
    this.#line.textContent = "";
    endBox2D(this.#app);
  }
}
