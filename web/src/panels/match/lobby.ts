/**
 * The players of a match and their connections, from the first invitation to the end. Who invites is
 * player 0, and is connected with each of the others.
 */
import type { App } from "../../page/app";
import type { Match } from "../../worker/protocol";
import type { FromMatch, MatchNews, ToMatch } from "../../worker/match";
import { Connection, type Line } from "./connection";
import type { Invitation } from "./invitation";

/** The most that play. */
const MOST = 4;
/** Bytes of a message of another player at most; larger ones are dropped. Chosen. */
const LARGEST = 65_536;
/** The change of the clock's speed for each step that this player is ahead, and its bounds. Chosen. */
const SLOWER = 0.02;
const SLOWEST = 0.1;

export interface LobbyListener {
  /** Who is connected has changed, or a match has begun or ended. */
  changed(): void;
  /** How the match goes. */
  news(news: MatchNews): void;
  /** A message for the visitor. */
  told(text: string): void;
}

/** Another player: in a match `player` is the number that it has there. */
interface Other {
  connection: Connection;
  player: number;
  /** By it who comes back is known; "": it has said none. */
  token: string;
}

export class Lobby {
  readonly line: Line = { delay: 0, loss: 0 };
  /** A STUN server; "": none. */
  server = "";
  /** Whether this browser was invited. */
  invited = false;
  readonly #app: App;
  readonly #listener: LobbyListener;
  readonly #others: Other[] = [];
  /** A connection that is not open yet, and the name of its invitation. */
  #next: { connection: Connection; name: string } | null = null;
  #match: Match | null = null;
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

  /** The number of others who are connected. */
  get connected(): number {
    return this.#others.length;
  }

  get isFull(): boolean {
    return this.#others.length >= this.#places - 1;
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

  /** Answers an invitation. */
  async answer(offer: Invitation): Promise<string> {
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
    this.#others.forEach((other, i) => {
      other.player = i + 1;
      this.#seats.set(other.player, other.token);
      other.connection.sendSurely(JSON.stringify({ start: { players, own: i + 1, seed: this.#app.state.seed } }));
    });
    await this.#begin({ players, own: 0, present: this.#others.map(({ player }) => player) });
  }

  /** Somebody has said who it is: in the midst of a match it gets its place, or a free one. */
  #seat(other: Other, token: string): void {
    other.token = token;
    if (this.invited || !this.playing) return;
    // Who comes back may be here before it is known that its connection has ended.
    for (const one of [...this.#others])
      if (one !== other && token && one.token === token) one.connection.close();
    const { players } = this.#match!;
    const taken = new Set(this.#others.filter((one) => one !== other).map(({ player }) => player));
    const free = Array.from({ length: players - 1 }, (_, i) => i + 1).filter((player) => !taken.has(player));
    const own = free.find((player) => token && this.#seats.get(player) === token);
    const player = own ?? free.find((player) => !this.#seats.has(player)) ?? free[0];
    if (player === undefined) return other.connection.close();
    other.player = player;
    this.#seats.set(player, token);
    other.connection.sendSurely(JSON.stringify({ start: { players, own: player, seed: this.#app.state.seed } }));
    this.#post({ joined: player });
    this.#listener.told(`Player ${player + 1} has ${own ? "come back" : "joined"}.`);
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
    // Alone it is played by as many as before.
    if (this.#match) this.#app.state.size = this.#size;
    this.#match = null;
    this.#port?.close();
    this.#port = null;
    this.#app.player.pace = 1;
  }

  #drop(): void {
    const connection = this.#next?.connection;
    this.#next = null;
    connection?.close();
  }

  #connect(): Connection {
    const connection: Connection = new Connection(this.line, this.server, {
      opened: () => {
        this.#next = null;
        // In a match its number comes when it has said who it is.
        const player = this.invited ? 0 : this.playing ? -1 : this.#others.length + 1;
        this.#others.push({ connection, player, token: "" });
        if (this.invited) connection.sendSurely(JSON.stringify({ hello: ownToken() }));
        this.#listener.changed();
      },
      heard: (data) => this.#hear(connection, data),
      closed: () => this.#lose(connection),
    });
    return connection;
  }

  #lose(connection: Connection, over = false): void {
    if (this.#next?.connection === connection) {
      this.#next = null;
      this.#listener.told("The connection could not be made.");
    }
    const at = this.#others.findIndex((other) => other.connection === connection);
    if (at < 0) return;
    const [{ player }] = this.#others.splice(at, 1) as [Other];
    if (player >= 0) this.#post({ lost: player, over });
    if (player >= 0)
      this.#listener.told(this.invited ? "The connection has ended." : `Player ${player + 1} has left.`);
    if (this.invited) this.#end();
    this.#listener.changed();
  }

  #hear(connection: Connection, data: ArrayBuffer | string): void {
    const other = this.#others.find((one) => one.connection === connection);
    if (!other) return;
    if (typeof data !== "string") {
      if (data.byteLength <= LARGEST && other.player >= 0) this.#post({ from: other.player, bytes: data });
      return;
    }
    const { start, hello, bye } = data.length < LARGEST ? readText(data) : {};
    if (start && this.invited && !this.#match) void this.#begin({ players: start.players, own: start.own, present: [] }, start.seed);
    else if (hello !== undefined && !other.token) this.#seat(other, hello);
    else if (bye) {
      this.#lose(connection, true);
      connection.close();
    }
  }

  async #begin(about: Omit<Match, "port">, seed = this.#app.state.seed): Promise<void> {
    const app = this.#app;
    const { port1, port2 } = new MessageChannel();
    this.#port?.close();
    this.#port = port1;
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
      this.#listener.news(message.news);
      return;
    }
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

/** What browsers tell each other beside the match: that one begins, who this is, and farewell. */
function readText(text: string): { start?: { players: number; own: number; seed: number }; hello?: string; bye?: boolean } {
  try {
    const told = JSON.parse(text) as { start?: { players?: unknown; own?: unknown; seed?: unknown }; hello?: unknown; bye?: unknown };
    const [players, own, seed] = [told.start?.players, told.start?.own, told.start?.seed].map(Number) as [number, number, number];
    const isStart =
      Number.isInteger(players) && players >= 2 && players <= MOST &&
      Number.isInteger(own) && own >= 1 && own < players &&
      Number.isSafeInteger(seed) && seed >= 0;
    return {
      start: isStart ? { players, own, seed } : undefined,
      hello: typeof told.hello === "string" && told.hello.length <= 40 ? told.hello : undefined,
      bye: told.bye === true,
    };
  } catch {
    return {};
  }
}
