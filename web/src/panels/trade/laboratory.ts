/**
 * A second physics worker, which measures with nothing else to do; the scene on the page stands
 * still meanwhile. Ending the worker ends a measurement at any moment, even in a step of seconds.
 */
import type { App } from "../../page/app";
import { Client } from "../../page/client";
import { chooseWasm } from "../../wasm/choose";
import type { Progress, QuestionName, Questions, SceneRequest } from "../../worker/protocol";

export class Laboratory {
  readonly #app: App;
  readonly #changed: () => void;
  #client: Client | null = null;

  /** `changed` hears that measuring begins or ends. */
  constructor(app: App, changed: () => void) {
    this.#app = app;
    this.#changed = changed;
    // What would come out would be another scene's.
    app.listen({ run: () => this.cancel() });
  }

  get busy(): boolean {
    return this.#client !== null;
  }

  /** The scene as it runs on the page. */
  get request(): SceneRequest {
    const app = this.#app;
    const { scene, code, size, seed, choices } = app.state;
    return {
      name: scene,
      code: code ?? undefined,
      files: app.files,
      size,
      seed,
      choices: { ...choices },
    };
  }

  /** Null: it was cancelled. `slow` hears that nothing has come back for seconds. */
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

  cancel(): void {
    const client = this.#client;
    if (!client) return;
    this.#client = null;
    client.close();
    this.#changed();
  }
}
