/**
 * Recordings on the page: opens one and shows a bar for it below the scene; lists the calls of its
 * steps; forks it, so that the visitor can change what happens from a step on; and saves the
 * running scene as a recording. Imported when the first recording is opened or saved.
 */
import "../style/recording.css";
import recordedUrl from "thud/thud-recorded.wasm?url";
import type { Frame } from "../scene/frame";
import { messageOf } from "../shared/error";
import type { App } from "./app";
import { byId, make } from "./dom";
import { count } from "./format";
import { notice } from "./messages";
import { saveFile } from "./save-file";
import { SPEEDS } from "./url";

/** The scene name of recordings; no file of web/public/scenes has this name. */
const RECORDING = "recording";
/** Maximum size in bytes of a recording that is opened. Chosen. */
const LARGEST_FILE = 2 ** 28;

/** Made when the first recording is opened. */
let bar: Bar | null = null;

/**
 * Plays a recording in place of the running scene. If it cannot be played, shows why, and the
 * running scene goes on.
 */
export async function openRecording(app: App, file: File): Promise<void> {
  if (file.size > LARGEST_FILE) throw new Error(`“${file.name}” is too large for a recording.`);
  const bytes = new Uint8Array(await file.arrayBuffer());
  const name = file.name.replace(/\.[^.]*$/, "");
  bar ??= new Bar(app);
  const recording = { name, bytes, wasm: recordedUrl, fork: null };
  if (!(await app.open(RECORDING, { recording }))) return;
  // The visitor has paused the scene before, not this recording.
  if (app.state.paused && !matchMedia("(prefers-reduced-motion: reduce)").matches)
    app.setPaused(false);
}

/**
 * Records the steps from the oldest one that the history keeps to the one that is shown, and saves
 * the recording as a file.
 */
export async function saveRecording(app: App): Promise<void> {
  try {
    const { bytes, steps } = await app.client.ask("record", { wasm: recordedUrl }, (part) =>
      notice(`Recording: ${Math.floor(100 * part)} %`),
    );
    saveFile(app, new Blob([bytes], { type: "application/octet-stream" }), "rec");
    notice(`Recorded: ${count(steps)} steps, ${count(Math.ceil(bytes.length / 1000))} kB.`);
  } catch (error) {
    notice(`Nothing is recorded: ${messageOf(error)}`, 20);
  }
}

