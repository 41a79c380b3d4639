/**
 * Rollback for networked games: each peer runs every step at once with the inputs that it knows,
 * and predicts for the other players their last known input. When an input arrives that differs
 * from the prediction, the peer restores the snapshot before that step and runs the steps since
 * then again. Only inputs are sent over the network.
 *
 *     const rollback = new Rollback(world, { idle: [0, 0], step });
 *     rollback.input(me, rollback.steps, held); // and another's as it arrives, with its step
 *     rollback.advance();
 */
import { ThudError } from "../error.js";
import type { Mover, MoverState } from "../mover.js";
import { checkOptions } from "../checks/names.js";
import type { World } from "../world.js";

/** The maximum of `depth`, steps (THUD_ROLLBACK_DEPTH_MAX). */
const DEEPEST = 1000;

/** Inputs are compared by `===`, so they should be numbers or strings. */
export interface RollbackOptions<Input, State> {
  /** For each player, its input before the first that is known. At least one player. */
  idle: readonly Input[];
  /**
   * Runs one step of the game: applies the input of each player, and calls `world.step()`. It must
   * be deterministic: the same world, state and inputs give the same result on every peer. Nothing
   * else may change the world.
   */
  step: (inputs: readonly Input[], state: State) => void;
  /** The game's data beside the world, such as the score: plain data, which `step` may change. */
  state?: State;
  /** The movers that are restored with the world. Default none. */
  movers?: readonly Mover[];
  /** The number of steps that an input may arrive late, 1 to 1000. Default 60. */
  depth?: number;
}

/** The state before a step, and the inputs with which the step was run. */
interface Moment<Input, State> {
  snapshot: Uint8Array;
  hash: string;
  state: State;
  movers: MoverState[];
  inputs: readonly Input[];
}

/** The known inputs of a player by step; those of all steps below `before` have arrived. */
interface Known<Input> {
  readonly inputs: Map<number, Input>;
  before: number;
}

/** The rollback of one world, which it steps. It needs no `close`. */
export class Rollback<Input = number, State = undefined> {
  readonly #world: World;
  readonly #idle: readonly Input[];
  readonly #step: (inputs: readonly Input[], state: State) => void;
  readonly #movers: readonly Mover[];
  readonly #depth: number;
  /** The moments of the last depth + 2 steps, by step. */
  readonly #moments = new Map<number, Moment<Input, State>>();
  readonly #known: readonly Known<Input>[];
  #state: State;
  #steps = 0;
  #replayed = 0;
  /** The first step with a wrong prediction, which is to be run again; Infinity: none. */
  #wrong = Infinity;

  /** @throws {ThudError} "invalid" for an unknown option or a value out of range. */
  constructor(world: World, options: RollbackOptions<Input, State>) {
    checkOptions("rollback", options, ["idle", "step", "state", "movers", "depth"]);
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

  /** The number of steps that were run, which is the number of the next step. */
  get steps(): number {
    return this.#steps;
  }

  /** All inputs of the steps before this one are known: they are final. */
  get confirmed(): number {
    return Math.min(this.#steps, ...this.#known.map(({ before }) => before));
  }

  /** How many times in all a step was run again. */
  get replayed(): number {
    return this.#replayed;
  }

  /** The game's data, after wrongly predicted steps were run again. */
  get state(): State {
    this.settle();
    return this.#state;
  }

  /**
   * Sets the input of a player, from 0 on, in a step, from 0 on. Inputs may come in any order,
   * late, early, or more than once.
   * @throws {ThudError} "invalid" for an unknown player, a step more than `depth` ahead, or another
   * input than was set for that step before.
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
   * Runs wrongly predicted steps again, and then the next step. Returns false, without the next
   * step, while an input of `depth` steps ago is not known: wait for the other peers then.
   */
  advance(): boolean {
    this.settle();
    if (this.#steps - this.confirmed >= this.#depth) return false;
    this.#play(this.#steps);
    this.#steps++;
    // The moment before the earliest step that may still be wrong is kept: its inputs are the
    // prediction for that step.
    const old = this.#steps - this.#depth - 2;
    this.#moments.delete(old);
    for (const { inputs } of this.#known) inputs.delete(old);
    return true;
  }

  /** Runs wrongly predicted steps again, and no further step. Returns the number of these steps. */
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
   * The world's hash before one of the last `depth` steps, or before the next one. Up to
   * `confirmed` it is the same on all peers; where it is not, the game's `step` is not
   * deterministic.
   * @throws {ThudError} "invalid" for a step that is not kept.
   */
  hashAt(step: number): string {
    this.settle();
    const hash = step === this.#steps ? this.#world.hash() : this.#moments.get(step)?.hash;
    if (hash === undefined) throw new ThudError("invalid", `rollback: step ${step} is not kept`);
    return hash;
  }

  /**
   * Keeps the moment before the step, and runs the step with known and predicted inputs. Where the
   * game's `step` throws, #wrong names this step, and the next `settle` starts from it.
   */
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
