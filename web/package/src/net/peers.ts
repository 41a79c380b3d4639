/**
 * What the players of a rollback tell each other, and what they make of it: inputs, clocks, hashes, who
 * leaves and enters, and reports of a difference. What carries the bytes is not known here. The host,
 * player 0 at first, is connected with each of the others and passes their inputs on; the others tell
 * the host alone.
 *
 *     const peers = new RollbackPeers({ rollback, players, own, inputs, depth, send });
 *     peers.connect(1);             // on the host, for each player who is there; others: connect(0)
 *     peers.hear(from, bytes);      // what arrives
 *     peers.give(held);             // each step
 *     peers.advance();
 *     peers.tell();
 *
 * Packets may be lost, doubled or late: each has all inputs and events that its receiver has not
 * acknowledged. What comes from another player is checked before it is used, and refused as a whole
 * otherwise. examples/network/peer.c is the same in C, but for what follows.
 *
 * When the host is gone, another player can take its place (host migration), if it can send to the
 * others. All of them have to agree on which:
 *
 *     peers.follow(next);           // on each of the others: sends what it has to `next`
 *     peers.takeOver();             // on `next`, when all who go on are among peers.followers
 *
 * The last inputs and events of the old host may have come to some of them alone. The new host has
 * to know all that any of them knows before it tells anything, so each sends it what it has; who has
 * not done so by then has left.
 */
import { ThudError } from "../error.js";
import { checkOptions } from "../checks/names.js";
import {
  EVENTS_MAX,
  NUMBERS,
  type Migration,
  type Packet,
  type PlayerEvent,
  readMigration,
  readPacket,
  RUN_INPUTS,
  type Run,
  WelcomeReader,
  writeMigration,
  writePacket,
  writeWelcome,
} from "./messages.js";
import type { Rollback, RollbackDifference } from "./rollback.js";

/** Steps from one hash that is compared to the next, and how many are kept for what is told late. */
const [HASH_EVERY, HASHES] = [4, 64];
/** Reports that are sent at most: what differs is told, and once more in detail. Chosen. */
const REPORTS_MAX = 3;
/** The share of a new round trip in the mean. Chosen. */
const NEWEST = 0.1;
/** Milliseconds: round trips that are not shorter are ignored. */
const TRIP_MAX = 30_000;
/** Who joins enters so many steps after that was announced. Chosen. */
const NOTICE = 12;

/**
 * Inputs of a player that are told to a new host, in depths of the rollback. Each of two players may be
 * a depth ahead of what the other has sent, and has inputs of others up to a depth ahead of itself.
 */
const MIGRATED_DEPTHS = 4;

/**
 * Inputs of each player that are kept at least, beside those of MIGRATED_DEPTHS. Chosen: as many as
 * examples/network/peer.c stores.
 */
const KEPT = 1024;

/** Sends bytes to a player; `sure`: they arrive, and in order. */
type Send = (player: number, bytes: Uint8Array<ArrayBuffer>, sure: boolean) => void;

export interface RollbackPeersOptions {
  rollback: Rollback<number, any>;
  /** The number of players. */
  players: number;
  /** The own number, from 0. From `players` on: who only watches. */
  own: number;
  /** The number of the host. Default 0. */
  host?: number;
  /** The number of different inputs, 1 to 256: an input is a whole number below it. */
  inputs: number;
  /** As in RollbackOptions. */
  depth: number;
  /**
   * Steps from a key press to the step in which it takes effect. Inputs that reach the others
   * within so many steps cause no rollback. Default 0.
   */
  delay?: number;
  /** The steps of the game; 0, the default: it has no end. */
  end?: number;
  /**
   * Each player is connected with each of the others, and tells them its own inputs alone. There is no
   * host, and nobody can join. Default false.
   */
  mesh?: boolean;
  send?: Send;
  /** Milliseconds, for round trips; null: they are not measured. Default performance.now. */
  now?: (() => number) | null;
}

/** What is known of a player’s inputs. */
interface Inputs {
  /** The step of the first of `list`. */
  from: number;
  list: number[];
  /** Absent from one step until before the other; Infinity: never. */
  gone: number;
  back: number;
}

