/**
 * Recordings on the page: opens one, with a bar of its own below the scene, goes on from one of its
 * steps by hand, and saves what runs as one. Imported when the first recording is opened or saved.
 */
import "../style/recording.css";
import recordedUrl from "thud/thud-recorded.wasm?url";
import { messageOf } from "../shared/error";
import type { App } from "./app";
import { byId, make } from "./dom";
import { count } from "./format";
import { notice } from "./messages";
import { SPEEDS } from "./url";

/** What plays a recording; no file of web/public/scenes has this name. */
const RECORDING = "recording";
/** Bytes of a recording that is opened at most. Chosen. */
const LARGEST_FILE = 2 ** 28;

/** Milliseconds for which a file that is saved stays there for the browser. Chosen. */
const KEPT = 60_000;

/** Made when the first recording is opened. */
let bar: Bar | null = null;

/** Plays a file in place of what runs. If it cannot be played, that is told, and what runs goes
 * on. */
export async function openRecording(app: App, file: File): Promise<void> {
  if (file.size > LARGEST_FILE) throw new Error(`“${file.name}” is too large for a recording.`);
  const bytes = new Uint8Array(await file.arrayBuffer());
  const name = file.name.replace(/\.[^.]*$/, "");
  bar ??= new Bar(app);
  const recording = { name, bytes, wasm: recordedUrl, fork: null };
  if (!(await app.open(RECORDING, { recording }))) return;
  // Whoever paused the scene before has not paused this.
  if (app.state.paused && !matchMedia("(prefers-reduced-motion: reduce)").matches)
    app.setPaused(false);
}

/** Records what the time slider reaches, and gives it to the visitor as a file. */
export async function saveRecording(app: App): Promise<void> {
  const { title } = app;
  try {
    const { bytes, steps } = await app.client.ask("record", { wasm: recordedUrl }, (part) =>
      notice(`Recording: ${Math.floor(100 * part)} %`),
    );
    const url = URL.createObjectURL(new Blob([bytes], { type: "application/octet-stream" }));
    make("a", { href: url, download: `${title.replace(/[^\p{L}\p{N}]+/gu, "-")}.rec` }).click();
    // The browser may read it later.
    setTimeout(() => URL.revokeObjectURL(url), KEPT);
    notice(`Recorded: ${count(steps)} steps, ${count(Math.ceil(bytes.length / 1000))} kB.`);
  } catch (error) {
    notice(`Nothing is recorded: ${messageOf(error)}`, 20);
  }
}

/** The bar of a recording that is shown: its speed, and the way to change it and back. */
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
  readonly #element = make(
    "div",
    { id: "played", class: "panel", role: "group", "aria-label": "Recording", hidden: true },
    this.#name,
    this.#speed,
    this.#fork,
    this.#back,
  );
  /** The run whose first frame has come. */
  #begun = 0;
  /** The step at which the last fork was made. */
  #forkedAt = 0;

  constructor(app: App) {
    this.#app = app;
    byId("controls").before(this.#element);
    this.#speed.addEventListener("change", () => app.setSpeed(Number(this.#speed.value)));
    this.#fork.addEventListener("click", () => void this.#goOn());
    this.#back.addEventListener("click", () => void this.#goBack());
    app.listen({
      run: () => this.#show(),
      state: () => this.#tellSpeed(),
      frame: ({ run, step, ended }) => this.#follow(run, step, ended ?? false),
    });
    this.#tellSpeed();
  }

  /** Another scene, or the same one, has begun. */
  #show(): void {
    const { recording } = this.#app.state;
    const hidden = this.#element.hidden;
    this.#element.hidden = !recording;
    const forked = recording?.fork !== null;
    this.#fork.hidden = forked;
    this.#back.hidden = !forked;
    this.#name.textContent = forked ? "Fork" : "Recording";
    // The page makes room for what comes, and takes what goes.
    if (hidden !== this.#element.hidden) window.dispatchEvent(new Event("resize"));
  }

  #tellSpeed(): void {
    this.#speed.value = String(this.#app.state.speed);
  }

  /** A frame has come. What a ring has kept does not begin at step 0, and a recording ends. */
  #follow(run: number, step: number, ended: boolean): void {
    const { state, player } = this.#app;
    if (!state.recording) return;
    if (this.#begun !== run && step > player.place) player.skipTo(step);
    this.#begun = run;
    if (ended && !state.paused) this.#app.setPaused(true);
  }

  /** Goes on by hand from the step that is shown. */
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

  /** Shows the recording again, at the step where it was left. */
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
