/**
 * What the players of a match tell each other, as bytes, and what they make of it: inputs, clocks,
 * hashes, and reports of a difference. Player 0, who invited the others, is connected with each of
 * them, and passes their inputs on; the others are connected with player 0 alone.
 *
 * Packets may be lost, doubled or late: each has all inputs that its receiver has not acknowledged.
 * What comes from another player is checked before it is used, and refused as a whole otherwise.
 */
import type { Rollback, RollbackDifference } from "thud";

/** The first byte of what is sent. Packets come often and may get lost; the others must arrive. */
const PACKET = 1;
const REPORT = 2;
const LEFT = 3;

/** Steps from a key to the step that it takes effect in: so many of delay cost no correction. Chosen. */
export const INPUT_DELAY = 2;
/** Steps from one hash that is compared to the next. Chosen. */
const HASH_EVERY = 30;
/** Hashes that are kept for what another player tells late. Chosen. */
const HASHES = 40;
/** Inputs of a player in one packet at most. Chosen. */
const MOST_INPUTS = 120;
/** Reports that are sent in a match at most: what differs is told, and once more in detail. */
const MOST_REPORTS = 3;
/** The share of a new round trip in the mean that is shown. Chosen. */
const NEWEST = 0.1;

/** Places in a packet, bytes; then the acknowledged steps of all players, and inputs to the end. */
const AT = { players: 1, steps: 2, lead: 6, sent: 8, echo: 12, held: 16, hashStep: 18, hash: 22 };
const HEAD = 30;
/** In place of a number where there is none. */
const NONE = 0xffffffff;
/** Milliseconds between a packet and the next one to its sender that are told at most. */
const LONGEST_HELD = 0xfffe;

/** Sends bytes to a player; `sure`: they arrive, and in order. */
type Send = (player: number, bytes: Uint8Array<ArrayBuffer>, sure: boolean) => void;

interface Peer {
  /** Of each player, the step before which this peer has told that it has all inputs. */
  has: number[];
  /** The `sent` of its newest packet, and when that came; null: none has. */
  newest: { sent: number; came: number } | null;
  /** The hash that it told last, until the own one of that step is known. */
  told: { step: number; hash: string } | null;
}

export interface PeersOptions {
  rollback: Rollback<number, unknown>;
  players: number;
  own: number;
  /** The number of different inputs. */
  inputs: number;
  depth: number;
  send: Send;
  now?: () => number;
}

export class Peers {
  /** Milliseconds to another player and back, smoothed; null: not known yet. */
  roundTrip: number | null = null;
  /** Packets that were refused, and how many hashes of others equalled the own ones. */
  refused = 0;
  equal = 0;
  /** The step at which a hash of another player differed; -1: none did. */
  differs = -1;
  /** What a report said of it. */
  difference: RollbackDifference | null = null;
  /** The last step whose hash is known and final, and that hash. */
  final = { step: 0, hash: "" };
  /** Players who have left. */
  readonly gone = new Set<number>();
  readonly #options: PeersOptions;
  readonly #peers = new Map<number, Peer>();
  /** The inputs of each player from step 0 on. */
  readonly #inputs: number[][];
  readonly #hashes = new Map<number, string>();
  #reports = 0;
  readonly #now: () => number;

  constructor(options: PeersOptions) {
    const { players, own, rollback } = options;
    this.#options = options;
    this.#now = options.now ?? (() => performance.now());
    this.#inputs = Array.from({ length: players }, () => []);
    for (let player = 0; player < players; player++) {
      // Before the first input of anybody can take effect nobody holds a key.
      for (let step = 0; step < INPUT_DELAY; step++) this.#know(player, 0);
      const connected = own === 0 ? player !== 0 : player === 0;
      const has = Array.from({ length: players }, () => INPUT_DELAY);
      if (connected) this.#peers.set(player, { has, newest: null, told: null });
    }
    this.#noteHash(0, rollback.hashAt(0));
  }

