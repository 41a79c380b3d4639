/**
 * `App`: the state of the running page. It holds the visitor's choices, the running scene, the
 * client of the physics worker and the player that times the display, and it keeps the state in the
 * page's address. Controls and panels call its methods and follow it as listeners.
 */
import type { Frame, Sample, Shapes } from "../scene/frame";
import { findScene } from "../scene/registry";
import { messageOf } from "../shared/error";
import type { ChosenWasm } from "../wasm/choose";
import type { Command } from "../worker/commands";
import type { Choices, Look, RunningScene, SceneRequest, Trouble } from "../worker/protocol";
import { Client, TroubleError } from "./client";
import { Player } from "./player";
import { type State, USUAL, USUAL_OVERLAYS, USUAL_VERSUS, writeState } from "./url";

/** What `App` calls when something happens; a listener has only the functions that it needs. */
export interface Listener {
  /** A scene has started, or the same scene has started again. */
  run?(scene: RunningScene): void;
  /** A new frame has come from the worker; the player draws it when its time comes. */
  frame?(frame: Frame): void;
  /** The worker has made steps; one sample for each. */
  samples?(samples: readonly Sample[]): void;
  /** A picture has been drawn that differs from the one before. */
  drawn?(): void;
  /** `App.state` has changed. */
  state?(state: Readonly<State>): void;
  /** An error: the scene cannot be started, or, with `running`, it had started and has stopped. */
  trouble?(trouble: Trouble, running: boolean): void;
  /** Code from the page's address waits for the visitor's decision; null: it no longer does. */
  offer?(code: string | null): void;
  /** The worker has not answered for a long time (STUCK in client.ts). */
  stuck?(): void;
  /** The worker has answered after `stuck` was called. */
  answers?(): void;
}

/** Parts of the state that `open` sets besides the scene's name; those left out are reset. */
type Opening = Partial<
  Pick<State, "code" | "size" | "seed" | "camera" | "claim" | "level" | "recording" | "match" | "invite">
>;

/** The part of the state that determines what the running scene was started with. */
type Begun = Pick<State, "scene" | "code" | "size" | "seed" | "level" | "recording" | "match">;

/** Choices that are fixed when a world is created. */
const ANEW = ["detection", "broadphase", "stepRate", "topSpeed"] as const;

export class App {
  readonly client: Client;
  readonly player = new Player();
  readonly state: State = {
    scene: "towers",
    level: null,
    recording: null,
    match: null,
    invite: null,
    seed: 0,
    choices: { ...USUAL },
    versus: { ...USUAL_VERSUS },
    speed: 1,
    paused: false,
    overlays: USUAL_OVERLAYS,
    camera: null,
    code: null,
    result: null,
    panel: null,
    claim: null,
  };
  /** The worker's description of the running scene; null: none runs. */
  scene: RunningScene | null = null;
  /** The address's scene was paused only because the visitor's system asks for reduced motion. */
  waitsForMotion = false;
  /** Shapes of the running scene, from the last frame that carried them. */
  shapes: Shapes | null = null;
  /** Descriptions by scene name. Null until they are loaded, after the first picture. */
  abouts: Readonly<Record<string, string>> | null = null;
  /** Code from a link that the visitor has not run yet. The address keeps it. */
  offeredCode: string | null = null;
  /** The engine's files, from which further workers load it. */
  wasm: ChosenWasm = { wasm: "", simd: true };
  readonly #listeners = new Set<Listener>();
  readonly #look: () => Look;
  /** Number of single steps that the visitor has requested and the worker has not made yet. */
  #owed = 0;
  /** An error paused the scene, not the visitor: the next scene is not paused. */
  #halted = false;
  /** The frame that is shown must be made again although no step is due. */
  #stale = false;
  /** What the running scene was started with. `state` returns to it if the next one fails to
   * start. */
  #running: Begun | null = null;
  /** Number of the latest request to run a scene; results of earlier requests are ignored. */
  #runs = 0;
  /** A scene is requested and has not started yet; the one before runs until then. */
  #starting = false;
  /** Number of the latest address to be written; earlier ones that are ready later are dropped. */
  #addresses = 0;
  /** The browser shows a new address that has not been parsed yet; nothing is written meanwhile. */
  #left = false;
  /** The next scene that starts is the address's own, so it adds no entry to the history. */
  #arrives = true;
  /** The next write of the address adds an entry to the history: Back returns to the scene
   * before. */
  #goesOn = false;

