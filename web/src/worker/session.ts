/** A running scene: its world, its time, and the visitor's hands in it. */
import type { Vec2, World } from "thud";
import type { Sample } from "../scene/frame";
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
import { unseen } from "./watch";

type PointerCommand = Extract<Command, { kind: "pointer" }>;

/** What the visitor's hands hold; plain data, kept with every moment of the past. */
interface Hands {
  pull: Pull | null;
  held: Record<KeyName, boolean>;
  pointer: Input["pointer"];
}

/** Another engine that goes along; see box2d/companion.ts. */
export interface Companion {
  /** The first thing of a step. */
  begin(): void;
  /** Does something to the world that it does to its own bodies in its own way. */
  apart(act: () => void): void;
  explode(blast: Blast): void;
  /** Just before the world's step: follows what the scene did. */
  sync(): void;
  /** After the world's step, makes the same. */
  step(): Sample["box2d"];
  /** The world ends or goes to another time, from which it begins anew. */
  end(): void;
  /** Of the last two steps, laid out as World.poses; to be given away. */
  poses(origin: Vec2): { before: Float32Array; now: Float32Array };
}

export class Session {
  readonly world: World;
  readonly history = new History();
  /** Steps since the scene began. */
  step = 0;
  paint: Paint | null = null;
  samples: Sample[] = [];
  companion: Companion | null = null;
  /** Why there is no companion although one is wanted. */
  box2dTrouble: string | null = null;
  readonly #hands: Hands = { pull: null, held: noKeys(), pointer: null };
  /** What the visitor does at this moment, wherever in time the scene is. */
  readonly #present: Pick<Hands, "held" | "pointer"> & {
    pulls: boolean;
    adjustment: Adjustment | null;
  } = { pulls: false, held: { ...this.#hands.held }, pointer: null, adjustment: null };
  /** The hands are those of a moment that was gone to. */
  #sought = false;
  /** Since the last step. */
  #done: Command[] = [];

  constructor(
    readonly run: number,
    readonly scene: Scene,
    readonly size: number,
    readonly sizes: SceneSize | null,
    readonly lengthScale: number,
    readonly timeStep: number,
    readonly title: string | null,
    /** Whatever else the scene made and its world does not own. */
    readonly others: readonly { close(): void }[],
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

  /** Does something to the world; a step later it is in the journal. */
  do(command: Command): void {
    this.#apply(command);
    this.#heed(command);
    this.#note(command);
  }

  #note(command: Command): void {
    const last = this.#done.at(-1);
    if (last && replaces(command, last, this.#done.at(-2))) this.#done.pop();
    this.#done.push(command);
  }

  makeStep(): void {
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
      penetration: world.error().penetrationMax,
      awake: awakeBodies,
      box2d: this.companion?.step(),
    });
    if (this.history.wants(this.step, 1000 * stepSeconds, bytes)) this.#keepMoment();
  }

  /** Goes to a step of the past, or on from there; false if it is out of reach. */
  seek(step: number): boolean {
    const moment = this.history.before(step);
    if (!moment || step > this.history.last) return false;
    // What was done since the last step is no part of the past.
    const edited = this.#done.length > 0;
    this.#done = [];
    // A body that is held stays behind.
    this.#present.pulls = false;
    this.#sought = true;
    if (step !== this.step || edited) this.companion?.end();
    if (step < this.step || moment.step > this.step || edited) this.#goTo(moment);
    this.#runAgain(step);
    return true;
  }

  /**
   * Runs the last steps again, from the newest moment that lies at least so far back, with the
   * same commands. Leaves everything as it is.
   */
  rerun(steps: number): Rerun {
    const present = this.#moment();
    const { step, hash } = this.hash;
    const moment = this.history.before(Math.max(this.history.first, step - steps));
    if (!moment) throw new Error("Nothing of the past is kept yet.");
    this.companion?.end();
    this.#goTo(moment);
    this.#runAgain(step);
    // What was done since the last step belongs to the present.
    for (const command of this.#done) this.#apply(command);
    const again = this.world.hash();
    this.#goTo(present);
    return { from: moment.step, step, hash, again };
  }

  get hash(): StateHash {
    return { step: this.step, hash: this.world.hash() };
  }

  /** On to a step of the past, with the commands of the journal. */
  #runAgain(step: number): void {
    while (this.step < step) {
      for (const command of this.history.commandsAt(this.step)) this.#apply(command);
      this.#advance(null);
    }
  }

  /** What the visitor does now, as far as the past has no part in it. */
  #heed(command: Command): void {
    const present = this.#present;
    if (command.kind === "grab") present.pulls = true;
    else if (command.kind === "release") present.pulls = false;
    else if (command.kind === "keys") Object.assign(present.held, command.held);
    else if (command.kind === "pointer") present.pointer = pointerOf(command);
    else if (command.kind === "choose") present.adjustment = command;
  }

  /** From a moment of the past time goes on with what the visitor does and has chosen now: what was
   * held then and let go later would be held for ever. */
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

  /** By hand each engine's bodies are taken as they are there. */
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

  #point(command: PointerCommand): void {
    const pointer = pointerOf(command);
    this.#hands.pointer = pointer;
    if (!this.scene.pointed) return;
    this.scene.pointed(pointer);
    this.paint = this.scene.paint?.() ?? null;
  }

  /** Seen also while the scene stands. */
  #set({ name, value }: Extract<Command, { kind: "set" }>): void {
    const { controls = [], state } = this.scene;
    if (!state || !controls.some((control) => control.name === name)) return;
    Object.assign(state, { [name]: value });
    this.paint = this.scene.paint?.() ?? null;
  }

  #adjust(choices: Adjustment): void {
    // Between two qualities, one of which may be without what holds a largest error.
    this.world.setMaxError(0);
    this.world.setQuality(choices.quality, choices.substeps);
    this.world.setMaxError(maxErrorOf(choices) * this.lengthScale);
  }
}

function pointerOf({ x, y, down }: PointerCommand): NonNullable<Input["pointer"]> {
  return { x, y, down };
}

/**
 * Of moves, or settings of one control, without a step between them only the last counts; a press or
 * release is none, nor is the pointer's first move after it.
 */
function replaces(command: Command, last: Command, before?: Command): boolean {
  if (command.kind === "pointer")
    return [last, before].every((one) => one?.kind === "pointer" && one.down === command.down);
  if (command.kind === "set") return last.kind === "set" && last.name === command.name;
  return command.kind === "drag" && last.kind === "drag";
}

/** In length scales. Draft has no direct solver, and so nothing that could hold one. */
export function maxErrorOf({ quality, maxError }: Pick<Choices, "quality" | "maxError">): number {
  return quality === "draft" ? 0 : maxError;
}

/** A visitor's scene may have closed some of them before, and its own `close` may throw. */
export function closeAll(made: Iterable<{ close?(): void }>): void {
  for (const one of made)
    try {
      one.close?.();
    } catch (error) {
      console.warn("Something that a scene made cannot be closed:", error);
    }
}

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

/** The same object with other contents: scenes hold on to it. */
function replace(target: object, source: object): void {
  for (const key of Object.keys(target))
    if (!(key in source)) delete (target as Record<string, unknown>)[key];
  Object.assign(target, source);
}
