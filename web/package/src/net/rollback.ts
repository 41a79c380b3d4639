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
import type { BodyId } from "../types.js";
import type { World } from "../world.js";
import { type Game, isMoverState, isStep, packGame, readState, unpackGame, writeState } from "./rollback-bytes.js";
import { hashOfBody, inputNumber, readReport, writeReport } from "./rollback-report.js";

/** The maximum of `depth`, steps (THUD_ROLLBACK_DEPTH_MAX). */
const DEEPEST = 1000;
/** Each lead that is heard of moves the smoothed one by this share of the difference. Chosen. */
const LEAD_SHARE = 1 / 16;

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
  /**
   * How `snapshot` writes the state, and `restore` reads it; with movers it is not possible. Who plays
   * with a program in C writes the bytes of that program's state. Default: as JSON, and a state that is
   * undefined as no bytes.
   */
  stateBytes?: { write(state: State): Uint8Array; read(bytes: Uint8Array): State };
  /** The movers that are restored with the world. Default none. */
  movers?: readonly Mover[];
  /** The number of steps that an input may arrive late, 1 to 1000. Default 60. */
  depth?: number;
  /** The most steps that `advance` runs again in one call, 0 to 1000; 0, the default: no limit. */
  budget?: number;
}

/** How a peer differs from the one that wrote a report. */
export interface RollbackDifference {
  /** The first step that both have kept before which the worlds differ; -1: they do not differ. */
  step: number;
  /**
   * The report has the bodies before that step. Otherwise the other fields say nothing: tell the
   * peer `step`, and compare its report of that step.
   */
  isDetailed: boolean;
  /** The first body that differs or is missing there; null: none, or one that is missing here. */
  body: BodyId | null;
  /** Its slot, the `index` of its handle; -1: none. */
  bodySlot: number;
  /** The number of bodies that differ. */
  bodies: number;
  /**
   * The first player whose input in the step before differs: it told its inputs differently. -1:
   * none, or inputs that are no longer kept.
   */
  player: number;
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
  /** No input of this step or a later one has been given. */
  told: number;
  /** Absent from one step until before the other; Infinity: never. */
  gone: number;
  back: number;
  /** `lead`, and the player's own, smoothed; null: not heard of. */
  leads: [number, number] | null;
}

const isAbsent = ({ gone, back }: Known<unknown>, step: number) => step >= gone && step < back;

/** The rollback of one world, which it steps. It needs no `close`. */
export class Rollback<Input = number, State = undefined> {
  readonly #world: World;
  readonly #idle: readonly Input[];
  readonly #step: (inputs: readonly Input[], state: State) => void;
  readonly #stateBytes: RollbackOptions<Input, State>["stateBytes"];
  readonly #movers: readonly Mover[];
  readonly #depth: number;
  readonly #budget: number;
  /** The moments of the last depth + 2 steps, by step. */
  readonly #moments = new Map<number, Moment<Input, State>>();
  readonly #known: readonly Known<Input>[];
  #state: State;
  #steps = 0;
  #replayed = 0;
  /** The step with which it began: 0, unless it has joined; and the inputs before it. */
  #first = 0;
  #base: readonly Input[];
  /** The step before which world and state are; -1: in the middle of one. */
  #at = 0;
  /** The first step with a wrong prediction, which is to be run again; Infinity: none. */
  #wrong = Infinity;

