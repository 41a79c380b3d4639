/** A running scene: its world, its present step and its past, and what the visitor holds in it. */
import type { Vec2, World } from "thud";
import type { Calls, Sample } from "../scene/frame";
import {
  type Input,
  KEY_NAMES,
  type KeyName,
  noKeys,
  type Paint,
  type Scene,
  type SceneSize,
} from "../scene/scene";
import { type Adjustment, type Command, dig, reachedBy, spawn } from "./commands";
import { type Blast, explode } from "./hands";
import { History, type Moment } from "./history";
import { aimHold, holds, letGo, moveHold, type Pull, takeHold } from "./hold";
import type { Choices, Rerun, StateHash } from "./protocol";
import { SceneError } from "./trouble";
import { recordOf, unseen } from "./watch";

type PointerCommand = Extract<Command, { kind: "pointer" }>;

/**
 * What the visitor holds: a body, keys and the pointer. Plain data, kept with every moment of the
 * past.
 */
interface Hands {
  pull: Pull | null;
  held: Record<KeyName, boolean>;
  pointer: Input["pointer"];
}

/**
 * Another engine that runs beside the scene. It is called at the points of a step that are named
 * here; see box2d/companion.ts.
 */
export interface Companion {
  /** At the beginning of a step, before the scene's code. */
  begin(): void;
  /**
   * Runs `act`, which changes the thud world, without the companion copying the change: the
   * companion is given a command of its own for it.
   */
  apart(act: () => void): void;
  /** The companion's own version of a blast. */
  explode(blast: Blast): void;
  /** Just before the world's step: copies what the scene's code did. */
  sync(): void;
  /** After the world's step: makes the companion's step, and returns its sample. */
  step(): Sample["box2d"];
  /** The world is closed, or goes to another time. The next `begin` copies the world anew. */
  end(): void;
  /**
   * Poses before and after the last step, laid out like World.poses; the buffers are the caller's.
   */
  poses(origin: Vec2): { before: Float32Array; now: Float32Array };
}

