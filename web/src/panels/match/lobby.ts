/**
 * The players of a match and their connections, from the first invitation to the end. Who invites is
 * player 0 and the host, and is connected with each of the others. When a match begins, the others
 * connect with each other, too, through the host: these connections stand idle until the host is gone.
 * Then the player with the lowest number of those who are there takes its place: it asks the others
 * to go on with it, each of them sends it what it has of the game, and it tells all of them the
 * rest (RollbackPeers).
 */
import type { App } from "../../page/app";
import type { Match } from "../../worker/protocol";
import type { FromMatch, MatchNews, ToMatch } from "../../worker/match";
import { Connection, type Line } from "./connection";
import { type Invitation, unpackInvitation } from "./invitation";

/** The most that play, and that watch besides. Chosen. */
const [MOST, MOST_WATCHING] = [4, 4];
/** Bytes of a message of another player at most; larger ones are dropped. Chosen. */
const LARGEST = 65_536;
/** The change of the clock's speed for each step that this player is ahead, and its bounds. Chosen. */
const SLOWER = 0.02;
const SLOWEST = 0.1;
/**
 * Milliseconds for which the next host waits for answers of others, for which these wait to be told the
 * game, and within which a host has to be heard that is said to be gone. Chosen.
 */
const [ANSWERED, TAKEN_OVER, HEARD] = [4000, 12_000, 1500];

export interface LobbyListener {
  /** Who is connected has changed, or a match has begun or ended. */
  changed(): void;
  /** How the match goes. */
  news(news: MatchNews): void;
  /** A message for the visitor. */
  told(text: string): void;
  /** This browser is the host from now on; `closed`: the one before has closed its page. */
  tookOver(closed: boolean): void;
  /** The match has ended, and not by this browser. */
  cut(): void;
}

/** Another player: in a match `player` is the number that it has there. */
interface Other {
  connection: Connection;
  player: number;
  /** By it a browser that comes back is recognised; "" before it has said it. */
  token: string;
  /** It has come to watch. */
  watches: boolean;
  /** When something came from it last, by performance.now. */
  heard: number;
}

/** The time from when the host is gone until the next one tells the game. */
interface Gap {
  /** The host has ended the match for itself, or closed its page. */
  left: boolean;
  closed: boolean;
  /** Whom this browser has asked to go on with it, and who does. */
  asked: Set<number>;
  followers: Set<number>;
  /** The next host, with which this browser goes on; -1: not known yet. */
  next: number;
  /** The match has been told that this browser takes over. */
  taken: boolean;
  timer: ReturnType<typeof setTimeout>;
}

export class Lobby {
  readonly line: Line = { delay: 0, loss: 0 };
  /** A STUN server; "": none. */
  server = "";
  /** Whether this browser was invited. Who takes the place of the host counts as the one who invites. */
  invited = false;
  /** This browser comes to watch. */
  watches = false;
  /** It has taken the place of the host in this match. */
  carries = false;
  readonly #app: App;
  readonly #listener: LobbyListener;
  readonly #others: Other[] = [];
  /** A connection that is not open yet, and the name of its invitation. */
  #next: { connection: Connection; name: string } | null = null;
  /** Connections with other guests that are not open yet, by player. */
  readonly #links = new Map<number, Connection>();
  #match: Match | null = null;
  #host = 0;
  #gap: Gap | null = null;
  /**
   * A guest that asks to take the host's place while the host is not known to be gone here; null:
   * none.
   */
  #asker: Other | null = null;
  /** The players who are there, as the match has told last. */
  #present: readonly number[] = [];
  /** The scene's size before the match. */
  #size: number | undefined;
  /** Who had which number in this match. */
  readonly #seats = new Map<number, string>();
  #port: MessagePort | null = null;