  /** `look` returns the visible part of the world and the overlays that the engine shall draw. */
  constructor(look: () => Look) {
    this.#look = look;
    this.client = new Client({
      frame: (frame) => this.#take(frame),
      trouble: (trouble, run) => this.#takeTrouble(trouble, run),
      stuck: () => this.#tell((listener) => listener.stuck?.()),
      answers: () => this.#tell((listener) => listener.answers?.()),
    });
  }

  /** Adds a listener; the returned function removes it. */
  listen(listener: Listener): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /** Loads the engine into the worker. Must be done before a scene is run. */
  async load(wasm: ChosenWasm): Promise<void> {
    this.wasm = wasm;
    await this.client.load(wasm);
  }

  /** Loads another engine into a new worker, and runs the scene from its beginning. Resolves to the
   * engine's number of threads. */
  async reload(wasm: ChosenWasm): Promise<number> {
    const threads = await this.#startWorker(wasm);
    await this.restart();
    return threads;
  }

  // ---- scenes ----

  /** Runs another scene. True once it runs; false if it failed or another was requested since. */
  async open(scene: string, more: Opening = {}): Promise<boolean> {
    const { state } = this;
    state.scene = scene;
    state.code = more.code ?? null;
    state.size = more.size;
    state.seed = more.seed ?? 0;
    state.camera = more.camera ?? null;
    state.claim = more.claim ?? null;
    state.level = more.level ?? null;
    state.recording = more.recording ?? null;
    state.match = more.match ?? null;
    state.invite = more.invite ?? null;
    return this.#run();
  }

  /** The level's files by name. The scene's `readText` looks in them before the page's files. */
  get files(): Record<string, string> | undefined {
    return this.state.level?.files;
  }

  /** The current choices, as a worker's request to run the scene. */
  get request(): SceneRequest {
    const { scene, code, recording, size, seed, choices } = this.state;
    return {
      name: scene,
      code: code ?? undefined,
      files: this.files,
      recording: recording ?? undefined,
      size,
      seed,
      choices,
    };
  }

  /** Runs the scene from its beginning with the current choices. Returns as `open` does. */
  async restart(): Promise<boolean> {
    // A link's claim holds only for the choices that came with it.
    this.state.claim = null;
    // A match is left: one player alone cannot start it again.
    this.state.match = null;
    return this.#run();
  }

  /** Asks the worker to run `request`. Of overlapping calls only the last one takes effect. */
  async #run(): Promise<boolean> {
    const number = ++this.#runs;
    this.#starting = true;
    try {
      const { match } = this.state;
      const request = match ? { ...this.request, match } : this.request;
      const ports = match ? [match.port] : [];
      const scene = await this.client.ask("run", request, undefined, ports);
      if (number !== this.#runs) return false;
      this.#starting = false;
      this.#begin(scene);
      return true;
    } catch (error) {
      if (number !== this.#runs) return false;
      this.#starting = false;
      this.#stop(
        error instanceof TroubleError ? error.trouble : { message: messageOf(error) },
        false,
      );
      this.#keepRunning();
      return false;
    }
  }

  /** Terminates a worker that does not answer, and runs a scene in a new one. */
  async revive(scene: string): Promise<void> {
    await this.#startWorker();
    await this.open(scene);
  }

  /**
   * Terminates a visitor's code that does not answer. If that code had not started yet, the scene
   * that ran before it is run again; otherwise the same scene without the visitor's changes.
   */
  async endCode(): Promise<void> {
    const { camera, code: ended } = this.state;
    const before = this.#running?.code === ended ? null : this.#running;
    await this.#startWorker();
    // The port of a match went to the worker that is gone.
    const { scene, match: _, ...more } = before ?? { ...this.#running, scene: this.state.scene, code: null };
    await this.open(scene, { ...more, camera });
  }

  /** Replaces the worker by a new one with the engine loaded; no scene runs in it yet. Resolves to
   * the engine's number of threads. */
  async #startWorker(wasm = this.wasm): Promise<number> {
    // A `#run` that still waits for the old worker must not report that as an error.
    this.#runs++;
    this.#starting = false;
    this.client.restart();
    // Frames cannot be requested until a scene runs in the new worker.
    this.scene = null;
    this.wasm = wasm;
    return this.client.load(wasm);
  }

