/**
 * Networked play without waiting: a peer plays each step at once by the inputs that it knows, takes
 * the others to hold what they held last, and plays again what that was wrong in. Inputs alone are
 * sent.
 *
 *     const rollback = new Rollback(world, { idle: [0, 0], step });
 *     rollback.input(me, rollback.steps, held); // and another's as it arrives, with its step
 *     rollback.advance();
 */
import { ThudError } from "../error.js";
import type { Mover, MoverState } from "../mover.js";
import { checkNames } from "../checks/names.js";
import type { World } from "../world.js";

const DEEPEST = 1000;

/** Inputs are compared by `===`: numbers and strings serve. */
export interface RollbackOptions<Input, State> {
  /** One for each player: what it holds until something is known of it. */
  idle: readonly Input[];
  /**
   * Plays one step: does what each player's input says, and calls `world.step()`. From the same
   * world, state and inputs it does the same, on every peer; nothing else changes the world.
   */
  step: (inputs: readonly Input[], state: State) => void;
  /** What a game keeps beside its world, score and all: plain data, for `step` to change. */
  state?: State;
  /** Who goes back with the world. Default none. */
  movers?: readonly Mover[];
  /** How many steps an input may be late, 1 to 1000. Default 60. */
  depth?: number;
}

/** What was before a step, and what the step was played with. */
interface Moment<Input, State> {
  snapshot: Uint8Array;
  hash: string;
  state: State;
  movers: MoverState[];
  inputs: readonly Input[];
}

/** What is known of a player: its inputs by step, all of them before one. */
interface Known<Input> {
  readonly inputs: Map<number, Input>;
  before: number;
}

/** Of one world, which it steps; it holds nothing that is to be freed. */
export class Rollback<Input = number, State = undefined> {
  readonly #world: World;
  readonly #idle: readonly Input[];
  readonly #step: (inputs: readonly Input[], state: State) => void;
  readonly #movers: readonly Mover[];
  readonly #depth: number;
  /** Of the last steps. */
  readonly #moments = new Map<number, Moment<Input, State>>();
  readonly #known: readonly Known<Input>[];
  #state: State;
  #steps = 0;
  #replayed = 0;
  /** The first step that is to be played again. */
  #wrong = Infinity;

  constructor(world: World, options: RollbackOptions<Input, State>) {
    checkNames("rollback", options, ["idle", "step", "state", "movers", "depth"]);
    const { idle, step, state, movers = [], depth = 60 } = options;
    if (!Array.isArray(idle) || idle.length === 0)
      throw new ThudError("invalid", "rollback: idle has an input for each player");
    if (typeof step !== "function") throw new ThudError("invalid", "rollback: step is a function");
    if (!Number.isInteger(depth) || depth < 1 || depth > DEEPEST)
      throw new ThudError("invalid", `rollback: depth is whole, from 1 to ${DEEPEST}`);
    this.#world = world;
    this.#idle = [...idle];
    this.#step = step;
    this.#movers = [...movers];
    this.#depth = depth;
    this.#known = idle.map(() => ({ inputs: new Map(), before: 0 }));
    this.#state = structuredClone(state) as State;
  }

  /** How many steps were made: the number of the next. */
  get steps(): number {
    return this.#steps;
  }

  /** Before this step every input is known: nothing there is played again. */
  get confirmed(): number {
    return Math.min(this.#steps, ...this.#known.map(({ before }) => before));
  }

  /** How many steps were played again, in all. */
  get replayed(): number {
    return this.#replayed;
  }

  /** The game's own, as of now. */
  get state(): State {
    this.settle();
    return this.#state;
  }

  /**
   * What a player held in a step, from 0 on: in any order, late, early, or once more. Throws for one
   * more than `depth` steps ahead, or another than was told before.
   */
  input(player: number, step: number, input: Input): void {
    const known = this.#known[player] as Known<Input> | undefined;
    if (!known) throw new ThudError("invalid", `rollback: there is no player ${player}`);
    if (!Number.isInteger(step) || step < 0 || step > this.#steps + this.#depth)
      throw new ThudError("invalid", `rollback: step ${step} is none, or too far ahead`);
    if (known.inputs.has(step) && known.inputs.get(step) !== input)
      throw new ThudError("invalid", `rollback: player ${player} held two inputs in step ${step}`);
    if (step < known.before) return;
    known.inputs.set(step, input);
    while (known.inputs.has(known.before)) known.before++;
    const moment = this.#moments.get(step);
    if (step < this.#steps && moment && moment.inputs[player] !== input)
      this.#wrong = Math.min(this.#wrong, step);
  }

  /**
   * Plays again what was wrong, and the next step. False, and the next step is not made, while an
   * input of `depth` steps ago is not known: then wait for the others.
   */
  advance(): boolean {
    this.settle();
    if (this.#steps - this.confirmed >= this.#depth) return false;
    this.#play(this.#steps);
    this.#steps++;
    // The moment before the earliest that may be wrong is kept: who is not known holds what it held.
    const old = this.#steps - this.#depth - 2;
    this.#moments.delete(old);
    for (const { inputs } of this.#known) inputs.delete(old);
    return true;
  }

  /** Plays again what was wrong, and no more. Returns how many steps that were. */
  settle(): number {
    const from = this.#wrong;
    const moment = this.#moments.get(from);
    if (!moment) return 0;
    this.#world.restore(moment.snapshot);
    this.#movers.forEach((mover, i) => mover.restore(moment.movers[i]));
    this.#state = moment.state;
    for (let step = from; step < this.#steps; step++) this.#play(step);
    this.#wrong = Infinity;
    this.#replayed += this.#steps - from;
    return this.#steps - from;
  }

  /**
   * The world's hash before a step, of the last `depth`: the same on all peers up to `confirmed`, or
   * else the game's `step` does not do the same everywhere.
   */
  hashAt(step: number): string {
    this.settle();
    const hash = step === this.#steps ? this.#world.hash() : this.#moments.get(step)?.hash;
    if (hash === undefined) throw new ThudError("invalid", `rollback: step ${step} is not kept`);
    return hash;
  }

  /** Whatever throws in between, the next `settle` begins here again. */
  #play(step: number): void {
    const world = this.#world;
    const before = this.#moments.get(step - 1)?.inputs ?? this.#idle;
    const held = ({ inputs }: Known<Input>, player: number) =>
      inputs.has(step) ? (inputs.get(step) as Input) : before[player];
    const inputs = this.#known.map(held);
    this.#moments.set(step, {
      snapshot: world.snapshot(),
      hash: world.hash(),
      state: structuredClone(this.#state),
      movers: this.#movers.map((mover) => mover.state()),
      inputs,
    });
    this.#wrong = step;
    this.#step(inputs, this.#state);
    this.#wrong = Infinity;
  }
}
