/**
 * The part "Same bits" of the panel Inside: the hash of the world's state, and checks that the same
 * steps give the same hash on the machine that built the page, in native programs, on the machine
 * of a link's sender, and again on this machine after going back in time.
 */
import type { App } from "../../page/app";
import { make } from "../../page/dom";
import { notice, say } from "../../page/messages";
import { USUAL, writeState } from "../../page/url";
import { messageOf } from "../../shared/error";
import type { StateHash } from "../../worker/protocol";
import { fillList } from "./values";
import {
  EVERY,
  firstDifference,
  isUsual,
  Proof,
  type Reference,
  referenceOf,
} from "./proof";

/** Steps after which hashes are compared: those of which web/tools/hashes.mjs writes references. */
const STEPS = [1, 2, 3, 4, 5].map((i) => i * EVERY);
/** Seconds that the rewind check goes back. Chosen. */
const BACK = 5;
/** Milliseconds between two requests for the present hash. Chosen. */
const REFRESH = 400;

/** "open": there is no result yet, or nothing to compare with. */
type Verdict = "same" | "different" | "open";

export class CheckPart {
  readonly element: HTMLElement;
  /** Whether this part is shown; while it is not, the present hash is not requested. */
  seen = false;
  readonly #app: App;
  readonly #now = make("dl", { class: "facts", id: "hash-now" });
  readonly #check = make("button", { class: "wide primary", id: "check" }, "Check determinism");
  readonly #rewind = make("button", { class: "wide", id: "rewind" }, "Rewind check");
  readonly #link = make("button", { class: "wide", id: "hash-link" }, "Copy a link to compare");
  readonly #verdict = make("p", { id: "verdict", role: "status" });
  readonly #table = make("table", { id: "hashes" });
  readonly #rewound = make("p", { id: "rewound" });
  /** The worker that runs the scene for a check; null: none runs. */
  #proof: Proof | null = null;
  /** Ends listening to the app. */
  #stop: (() => void) | null = null;
  /** When the present hash was last requested, on the clock of performance.now(). */
  #asked = 0;
  /** The claim of the page's link has been checked. */
  #claimed = false;

  constructor(app: App) {
    this.#app = app;
    this.#check.addEventListener("click", () => void this.#toggle());
    this.#rewind.addEventListener("click", () => void this.#checkRewind());
    this.#link.addEventListener("click", () => void this.#copyLink());
    this.element = make(
      "section",
      { class: "part", "aria-label": "Same bits" },
      make("h3", {}, "This state"),
      this.#now,
      make("h3", {}, "Same on your machine?"),
      make(
        "p",
        { class: "quiet" },
        `Runs the scene from its start for ${STEPS.at(-1)} steps beside this one, with nobody's ` +
          "hands in it, and compares a hash of the whole state with other machines’.",
      ),
      this.#check,
      this.#verdict,
      this.#table,
      this.#link,
      make("h3", {}, "Same after going back?"),
      make(
        "p",
        { class: "quiet" },
        `Goes back ${BACK} seconds, does what you did again, and compares with the present.`,
      ),
      this.#rewind,
      this.#rewound,
    );
    this.#forget();
  }

