/**
 * `Laboratory`: runs a measurement in a second physics worker that does nothing else, while the
 * scene on the page is paused. Terminating that worker cancels the measurement at any moment, even
 * in the middle of a step that takes seconds.
 */
import type { App } from "../../page/app";
import { Client } from "../../page/client";
import { chooseWasm } from "../../wasm/choose";
import type { Progress, QuestionName, Questions, SceneRequest } from "../../worker/protocol";

export class Laboratory {
  readonly #app: App;
  readonly #changed: () => void;
  /** The second worker; null while nothing is measured. */
  #client: Client | null = null;

  /** `changed` is called when a measurement begins or ends. */
  constructor(app: App, changed: () => void) {
    this.#app = app;
    this.#changed = changed;
    // When another scene starts, the measurement is no longer of the scene on the page.
    app.listen({ run: () => this.cancel() });
  }

  /** Whether a measurement runs. */
  get busy(): boolean {
    return this.#client !== null;
  }

  /** The request that runs the page's scene with the present choices. */
  get request(): SceneRequest {
    const { request } = this.#app;
    return { ...request, choices: { ...request.choices } };
  }

  /**
   * Asks a question in a new worker, and terminates the worker afterwards. Null: it was cancelled.
   * `slow` is called if the worker sends nothing for some seconds (STUCK in client.ts).
   */
  async ask<Name extends QuestionName>(
    name: Name,
    value: Questions[Name]["ask"],
    report: (progress: Progress<Name>) => void,
    slow: () => void,
  ): Promise<Questions[Name]["answer"] | null> {
    const app = this.#app;
    const { paused } = app.state;
    app.setPaused(true);
    const client = new Client({ frame() {}, trouble() {}, stuck: slow });
    this.#client = client;
    this.#changed();
    try {
      const { wasm, rest } = chooseWasm();
      await client.ask("load", { wasm, rest, page: document.baseURI });
      await client.ask("complete", {});
      return await client.ask(name, value, report);
    } catch (error) {
      if (this.#client === null) return null;
      throw error;
    } finally {
      this.cancel();
      app.setPaused(paused);
    }
  }

  /** Terminates the measurement that runs, if any. */
  cancel(): void {
    const client = this.#client;
    if (!client) return;
    this.#client = null;
    client.close();
    this.#changed();
  }
}