  /** The own input, for the next step that has none yet. To be called before each step. */
  give(input: number): void {
    const { rollback, own } = this.#options;
    if (this.#inputs[own].length <= rollback.steps + INPUT_DELAY) this.#know(own, input);
  }

  /** Sends a packet to every peer. To be called after each step, and in any case some times a second. */
  tell(): void {
    this.#noteFinal();
    for (const [player, peer] of this.#peers)
      this.#options.send(player, this.#packetFor(player, peer), false);
  }

  /** Takes what came from a peer; what is wrong with it is counted in `refused`. */
  hear(player: number, bytes: Uint8Array): void {
    const peer = this.#peers.get(player);
    if (!peer || bytes.length < 1) return;
    try {
      if (bytes[0] === PACKET) this.#hearPacket(player, peer, bytes);
      else if (bytes[0] === REPORT) this.#hearReport(player, bytes.slice(1));
      else if (bytes[0] === LEFT) this.#hearLeft(player, bytes);
      else throw new RangeError("unknown");
    } catch {
      this.refused++;
    }
  }

  /** The connection with a peer has ended. True: without it the match cannot go on. */
  lose(player: number): boolean {
    if (!this.#peers.delete(player)) return false;
    if (this.#options.own !== 0) return true;
    const step = this.#inputs[player].length;
    this.#leave(player, step);
    const bytes = new Uint8Array(6);
    const view = new DataView(bytes.buffer);
    view.setUint8(0, LEFT);
    view.setUint8(1, player);
    view.setUint32(2, step);
    for (const other of this.#peers.keys()) this.#options.send(other, bytes, true);
    return this.#peers.size === 0;
  }

  #know(player: number, input: number): void {
    const inputs = this.#inputs[player];
    this.#options.rollback.input(player, inputs.length, input);
    inputs.push(input);
  }

  #leave(player: number, step: number): void {
    this.#options.rollback.leave(player, step);
    this.gone.add(player);
  }

  // ---- packets ----

  #packetFor(player: number, peer: Peer): Uint8Array<ArrayBuffer> {
    const { rollback, players, own } = this.#options;
    const told = this.#inputs
      .map((inputs, from) => ({ from, first: peer.has[from], inputs: inputs.slice(peer.has[from]) }))
      .filter(({ from, inputs }) => inputs.length > 0 && (own === 0 ? from !== player : from === own))
      .map((one) => ({ ...one, inputs: one.inputs.slice(0, MOST_INPUTS) }));
    const length = told.reduce((sum, { inputs }) => sum + 6 + inputs.length, HEAD + 4 * players);
    const bytes = new Uint8Array(length);
    const view = new DataView(bytes.buffer);
    const now = this.#now();
    view.setUint8(0, PACKET);
    view.setUint8(AT.players, players);
    view.setUint32(AT.steps, rollback.steps);
    view.setInt16(AT.lead, rollback.leadOver(player));
    view.setUint32(AT.sent, Math.floor(now) % NONE);
    view.setUint32(AT.echo, peer.newest?.sent ?? NONE);
    const held = peer.newest ? now - peer.newest.came : 0;
    view.setUint16(AT.held, Math.min(LONGEST_HELD, Math.round(held)));
    view.setUint32(AT.hashStep, this.final.step);
    for (let i = 0; i < 2; i++)
      view.setUint32(AT.hash + 4 * i, Number.parseInt(this.final.hash.slice(8 * i, 8 * i + 8), 16));
    this.#inputs.forEach((inputs, from) => view.setUint32(HEAD + 4 * from, inputs.length));
    let at = HEAD + 4 * players;
    for (const { from, first, inputs } of told) {
      view.setUint8(at, from);
      view.setUint32(at + 1, first);
      view.setUint8(at + 5, inputs.length);
      bytes.set(inputs, at + 6);
      at += 6 + inputs.length;
    }
    return bytes;
  }

  #hearPacket(player: number, peer: Peer, bytes: Uint8Array): void {
    const { players } = this.#options;
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    demand(bytes.length >= HEAD + 4 * players && view.getUint8(AT.players) === players);
    const has = this.#inputs.map((_, from) => view.getUint32(HEAD + 4 * from));
    // Of others it may know more than is known here, but not of this player.
    demand(has[this.#options.own] <= this.#inputs[this.#options.own].length);
    const told = this.#readInputs(player, view, bytes);
    const lead = view.getInt16(AT.lead);
    demand(Math.abs(lead) <= this.#options.depth + MOST_INPUTS);
    // All of it is in order: nothing was changed until here.
    peer.has = peer.has.map((before, from) => Math.max(before, Math.min(has[from], this.#inputs[from].length)));
    for (const { from, first, inputs } of told) this.#take(from, first, inputs);
    this.#hearTime(player, peer, view, lead);
    const hash = [0, 4].map((i) => view.getUint32(AT.hash + i).toString(16).padStart(8, "0")).join("");
    peer.told = { step: view.getUint32(AT.hashStep), hash };
    this.#compare(player, peer);
  }

  /** The inputs in a packet; refuses those of a player of whom the sender cannot know. */
  #readInputs(player: number, view: DataView, bytes: Uint8Array) {
    const { players, own, inputs: count } = this.#options;
    const told: { from: number; first: number; inputs: Uint8Array }[] = [];
    for (let at = HEAD + 4 * players; at < bytes.length; ) {
      demand(bytes.length - at > 6);
      const [from, first, length] = [view.getUint8(at), view.getUint32(at + 1), view.getUint8(at + 5)];
      demand(from < players && from !== own && (player === 0 || from === player));
      demand(length > 0 && length <= MOST_INPUTS && bytes.length - at - 6 >= length);
      const inputs = bytes.subarray(at + 6, at + 6 + length);
      demand(inputs.every((input) => input < count));
      // An input that was told before is told again the same.
      const known = this.#inputs[from];
      demand(inputs.every((input, i) => (known[first + i] ?? input) === input));
      told.push({ from, first, inputs });
      at += 6 + length;
    }
    return told;
  }

  /** Takes the inputs that continue those that are known, as far as the rollback reaches. */
  #take(from: number, first: number, inputs: Uint8Array): void {
    const { rollback, depth } = this.#options;
    const known = this.#inputs[from];
    if (this.gone.has(from) || first > known.length) return;
    for (const input of inputs.subarray(known.length - first)) {
      if (known.length > rollback.steps + depth) return;
      this.#know(from, input);
    }
  }

  #hearTime(player: number, peer: Peer, view: DataView, lead: number): void {
    this.#options.rollback.hearLead(player, lead);
    const now = this.#now();
    const sent = view.getUint32(AT.sent);
    const echo = view.getUint32(AT.echo);
    if (!peer.newest || sent > peer.newest.sent) peer.newest = { sent, came: now };
    if (echo === NONE) return;
    const trip = (Math.floor(now) % NONE) - echo - view.getUint16(AT.held);
    if (trip >= 0 && trip < LONGEST_HELD)
      this.roundTrip = this.roundTrip === null ? trip : this.roundTrip + NEWEST * (trip - this.roundTrip);
  }

  // ---- hashes ----

  /** Notes the hashes of steps that have become final. */
  #noteFinal(): void {
    const { rollback } = this.#options;
    const end = Math.min(rollback.confirmed, rollback.settled);
    for (let step = this.final.step + HASH_EVERY; step <= end; step += HASH_EVERY)
      this.#noteHash(step, rollback.hashAt(step));
    for (const [player, peer] of this.#peers) this.#compare(player, peer);
  }

  #noteHash(step: number, hash: string): void {
    this.#hashes.set(step, hash);
    this.#hashes.delete(step - HASH_EVERY * HASHES);
    this.final = { step, hash };
  }

  /** Compares the hash that a peer told, once the own one of that step is known. */
  #compare(player: number, peer: Peer): void {
    const own = peer.told && this.#hashes.get(peer.told.step);
    if (!peer.told || own === undefined) return;
    const { step, hash } = peer.told;
    peer.told = null;
    if (own === hash) {
      this.equal = Math.max(this.equal, step / HASH_EVERY + 1);
      return;
    }
    if (this.differs >= 0) return;
    this.differs = step;
    this.#report(player, -1);
  }

  /** Tells a peer the own hashes, and those of the bodies before a step, to find what differs. */
  #report(player: number, step: number): void {
    if (this.#reports++ >= MOST_REPORTS) return;
    const report = this.#options.rollback.report(step);
    const bytes = new Uint8Array(1 + report.length);
    bytes[0] = REPORT;
    bytes.set(report, 1);
    this.#options.send(player, bytes, true);
  }

  #hearReport(player: number, report: Uint8Array): void {
    const found = this.#options.rollback.compare(report);
    if (found.step < 0) return;
    this.differs = this.differs < 0 ? found.step : Math.min(this.differs, found.step);
    if (found.isDetailed) this.difference = found;
    this.#report(player, found.step);
  }

  #hearLeft(player: number, bytes: Uint8Array): void {
    demand(player === 0 && bytes.length === 6);
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    const who = view.getUint8(1);
    demand(who > 0 && who < this.#options.players && who !== this.#options.own);
    demand(!this.gone.has(who));
    this.#leave(who, view.getUint32(2));
  }
}

/** Refuses what does not hold. */
function demand(holds: boolean): void {
  if (!holds) throw new RangeError("refused");
}