/** Somebody to whom packets are sent. */
interface Peer {
  /** Of each player, the step before which it has all inputs; and the events that it has. */
  has: number[];
  events: number;
  /** The last step of which it has told a hash: it has run the game up to there; -1: none. */
  final: number;
  /** The `sent` of its newest packet, and when that came; null: none has. */
  newest: { sent: number; came: number } | null;
  /** The hash that it told last, until the own one of that step is known. */
  told: { step: number; hash: bigint } | null;
  hashStep: number;
  differs: number;
}

export class RollbackPeers {
  /** Milliseconds to another player and back, smoothed; null: not known yet. */
  roundTrip: number | null = null;
  /** Messages that were refused, and how many hashes of others equalled the own ones. */
  refused = 0;
  equal = 0;
  /** The step at which a hash of another player differed; -1: none did. */
  differs = -1;
  /** What a report said of it. */
  difference: RollbackDifference | null = null;
  /** The last step whose hash is known and final, and that hash. */
  final = { step: -1, hash: "" };
  readonly #options: Required<Omit<RollbackPeersOptions, "rollback">> & { rollback: Rollback<number, unknown> };
  readonly #peers = new Map<number, Peer>();
  readonly #inputs: Inputs[];
  /**
   * Who leaves and enters: the events from number `#firstEvent` on. Those with a number below
   * `#applied` are in effect; later ones wait until the rollback reaches their step.
   */
  readonly #events: PlayerEvent[] = [];
  #firstEvent = 0;
  #applied = 0;
  /** By connection: the player who enters when it has come near enough to the present. */
  readonly #joining = new Set<number>();
  #host: number;
  /** What players who go on with this one as the host have told of the game. */
  readonly #migrations = new Map<number, Migration>();
  /** Inputs that others have told a new host, and that lie too far ahead so far; by player. */
  readonly #ahead = new Map<number, Run>();
  readonly #hashes = new Map<number, bigint>();
  #nextHash = 0;
  #reports = 0;