/** The bar below a recording: its speed, and the buttons that fork it and that return to it. */
class Bar {
  readonly #app: App;
  readonly #speed = make(
    "select",
    { id: "played-speed", "aria-label": "Speed" },
    ...SPEEDS.map((speed) => make("option", { value: speed }, `${speed}×`)),
  );
  readonly #name = make("span", { class: "name", "aria-hidden": "true" });
  readonly #fork = make(
    "button",
    { id: "fork", class: "primary", title: "Go on by hand from the step that is shown" },
    "Fork here",
  );
  readonly #back = make("button", { id: "to-recording" }, "To the recording");
  readonly #callsButton = make(
    "button",
    {
      id: "calls-button",
      "aria-expanded": "false",
      "aria-controls": "played-calls",
      title: "List and draw the calls that led to each step",
    },
    "Calls",
  );
  readonly #callsHead = make("h2", {});
  readonly #callsList = make("ol", {});
  readonly #calls = make(
    "section",
    { id: "played-calls", class: "panel", tabindex: 0, "aria-label": "Calls of this step", hidden: true },
    this.#callsHead,
    this.#callsList,
  );
  readonly #element = make(
    "div",
    { id: "played", class: "panel", role: "group", "aria-label": "Recording", hidden: true },
    this.#name,
    this.#speed,
    this.#callsButton,
    this.#fork,
    this.#back,
  );
  /**
   * Whether the visitor wants the calls of each step listed. The list is hidden in a fork, whose
   * calls are not known.
   */
  #lists = false;
  /** The number of the run (RunningScene.run) whose first frame has come. */
  #begun = 0;
  /** The step at which the last fork was made. */
  #forkedAt = 0;

  constructor(app: App) {
    this.#app = app;
    byId("controls").before(this.#calls, this.#element);
    this.#speed.addEventListener("change", () => app.setSpeed(Number(this.#speed.value)));
    this.#fork.addEventListener("click", () => void this.#goOn());
    this.#back.addEventListener("click", () => void this.#goBack());
    this.#callsButton.addEventListener("click", () => this.#listCalls(!this.#lists));
    app.listen({
      run: () => this.#show(),
      state: () => this.#tellSpeed(),
      frame: (frame) => {
        this.#follow(frame);
        this.#tellCalls(frame);
      },
    });
    this.#tellSpeed();
  }

  /** Another scene, or the same one, has begun. */
  #show(): void {
    const { recording } = this.#app.state;
    const forked = recording?.fork !== null;
    const hidden = this.#element.hidden;
    this.#element.hidden = !recording;
    this.#fork.hidden = this.#callsButton.hidden = forked;
    this.#back.hidden = !forked;
    this.#name.textContent = forked ? "Fork" : "Recording";
    this.#showCalls(hidden !== this.#element.hidden);
  }

  /** Begins (`on`) or ends listing the calls. */
  #listCalls(on: boolean): void {
    this.#lists = on;
    this.#showCalls();
  }

  /** Shows the list where it belongs, and asks the worker for it. `changed`: the bar has appeared or
   * disappeared. */
  #showCalls(changed = false): void {
    const { recording } = this.#app.state;
    const plays = recording?.fork === null;
    const { hidden } = this.#calls;
    this.#callsButton.setAttribute("aria-expanded", String(this.#lists));
    this.#calls.hidden = !plays || !this.#lists;
    if (plays) {
      void this.#app.client.ask("listCalls", { on: this.#lists }).catch(() => {});
      this.#app.refresh();
    }
    // The page is laid out anew where the bar or the list has appeared or disappeared.
    if (changed || hidden !== this.#calls.hidden) window.dispatchEvent(new Event("resize"));
  }

  #tellCalls({ step, calls }: Frame): void {
    if (!calls || this.#calls.hidden) return;
    const { count: all, lines } = calls;
    this.#callsHead.textContent = `Calls of step ${step}: ${all}`;
    const rest = all > lines.length ? [`and ${all - lines.length} more`] : [];
    const rows = all === 0 ? ["none beside the step itself"] : [...lines, ...rest];
    this.#callsList.replaceChildren(...rows.map((text) => make("li", {}, text)));
  }

  #tellSpeed(): void {
    this.#speed.value = String(this.#app.state.speed);
  }

  /**
   * A frame has come. A recording made with `ringSteps` begins later than step 0: its first frame
   * is shown at once. At its last step the page pauses it.
   */
  #follow({ run, step, ended }: Frame): void {
    const { state, player } = this.#app;
    if (!state.recording) return;
    if (this.#begun !== run && step > player.place) player.skipTo(step);
    this.#begun = run;
    if (ended && !state.paused) this.#app.setPaused(true);
  }

  /** Forks the recording: from the step that is shown the visitor can change what happens. */
  async #goOn(): Promise<void> {
    const { recording } = this.#app.state;
    const step = this.#app.player.shown?.frame.step;
    if (!recording || step === undefined) return;
    this.#forkedAt = step;
    const forked = await this.#app.open(RECORDING, { recording: { ...recording, fork: step } });
    if (!forked) return;
    this.#back.focus();
    notice(`This goes on by hand from step ${step}: drag, add, explode.`);
  }

  /** Returns from the fork to the recording, at the step at which it was forked. */
  async #goBack(): Promise<void> {
    const { recording } = this.#app.state;
    if (!recording) return;
    const app = this.#app;
    app.setPaused(true);
    if (!(await app.open(RECORDING, { recording: { ...recording, fork: null } }))) return;
    await app.seek(this.#forkedAt).catch((error) => notice(messageOf(error)));
    this.#fork.focus();
  }
}