  /** The running scene's title, with ", edited" where the visitor's code runs. */
  get title(): string {
    const { code, level, recording } = this.state;
    const own = recording ? this.scene?.title : level?.name;
    const title = findScene(this.state.scene)?.title ?? own ?? "";
    return code === null ? title : `${this.scene?.title ?? title}, edited`;
  }

  /** The scene's description; "" if it has none or `abouts` are not loaded yet. */
  get about(): string {
    return this.abouts?.[this.state.scene] ?? "";
  }

  /** The browser shows a new address: nothing is written there until `begin` gets its state. */
  leaveAddress(): void {
    this.#left = true;
  }

  /** Takes over the state parsed from an address, except for its scene, which `open` runs. */
  begin({ choices, versus, speed, paused, overlays, result }: Partial<State>): void {
    // A write that is still pending belongs to the address before.
    this.#addresses++;
    this.#left = false;
    this.#arrives = true;
    this.#goesOn = false;
    this.state.result = result ?? null;
    if (choices) Object.assign(this.state.choices, choices);
    if (versus) Object.assign(this.state.versus, versus);
    if (overlays) this.state.overlays = overlays;
    this.state.speed = this.player.speed = speed ?? 1;
    // Where reduced motion is asked for, the scene stays paused until the visitor starts it.
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.waitsForMotion = still && paused === undefined;
    this.state.paused = this.player.paused = paused ?? still;
  }

  /** Offers code that came with a link: it runs only when the visitor says so. Null: ends that. */
  offerCode(code: string | null): void {
    this.offeredCode = code;
    this.#tell((listener) => listener.offer?.(code));
    this.chosen();
  }

  /** The worker has started `scene`: updates the state and the listeners, requests a frame. */
  #begin(scene: RunningScene): void {
    // The worker has clamped the size to the scene's range; a scene of one size has none.
    if (this.state.size !== undefined) this.state.size = scene.sizes ? scene.size : undefined;
    const { scene: name, code, size, seed, level, recording, match } = this.state;
    this.scene = scene;
    if (code !== null || name !== this.#running?.scene) this.offeredCode = null;
    const before = this.#running;
    const same = level === before?.level && recording === before.recording;
    if (!this.#arrives && (name !== before?.scene || !same)) this.#goesOn = true;
    this.#arrives = false;
    this.#running = { scene: name, code, size, seed, level, recording, match };
    this.shapes = null;
    this.#owed = 0;
    if (this.#halted) this.setPaused(false);
    this.player.begin(scene.run, scene.timeStep);
    this.#tell((listener) => listener.run?.(scene));
    this.chosen();
    this.requestFrame();
  }

  /** Returns `state` to that of the scene that still runs. */
  #keepRunning(): void {
    if (this.#running) Object.assign(this.state, this.#running);
  }

  /** Stops the running scene for an error that the page, not the worker, has found. */
  end(trouble: Trouble): void {
    this.#stop(trouble, true);
  }

  /** Takes an error of the worker, or of run number `run` of a scene. That of a scene that is being
   * replaced is dropped: it would be shown as one of the next scene. */
  #takeTrouble(trouble: Trouble, run?: number): void {
    const isOfShown = !this.#starting && run === this.scene?.run;
    if (run === undefined || isOfShown) this.#stop(trouble, true);
  }

  /** Reports an error to the listeners, and pauses the scene if it was `running`. */
  #stop(trouble: Trouble, running: boolean): void {
    if (trouble.tooLarge) {
      // Terminating the worker frees its memory.
      this.client.close();
      this.scene = null;
    }
    if (running && !this.state.paused) this.#stand(true, true);
    this.#tell((listener) => listener.trouble?.(trouble, running));
  }

  // ---- choices ----