  constructor(app: App, listener: LobbyListener) {
    this.#app = app;
    this.#listener = listener;
    app.listen({
      run: () => {
        // The match's scene was begun anew, or another one runs.
        if (this.#match && app.state.match !== this.#match) this.leave();
      },
    });
    window.addEventListener("pagehide", () => this.leave(true));
  }

  /** The number of others who are connected, and of those among them who watch. */
  get connected(): number {
    return this.#others.length;
  }

  get watching(): number {
    const players = this.#match?.players ?? Infinity;
    return this.#others.filter(({ player, watches }) => watches || player >= players).length;
  }

  get isFull(): boolean {
    return this.#others.length >= this.#places - 1 + MOST_WATCHING;
  }

  /** Whether this browser only watches the match. */
  get isWatching(): boolean {
    return this.#match !== null && this.#match.own >= this.#match.players;
  }

  /** Whether an invitation waits for its answer, or for the connection that the answer makes. */
  get isConnecting(): boolean {
    return this.#next !== null;
  }

  /** The number of players of the game, who need not all be there. */
  get #places(): number {
    return Math.min(MOST, this.#app.scene?.sizes?.most ?? 2);
  }

  get playing(): boolean {
    return this.#match !== null;
  }

  /** Makes an invitation, in place of one that nobody has answered. */
  async invite(): Promise<string> {
    this.#drop();
    if (this.#others.length === 0 && !this.playing) this.invited = false;
    const connection = this.#connect();
    const { text, name } = await connection.invite();
    this.#next = { connection, name };
    return text;
  }

  /** Takes the answer to the invitation. False if it answers another one. */
  async accept(answer: Invitation): Promise<boolean> {
    if (answer.type !== "answer" || answer.to !== this.#next?.name) return false;
    await this.#next.connection.accept(answer);
    return true;
  }

  /** Answers an invitation. Who carries a match on alone may go back to that of others. */
  async answer(offer: Invitation): Promise<string> {
    if (this.playing && this.connected > 0) throw new Error("others play in the match that runs here");
    this.#drop();
    this.invited = true;
    const connection = this.#connect();
    this.#next = { connection, name: "" };
    return connection.answer(offer);
  }

  /** Begins a match with all who are connected; others may come later. */
  async start(): Promise<void> {
    this.#drop();
    const players = this.#places;
    this.#seats.clear();
    this.#host = 0;
    let [player, watcher] = [1, players];
    for (const other of this.#others) {
      other.player = other.watches || player === players ? watcher++ : player++;
      this.#seats.set(other.player, other.token);
      this.#tellStart(other, players);
    }
    this.#others.forEach((other, i) => this.#introduce(other, this.#others.slice(0, i), players));
    await this.#begin({ players, own: 0, host: 0, present: this.#others.map(({ player }) => player) });
  }

  #tellStart({ player, connection }: Other, players: number): void {
    const start = { players, own: player, host: this.#host, seed: this.#app.state.seed };
    connection.sendSurely(JSON.stringify({ start }));
  }

  /** Has a guest connect with others, with whom it can go on when this browser is gone. */
  #introduce({ player, connection }: Other, others: readonly Other[], players: number): void {
    for (const other of others)
      if (other.player >= 0 && Math.min(player, other.player) < players)
        connection.sendSurely(JSON.stringify({ meet: other.player }));
  }

  /** Somebody has said who it is: in the midst of a match it gets its place, or a free one. */
  #seat(other: Other, token: string, watches: boolean): void {
    other.token = token;
    other.watches = watches;
    this.#listener.changed();
    if (this.invited || !this.playing) return;
    // Who comes back may be here before it is known that its connection has ended.
    for (const one of [...this.#others])
      if (one !== other && token && one.token === token) one.connection.close();
    const { players, own } = this.#match!;
    const others = this.#others.filter((one) => one !== other);
    const taken = new Set([own, ...others.map(({ player }) => player)]);
    const free = Array.from({ length: players + MOST_WATCHING }, (_, i) => i).filter((number) => !taken.has(number));
    const places = watches ? [] : free.filter((number) => number < players);
    const before = places.find((player) => token && this.#seats.get(player) === token);
    const player = before ?? places.find((player) => !this.#seats.has(player)) ?? places[0] ?? free.find((number) => number >= players);
    if (player === undefined) return other.connection.close();
    other.player = player;
    this.#seats.set(player, token);
    this.#tellStart(other, players);
    this.#post({ joined: player });
    this.#introduce(other, others, players);
    const what = before === undefined ? "joined" : "come back";
    this.#listener.told(player < players ? `Player ${player + 1} has ${what}.` : "Somebody has come to watch.");
    this.#listener.changed();
  }

  /** Ends the match and all connections. `returns`: this browser may come back. */
  leave(returns = false): void {
    this.#drop();
    for (const { connection } of this.#others.splice(0)) {
      if (!returns) connection.sendSurely(JSON.stringify({ bye: true }));
      connection.close();
    }
    this.#end();
    this.#listener.changed();
  }

  #end(): void {
    clearTimeout(this.#gap?.timer);
    this.#gap = null;
    this.carries = false;
    this.#present = [];
    for (const link of this.#links.values()) link.close();
    // The scene gets back the size that it had before the match.
    if (this.#match) this.#app.state.size = this.#size;
    this.#match = null;
    // A worker that still waits for the host's welcome gives it up.
    this.#post({ lost: this.#host, over: true });
    this.#port?.close();
    this.#port = null;
    this.#app.player.pace = 1;
  }

  #drop(): void {
    const connection = this.#next?.connection;
    this.#next = null;
    connection?.close();
  }

  /** `guest`: the number of another guest, with whom this one goes on when the host is gone. */
  #connect(guest = -1): Connection {
    const connection: Connection = new Connection(this.line, this.server, {
      opened: () => {
        if (guest >= 0) {
          this.#links.delete(guest);
          for (const one of this.#others.filter(({ player }) => player === guest)) one.connection.close();
        } else this.#next = null;
        // In a match its number comes when it has said who it is.
        const player = guest >= 0 ? guest : this.invited ? 0 : this.playing ? -1 : this.#others.length + 1;
        this.#others.push({ connection, player, token: "", watches: false, heard: performance.now() });
        if (this.invited) connection.sendSurely(JSON.stringify({ hello: ownToken(), watches: this.watches }));
        this.#listener.changed();
      },
      heard: (data) => this.#hear(connection, data),
      closed: () => {
        if (this.#links.get(guest) === connection) this.#links.delete(guest);
        this.#lose(connection);
      },
    });
    return connection;
  }

  #lose(connection: Connection, left = false): void {
    if (this.#next?.connection === connection) {
      this.#next = null;
      if (this.carries) this.invited = false;
      this.#listener.told("The connection could not be made.");
    }
    const at = this.#others.findIndex((other) => other.connection === connection);
    if (at < 0) return;
    const [{ player }] = this.#others.splice(at, 1) as [Other];
    if (!this.invited || this.carries) {
      this.invited = false;
      if (player >= 0) this.#post({ lost: player, over: left });
      const isPlayer = player < (this.#match?.players ?? Infinity);
      if (player >= 0) this.#listener.told(isPlayer ? `Player ${player + 1} has left.` : "Somebody who watched has left.");
    } else if (this.#gap) this.#goOn();
    else if (player === this.#host) this.#miss(left, !connection.failed);
    this.#listener.changed();
  }

  #hear(connection: Connection, data: ArrayBuffer | string): void {
    const other = this.#others.find((one) => one.connection === connection);
    if (!other) return;
    other.heard = performance.now();
    if (typeof data !== "string") {
      if (data.byteLength > LARGEST || other.player < 0) return;
      if (this.#gap?.next === other.player) this.#settle();
      this.#post({ from: other.player, bytes: data });
      return;
    }
    const told: Told = data.length < LARGEST ? readText(data) : {};
    const { start, hello, bye, next } = told;
    if (start && this.invited && (!this.#match || this.carries)) {
      this.carries = false;
      this.#host = other.player = start.host;
      void this.#begin({ ...start, present: [] }, start.seed);
    } else if (hello !== undefined && !other.token) this.#seat(other, hello, told.watches === true);
    else if (next) this.#hearNext(other);
    else if (told.stays && this.#gap?.asked.has(other.player)) this.#giveUp();
    else if (told.meet !== undefined || told.invitation !== undefined) void this.#link(other, told).catch(() => {});
    else if (bye) {
      this.#lose(connection, true);
      connection.close();
    }
  }

  // ---- when the host is gone ----

  /**
   * Connects two guests through the host. On the host: passes an invitation or its answer on. On a
   * guest: opens a connection when the host says `meet`, answers the invitation of another guest,
   * or takes its answer.
   */
  async #link(other: Other, { meet, invitation, to, from }: Told): Promise<void> {
    if (!this.playing) return;
    if (!this.invited) {
      const target = this.#others.find(({ player }) => player === to);
      target?.connection.sendSurely(JSON.stringify({ from: other.player, invitation }));
      return;
    }
    const player = meet ?? from;
    if (other.player !== this.#host || player === undefined || player === this.#match!.own) return;
    const send = (text: string) => other.connection.sendSurely(JSON.stringify({ to: player, invitation: text }));
    const open = () => {
      this.#links.get(player)?.close();
      const connection = this.#connect(player);
      this.#links.set(player, connection);
      return connection;
    };
    if (meet !== undefined) return send((await open().invite()).text);
    const told = await unpackInvitation(invitation ?? "");
    if (told?.type === "offer") send(await open().answer(told));
    else if (told) await this.#links.get(player)?.accept(told);
  }

  /** The host is gone. */
  #miss(left: boolean, closed: boolean): void {
    if (!this.#match) {
      this.#listener.told("The connection has ended.");
      return;
    }
    const isNext = this.#successor === this.#match.own;
    const timer = setTimeout(() => this.#goOn(true), isNext ? ANSWERED : TAKEN_OVER);
    this.#gap = { left, closed, asked: new Set(), followers: new Set(), next: -1, taken: false, timer };
    this.#goOn();
    const asker = this.#asker;
    this.#asker = null;
    if (this.#gap && asker && this.#others.includes(asker)) this.#hearNext(asker);
  }

  /** The lowest number of the players who are there and connected with this one, and of this one. */
  get #successor(): number {
    const numbers = [this.#match!.own, ...this.#others.map(({ player }) => player)];
    return Math.min(...this.#present.filter((player) => numbers.includes(player)));
  }

  /**
   * Goes on without the host. Where this browser is next, it asks the others to follow, and takes
   * over when all do, or at once if `late` (the time for answers is over). Where another one is
   * next, it waits for that one, or gives up if `late`.
   */
  #goOn(late = false): void {
    const gap = this.#gap!;
    const { own } = this.#match!;
    if (!this.#others.some(({ player }) => player === gap.next)) gap.next = -1;
    const next = gap.next < 0 ? this.#successor : gap.next;
    if (next === Infinity || (gap.left && this.#others.length === 0)) return this.#giveUp();
    if (next !== own) {
      // It asks as soon as it knows that the host is gone.
      if (late) this.#giveUp();
      return;
    }
    for (const { player, connection } of this.#others) {
      if (gap.asked.has(player)) continue;
      gap.asked.add(player);
      connection.sendSurely(JSON.stringify({ next: true }));
    }
    if (gap.taken || !(late || this.#others.every(({ player }) => gap.followers.has(player)))) return;
    gap.taken = true;
    this.#post({ takeOver: true });
  }

  /** Another guest takes the place of the host. */
  #hearNext(other: Other): void {
    const match = this.#match;
    const { player, connection } = other;
    if (!match || !this.invited || player === this.#host || player >= match.players) return;
    // Who does not play yet cannot go on.
    if (this.#present.length === 0) return connection.close();
    if (!this.#present.includes(player)) return connection.sendSurely(JSON.stringify({ stays: true }));
    const gap = this.#gap;
    if (!gap) {
      this.#asker = other;
      setTimeout(() => this.#doubt(other), HEARD);
      return;
    }
    // Of two who ask, the one with the lower number is the next.
    const lowest = gap.next < 0 ? (this.#successor === match.own ? match.own : Infinity) : gap.next;
    if (player > lowest) return;
    gap.next = player;
    clearTimeout(gap.timer);
    gap.timer = setTimeout(() => this.#goOn(true), TAKEN_OVER);
    this.#post({ follow: player });
  }

  /** Tells who has lost the host that it is there; or gives it up, where it is not heard here either. */
  #doubt(other: Other): void {
    if (this.#asker !== other || !this.#others.includes(other)) return;
    const host = this.#others.find(({ player }) => player === this.#host);
    if (host && performance.now() - host.heard >= HEARD) return host.connection.close();
    this.#asker = null;
    other.connection.sendSurely(JSON.stringify({ stays: true }));
  }

  /** The next host tells the game. */
  #settle(): void {
    const { next, timer } = this.#gap!;
    clearTimeout(timer);
    this.#gap = null;
    this.#host = next;
    this.#listener.told(`The player who invited you has left. Player ${next + 1} carries the match on.`);
    this.#listener.changed();
  }

  /** This browser is the host now; some cannot go on with it. */
  #tookOver(refused: readonly number[]): void {
    if (!this.#gap) return;
    const { closed, followers, timer } = this.#gap;
    clearTimeout(timer);
    this.#gap = null;
    this.invited = false;
    this.carries = true;
    this.#host = this.#match!.own;
    const going = this.#others.filter(({ player }) => followers.has(player) && !refused.includes(player));
    const others = this.#others.splice(0, Infinity, ...going);
    for (const { player, connection } of others) if (!going.some((one) => one.player === player)) connection.close();
    for (const link of this.#links.values()) link.close();
    this.#seats.clear();
    for (const { player, token } of going) this.#seats.set(player, token);
    this.#listener.told("The player who invited you has left. You carry the match on.");
    this.#listener.tookOver(closed);
    this.#listener.changed();
  }

  /** The match cannot go on without the host. */
  #giveUp(): void {
    this.#listener.told(this.#gap?.left ? "The others have left." : "The connection has ended.");
    this.#post({ lost: this.#host, over: this.#gap?.left ?? false });
    this.#end();
    for (const { connection } of this.#others.splice(0)) connection.close();
    this.#listener.cut();
    this.#listener.changed();
  }

  async #begin(about: Omit<Match, "port">, seed = this.#app.state.seed): Promise<void> {
    const app = this.#app;
    const { port1, port2 } = new MessageChannel();
    this.#port?.close();
    this.#port = port1;
    this.#present = [];
    this.#match = { port: port2, ...about };
    port1.onmessage = ({ data }: MessageEvent<FromMatch>) => this.#take(data);
    app.setSpeed(1);
    app.setPaused(false);
    this.#listener.changed();
    const match = this.#match;
    if (!app.state.match) this.#size = app.state.size;
    const { sizes } = app.scene ?? {};
    const size = sizes ? about.players : undefined;
    if (await app.open(app.state.scene, { size, seed, match })) return;
    if (this.#match === match) this.leave();
  }

  /** Takes what the worker has to say. */
  #take(message: FromMatch): void {
    if ("news" in message) {
      const { ahead } = message.news;
      const slower = Math.min(SLOWEST, Math.max(-SLOWEST, SLOWER * ahead));
      this.#app.player.pace = 1 - slower;
      // Who waits for others is not slow.
      if (message.news.waits) this.#app.player.lag = 0;
      this.#present = message.news.present;
      this.#listener.news(message.news);
      return;
    }
    if ("follower" in message) {
      this.#gap?.followers.add(message.follower);
      if (this.#gap) this.#goOn();
      return;
    }
    if ("tookOver" in message) return this.#tookOver(message.tookOver);
    const { to, bytes, sure } = message;
    const other = this.#others.find(({ player }) => player === to);
    if (sure) other?.connection.sendSurely(bytes);
    else other?.connection.send(bytes);
  }

  #post(message: ToMatch): void {
    this.#port?.postMessage(message, "bytes" in message ? [message.bytes] : []);
  }
}

/** By this others know a browser that comes back; it lasts as long as the tab. */
function ownToken(): string {
  try {
    sessionStorage.matchToken ??= crypto.randomUUID();
    return String(sessionStorage.matchToken);
  } catch {
    return crypto.randomUUID();
  }
}

/** What browsers tell each other beside the match. */
interface Told {
  /** A match begins, of which the teller is the host. */
  start?: { players: number; own: number; host: number; seed: number };
  /** Who the teller is, and whether it comes to watch. */
  hello?: string;
  watches?: boolean;
  /** It leaves on purpose. */
  bye?: boolean;
  /** It takes the place of the host, which is gone; and the answer that it is not. */
  next?: boolean;
  stays?: boolean;
  /** The host: connect with this guest. And what guests tell each other through the host. */
  meet?: number;
  invitation?: string;
  to?: number;
  from?: number;
}

function readText(text: string): Told {
  try {
    const told = JSON.parse(text) as Partial<Record<keyof Told, unknown>>;
    const start = told.start as Partial<Record<string, unknown>> | undefined;
    const [players, own, host, seed] = [start?.players, start?.own, start?.host, start?.seed].map(Number) as [number, number, number, number];
    const isNumber = (value: unknown): value is number => Number.isInteger(value) && Number(value) >= 0 && Number(value) < MOST + MOST_WATCHING;
    const isStart =
      Number.isInteger(players) && players >= 2 && players <= MOST &&
      isNumber(own) && isNumber(host) && host < players && own !== host &&
      Number.isSafeInteger(seed) && seed >= 0;
    const number = (value: unknown) => (isNumber(value) ? value : undefined);
    return {
      start: isStart ? { players, own, host, seed } : undefined,
      hello: typeof told.hello === "string" && told.hello.length <= 40 ? told.hello : undefined,
      watches: told.watches === true,
      bye: told.bye === true,
      next: told.next === true,
      stays: told.stays === true,
      meet: number(told.meet),
      invitation: typeof told.invitation === "string" ? told.invitation : undefined,
      to: number(told.to),
      from: number(told.from),
    };
  } catch {
    return {};
  }
}
