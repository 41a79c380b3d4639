/**
 * The bytes that players of a rollback tell each other: packets with inputs, which may get lost, and
 * what must arrive: who wants to join, what a game is, and the game itself. The layout stands in
 * examples/network/messages.h; messages.c writes and reads the same bytes.
 */
import { sumOf } from "./rollback-bytes.js";

const SUM = 4;
/** Inputs of one player in one packet at most. */
export const RUN_INPUTS = 120;
/**
 * Events in one packet at most; and the limit below which the numbers of all players and spectators
 * are.
 */
export const [EVENTS_MAX, NUMBERS] = [16, 32];
/** Bytes of a game in one part. */
const PART = 8192;
/** The largest game that is joined, bytes. */
const GAME_MAX = 1 << 26;

const markOf = (text: string) => new DataView(new TextEncoder().encode(text).buffer).getUint32(0, true);
const [PACKET, HELLO, WELCOME, GAME, MIGRATION] = ["TNP3", "TNH1", "TNW2", "TNG1", "TNM1"].map(markOf);
const HEAD = 22;
const MIGRATION_HEAD = 14;
const [TIMED, EVENTFUL] = [1, 2];
const [WELCOME_BYTES, HELLO_BYTES, GAME_HEAD] = [40, 17, 8];

/** A player has left (`enters` false), or enters, before a step. */
export interface PlayerEvent {
  enters: boolean;
  player: number;
  step: number;
}

/** Inputs of a player from a step on. */
export interface Run {
  player: number;
  first: number;
  inputs: Uint8Array;
}

export interface Packet {
  from: number;
  /** Steps by which the sender is ahead of the receiver (`Rollback.leadOver`). */
  lead: number;
  /** -1: none. */
  hashStep: number;
  hash: bigint;
  /** Milliseconds, of 16 bits; `held`: since the newest packet came, whose `sent` is `echo`; -1: none came. */
  time: { sent: number; echo: number; held: number } | null;
  /** The events from number `first` on; the sender has those before `known`. */
  events: { known: number; first: number; list: PlayerEvent[] } | null;
  /** Player and step: the sender has the player’s inputs before it. */
  acks: [player: number, step: number][];
  runs: Run[];
}

/** What a player has to know to begin. */
export interface Welcome {
  own: number;
  players: number;
  /** Steps a second. */
  rate: number;
  depth: number;
  /** The steps of the game; 0: it has no end. */
  end: number;
  seed: number;
  /** The step before which it begins, the events that are over by then, and who is absent, by bits. */
  step: number;
  events: number;
  absent: number;
  /** Bytes of the game, which follow in parts; 0: it begins with the first step. */
  bytes: number;
  /** How many of these, the last ones, the program has added. */
  more: number;
}

/**
 * What a player has of a game whose host is gone, for the player who takes its place: all events from
 * number `firstEvent` on, and of each player in turn a run that ends with its last known input.
 */
export interface Migration {
  from: number;
  /** All steps before this one are final. */
  confirmed: number;
  firstEvent: number;
  events: PlayerEvent[];
  runs: Run[];
}

const viewOf = (bytes: Uint8Array) => new DataView(bytes.buffer, bytes.byteOffset, bytes.length);

function seal(bytes: Uint8Array<ArrayBuffer>, mark: number): Uint8Array<ArrayBuffer> {
  const view = viewOf(bytes);
  view.setUint32(0, mark, true);
  const end = bytes.length - SUM;
  view.setUint32(end, sumOf(bytes.subarray(0, end)), true);
  return bytes;
}

function isSealed(bytes: Uint8Array, mark: number, least: number): boolean {
  if (bytes.length < least) return false;
  const [view, end] = [viewOf(bytes), bytes.length - SUM];
  return view.getUint32(0, true) === mark && view.getUint32(end, true) === sumOf(bytes.subarray(0, end));
}

/** Writes numbers and bytes one behind the other from a place on. */
function writer(bytes: Uint8Array, from: number) {
  let at = from;
  return {
    put(value: number, count: number): void {
      for (let i = 0; i < count; i++) bytes[at++] = Math.floor(value / 256 ** i) % 256;
    },
    append(list: Uint8Array): void {
      bytes.set(list, at);
      at += list.length;
    },
  };
}

/** Reads what a writer has written, up to `end`; what lies beyond is read as 0. */
function reader(bytes: Uint8Array, from: number, end: number) {
  let at = from;
  return {
    take(count: number): number {
      let value = 0;
      for (let i = 0; i < count; i++) value += (at + i < end ? bytes[at + i]! : 0) * 256 ** i;
      at += count;
      return value;
    },
    slice(count: number): Uint8Array {
      const list = bytes.slice(Math.min(at, end), Math.min(at + count, end));
      at += count;
      return list;
    },
    /** Whether exactly the bytes up to the end have been read. */
    isAtEnd: () => at === end,
  };
}

type Writer = ReturnType<typeof writer>;
type Reader = ReturnType<typeof reader>;