export class Session {
  readonly world: World;
  /** Number of steps made since the scene began. */
  step = 0;
  /** What the scene's `paint` returned last. */
  paint: Paint | null = null;
  /** A step has failed halfway: the world may not be that of any step. */
  broken = false;
  /** The samples of the steps since the last frame. */
  samples: Sample[] = [];
  companion: Companion | null = null;
  /** Why no companion runs although the page wants one. */
  box2dTrouble: string | null = null;
  readonly #hands: Hands = { pull: null, held: noKeys(), pointer: null };
  /**
   * What the visitor really holds now. It differs from `#hands` while the scene shows a step of the
   * past. `pulls`: whether the visitor pulls a body; `adjustment`: the last choices.
   */
  readonly #present: Pick<Hands, "held" | "pointer"> & {
    pulls: boolean;
    adjustment: Adjustment | null;
  } = { pulls: false, held: { ...this.#hands.held }, pointer: null, adjustment: null };
  /** Whether `#hands` are those of a moment of the past, from which no step has been made yet. */
  #sought = false;
  /** The commands since the last step. */
  #done: Command[] = [];

  /** `others`: what else the scene made that the world does not own. */
  constructor(
    readonly run: number,
    readonly scene: Scene,
    readonly size: number,
    readonly sizes: SceneSize | null,
    readonly lengthScale: number,
    readonly timeStep: number,
    readonly title: string | null,
    readonly others: readonly { close(): void }[],
    readonly history = new History(),
  ) {
    this.world = scene.world;
    this.paint = scene.paint?.() ?? null;
    this.#keepMoment();
  }

  close(): void {
    const { companion, scene, others, world } = this;
    companion?.end();
    closeAll([scene, ...others, world]);
  }

  get pull(): Pull | null {
    return this.#hands.pull;
  }

  /** The step after which there is none; a scene goes on for ever. */
  get end(): number {
    return Infinity;
  }

  /** The calls that led to this step; undefined unless they are listed. */
  get calls(): Calls | undefined {
    return undefined;
  }

  /** Begins or ends to list and draw the calls of each step. Only recordings know them. */
  listCalls(_on: boolean): void {}

  /** Whether the world may have joints. */
  get tied(): boolean {
    return recordOf(this.world)?.tied ?? false;
  }

  /** Applies a command to the world at once; the next step puts it into the journal. */
  do(command: Command): void {
    this.#apply(command);
    this.#heed(command);
    this.#note(command);
  }

  /** Adds a command to those of this step, or puts it in place of the last one. */
  #note(command: Command): void {
    const last = this.#done.at(-1);
    if (last && replaces(command, last, this.#done.at(-2))) this.#done.pop();
    this.#done.push(command);
  }

  /** Makes a step, and keeps a moment where the history wants one. */
  makeStep(): void {
    this.broken = true;
    this.#makeStep();
    this.broken = false;
  }

  /** The step itself; `broken` says whether it has come to its end. */
  #makeStep(): void {
    if (this.#sought) this.#takeOver();
    const commands = this.#done;
    this.#done = [];
    this.history.note(this.step, commands);
    this.companion?.begin();
    this.#advance(this.companion);
    const { world } = this;
    const { stepSeconds, bytes, awakeBodies } = world.stats();
    this.samples.push({
      step: this.step,
      milliseconds: 1000 * stepSeconds,
      penetration: world.stepError().penetrationMax,
      awake: awakeBodies,
      box2d: this.companion?.step(),
    });
    if (this.history.wants(this.step, 1000 * stepSeconds, bytes)) this.#keepMoment();
  }

  /**
   * Goes to a step of the past, or forward again to a later one that was made. False if that step
   * is not kept, or was never made.
   */
  seek(step: number): boolean {
    const moment = this.history.before(step);
    if (!moment || step > this.history.last) return false;
    // Commands since the last step are undone, as they are not in the journal, and so is half a step.
    const edited = this.#done.length > 0 || this.broken;
    this.#done = [];
    // The visitor lets go of a body that is held.
    this.#present.pulls = false;
    this.#sought = true;
    this.broken = false;
    if (step !== this.step || edited) this.companion?.end();
    if (step < this.step || moment.step > this.step || edited) this.#goTo(moment);
    this.#runAgain(step);
    return true;
  }

  /**
   * Runs the last steps again with the same commands, from the newest moment at least `steps` steps
   * back (or the oldest one), and compares the hashes. The present state is restored afterwards.
   */
  rerun(steps: number): Rerun {
    const { step, hash } = this.hash;
    const moment = this.history.before(Math.max(this.history.first, step - steps));
    if (!moment) throw new Error("Nothing of the past is kept yet.");
    const again = this.#inThePast(moment, () => {
      this.#runAgain(step);
      // Commands since the last step are applied again, as they are part of the present state.
      for (const command of this.#done) this.#apply(command);
      return this.world.hash();
    });
    return { from: moment.step, step, hash, again };
  }

  /**
   * Reads the world as it was before a step of the past and after it. `read` is called twice. The
   * present state is restored afterwards.
   */
  review<T>(step: number, read: () => T): [before: T, after: T] {
    const moment = step > this.step ? undefined : this.history.before(step - 1);
    if (!moment) throw new Error(`Step ${step} is not kept any more, or has not been made.`);
    return this.#inThePast(moment, () => {
      this.#runAgain(step - 1);
      const before = read();
      this.#runAgain(step);
      return [before, read()];
    });
  }

  /** Runs `act` from a moment of the past on, and restores the present state afterwards. */
  #inThePast<T>(moment: Moment, act: () => T): T {
    const present = this.#moment();
    this.companion?.end();
    this.#goTo(moment);
    try {
      return act();
    } finally {
      this.#goTo(present);
    }
  }

  /**
   * Brings another session of the same scene, which may run in another engine, to the oldest step
   * that this session's history keeps.
   */
  startIn(other: Session): void {
    other.#goTo(this.history.before(this.history.first)!);
  }

  /**
   * Makes the same steps up to the present one in another session, which startIn has prepared, with
   * the same commands. `made` is called after each step.
   */
  repeatIn(other: Session, made: (step: number) => void): void {
    while (other.step < this.step) {
      for (const command of this.history.commandsAt(other.step)) other.#apply(command);
      other.#advance(null);
      made(other.step);
    }
    for (const command of this.#done) other.#apply(command);
  }

  get hash(): StateHash {
    return { step: this.step, hash: this.world.hash() };
  }

  /** Runs on to a step of the past, with the commands of the journal. */
  #runAgain(step: number): void {
    while (this.step < step) {
      for (const command of this.history.commandsAt(this.step)) this.#apply(command);
      this.#advance(null);
    }
  }

  /** Notes what the visitor holds now. */
  #heed(command: Command): void {
    const present = this.#present;
    if (command.kind === "grab") present.pulls = true;
    else if (command.kind === "release") present.pulls = false;
    else if (command.kind === "keys") Object.assign(present.held, command.held);
    else if (command.kind === "pointer") present.pointer = pointerOf(command);
    else if (command.kind === "choose") present.adjustment = command;
  }

  /**
   * Goes on from a moment of the past with what the visitor holds and has chosen now. Without this,
   * a key or a body that was held at that moment, and is not now, would be held for ever.
   */
  #takeOver(): void {
    this.#sought = false;
    const { pulls, held, pointer, adjustment } = this.#present;
    const hands = this.#hands;
    const commands: Command[] = [];
    if (adjustment) commands.push({ kind: "choose", ...adjustment });
    if (hands.pull && !pulls) commands.push({ kind: "release" });
    if (KEY_NAMES.some((name) => hands.held[name] !== held[name]))
      commands.push({ kind: "keys", held: { ...held } });
    if (hands.pointer?.down && !pointer?.down)
      commands.push({ kind: "pointer", ...(pointer ?? hands.pointer), down: false });
    for (const command of commands) {
      this.#apply(command);
      this.#note(command);
    }
  }

  /**
   * One step: the pull, the scene's code, and the world's step. `companion` is null while steps are
   * run again.
   */
  #advance(companion: Companion | null): void {
    const hands = this.#hands;
    if (hands.pull && !holds(this.world, hands.pull)) this.#release();
    if (hands.pull) aimHold(this.world, hands.pull, this.lengthScale);
    this.scene.update?.({ step: this.step, held: hands.held, pointer: hands.pointer });
    companion?.sync();
    this.world.step();
    this.scene.stepped?.();
    this.step++;
    this.paint = this.scene.paint?.() ?? null;
  }

  #apply(command: Command): void {
    const { world } = this;
    const hands = this.#hands;
    switch (command.kind) {
      case "grab":
        this.#release();
        hands.pull = takeHold(world, command, this.lengthScale);
        break;
      case "drag":
        if (hands.pull) moveHold(world, hands.pull, [command.x, command.y]);
        break;
      case "release":
        this.#release();
        break;
      case "spawn":
        spawn(world, command);
        break;
      case "explode":
        this.#apart(() => explode(world, reachedBy(world, command), command));
        this.companion?.explode(command);
        break;
      case "dig":
        dig(world, command);
        break;
      case "keys":
        Object.assign(hands.held, command.held);
        break;
      case "pointer":
        this.#point(command);
        break;
      case "set":
        this.#set(command);
        break;
      case "choose":
        this.#adjust(command);
        break;
    }
  }

  #release(): void {
    const { pull } = this.#hands;
    this.#hands.pull = null;
    if (pull) letGo(this.world, pull);
  }

  /**
   * Runs `act`, a blast in the thud world, without the companion copying it: the companion applies
   * the blast to its own bodies, which may be in other places.
   */
  #apart(act: () => void): void {
    if (this.companion) this.companion.apart(act);
    else act();
  }

  #keepMoment(): void {
    this.history.keep(this.#moment());
  }

  #moment(): Moment {
    return {
      step: this.step,
      world: this.world.snapshot(),
      rest: { hands: structuredClone(this.#hands), state: copyOf(this.scene.state) },
    };
  }

  /** Restores a moment. */
  #goTo(moment: Moment): void {
    const rest = structuredClone(moment.rest) as { hands: Hands; state: object | null };
    const { state } = this.scene;
    if (state && rest.state) replace(state, rest.state);
    unseen(this.world, () => this.world.restore(moment.world));
    this.step = moment.step;
    Object.assign(this.#hands, rest.hands);
    this.scene.restored?.();
    this.paint = this.scene.paint?.() ?? null;
  }

  /** Gives the scene the pointer, which it may use at once, also while it is paused. */
  #point(command: PointerCommand): void {
    const pointer = pointerOf(command);
    this.#hands.pointer = pointer;
    if (!this.scene.pointed) return;
    this.scene.pointed(pointer);
    this.paint = this.scene.paint?.() ?? null;
  }

  /**
   * Sets one of the scene's controls. The picture is updated at once, also while the scene is
   * paused.
   */
  #set({ name, value }: Extract<Command, { kind: "set" }>): void {
    const { controls = [], state } = this.scene;
    if (!state || !controls.some((control) => control.name === name)) return;
    Object.assign(state, { [name]: value });
    this.paint = this.scene.paint?.() ?? null;
  }

  #adjust(choices: Adjustment): void {
    // The error limit is off while the quality changes: draft, which has no direct solver, cannot
    // have one.
    this.world.setMaxError(0);
    this.world.setQuality(choices.quality, choices.substeps);
    this.world.setMaxError(maxErrorOf(choices) * this.lengthScale);
  }
}