  /** @throws {ThudError} "invalid" for an unknown option or a value out of range. */
  constructor(options: RollbackPeersOptions) {
    const names = ["rollback", "players", "own", "host", "inputs", "depth", "delay", "end", "mesh", "send", "now"];
    checkOptions("peers", options, names);
    // An option that is undefined counts as not given.
    const given = Object.fromEntries(Object.entries(options).filter(([, value]) => value !== undefined));
    const rest = { host: 0, delay: 0, end: 0, mesh: false, send: () => {}, now: () => performance.now() };
    this.#options = { ...rest, ...(given as unknown as RollbackPeersOptions) };
    const { players, own, host, inputs, delay } = this.#options;
    const isWhole = (value: number, least: number, most: number) =>
      Number.isInteger(value) && value >= least && value <= most;
    if (!isWhole(players, 2, NUMBERS - 1) || !isWhole(own, 0, NUMBERS - 1))
      throw new ThudError("invalid", "peers: players is whole, from 2 to 31, and own a number of one");
    if (!isWhole(host, 0, players - 1)) throw new ThudError("invalid", "peers: host is the number of a player");
    this.#host = host;
    if (!isWhole(inputs, 1, 256) || !isWhole(delay, 0, options.depth))
      throw new ThudError("invalid", "peers: inputs is whole, from 1 to 256, and delay no longer than depth");
    const { rollback } = this.#options;
    const step = rollback.steps;
    this.#inputs = Array.from({ length: players }, () => (
      { from: step, list: [] as number[], gone: Infinity, back: Infinity }
    ));
    // Before the first input of anybody can take effect nobody holds a key.
    if (step === 0) for (let i = 0; i < delay; i++) for (let player = 0; player < players; player++) this.#know(player, 0);
    this.#nextHash = Math.ceil(step / HASH_EVERY) * HASH_EVERY;
    this.#noteFinal();
  }

  /** Joins a game of which all has come; `rollback` is that of the own world, made as for a new game. */
  static join(read: WelcomeReader, options: Omit<RollbackPeersOptions, "own" | "players" | "depth" | "end">): RollbackPeers {
    const { welcome, game } = read;
    if (!welcome || !read.isWhole) throw new ThudError("invalid", "peers: the welcome has not come");
    if (game) options.rollback.restore(game);
    if (options.rollback.steps !== welcome.step)
      throw new ThudError("invalid", "peers: the game is not at the step of its welcome");
    const { own, players, depth, end } = welcome;
    const peers = new RollbackPeers({ ...options, own, players, depth, end });
    peers.#firstEvent = peers.#applied = welcome.events;
    peers.#inputs.forEach((known, player) => {
      if (welcome.absent & (1 << player)) known.gone = welcome.step;
    });
    peers.connect(peers.#host);
    return peers;
  }

  /** On the host, before the first step: what somebody has to get who is there from then on. Packets follow. */
  start(number: number, { rate = 60, seed = 0 } = {}): Uint8Array<ArrayBuffer>[] {
    const { players, depth, end } = this.#options;
    this.connect(number);
    const none = { step: 0, events: 0, absent: 0, bytes: 0, more: 0 };
    return writeWelcome({ own: number, players, rate, depth, end, seed, ...none });
  }

  /**
   * Packets are sent to somebody, who has the game from its first step on. In a game that runs already it
   * has to have all but the last KEPT inputs of each player: older ones may be stored no longer.
   */
  connect(number: number): void {
    const has = this.#inputs.map(({ from, list }) => (from === 0 ? Math.min(list.length, this.#options.delay) : from));
    this.#add(number, has, this.#firstEvent);
  }

  #add(number: number, has: number[], events: number): void {
    this.#peers.set(number, { has, events, final: -1, newest: null, told: null, hashStep: -1, differs: -1 });
  }

  /** Whether somebody is told anything. */
  tells(number: number): boolean {
    return this.#peers.has(number);
  }

  /**
   * Whether a player is absent once all events that were put into effect have passed: the step at
   * which it leaves or enters may still be up to `depth` ahead.
   */
  isAbsent(player: number): boolean {
    const { gone, back } = this.#inputs[player];
    return gone < Infinity && back === Infinity;
  }

  /** Whether a player is absent after all events that are known, some of which may not be in effect. */
  #willBeAbsent(player: number): boolean {
    const event = this.#pendingOf(player);
    return event ? !event.enters : this.isAbsent(player);
  }

  /** The last event of a player that is not in effect. */
  #pendingOf(player: number): PlayerEvent | undefined {
    return this.#events.slice(this.#applied - this.#firstEvent).reverse().find((one) => one.player === player);
  }

  get #isHost(): boolean {
    return this.#options.own === this.#host && !this.#options.mesh;
  }

  get #isOver(): boolean {
    const { end, rollback } = this.#options;
    return end > 0 && rollback.steps >= end;
  }

  // ---- playing ----

  /**
   * The own input, for all steps up to `delay` after the next one that have none yet. To be called
   * before each step.
   */
  give(input: number): void {
    const { rollback, own, players, delay, end } = this.#options;
    if (own >= players || this.isAbsent(own)) return;
    const last = Math.min(rollback.steps + delay, end > 0 ? end - 1 : Infinity);
    while (this.#end(own) <= last) this.#know(own, input);
  }

  /** Runs the next step, as Rollback.advance; at the end of the game none. Returns whether one was run. */
  advance(): boolean {
    const { rollback } = this.#options;
    this.#apply();
    let made = false;
    if (this.#isOver) rollback.settle();
    else made = rollback.advance();
    this.#noteFinal();
    this.#forget();
    return made;
  }

  /**
   * Drops inputs that nobody lacks who is sent them, but for the last ones, which a new host may need.
   * Those who join get a game that has the others in it. As many at once as are kept, since all that
   * follow are moved.
   */
  #forget(): void {
    const kept = Math.max(KEPT, MIGRATED_DEPTHS * this.#options.depth);
    this.#inputs.forEach((known, player) => {
      if (known.list.length < 2 * kept) return;
      const lacked = [...this.#peers].filter(([number]) => this.#tellsOf(number, player));
      const first = Math.min(this.#end(player) - kept, ...lacked.map(([, peer]) => this.#nextFor(peer, player)));
      const dropped = known.list.splice(0, Math.max(0, first - known.from));
      known.from += dropped.length;
    });
  }

  /** Whether somebody is told the inputs of a player by this one. */
  #tellsOf(number: number, player: number): boolean {
    return this.#isHost ? player !== number : player === this.#options.own;
  }

  /** Whether the next step lies far behind what is known: who has joined runs until it does not. */
  get isBehind(): boolean {
    const { rollback, own } = this.#options;
    const there = [...this.#inputs.keys()].filter((player) => !this.isAbsent(player));
    // The own inputs are given step by step, from the one on in which this player enters.
    const known = there.map((player) => (player === own ? this.#inputs[own].from : this.#end(player)));
    return there.length > 0 && Math.min(...known) > rollback.steps + 2 && !this.#isOver;
  }

  /** Whether the game is at its end: all inputs are known, and all steps were run with them. */
  get hasEnded(): boolean {
    const { rollback, end } = this.#options;
    return end > 0 && rollback.confirmed >= end && rollback.settled >= end;
  }

  /** Whether, besides, everyone has what this player knows: nothing is left to be sent. */
  get isDone(): boolean {
    if (!this.hasEnded) return false;
    for (const player of this.#inputs.keys())
      for (const [number, peer] of this.#peers)
        if (this.#tellsOf(number, player) && this.#nextFor(peer, player) < this.#end(player)) return false;
    const isKnown = ({ events }: Peer) => events >= this.#applied;
    return !this.#isHost || [...this.#peers.values()].every(isKnown);
  }

  /** Sends a packet to everyone. To be called after each step, and in any case some times a second. */
  tell(): void {
    this.#letIn();
    for (const number of this.#peers.keys()) this.#options.send(number, this.write(number), false);
  }

  /**
   * The connection with somebody has ended. True on the host where nobody else is connected now;
   * elsewhere for every connection that there was: on a guest it was the one with the host.
   */
  lose(number: number): boolean {
    if (!this.#peers.delete(number)) return false;
    this.#joining.delete(number);
    if (!this.#isHost) return true;
    if (number < this.#options.players && !this.#willBeAbsent(number)) this.#announceLeave(number);
    return this.#peers.size === 0;
  }

  /** On the host, before the first step: a player is not there yet. */
  miss(player: number): void {
    this.#announceLeave(player);
  }

  /** It leaves at a step of which nobody has an input. */
  #announceLeave(player: number): void {
    const pending = this.#pendingOf(player)?.step ?? 0;
    const step = Math.max(this.#end(player), endOf(this.#ahead.get(player)), pending);
    this.#announce({ enters: false, player, step });
  }

  /** The step of the first input of a player that is not known. */
  #end(player: number): number {
    const { from, list } = this.#inputs[player];
    return from + list.length;
  }

  #know(player: number, input: number): void {
    this.#options.rollback.input(player, this.#end(player), input);
    this.#inputs[player].list.push(input);
  }

  // ---- who comes and goes ----

  /**
   * On the host: the messages that tell somebody the game, each of which has to arrive, in order;
   * packets follow. As a player, who is absent, it enters as soon as it has come near enough to the
   * present. Null where this player is not the host, where that player is still there, or while
   * somebody is leaving or entering: ask again after the next step. `more`: bytes of the program's
   * own that come with it.
   */
  invite(number: number, { rate = 60, seed = 0, more = new Uint8Array() } = {}): Uint8Array<ArrayBuffer>[] | null {
    const { rollback, players, depth, end } = this.#options;
    rollback.settle();
    const step = rollback.confirmed;
    const isSettled = ({ gone, back }: Inputs) => (gone === Infinity || gone <= step) && (back === Infinity || back <= step);
    const isApplied = this.#applied === this.#firstEvent + this.#events.length;
    if (!this.#isHost || !isApplied || !this.#inputs.every(isSettled)) return null;
    if (number < players && !this.isAbsent(number)) return null;
    const game = rollback.snapshot();
    const absent = this.#inputs.reduce((bits, _, i) => bits + (this.isAbsent(i) ? 2 ** i : 0), 0);
    const events = this.#firstEvent + this.#events.length;
    this.#add(number, this.#inputs.map(() => step), events);
    if (number < players) this.#joining.add(number);
    const bytes = new Uint8Array(game.length + more.length);
    bytes.set(game);
    bytes.set(more, game.length);
    const about = { own: number, players, rate, depth, end, seed, step, events, absent };
    return writeWelcome({ ...about, bytes: bytes.length, more: more.length }, bytes);
  }

  /** Players who have caught up enter, when everybody has what they did before they left. */
  #letIn(): void {
    const { own, rollback, end, depth } = this.#options;
    for (const player of this.#joining) {
      const { final } = this.#peers.get(player)!;
      const all = [...this.#peers.values()];
      const { gone } = this.#inputs[player];
      const isKnown = ({ events, has }: Peer) => events === this.#applied && (has[player] >= gone);
      const step = this.#end(own) + NOTICE;
      if (end > 0 && step >= end) continue;
      // How far it has come is known as late as a message takes, and of each few steps alone.
      if (final < 0 || final + HASH_EVERY < rollback.steps - depth || !all.every(isKnown)) continue;
      this.#joining.delete(player);
      this.#announce({ enters: true, player, step });
    }
  }

  #announce(event: PlayerEvent): void {
    this.#events.push(event);
    this.#apply();
  }

  /** Puts events into effect as far as the rollback reaches. */
  #apply(): void {
    const { rollback, depth } = this.#options;
    for (let event; (event = this.#events[this.#applied - this.#firstEvent]); this.#applied++) {
      const { enters, player, step } = event;
      const known = this.#inputs[player];
      if (step > rollback.steps + depth || (enters && this.#end(player) < known.gone)) break;
      if (enters) {
        rollback.enter(player, step);
        known.back = step;
        known.from = step;
        known.list = [];
      } else {
        rollback.leave(player, step);
        known.gone = step;
        known.back = Infinity;
      }
    }
    for (const run of this.#ahead.values()) this.#takeRun(run);
  }

  // ---- host migration ----

  /** Who has sent this player what it has, to go on with it as the host. */
  get followers(): ReadonlySet<number> {
    return new Set(this.#migrations.keys());
  }

  /** The host is gone: this player goes on with another one as the host, which is sent what this one has. */
  follow(host: number): void {
    const { players, own, depth, rollback, send, mesh } = this.#options;
    if (mesh || host === own || !Number.isInteger(host) || host < 0 || host >= players)
      throw new ThudError("invalid", "peers: the host is another player, and there is none in a mesh");
    this.#forgetHost(host);
    const runs = this.#inputs.map(({ from, list }, player): Run => {
      const first = Math.max(from, this.#end(player) - MIGRATED_DEPTHS * depth);
      return { player, first, inputs: Uint8Array.from(list.slice(first - from)) };
    });
    const events = { firstEvent: this.#firstEvent, events: this.#events };
    send(host, writeMigration({ from: own, confirmed: rollback.confirmed, ...events, runs }), true);
    this.#add(host, runs.map(endOf), this.#firstEvent + this.#events.length);
  }

  /**
   * The host is gone: this player takes its place, and goes on with its `followers`. All other players
   * have left. Returns those followers who cannot go on, since what they have sent contradicts what is
   * known here, or since they lack what is not stored here.
   * @throws {ThudError} "invalid" for who is the host already, is absent, or only watches.
   */
  takeOver(): number[] {
    const { players, own, mesh } = this.#options;
    if (mesh || this.#isHost || own >= players || this.#willBeAbsent(own))
      throw new ThudError("invalid", "peers: a player who is there takes the place of the host");
    const followers = [...this.#migrations];
    this.#forgetHost(own);
    const refused = new Set<number>();
    for (const [number, migration] of followers) if (!this.#merge(migration)) refused.add(number);
    // Who has left is known only now, and of whom which inputs.
    for (const [number, migration] of followers)
      if (!refused.has(number) && !this.#serve(number, migration)) refused.add(number);
    for (let player = 0; player < players; player++) {
      const [isFollower, isAbsent] = [this.#peers.has(player), this.#willBeAbsent(player)];
      if (isFollower && isAbsent) this.#joining.add(player);
      else if (!isFollower && !isAbsent && player !== own) this.#announceLeave(player);
    }
    return [...refused];
  }

  #forgetHost(next: number): void {
    this.#host = next;
    this.#peers.clear();
    this.#joining.clear();
    this.#migrations.clear();
  }

  /** Adds what a follower knows, and this player does not. False where it contradicts what is known. */
  #merge({ firstEvent, events, runs }: Migration): boolean {
    const { own } = this.#options;
    const isAlike = ({ player, first, inputs }: Run) => {
      const ahead = this.#ahead.get(player);
      const isAsTold = !ahead || inputs.every((input, i) => (ahead.inputs[first + i - ahead.first] ?? input) === input);
      return isAsTold && this.#isAsKnown(player, first, inputs);
    };
    const mine = runs[own];
    if (endOf(mine) > this.#end(own) || !runs.every(isAlike) || !this.#mergeEvents(firstEvent, events)) return false;
    this.#apply();
    for (const run of runs) {
      const { player, first } = run;
      const isNew = endOf(run) > Math.max(this.#end(player), endOf(this.#ahead.get(player)));
      // A player that enters has none before.
      if (isNew && first > this.#end(player) && !this.isAbsent(player)) return false;
      if (isNew) this.#ahead.set(player, run);
    }
    this.#apply();
    return true;
  }

  /** Adds the events that are not known; none where they contradict those that are, or cannot be. */
  #mergeEvents(first: number, events: readonly PlayerEvent[]): boolean {
    const { own } = this.#options;
    const isNew = (i: number) => first + i >= this.#firstEvent + this.#events.length;
    return events.every(({ player }, i) => player !== own || !isNew(i)) && this.#addEvents(first, events);
  }

  /** The same, also of the own player. */
  #addEvents(first: number, events: readonly PlayerEvent[]): boolean {
    const { rollback } = this.#options;
    const before = this.#events.length;
    const known = this.#firstEvent + before;
    const isAlike = ({ enters, player, step }: PlayerEvent, i: number) => {
      const event = this.#events[first + i - this.#firstEvent];
      return !event || (event.enters === enters && event.player === player && event.step === step);
    };
    let isPossible = first <= known && events.every(isAlike);
    for (const event of isPossible ? events.slice(Math.max(0, known - first)) : []) {
      const { enters, player, step } = event;
      const { gone } = this.#inputs[player];
      const least = enters ? Math.max(rollback.confirmed, this.isAbsent(player) ? gone : 0) : this.#end(player);
      isPossible &&= enters === this.#willBeAbsent(player);
      isPossible &&= step >= Math.max(least, this.#pendingOf(player)?.step ?? 0);
      this.#events.push(event);
    }
    if (!isPossible) this.#events.length = before;
    return isPossible;
  }

  /** Sends packets to a follower from now on. False where it needs what is not stored here. */
  #serve(number: number, { confirmed, firstEvent, events, runs }: Migration): boolean {
    // Of steps that are final for it, it needs nothing.
    const has = runs.map((run, player) => {
      const { from } = this.#inputs[player];
      return confirmed >= from ? Math.max(endOf(run), from) : endOf(run);
    });
    this.#add(number, has, firstEvent + events.length);
    const peer = this.#peers.get(number)!;
    const isStored = this.#inputs.every(({ from }, player) => player === number || this.#nextFor(peer, player) >= from);
    if (isStored && peer.events >= this.#firstEvent) return true;
    this.#peers.delete(number);
    return false;
  }

  #hearMigration(number: number, bytes: Uint8Array): void {
    const { players, inputs } = this.#options;
    const migration = readMigration(bytes, players, inputs);
    if (migration?.from === number) this.#migrations.set(number, migration);
  }

  // ---- packets ----

  /** The step of the first input of a player that somebody may lack: steps of an absence are left out. */
  #nextFor(peer: Peer, player: number): number {
    const { gone, back } = this.#inputs[player];
    const has = peer.has[player];
    return has >= gone && has < back && back < Infinity ? back : has;
  }

  /** The packet for somebody. */
  write(number: number): Uint8Array<ArrayBuffer> {
    const { rollback, players, own, mesh, now } = this.#options;
    const peer = this.#peers.get(number)!;
    const told = [...this.#inputs.keys()].filter((player) => this.#tellsOf(number, player));
    const runs = told.flatMap((player): Run[] => {
      const first = this.#nextFor(peer, player);
      const { from, list } = this.#inputs[player];
      const inputs = list.slice(Math.max(0, first - from), Math.max(0, first - from) + RUN_INPUTS);
      return inputs.length > 0 && first >= from ? [{ player, first, inputs: Uint8Array.from(inputs) }] : [];
    });
    const acked = mesh ? [number] : [...this.#inputs.keys()].filter((one) => !this.#isHost || one === number);
    const acks = acked.filter((one) => one !== own && one < players).map((player): [number, number] => [player, this.#end(player)]);
    const time = now && Math.floor(now());
    const held = peer.newest && time !== null ? Math.min(0xfffe, time - peer.newest.came) : -1;
    const { step, hash } = this.final;
    const { events } = peer;
    const at = events - this.#firstEvent;
    return writePacket({
      from: own,
      lead: this.#isTimed(number) ? Math.max(-1000, Math.min(1000, rollback.leadOver(number))) : 0,
      hashStep: step,
      hash: step < 0 ? 0n : BigInt(`0x${hash}`),
      time: time === null ? null : { sent: time & 0xffff, echo: peer.newest?.sent ?? 0, held },
      events: mesh ? null : {
        known: this.#firstEvent + this.#events.length,
        first: this.#isHost ? events : 0,
        list: this.#isHost ? this.#events.slice(at, at + EVENTS_MAX) : [],
      },
      acks,
      runs,
    });
  }

  /** Takes what came from somebody; what is wrong with it is counted in `refused`. */
  hear(number: number, bytes: Uint8Array): void {
    const peer = this.#peers.get(number);
    if (!peer) return this.#hearMigration(number, bytes);
    try {
      if (bytes[0] === REPORT[0] && bytes[2] === REPORT[1]) this.#hearReport(number, bytes);
      else this.#hearPacket(number, peer, bytes);
    } catch {
      this.refused++;
    }
  }

  #hearPacket(number: number, peer: Peer, bytes: Uint8Array): void {
    const { players, own, inputs, rollback } = this.#options;
    const packet = readPacket(bytes, players, inputs);
    demand(packet !== null && packet.from === number && Math.abs(packet.lead) <= 1000);
    // Who has not heard yet that it enters, has given no inputs.
    const gives = own < players && !this.isAbsent(own);
    for (const [player, step] of packet.acks) demand(player !== own || !gives || step <= this.#end(own));
    for (const run of packet.runs) this.#checkRun(number, run);
    this.#checkEvents(number, packet);
    // All of it is in order: nothing was changed until here.
    peer.final = Math.max(peer.final, packet.hashStep);
    for (const [player, step] of packet.acks)
      peer.has[player] = Math.max(peer.has[player], Math.min(step, this.#end(player)));
    this.#takeEvents(peer, packet);
    for (const run of packet.runs) this.#takeRun(run);
    this.#hearTime(peer, packet);
    if (this.#isTimed(number)) rollback.hearLead(number, packet.lead);
    if (!peer.told && packet.hashStep > peer.hashStep) {
      peer.hashStep = packet.hashStep;
      peer.told = { step: packet.hashStep, hash: packet.hash };
      this.#compare(number, peer);
    }
  }

  /** Takes the inputs that are not known, as far as the rollback reaches. */
  #takeRun({ player, first, inputs }: Run): void {
    const { rollback, depth } = this.#options;
    const last = Math.min(rollback.steps + depth, this.isAbsent(player) ? this.#inputs[player].gone : Infinity);
    for (let at = this.#end(player) - first; at >= 0 && at < inputs.length && first + at < last; at++)
      this.#know(player, inputs[at]);
  }

  /** Whether the clocks of this player and another one are compared: both play. */
  #isTimed(number: number): boolean {
    const { own, players } = this.#options;
    return Math.max(own, number) < players && !this.isAbsent(own) && !this.isAbsent(number);
  }

  /** Refuses inputs of which the sender cannot know, and others than were told before. */
  #checkRun(number: number, { player, first, inputs }: Run): void {
    const { own, mesh } = this.#options;
    demand(player !== own && (player === number || (number === this.#host && !mesh)));
    demand(this.#isAsKnown(player, first, inputs));
  }

  #isAsKnown(player: number, first: number, inputs: Uint8Array): boolean {
    const { from, list } = this.#inputs[player];
    return inputs.every((input, i) => (list[first + i - from] ?? input) === input);
  }

  /** Only the host says who leaves and enters; and nobody has heard of more than it has said. */
  #checkEvents(number: number, { events }: Packet): void {
    const { mesh, own } = this.#options;
    if (!events) return;
    const known = this.#firstEvent + this.#events.length;
    if (this.#isHost) demand(events.known <= known && events.list.length === 0);
    else {
      demand(number === this.#host && !mesh && (events.list.length === 0 || events.first <= known));
      demand(events.list.every(({ player, enters }) => player !== own || enters));
      const before = this.#events.length;
      const isPossible = events.list.length === 0 || this.#addEvents(events.first, events.list);
      this.#events.length = before;
      demand(isPossible);
    }
  }

  #takeEvents(peer: Peer, { events }: Packet): void {
    if (!events) return;
    if (this.#isHost) peer.events = Math.max(peer.events, events.known);
    else {
      const known = this.#firstEvent + this.#events.length;
      this.#events.push(...events.list.slice(known - events.first));
      this.#apply();
    }
  }

  #hearTime(peer: Peer, { time }: Packet): void {
    const { now } = this.#options;
    if (!now || !time) return;
    const came = Math.floor(now());
    const past = (of: number) => (came - of) & 0xffff;
    if (!peer.newest || past(time.sent) <= past(peer.newest.sent)) peer.newest = { sent: time.sent, came };
    if (time.held < 0) return;
    const trip = (past(time.echo) - time.held) & 0xffff;
    if (trip < TRIP_MAX)
      this.roundTrip = this.roundTrip === null ? trip : this.roundTrip + NEWEST * (trip - this.roundTrip);
  }

  // ---- hashes ----

  /** Notes the hashes of steps that have become final. */
  #noteFinal(): void {
    const { rollback } = this.#options;
    const end = Math.min(rollback.confirmed, rollback.settled);
    for (; this.#nextHash <= end; this.#nextHash += HASH_EVERY) {
      const [step, hash] = [this.#nextHash, rollback.hashAt(this.#nextHash)];
      this.#hashes.set(step, BigInt(`0x${hash}`));
      this.#hashes.delete(step - HASH_EVERY * HASHES);
      this.final = { step, hash };
    }
    for (const [number, peer] of this.#peers) this.#compare(number, peer);
  }

  /** Compares the hash that somebody told, once the own one of that step is known. */
  #compare(number: number, peer: Peer): void {
    if (!peer.told || peer.told.step > this.final.step) return;
    const { step, hash } = peer.told;
    const own = this.#hashes.get(step);
    peer.told = null;
    if (own === undefined) return;
    if (own === hash) {
      this.equal++;
      return;
    }
    if (peer.differs >= 0) return;
    peer.differs = step;
    if (this.differs < 0) this.differs = step;
    this.#report(number, -1);
  }

  /** Tells somebody the own hashes, and those of the bodies before a step, to find what differs. */
  #report(number: number, step: number): void {
    if (this.#reports++ < REPORTS_MAX) this.#options.send(number, this.#options.rollback.report(step), true);
  }

  #hearReport(number: number, report: Uint8Array): void {
    const found = this.#options.rollback.compare(report);
    if (found.step < 0) return;
    this.differs = this.differs < 0 ? found.step : Math.min(this.differs, found.step);
    if (found.isDetailed) this.difference = found;
    this.#report(number, found.step);
  }
}

/** The step after the last input of a run; 0: there is none. */
function endOf(run: Run | undefined): number {
  return run ? run.first + run.inputs.length : 0;
}

/** What a report begins with, at its first and third byte ("tdR2"): no other message does. */
const REPORT = ["t".charCodeAt(0), "R".charCodeAt(0)];

/** Refuses what does not hold. */
function demand(holds: boolean): asserts holds {
  if (!holds) throw new RangeError("refused");
}