function writeEvents({ put }: Writer, list: readonly PlayerEvent[]): void {
  for (const { enters, player, step } of list) {
    put(Number(enters), 1);
    put(player, 1);
    put(step, 4);
  }
}

/** Null for one that cannot be, or too many. */
function readEvents({ take }: Reader, count: number, most: number, players: number): PlayerEvent[] | null {
  if (count > most) return null;
  const list = Array.from({ length: count }, () => ({ enters: take(1), player: take(1), step: take(4) }));
  if (!list.every(({ enters, player }) => enters <= 1 && player < players)) return null;
  return list.map(({ enters, player, step }) => ({ enters: enters === 1, player, step }));
}

export function writePacket(packet: Packet): Uint8Array<ArrayBuffer> {
  const { time, events, acks, runs } = packet;
  const more = (time ? 6 : 0) + (events ? 5 + 6 * events.list.length : 0) + 5 * acks.length;
  const length = runs.reduce((sum, { inputs }) => sum + 6 + inputs.length, HEAD + more + SUM);
  const bytes = new Uint8Array(length);
  const view = viewOf(bytes);
  view.setUint8(4, packet.from);
  view.setUint8(5, (time ? TIMED : 0) + (events ? EVENTFUL : 0));
  view.setInt16(6, packet.lead, true);
  view.setUint32(8, packet.hashStep + 1, true);
  view.setBigUint64(12, packet.hash, true);
  view.setUint8(20, acks.length);
  view.setUint8(21, runs.length);
  const out = writer(bytes, HEAD);
  if (time) for (const one of [time.sent, time.echo, time.held]) out.put(one < 0 ? 0xffff : one, 2);
  if (events) {
    out.put(events.known, 2);
    out.put(events.first, 2);
    out.put(events.list.length, 1);
    writeEvents(out, events.list);
  }
  for (const [player, step] of acks) {
    out.put(player, 1);
    out.put(step, 4);
  }
  for (const { player, first, inputs } of runs) {
    out.put(player, 1);
    out.put(first, 4);
    out.put(inputs.length, 1);
    out.append(inputs);
  }
  return seal(bytes, PACKET!);
}

/** The packet in bytes, for a game of so many players and different inputs; null: they are none, or damaged. */
export function readPacket(bytes: Uint8Array, players: number, inputs: number): Packet | null {
  if (!isSealed(bytes, PACKET!, HEAD + SUM)) return null;
  const view = viewOf(bytes);
  const read = reader(bytes, HEAD, bytes.length - SUM);
  const { take } = read;
  const flags = bytes[5]!;
  let time: Packet["time"] = null;
  let events: Packet["events"] = null;
  if (flags & TIMED) {
    const [sent, echo, held] = [take(2), take(2), take(2)];
    time = { sent, echo, held: held === 0xffff ? -1 : held };
  }
  if (flags & EVENTFUL) {
    const [known, first, count] = [take(2), take(2), take(1)];
    const list = readEvents(read, count, EVENTS_MAX, players);
    if (!list) return null;
    events = { known, first, list };
  }
  const acks = Array.from({ length: bytes[20]! }, (): [number, number] => [take(1), take(4)]);
  let isWhole = true;
  const runs = Array.from({ length: bytes[21]! }, () => {
    const [player, first, count] = [take(1), take(4), take(1)];
    const list = read.slice(count);
    isWhole &&= count > 0 && count <= RUN_INPUTS && list.every((input) => input < inputs);
    return { player, first, inputs: list };
  });
  const isRight =
    isWhole && read.isAtEnd() && bytes[20]! <= players && bytes[21]! <= players && flags <= TIMED + EVENTFUL && bytes[4]! < NUMBERS &&
    acks.every(([player]) => player < players) && runs.every(({ player }) => player < players);
  if (!isRight) return null;
  return {
    ...{ from: bytes[4]!, lead: view.getInt16(6, true), hashStep: view.getUint32(8, true) - 1 },
    ...{ hash: view.getBigUint64(12, true), time, events, acks, runs },
  };
}

export function writeMigration({ from, confirmed, firstEvent, events, runs }: Migration): Uint8Array<ArrayBuffer> {
  const length = runs.reduce((sum, { inputs }) => sum + 6 + inputs.length, MIGRATION_HEAD + 6 * events.length + SUM);
  const bytes = new Uint8Array(length);
  const out = writer(bytes, 4);
  out.put(from, 1);
  out.put(runs.length, 1);
  out.put(confirmed, 4);
  out.put(firstEvent, 2);
  out.put(events.length, 2);
  writeEvents(out, events);
  for (const { first, inputs } of runs) {
    out.put(first, 4);
    out.put(inputs.length, 2);
    out.append(inputs);
  }
  return seal(bytes, MIGRATION!);
}