/** The state of the pointer after a command. */
function pointerOf({ x, y, down }: PointerCommand): NonNullable<Input["pointer"]> {
  return { x, y, down };
}

/**
 * Whether a command takes the place of the one before it (`last`) in the same step. Of several
 * moves of the pointer, or of several settings of one control, only the last has an effect. A
 * pointer command replaces the last one only if the last two have the same `down`, so that presses
 * and releases are kept.
 */
function replaces(command: Command, last: Command, before?: Command): boolean {
  if (command.kind === "pointer")
    return [last, before].every((one) => one?.kind === "pointer" && one.down === command.down);
  if (command.kind === "set") return last.kind === "set" && last.name === command.name;
  return command.kind === "drag" && last.kind === "drag";
}

/** The largest error to be set, in length scales. 0 (off) for draft, which has no direct solver. */
export function maxErrorOf({ quality, maxError }: Pick<Choices, "quality" | "maxError">): number {
  return quality === "draft" ? 0 : maxError;
}

/**
 * Closes what a scene made. Errors are only logged: a scene may have closed some of it before, and
 * its own `close` may throw.
 */
export function closeAll(made: Iterable<{ close?(): void }>): void {
  for (const one of made)
    try {
      one.close?.();
    } catch (error) {
      console.warn("Something that a scene made cannot be closed:", error);
    }
}

/** A copy of the scene's state. Throws a SceneError if it is not plain data. */
function copyOf(state: object | undefined): object | null {
  try {
    return structuredClone(state ?? null);
  } catch (error) {
    throw new SceneError({
      message:
        "A scene's state is plain data, which every moment of the past keeps: " +
        (error instanceof Error ? error.message : String(error)),
    });
  }
}

/**
 * Replaces the contents of an object, which stays the same because scenes keep a reference to it.
 */
function replace(target: object, source: object): void {
  for (const key of Object.keys(target))
    if (!(key in source)) delete (target as Record<string, unknown>)[key];
  Object.assign(target, source);
}