  /** The panel is opened. */
  watch(): void {
    this.#stop = this.#app.listen({
      run: () => {
        this.#end();
        this.#forget();
        void this.#checkClaim();
      },
      frame: () => void this.#showNow(),
    });
    void this.#showNow();
    void this.#checkClaim();
  }

  /** The panel is closed. */
  rest(): void {
    this.#stop?.();
    this.#end();
  }

  /** Shows the hash of the state that is shown. */
  async #showNow(): Promise<void> {
    const now = performance.now();
    if (!this.seen || (now - this.#asked < REFRESH && !this.#app.state.paused)) return;
    this.#asked = now;
    try {
      const { step, hash } = await this.#app.client.ask("hash", {});
      fillList(this.#now, [
        ["step", String(step)],
        ["hash", hash],
      ]);
    } catch {
      // No scene runs.
    }
  }

  // ---- comparison with other machines ----

  /** The button: starts the check, or ends one that runs. */
  async #toggle(): Promise<void> {
    if (this.#proof) {
      this.#end();
      this.#tell("open", "Stopped.");
    } else await this.#checkReference();
  }

  /** Compares with the machine that built the page, if the scene and its choices are the default
   * ones, of which references exist. */
  async #checkReference(): Promise<void> {
    const { state } = this.#app;
    const reference = isUsual(state) ? referenceOf(state.scene) : null;
    const hashes = await this.#run(STEPS, {});
    if (!hashes) return;
    if (!reference) {
      this.#list(hashes, null);
      this.#tell(
        "open",
        "There is no reference for what you have chosen here. Send the link below to a friend: " +
          "there the page compares the two machines.",
      );
      return;
    }
    this.#list(hashes, reference.hashes);
    const from = firstDifference(hashes, reference.hashes);
    if (from !== null)
      this.#tell(
        "different",
        from === EVERY
          ? `Different from the first ${EVERY} steps on.`
          : `Different: the same up to step ${from - EVERY}, and no more at step ${from}.`,
      );
    else await this.#checkNative(reference);
  }

  /** Compares with the native engine's hash, if there is one, at its size of the scene. */
  async #checkNative({ native }: Reference): Promise<void> {
    const built = "Same bits as on the machine that built this page";
    if (!native) return this.#tell("same", `${built}.`);
    const { size, step, hash } = native;
    const hashes = await this.#run([step], { size, choices: USUAL });
    if (!hashes) return;
    const where = size === 0 ? "" : ` (at size ${size} after ${step} steps)`;
    if (hashes[0].hash === hash)
      this.#tell("same", `${built}, and as in native x86-64 programs of gcc and clang${where}.`);
    else
      this.#tell(
        "different",
        `${built}, but native x86-64 programs have ${hash}${where} and not ${hashes[0].hash}.`,
      );
  }

  /** Compares with the hash that the page's link claims for its sender's machine; once. */
  async #checkClaim(): Promise<void> {
    const { claim, code } = this.#app.state;
    if (!claim || this.#claimed || this.#proof) return;
    if (this.#app.offeredCode !== null && code === null) {
      this.#tell("open", "The link brings code of its own: run it first, then check.");
      return;
    }
    this.#claimed = true;
    const hashes = await this.#run([claim.step], {});
    if (!hashes) return;
    this.#list(hashes, [claim]);
    if (hashes[0].hash === claim.hash)
      this.#tell(
        "same",
        `Same bits as on the machine of whoever sent the link, after ${claim.step} steps.`,
      );
    else
      this.#tell(
        "different",
        `Different from the machine of whoever sent the link, after ${claim.step} steps. ` +
          "Or the link was made by another version of this page.",
      );
  }

  /** Runs the scene, with changes of the request, in a worker of its own, and returns its hashes
   * after these steps; null if that was stopped or the scene cannot be run. */
  async #run(
    steps: readonly number[],
    change: Partial<App["request"]>,
  ): Promise<StateHash[] | null> {
    this.#end();
    const proof = (this.#proof = new Proof(this.#app.wasm));
    this.#check.textContent = "Stop";
    this.#tell("open", "Running…");
    try {
      return await proof.run({ ...this.#app.request, ...change }, steps, (step) => {
        this.#verdict.textContent = `Running: step ${step} of ${steps.at(-1)}`;
      });
    } catch (error) {
      if (this.#proof === proof) this.#tell("different", `It cannot be run: ${messageOf(error)}`);
      return null;
    } finally {
      if (this.#proof === proof) this.#end();
    }
  }

  /** Stops the check that runs. */
  #end(): void {
    const proof = this.#proof;
    this.#proof = null;
    proof?.close();
    this.#check.textContent = "Check determinism";
  }

  /** Clears the results. */
  #forget(): void {
    this.#table.replaceChildren();
    this.#tell("open", "");
    this.#rewound.textContent = "";
  }

  /** Shows a verdict; its kind selects the colour. */
  #tell(verdict: Verdict, text: string): void {
    this.#verdict.dataset.verdict = verdict;
    this.#verdict.textContent = text;
  }

  /** Lists hashes, beside those of the reference if there is one. */
  #list(hashes: readonly StateHash[], reference: readonly { hash: string }[] | null): void {
    const head = ["Step", "Here", ...(reference ? ["There"] : [])];
    const rows = hashes.map(({ step, hash }, i) => {
      const other = reference?.[i].hash;
      const cells = [hash, ...(other ? [other] : [])].map((text) => make("td", {}, text));
      const same = !other || other === hash;
      const name = make("th", { scope: "row" }, String(step));
      return make("tr", { "data-same": String(same) }, name, ...cells);
    });
    this.#table.replaceChildren(
      make("thead", {}, make("tr", {}, ...head.map((text) => make("th", { scope: "col" }, text)))),
      make("tbody", {}, ...rows),
    );
  }

  /** Runs the scene and copies a link that claims its hash. Where the clipboard is not allowed, the
   * link is shown in a field. */
  async #copyLink(): Promise<void> {
    const steps = STEPS.at(-1)!;
    const hashes = await this.#run([steps], {});
    if (!hashes) return;
    this.#list(hashes, null);
    const claim = { step: steps, hash: hashes[0].hash };
    const address = await writeState({ ...this.#app.state, panel: "inside", camera: null, claim });
    const link = new URL(address, location.href).href;
    this.#tell("open", `After ${steps} steps: ${claim.hash}`);
    try {
      await navigator.clipboard.writeText(link);
      notice("The link is in the clipboard. Opened elsewhere, it tells if the bits are the same.");
    } catch {
      const field = make("input", { readonly: true, value: link, "aria-label": "Link to compare" });
      this.#verdict.append(field);
      field.select();
    }
  }

  // ---- back in time ----

  /** Has the worker go back, make the same steps again and compare the hashes. */
  async #checkRewind(): Promise<void> {
    const seconds = this.#app.scene?.timeStep ?? 1 / 60;
    this.#rewound.textContent = "Running…";
    try {
      const steps = Math.round(BACK / seconds);
      const { from, step, hash, again } = await this.#app.client.ask("rerun", { steps });
      const same = hash === again;
      this.#rewound.dataset.verdict = same ? "same" : "different";
      this.#rewound.textContent =
        step === from
          ? "There is nothing to go back to yet: let the scene run for a while."
          : same
            ? `Same bits: steps ${from} to ${step} came out as before, ${hash}.`
            : `Different: from step ${from} again, step ${step} has ${again} and had ${hash}.`;
    } catch (error) {
      this.#rewound.textContent = messageOf(error);
    }
    say(this.#rewound.textContent);
  }
}
