/**
 * The players of a match and their connections, from the first invitation to the end. Who invites is
 * player 0, and is connected with each of the others.
 */
import type { App } from "../../page/app";
import type { Match } from "../../worker/protocol";
import type { FromMatch, MatchNews, ToMatch } from "../../worker/match";
import { Connection, type Line } from "./connection";
import type { Invitation } from "./invitation";

/** The most that are played with. */
const MOST_OTHERS = 3;
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
    window.addEventListener("pagehide", () => this.leave());
  }

  /** The number of others who are connected. */
  get connected(): number {
    return this.#others.length;
  }

  get isFull(): boolean {
    return this.#others.length >= MOST_OTHERS;
  }

  get playing(): boolean {
    return this.#match !== null;
  }

  /** Makes an invitation, in place of one that nobody has answered. */
  async invite(): Promise<string> {
    this.#drop();
    this.invited = false;
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

  /** Begins a match with all who are connected. */
  async start(): Promise<void> {
    this.#drop();
    const players = this.#others.length + 1;
    this.#others.forEach((other, i) => {
      other.player = i + 1;
      other.connection.sendSurely(JSON.stringify({ start: { players, own: i + 1 } }));
    });
    await this.#begin(players, 0);
  }

  /** Ends the match and all connections. */
  leave(): void {
    this.#drop();
    for (const { connection } of this.#others.splice(0)) connection.close();
    this.#end();
    this.#listener.changed();
  }

  #end(): void {
    this.#match = null;
    this.#port?.close();
    this.#port = null;
    this.#app.player.pace = 1;
  }

  #drop(): void {
    this.#next?.connection.close();
    this.#next = null;
  }

  #connect(): Connection {
    const connection: Connection = new Connection(this.line, this.server, {
      opened: () => {
        this.#next = null;
        this.#others.push({ connection, player: this.invited ? 0 : this.#others.length + 1 });
        this.#listener.changed();
      },
      heard: (data) => this.#hear(connection, data),
      closed: () => this.#lose(connection),
    });
    return connection;
  }

  #lose(connection: Connection): void {
    if (this.#next?.connection === connection) {
      this.#next = null;
      this.#listener.told("The connection could not be made.");
    }
    const at = this.#others.findIndex((other) => other.connection === connection);
    if (at < 0) return;
    const [{ player }] = this.#others.splice(at, 1) as [Other];
    this.#post({ lost: player });
    this.#listener.told(this.invited ? "The connection has ended." : `Player ${player + 1} has left.`);
    this.#listener.changed();
  }

  #hear(connection: Connection, data: ArrayBuffer | string): void {
    const other = this.#others.find((one) => one.connection === connection);
    if (!other) return;
    if (typeof data === "string") {
      const start = this.invited && !this.#match && data.length < LARGEST ? readStart(data) : null;
      if (start) void this.#begin(start.players, start.own);
    } else if (data.byteLength <= LARGEST) this.#post({ from: other.player, bytes: data });
  }

  async #begin(players: number, own: number): Promise<void> {
    const app = this.#app;
    const { port1, port2 } = new MessageChannel();
    this.#port?.close();
    this.#port = port1;
    this.#match = { port: port2, own };
    port1.onmessage = ({ data }: MessageEvent<FromMatch>) => this.#take(data);
    app.setSpeed(1);
    app.setPaused(false);
    this.#listener.changed();
    const match = this.#match;
    if (await app.open(app.state.scene, { size: players, match })) return;
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

/** What the one who invites says when a match begins; null if the text is none of that. */
function readStart(text: string): { players: number; own: number } | null {
  try {
    const { start } = JSON.parse(text) as { start?: { players?: unknown; own?: unknown } };
    const [players, own] = [Number(start?.players), Number(start?.own)];
    const isRight =
      Number.isInteger(players) && players >= 2 && players <= MOST_OTHERS + 1 &&
      Number.isInteger(own) && own >= 1 && own < players;
    return isRight ? { players, own } : null;
  } catch {
    return null;
  }
}
