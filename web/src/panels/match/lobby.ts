/**
 * The players of a match and their connections, from the first invitation to the end. The player
 * who invites is number 0 and the host, and is connected with each of the others, the guests. When
 * a match begins, the guests connect with each other as well; the host passes on what this needs.
 * These connections are not used until the host is gone. Then the guest with the lowest number
 * takes its place: it asks the others to follow it, each of them sends it the inputs that it knows,
 * and it sends each the inputs that this one lacks (RollbackPeers).
 */
import type { App } from "../../page/app";
import type { Match } from "../../worker/protocol";
import type { FromMatch, MatchNews, ToMatch } from "../../worker/match";
import { Connection, type Line } from "./connection";
import { type Invitation, unpackInvitation } from "./invitation";

/** Maximum number of players, and maximum number of visitors who watch them. Chosen. */
const [MOST, MOST_WATCHING] = [4, 4];
/** Maximum size in bytes of a message of another player; larger ones are dropped. Chosen. */
const LARGEST = 65_536;
/**
 * SLOWER: by how much the clock's speed is changed for each step that this player is ahead of the
 * others; SLOWEST: the bound of that change. Chosen.
 */
const SLOWER = 0.02;
const SLOWEST = 0.1;
/**
 * In milliseconds. ANSWERED: how long the next host waits for the answers of the others.
 * TAKEN_OVER: how long the others wait for the state of the game from it. HEARD: a host that
 * another player reports as gone is kept if something came from it within this time. Chosen.
 */
const [ANSWERED, TAKEN_OVER, HEARD] = [4000, 12_000, 1500];

export interface LobbyListener {
  /** Called when a player has come or gone, or a match has begun or ended. */
  changed(): void;
  /** How the match goes. */
  news(news: MatchNews): void;
  /** A message for the visitor. */
  told(text: string): void;
  /**
   * Called when this browser has become the host; `closed`: the host before has closed its page.
   */
  tookOver(closed: boolean): void;
  /** Called when the match has ended, unless this browser has ended it. */
  cut(): void;
}

/** Another player: in a match `player` is the number that it has there. */
interface Other {
  connection: Connection;
  player: number;
  /**
   * A random text by which a browser that returns is recognised; "" until the other browser has
   * sent it.
   */
  token: string;
  /** This player only watches. */
  watches: boolean;
  /** When data came from this player last, on the clock of performance.now(). */
  heard: number;
}

/**
 * What is known in the time between the loss of the host and the next host's message with the state
 * of the game.
 */
interface Gap {
  /** `left`: the host has left the match; `closed`: it has closed its page. */
  left: boolean;
  closed: boolean;
  /** The numbers of the players whom this browser has asked to follow it, and of those who do. */
  asked: Set<number>;
  followers: Set<number>;
  /** The number of the next host, which this browser follows; -1: not known yet. */
  next: number;
  /** The worker has been told that this browser takes over as the host. */
  taken: boolean;
  timer: ReturnType<typeof setTimeout>;
}

export class Lobby {
  readonly line: Line = { delay: 0, loss: 0 };
  /** A STUN server; "": none. */
  server = "";
  /**
   * Whether this browser was invited. False also for one that has taken over as the host, which
   * invites from then on.
   */
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
   * A guest that has asked to take over as the host, although this browser is still connected with
   * the host; null: none.
   */
  #asker: Other | null = null;
  /** The numbers of the connected players, from the worker's last news. */
  #present: readonly number[] = [];
  /** The scene's size before the match. */
  #size: number | undefined;
  /** By number of a player in this match: the token of its browser. */
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

  /**
   * Answers an invitation. Throws if this browser plays with others; one that goes on playing alone
   * may leave its match for another.
   */
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

  /**
   * Another browser has sent its token. In a running match it gets the number that it had, or a
   * free one.
   */
  #seat(other: Other, token: string, watches: boolean): void {
    other.token = token;
    other.watches = watches;
    this.#listener.changed();
    if (this.invited || !this.playing) return;
    // A browser that returns may connect before its old connection is known to have ended.
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

  /**
   * Creates a connection. `guest`: the number of the other guest, for a connection between guests;
   * -1: a connection with the host.
   */
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
      // The next host asks as soon as it notices that the host is gone; until then this browser
      // waits.
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
    // A guest that does not play yet knows no state of the game, and cannot continue.
    if (this.#present.length === 0) return connection.close();
    if (!this.#present.includes(player)) return connection.sendSurely(JSON.stringify({ stays: true }));
    const gap = this.#gap;
    if (!gap) {
      this.#asker = other;
      setTimeout(() => this.#doubt(other), HEARD);
      return;
    }
    // If two guests ask, the one with the lower number becomes the host.
    const lowest = gap.next < 0 ? (this.#successor === match.own ? match.own : Infinity) : gap.next;
    if (player > lowest) return;
    gap.next = player;
    clearTimeout(gap.timer);
    gap.timer = setTimeout(() => this.#goOn(true), TAKEN_OVER);
    this.#post({ follow: player });
  }

  /**
   * Answers a guest that has lost the host: if this browser has heard from the host recently, it
   * says that the host is still there; otherwise it gives up the host as well.
   */
  #doubt(other: Other): void {
    if (this.#asker !== other || !this.#others.includes(other)) return;
    const host = this.#others.find(({ player }) => player === this.#host);
    if (host && performance.now() - host.heard >= HEARD) return host.connection.close();
    this.#asker = null;
    other.connection.sendSurely(JSON.stringify({ stays: true }));
  }

  /** The next host has sent the state of the game: the gap is over. */
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

  /** Handles a message of the worker. */
  #take(message: FromMatch): void {
    if ("news" in message) {
      const { ahead } = message.news;
      const slower = Math.min(SLOWEST, Math.max(-SLOWEST, SLOWER * ahead));
      this.#app.player.pace = 1 - slower;
      // A player who waits for inputs of others is not slow itself.
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

/**
 * The token by which the other players recognise this browser when it returns; it is kept as long
 * as the tab.
 */
function ownToken(): string {
  try {
    sessionStorage.matchToken ??= crypto.randomUUID();
    return String(sessionStorage.matchToken);
  } catch {
    return crypto.randomUUID();
  }
}

/** The messages of the lobby that browsers send each other, apart from those of the match. */
interface Told {
  /** From the host: a match begins. */
  start?: { players: number; own: number; host: number; seed: number };
  /** The token of the sender, and whether it only watches. */
  hello?: string;
  watches?: boolean;
  /** It leaves on purpose. */
  bye?: boolean;
  /**
   * `next`: the sender wants to take over as the host, which is gone; `stays`: the answer that the
   * host is not gone.
   */
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