  /**
   * Changes choices. Those of ANEW are fixed when a world is created, so another one restarts the
   * scene; the other choices are set in the running world.
   */
  choose(change: Partial<Choices>): void {
    const { choices } = this.state;
    const anew = ANEW.some((name) => (change[name] ?? choices[name]) !== choices[name]);
    Object.assign(choices, change);
    if (anew) void this.restart();
    else
      this.client
        .ask("choose", choices)
        .catch((error) => this.#stop({ message: messageOf(error) }, true));
    this.chosen();
  }

  setSpeed(speed: number): void {
    this.state.speed = this.player.speed = speed;
    this.chosen();
  }

  setPaused(paused: boolean): void {
    this.#stand(paused, false);
  }

  /** Pauses or resumes; `halted`: an error is the reason. */
  #stand(paused: boolean, halted: boolean): void {
    this.state.paused = this.player.paused = paused;
    this.#halted = halted;
    if (paused) this.player.settle();
    this.chosen();
  }

  /** Tells the listeners that `state` has changed, and writes it into the address. */
  chosen(): void {
    this.#tell((listener) => listener.state?.(this.state));
    const number = ++this.#addresses;
    const code = this.state.code ?? this.offeredCode;
    // A scene that an error paused is not paused after the page is reloaded.
    const paused = this.state.paused && !this.#halted;
    void writeState({ ...this.state, code, paused }).then((address) => {
      if (number === this.#addresses && !this.#left) this.#write(address);
    });
  }

  /** Replaces the browser's address, or adds it to the history if another scene runs now. */
  #write(address: string): void {
    const method = this.#goesOn ? "pushState" : "replaceState";
    this.#goesOn = false;
    const { level } = this.state;
    try {
      // The history entry keeps the level too, so that Back finds one too long for the address.
      history[method]({ level }, "", address);
    } catch {
      // The browser's limit on the size of such an entry is exceeded.
      history[method]({}, "", address);
    }
  }

  // ---- time ----

  /** Sends a command to the worker. While paused, a new frame is requested to show its effect. */
  do(command: Command): void {
    this.client.do(command);
    if (this.state.paused) this.refresh();
  }

  /** Pauses the scene and makes one step, which is shown at once. */
  stepOnce(): void {
    if (!this.state.paused) this.setPaused(true);
    this.#owed++;
    this.requestFrame();
  }

  /** Shows a recorded step, earlier or later than the present one. */
  async seek(step: number): Promise<void> {
    const frame = await this.client.ask("seek", { step, look: this.#look() });
    this.#keepShapes(frame);
    this.player.jump(frame);
    this.#tell((listener) => listener.frame?.(frame));
  }

  /** Called once per picture of the display: asks the worker for the next steps, if any are due. */
  requestFrame(): void {
    if (!this.scene || this.client.ticking) return;
    const { player } = this;
    if (this.#owed > 0) {
      this.client.tick(this.scene.run, player.newest + this.#owed, this.#look());
    } else if (player.wanted > player.newest || player.empty || this.#stale) {
      this.client.tick(this.scene.run, player.wanted, this.#look());
    }
    this.#stale = false;
  }

  /** Has the shown frame made again, since overlays or the visible part of the world changed. */
  refresh(): void {
    this.#stale = true;
  }

  /** Tells the listeners that a picture has been drawn. */
  drawn(): void {
    this.#tell((listener) => listener.drawn?.());
  }

  /** A frame has come from the worker. */
  #take(frame: Frame): void {
    if (frame.run !== this.scene?.run) return;
    this.#keepShapes(frame);
    const { player } = this;
    const made = frame.step - player.newest;
    // A match that waits for inputs of its players, and a recording at its end, make no step.
    const stands = frame.ended && made === 0;
    // A player who joins a running match begins at a late step, and makes several steps at once to
    // catch up with the others.
    const leaps = this.state.match !== null && frame.step > player.wanted;
    if (player.paused || stands || leaps) player.jump(frame);
    else player.take(frame);
    this.#owed = Math.max(0, this.#owed - made);
    if (frame.samples.length > 0) this.#tell((listener) => listener.samples?.(frame.samples));
    this.#tell((listener) => listener.frame?.(frame));
    // If the worker has not kept up with the display, it gets its next request now, without waiting
    // for the next picture.
    if (!player.paused && !stands) this.requestFrame();
  }

  #keepShapes(frame: Frame): void {
    if (frame.shapes) this.shapes = frame.shapes;
  }

  #tell(call: (listener: Listener) => void): void {
    for (const listener of this.#listeners) call(listener);
  }
}