  /** @throws {ThudError} "invalid" for an unknown option or a value out of range. */
  constructor(world: World, options: RollbackOptions<Input, State>) {
    const names = ["idle", "step", "state", "stateBytes", "movers", "depth", "budget"];
    checkOptions("rollback", options, names);
    const { idle, step, state, stateBytes, movers = [], depth = 60, budget = 0 } = options;
    if (!Array.isArray(idle) || idle.length === 0)
      throw new ThudError("invalid", "rollback: idle has an input for each player");
    if (typeof step !== "function") throw new ThudError("invalid", "rollback: step is a function");
    if (!Number.isInteger(depth) || depth < 1 || depth > DEEPEST)
      throw new ThudError("invalid", `rollback: depth is whole, from 1 to ${DEEPEST}`);
    if (!Number.isInteger(budget) || budget < 0 || budget > DEEPEST)
      throw new ThudError("invalid", `rollback: budget is whole, from 0 to ${DEEPEST}`);
    if (stateBytes && movers.length > 0)
      throw new ThudError("invalid", "rollback: stateBytes has no place for movers");
    this.#world = world;
    this.#stateBytes = stateBytes;
    this.#idle = [...idle];
    this.#base = this.#idle;
    this.#step = step;
    this.#movers = [...movers];
    this.#depth = depth;
    this.#budget = budget;
    this.#known = idle.map(() => ({
      ...{ inputs: new Map<number, Input>(), before: 0, told: 0 },
      ...{ gone: Infinity, back: Infinity, leads: null },
    }));
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

  /**
   * `steps - settled` steps have to be run again; what was before this step and `confirmed` is the
   * same on all peers.
   */
  get settled(): number {
    return Math.min(this.#steps, this.#wrong);
  }

  /**
   * Steps by which this peer is ahead of the mean of the others, by what `hearLead` heard: slow
   * down by so many; negative: catch up.
   */
  get ahead(): number {
    const heard = this.#known.flatMap((known) =>
      known.leads && !isAbsent(known, this.#steps) ? [(known.leads[0] - known.leads[1]) / 2] : [],
    );
    return heard.length > 0 ? heard.reduce((sum, one) => sum + one) / heard.length : 0;
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
    const known = this.#player(player);
    if (!isStep(step) || step > this.#steps + this.#depth)
      throw new ThudError("invalid", `rollback: step ${step} is none, or too far ahead`);
    if (known.inputs.has(step) && known.inputs.get(step) !== input)
      throw new ThudError("invalid", `rollback: player ${player} held two inputs in step ${step}`);
    if (step < known.before) return;
    known.told = Math.max(known.told, step + 1);
    this.#know(player, step, input);
  }

  /**
   * Runs wrongly predicted steps again, and then the next step. Returns false, without the next
   * step, while an input of `depth` steps ago is not known: wait for the other peers then. Returns
   * false, too, where more steps have to be run again than `budget`: so many were, the world is
   * before the step `settled`, and the next call goes on.
   */
  advance(): boolean {
    this.#settle(this.#budget || Infinity);
    if (this.#wrong !== Infinity || this.#steps - this.confirmed >= this.#depth) return false;
    this.#play(this.#steps);
    this.#steps++;
    // The moment before the earliest step that may still be wrong is kept: its inputs are the
    // prediction for that step.
    const old = this.#steps - this.#depth - 2;
    this.#moments.delete(old);
    this.#known.forEach(({ inputs }, player) => {
      inputs.delete(old);
      this.#knowAbsence(player, this.#steps + this.#depth);
    });
    return true;
  }

  /** Runs wrongly predicted steps again, and no further step. Returns the number of these steps. */
  settle(): number {
    return this.#settle(Infinity);
  }

  /**
   * The world's hash before one of the last `depth` steps, or before the next one. Up to
   * `confirmed` it is the same on all peers; where it is not, the game's `step` is not
   * deterministic, or a peer cheats: see `report`.
   * @throws {ThudError} "invalid" for a step that is not kept.
   */
  hashAt(step: number): string {
    if (step > this.#wrong || step === this.#steps) this.settle();
    const hash = step === this.#at ? this.#world.hash() : this.#moments.get(step)?.hash;
    if (hash === undefined) throw new ThudError("invalid", `rollback: step ${step} is not kept`);
    return hash;
  }

  // ---- peers that differ ----

  /**
   * Bytes for a peer whose hash of a confirmed step differs: the hashes before all confirmed steps
   * that are kept and, unless `step` is -1, a hash of each body before `step`, one of these, and the
   * inputs of the step before it. They are the same bytes that thud_rollback_report writes in C.
   * @throws {ThudError} "invalid" for a step that is not confirmed, or no longer kept.
   */
  report(step = -1): Uint8Array<ArrayBuffer> {
    this.settle();
    const { first, hashes } = this.#confirmedHashes();
    if (step !== -1 && hashes[step - first] === undefined)
      throw new ThudError("invalid", `rollback: step ${step} is not confirmed, or not kept`);
    const inputs = this.#inputsBefore(step);
    const own = step === -1 ? [] : this.#bodyHashes(step);
    const bodies = own.map(({ id, hash }): [number, bigint] => [id.index, hash]);
    return writeReport({ players: this.#known.length, first, hashes, step, inputs, bodies });
  }

  /**
   * Compares a report, from a peer with as many players, with this peer. A difference is found as
   * long as the step is kept, so exchange hashes at least every `depth` steps. Where inputs agree,
   * and a single one of several peers differs from all others, that one is at fault.
   * @throws {ThudError} "invalid" for bytes that are no report, or damaged.
   */
  compare(report: Uint8Array): RollbackDifference {
    const told = readReport(report, this.#known.length);
    this.settle();
    const { first, hashes } = this.#confirmedHashes();
    const at = told.hashes.findIndex((hash, i) => {
      const own = hashes[told.first + i - first];
      return own !== undefined && own !== hash;
    });
    const step = at < 0 ? -1 : told.first + at;
    const found = { step, isDetailed: step >= 0 && step === told.step, bodySlot: -1 };
    const difference = { ...found, body: null as BodyId | null, bodies: 0, player: -1 };
    if (!found.isDetailed) return difference;
    const inputs = this.#inputsBefore(step);
    if (inputs && told.inputs)
      difference.player = inputs.findIndex((input, player) => input !== told.inputs?.[player]);
    const own = this.#bodyHashes(step);
    const [here, there] = [new Map(own.map((one) => [one.id.index, one])), new Map(told.bodies)];
    for (const slot of [...new Set([...here.keys(), ...there.keys()])].sort((a, b) => a - b)) {
      const body = here.get(slot);
      if (body && body.hash === there.get(slot)) continue;
      if (difference.bodies++ > 0) continue;
      difference.bodySlot = slot;
      difference.body = body?.id ?? null;
    }
    return difference;
  }

  // ---- clocks ----

  /**
   * How many more steps this peer has run than inputs of a player have arrived. Tell the player this
   * number with each message.
   * @throws {ThudError} "invalid" for an unknown player.
   */
  leadOver(player: number): number {
    return this.#steps - this.#player(player).told;
  }

  /**
   * Notes that a player's message told this lead over the own inputs, from -1000 to 1000. Half the
   * difference of both leads is how far this peer is ahead: the delay between them cancels out where
   * it is the same in both directions. `ahead` is the mean of that over all players, smoothed. It is
   * as old as the delay, so correct a small share of it in each frame.
   * @throws {ThudError} "invalid" for an unknown player, or a lead out of range.
   */
  hearLead(player: number, lead: number): void {
    const known = this.#player(player);
    if (!(Math.abs(lead) <= DEEPEST)) throw new ThudError("invalid", `rollback: a lead of ${lead}`);
    const now = [this.leadOver(player), lead];
    const [own, theirs] = known.leads ?? now;
    known.leads = [own + LEAD_SHARE * (now[0] - own), theirs + LEAD_SHARE * (now[1] - theirs)];
  }

  // ---- players who come and go ----

  /**
   * From this step on a player is absent: its input is that of `idle`, and nobody waits for it. All
   * peers have to make the call with the same step, at which no peer has an input of the player;
   * inputs before it may still come.
   * @throws {ThudError} "invalid" for a step at or after which an input of the player is known, one
   * that is more than `depth` ahead or before the last `depth` steps, and for a player that is
   * unknown or absent.
   */
  leave(player: number, step: number): void {
    const known = this.#player(player);
    if (known.gone !== Infinity && !(step >= known.back))
      throw new ThudError("invalid", `rollback: player ${player} is absent`);
    if (!isStep(step) || step < this.#oldest || step > this.#steps + this.#depth || step < known.told)
      throw new ThudError("invalid", `rollback: step ${step} is known, or too far away`);
    known.gone = step;
    known.back = Infinity;
    this.#knowAbsence(player, step);
  }

  /**
   * From this step on an absent player is there again, and its inputs are needed. All peers have to
   * make the call with the same step: announce one that is some steps ahead, with the inputs before
   * it.
   * @throws {ThudError} "invalid" for a step that is confirmed, or more than `depth` ahead, and for
   * a player that is unknown or not absent.
   */
  enter(player: number, step: number): void {
    const known = this.#player(player);
    if (known.gone === Infinity || known.back !== Infinity)
      throw new ThudError("invalid", `rollback: player ${player} is not absent`);
    if (!isStep(step) || step < known.gone || step < this.confirmed || step > this.#steps + this.#depth)
      throw new ThudError("invalid", `rollback: step ${step} is confirmed, or too far ahead`);
    known.back = known.told = step;
    known.before = Math.min(known.before, step);
    for (let i = step; i <= this.#steps + this.#depth; i++) known.inputs.delete(i);
  }

  /**
   * What somebody needs to join the game, as bytes: the world, the state and the movers before the
   * step `confirmed`, and who is absent; the same bytes that thud_rollback_snapshot writes in C, but for
   * the state. The state has to be of numbers, strings, booleans, null, arrays and objects.
   */
  snapshot(): Uint8Array<ArrayBuffer> {
    this.settle();
    const step = this.confirmed;
    const moment = step < this.#steps ? this.#moments.get(step) : undefined;
    const inputs = this.#moments.get(step - 1)?.inputs ?? this.#base;
    const state = moment ? moment.state : this.#state;
    const movers = moment ? moment.movers : this.#movers.map((mover) => mover.state());
    const players = this.#known.map(({ gone, back }, i) => ({ input: inputNumber(inputs[i]), gone, back }));
    const isNumbered = inputs.every(Number.isSafeInteger);
    const own = this.#stateBytes?.write(state) ?? writeState({ state, movers, inputs: isNumbered ? null : inputs });
    return packGame({ step, players, world: moment ? moment.snapshot : this.#world.snapshot(), state: own });
  }

  /**
   * Joins a game: world, state, movers and steps become those of bytes that `snapshot` of another
   * peer returned; the world takes over its bodies' handles. Then the inputs of all players from
   * `steps` on are needed; a spectator gives none of its own.
   * @throws {ThudError} "invalid" for bytes that are damaged, or of a game with other players or
   * movers.
   */
  restore(bytes: Uint8Array): void {
    const game = unpackGame(bytes);
    const count = this.#known.length;
    if (game.players.length !== count)
      throw new ThudError("invalid", "rollback: the bytes are of a game with other players");
    const read = this.#readState(game);
    this.#world.restore(game.world);
    this.#movers.forEach((mover, i) => mover.restore(read.movers[i]));
    this.#state = read.state;
    this.#base = read.inputs;
    this.#first = this.#steps = this.#at = game.step;
    this.#wrong = Infinity;
    this.#moments.clear();
    this.#known.forEach((known, player) => {
      known.inputs.clear();
      known.before = known.told = game.step;
      known.leads = null;
      ({ gone: known.gone, back: known.back } = game.players[player]);
      this.#knowAbsence(player, game.step);
    });
  }

  /** What the bytes of a game say beside its world. */
  #readState({ players, state: bytes }: Game): { state: State; movers: MoverState[]; inputs: Input[] } {
    const inputs = players.map(({ input }) => Number(BigInt.asIntN(64, input)) as Input);
    if (this.#stateBytes) return { state: this.#stateBytes.read(bytes), movers: [], inputs };
    const own = readState(bytes) as { state: State; movers: MoverState[]; inputs: Input[] | null };
    const isListed = (list: unknown, length: number) => Array.isArray(list) && list.length === length;
    if (!isListed(own.movers, this.#movers.length) || !own.movers.every(isMoverState))
      throw new ThudError("invalid", "rollback: the bytes are of a game with other movers");
    if (own.inputs !== null && !isListed(own.inputs, players.length))
      throw new ThudError("invalid", "rollback: the bytes are of a game with other players");
    return { ...own, inputs: own.inputs ?? inputs };
  }

  // ---- inside ----

  /** The first step of which the state before it is kept. */
  get #oldest(): number {
    return Math.max(this.#first, this.#steps - this.#depth);
  }

  #player(player: number): Known<Input> {
    const known = this.#known[player] as Known<Input> | undefined;
    if (!known) throw new ThudError("invalid", `rollback: there is no player ${player}`);
    return known;
  }

  /** Notes that an input is known. Where the step was run with another one, it is run again. */
  #know(player: number, step: number, input: Input): void {
    const known = this.#known[player];
    known.inputs.set(step, input);
    while (known.inputs.has(known.before)) known.before++;
    const moment = this.#moments.get(step);
    if (step < this.#steps && moment && moment.inputs[player] !== input)
      this.#wrong = Math.min(this.#wrong, step);
  }

  /** Notes the inputs of a player for the steps at which it is absent, from this step on. */
  #knowAbsence(player: number, from: number): void {
    for (let step = from; step <= this.#steps + this.#depth; step++)
      if (isAbsent(this.#known[player], step)) this.#know(player, step, this.#idle[player]);
  }

  /** Runs at most so many of the steps again that have to be; returns their number. */
  #settle(most: number): number {
    const from = this.#wrong;
    const moment = this.#moments.get(from);
    if (!moment) return 0;
    if (this.#at !== from) {
      this.#world.restore(moment.snapshot);
      this.#movers.forEach((mover, i) => mover.restore(moment.movers[i]));
      this.#state = structuredClone(moment.state);
      this.#at = from;
    }
    const end = Math.min(this.#steps, from + most);
    for (let step = from; step < end; step++) {
      this.#play(step);
      this.#replayed++;
    }
    this.#wrong = end < this.#steps ? end : Infinity;
    return end - from;
  }

  /** The hashes before all confirmed steps that are kept, after `settle`. */
  #confirmedHashes(): { first: number; hashes: string[] } {
    const first = this.#oldest;
    const count = Math.max(0, this.confirmed - first + 1);
    return { first, hashes: Array.from({ length: count }, (_, i) => this.hashAt(first + i)) };
  }

  /** The inputs of the step before one, as reports tell them; null: not kept, or no such step. */
  #inputsBefore(step: number): bigint[] | null {
    const inputs = step > this.#first ? this.#moments.get(step - 1)?.inputs : undefined;
    return inputs?.map(inputNumber) ?? null;
  }

  /** The bodies before a step that is kept, in the order of their slots. */
  #bodyHashes(step: number): { id: BodyId; hash: bigint }[] {
    const world = this.#world;
    const list = () =>
      world.bodies().map((id) => ({ id, hash: hashOfBody(world.motionOf(id, []) as number[]) }));
    const moment = step < this.#steps ? this.#moments.get(step) : undefined;
    if (!moment) return list();
    return world.whatIf(() => {
      world.restore(moment.snapshot);
      return list();
    });
  }

  /**
   * Keeps the moment before the step, and runs the step with known and predicted inputs. Where the
   * game's `step` throws, #wrong names this step, and the next `settle` starts from it.
   */
  #play(step: number): void {
    const world = this.#world;
    const before = this.#moments.get(step - 1)?.inputs ?? this.#base;
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
    this.#at = -1;
    this.#step(inputs, this.#state);
    this.#at = step + 1;
    this.#wrong = Infinity;
  }
}
