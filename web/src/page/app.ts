/**
 * The running page: what is chosen, the scene that runs, its time. Controls and panels act through
 * it and listen to it; they do not know each other.
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

export interface Listener {
  /** A scene begins, or begins anew. */
  run?(scene: RunningScene): void;
  /** A frame is about to be drawn; only when it is another than the last. */
  frame?(frame: Frame): void;
  /** Steps were made. */
  samples?(samples: readonly Sample[]): void;
  /** Something was chosen. */
  state?(state: Readonly<State>): void;
  /** The scene cannot be run, or stopped with an error. `running`: it had begun. */
  trouble?(trouble: Trouble, running: boolean): void;
  /** Code came with the page's address, or is not offered any more. */
  offer?(code: string | null): void;
  /** The worker has not answered for a long time. */
  stuck?(): void;
  /** After all it does. */
  answers?(): void;
}

/** What a scene may be opened with. */
type Opening = Partial<Pick<State, "code" | "size" | "seed" | "camera" | "claim" | "level">>;

/** What a scene began with. */
type Begun = Pick<State, "scene" | "code" | "size" | "seed" | "level">;

export class App {
  readonly client: Client;
  readonly player = new Player();
  readonly state: State = {
    scene: "towers",
    level: null,
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
  scene: RunningScene | null = null;
  /** It stands still because less motion is wanted, and for no other reason. */
  waitsForMotion = false;
  /** Of the running scene, as the last frame with shapes had them. */
  shapes: Shapes | null = null;
  /** By scene. They come after the first picture. */
  abouts: Readonly<Record<string, string>> | null = null;
  /** Code of a link that has not been run; the address keeps it. */
  offeredCode: string | null = null;
  /** The engine's files, for further workers. */
  wasm: ChosenWasm = { wasm: "", simd: true };
  readonly #listeners = new Set<Listener>();
  readonly #look: () => Look;
  /** Single steps that are asked for and not yet made. */
  #owed = 0;
  /** An error stopped the scene, and not the visitor: the next one runs. */
  #halted = false;
  /** Whether the standing picture must be made anew. */
  #stale = false;
  /** What runs: `state` goes back to it if what is to come after it cannot be run. */
  #running: Begun | null = null;
  /** Of scenes that are asked for one after the other the last one runs. */
  #runs = 0;
  /** Of addresses that are written one after the other the last one stays. */
  #addresses = 0;
  /** The address is another one, of which is not known yet what it says. */
  #left = false;
  /** The next scene is that of the address, and not another after it. */
  #arrives = true;
  /** The next address is that of another scene: Back goes to the one before. */
  #goesOn = false;

  /** `look` tells what the page sees and what shall be drawn there by the engine. */
  constructor(look: () => Look) {
    this.#look = look;
    this.client = new Client({
      frame: (frame) => this.#take(frame),
      trouble: (trouble) => this.#stop(trouble, true),
      stuck: () => this.#tell((listener) => listener.stuck?.()),
      answers: () => this.#tell((listener) => listener.answers?.()),
    });
  }

  listen(listener: Listener): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  async load(wasm: ChosenWasm): Promise<void> {
    this.wasm = wasm;
    await this.client.load(wasm);
  }

  // ---- scenes ----

  /** Runs another scene; true if it does. */
  async open(scene: string, more: Opening = {}): Promise<boolean> {
    const { state } = this;
    state.scene = scene;
    state.code = more.code ?? null;
    state.size = more.size;
    state.seed = more.seed ?? 0;
    state.camera = more.camera ?? null;
    state.claim = more.claim ?? null;
    state.level = more.level ?? null;
    return this.#run();
  }

  /** Text of files that `readText` finds before those of the page. */
  get files(): Record<string, string> | undefined {
    return this.state.level?.files;
  }

  /** What is chosen now, as a worker is asked to run it. */
  get request(): SceneRequest {
    const { scene, code, size, seed, choices } = this.state;
    return { name: scene, code: code ?? undefined, files: this.files, size, seed, choices };
  }

  /** Runs the scene from its beginning, with what is chosen now. */
  async restart(): Promise<boolean> {
    // What was claimed was about what had been chosen then.
    this.state.claim = null;
    return this.#run();
  }

  async #run(): Promise<boolean> {
    const number = ++this.#runs;
    try {
      const scene = await this.client.ask("run", this.request);
      if (number !== this.#runs) return false;
      this.#begin(scene);
      return true;
    } catch (error) {
      if (number !== this.#runs) return false;
      this.#stop(
        error instanceof TroubleError ? error.trouble : { message: messageOf(error) },
        false,
      );
      this.#keepRunning();
      return false;
    }
  }

  /** Ends a worker that does not answer, and starts with this scene. */
  async revive(scene: string): Promise<void> {
    await this.#startWorker();
    await this.open(scene);
  }

  /**
   * Ends a visitor's code that does not answer. Goes back to what ran before it, if it never began,
   * else to the scene as it comes.
   */
  async endCode(): Promise<void> {
    const { camera, code: ended } = this.state;
    const before = this.#running?.code === ended ? null : this.#running;
    await this.#startWorker();
    const { scene, ...more } = before ?? { ...this.#running, scene: this.state.scene, code: null };
    await this.open(scene, { ...more, camera });
  }

  async #startWorker(): Promise<void> {
    // What the old one was asked to run is not missed.
    this.#runs++;
    this.client.restart();
    // No frame can be asked for until a scene runs in the new one.
    this.scene = null;
    await this.load(this.wasm);
  }

  /** Of what runs: a visitor's code is told from the scene that it was. */
  get title(): string {
    const { code, level } = this.state;
    const title = findScene(this.state.scene)?.title ?? level?.name ?? "";
    return code === null ? title : `${this.scene?.title ?? title}, edited`;
  }

  /** What to look at; "" also as long as `abouts` are not there. */
  get about(): string {
    return this.abouts?.[this.state.scene] ?? "";
  }

  /** The address is another one: nothing is written there before `begin` tells what it says. */
  leaveAddress(): void {
    this.#left = true;
  }

  /** What an address says, before its scene. */
  begin({ choices, versus, speed, paused, overlays, result }: Partial<State>): void {
    // What was to be written of the scene before is not of this address.
    this.#addresses++;
    this.#left = false;
    this.#arrives = true;
    this.#goesOn = false;
    this.state.result = result ?? null;
    if (choices) Object.assign(this.state.choices, choices);
    if (versus) Object.assign(this.state.versus, versus);
    if (overlays) this.state.overlays = overlays;
    this.state.speed = this.player.speed = speed ?? 1;
    // Whoever asked for less motion starts it deliberately.
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.waitsForMotion = still && paused === undefined;
    this.state.paused = this.player.paused = paused ?? still;
  }

  /** Code that came with a link: shown, and run when the visitor says so. Null: not any more. */
  offerCode(code: string | null): void {
    this.offeredCode = code;
    this.#tell((listener) => listener.offer?.(code));
    this.chosen();
  }

  #begin(scene: RunningScene): void {
    // The scene has bounds for it.
    if (this.state.size !== undefined) this.state.size = scene.sizes ? scene.size : undefined;
    const { scene: name, code, size, seed, level } = this.state;
    this.scene = scene;
    if (code !== null || name !== this.#running?.scene) this.offeredCode = null;
    if (!this.#arrives && (name !== this.#running?.scene || level !== this.#running.level))
      this.#goesOn = true;
    this.#arrives = false;
    this.#running = { scene: name, code, size, seed, level };
    this.shapes = null;
    this.#owed = 0;
    if (this.#halted) this.setPaused(false);
    this.player.begin(scene.run, scene.timeStep);
    this.#tell((listener) => listener.run?.(scene));
    this.chosen();
    this.requestFrame();
  }

  #keepRunning(): void {
    if (this.#running) Object.assign(this.state, this.#running);
  }

  /** Ends the scene that runs, for what the page found out about it. */
  end(trouble: Trouble): void {
    this.#stop(trouble, true);
  }

  #stop(trouble: Trouble, running: boolean): void {
    if (trouble.tooLarge) {
      // Its memory goes with it.
      this.client.close();
      this.scene = null;
    }
    if (running && !this.state.paused) this.#stand(true, true);
    this.#tell((listener) => listener.trouble?.(trouble, running));
  }

  // ---- choices ----

  /** What can be changed in a running world is; anything else starts the scene anew. */
  choose(change: Partial<Choices>): void {
    const { choices } = this.state;
    const anew =
      (change.detection ?? choices.detection) !== choices.detection ||
      (change.broadphase ?? choices.broadphase) !== choices.broadphase;
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

  #stand(paused: boolean, halted: boolean): void {
    this.state.paused = this.player.paused = paused;
    this.#halted = halted;
    if (paused) this.player.settle();
    this.chosen();
  }

  /** Tells everybody that `state` has changed, and keeps it in the address. */
  chosen(): void {
    this.#tell((listener) => listener.state?.(this.state));
    const number = ++this.#addresses;
    const code = this.state.code ?? this.offeredCode;
    // What an error stopped runs when the page is loaded again.
    const paused = this.state.paused && !this.#halted;
    void writeState({ ...this.state, code, paused }).then((address) => {
      if (number === this.#addresses && !this.#left) this.#write(address);
    });
  }

  #write(address: string): void {
    const method = this.#goesOn ? "pushState" : "replaceState";
    this.#goesOn = false;
    const { level } = this.state;
    try {
      // Levels that are too long for an address are found again with Back nevertheless.
      history[method]({ level }, "", address);
    } catch {
      history[method]({}, "", address);
    }
  }

  // ---- time ----

  do(command: Command): void {
    this.client.do(command);
    if (this.state.paused) this.refresh();
  }

  /** One step, shown at once; the scene stands still after it. */
  stepOnce(): void {
    if (!this.state.paused) this.setPaused(true);
    this.#owed++;
    this.requestFrame();
  }

  /** Goes to a step of the past, or on again. */
  async seek(step: number): Promise<void> {
    const frame = await this.client.ask("seek", { step, look: this.#look() });
    this.#keepShapes(frame);
    this.player.jump(frame);
    this.#tell((listener) => listener.frame?.(frame));
  }

  /** Once a frame of the display: asks the worker for what is needed next. */
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

  /** The standing picture must be made anew: another overlay, another part of the world. */
  refresh(): void {
    this.#stale = true;
  }

  #take(frame: Frame): void {
    if (frame.run !== this.scene?.run) return;
    this.#keepShapes(frame);
    const { player } = this;
    const made = frame.step - player.newest;
    if (player.paused) player.jump(frame);
    else player.take(frame);
    this.#owed = Math.max(0, this.#owed - made);
    if (frame.samples.length > 0) this.#tell((listener) => listener.samples?.(frame.samples));
    this.#tell((listener) => listener.frame?.(frame));
    // Where the worker is behind, it does not wait for the display.
    if (!player.paused) this.requestFrame();
  }

  #keepShapes(frame: Frame): void {
    if (frame.shapes) this.shapes = frame.shapes;
  }

  #tell(call: (listener: Listener) => void): void {
    for (const listener of this.#listeners) call(listener);
  }
}