/** The migration in bytes, for a game of so many players and different inputs; null: they are none, or damaged. */
export function readMigration(bytes: Uint8Array, players: number, inputs: number): Migration | null {
  if (!isSealed(bytes, MIGRATION!, MIGRATION_HEAD + SUM) || bytes[4]! >= NUMBERS || bytes[5] !== players) return null;
  const read = reader(bytes, 6, bytes.length - SUM);
  const [confirmed, firstEvent, count] = [read.take(4), read.take(2), read.take(2)];
  const events = readEvents(read, count, bytes.length / 6, players);
  if (!events) return null;
  const runs = Array.from({ length: players }, (_, player) => {
    const [first, count] = [read.take(4), read.take(2)];
    return { player, first, inputs: read.slice(count) };
  });
  const isRight = read.isAtEnd() && runs.every(({ inputs: list }) => list.every((input) => input < inputs));
  return isRight ? { from: bytes[4]!, confirmed, firstEvent, events, runs } : null;
}

/** Who comes: `watches`: not to play; `token`: the same, other than 0, of who comes back. */
export function writeHello({ watches, token }: { watches: boolean; token: bigint }): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(HELLO_BYTES);
  viewOf(bytes).setUint8(4, Number(watches));
  viewOf(bytes).setBigUint64(5, token, true);
  return seal(bytes, HELLO!);
}

/** null: the bytes say no such thing. */
export function readHello(bytes: Uint8Array): { watches: boolean; token: bigint } | null {
  if (bytes.length !== HELLO_BYTES || !isSealed(bytes, HELLO!, HELLO_BYTES) || bytes[4]! > 1) return null;
  return { watches: bytes[4] === 1, token: viewOf(bytes).getBigUint64(5, true) };
}

/** The messages that tell somebody a game, which has to get all of them in order. */
export function writeWelcome(welcome: Welcome, game: Uint8Array = new Uint8Array()): Uint8Array<ArrayBuffer>[] {
  const bytes = new Uint8Array(WELCOME_BYTES);
  const view = viewOf(bytes);
  view.setUint8(4, welcome.own);
  view.setUint8(5, welcome.players);
  view.setUint16(6, welcome.rate, true);
  view.setUint16(8, welcome.depth, true);
  view.setUint32(10, welcome.end, true);
  view.setUint32(14, welcome.seed, true);
  view.setUint32(18, welcome.step, true);
  view.setUint16(22, welcome.events, true);
  view.setUint32(24, welcome.absent, true);
  view.setUint32(28, game.length, true);
  view.setUint32(32, welcome.more, true);
  const messages = [seal(bytes, WELCOME!)];
  for (let from = 0; from < game.length; from += PART) {
    const piece = game.subarray(from, from + PART);
    const part = new Uint8Array(GAME_HEAD + piece.length + SUM);
    viewOf(part).setUint32(4, from, true);
    part.set(piece, GAME_HEAD);
    messages.push(seal(part, GAME!));
  }
  return messages;
}

function readWelcome(bytes: Uint8Array): Welcome | null {
  if (bytes.length !== WELCOME_BYTES || !isSealed(bytes, WELCOME!, WELCOME_BYTES)) return null;
  const view = viewOf(bytes);
  const welcome = {
    ...{ own: bytes[4]!, players: bytes[5]!, rate: view.getUint16(6, true), depth: view.getUint16(8, true) },
    ...{ end: view.getUint32(10, true), seed: view.getUint32(14, true), step: view.getUint32(18, true) },
    ...{ events: view.getUint16(22, true), absent: view.getUint32(24, true) },
    ...{ bytes: view.getUint32(28, true), more: view.getUint32(32, true) },
  };
  const { own, players, rate, depth, step, absent } = welcome;
  const isRight =
    players >= 2 && players < NUMBERS && own < NUMBERS && rate > 0 && depth > 0 && depth <= 1000 &&
    absent < 2 ** players && welcome.bytes <= GAME_MAX && welcome.more <= welcome.bytes && (welcome.bytes > 0 || step === 0);
  return isRight ? welcome : null;
}

/** Collects a welcome and the game that follows it. */
export class WelcomeReader {
  /** Null until it has come. */
  welcome: Welcome | null = null;
  #bytes = new Uint8Array();
  #has = 0;

  /** The game; null where it begins with the first step. */
  get game(): Uint8Array | null {
    return this.welcome?.bytes ? this.#bytes.subarray(0, this.welcome.bytes - this.welcome.more) : null;
  }

  /** What the program has added to it. */
  get more(): Uint8Array {
    return this.#bytes.subarray(this.#bytes.length - (this.welcome?.more ?? 0));
  }

  get isWhole(): boolean {
    return this.welcome !== null && this.#has === this.welcome.bytes;
  }

  /** False for bytes that are no part of it, or come in another order. */
  hear(bytes: Uint8Array): boolean {
    if (!this.welcome) {
      this.welcome = readWelcome(bytes);
      this.#bytes = new Uint8Array(this.welcome?.bytes ?? 0);
      return this.welcome !== null;
    }
    if (this.isWhole || !isSealed(bytes, GAME!, GAME_HEAD + SUM + 1)) return false;
    const piece = bytes.subarray(GAME_HEAD, bytes.length - SUM);
    const from = viewOf(bytes).getUint32(4, true);
    if (from !== this.#has || from + piece.length > this.#bytes.length) return false;
    this.#bytes.set(piece, from);
    this.#has += piece.length;
    return true;
  }
}
