/**
 * A scene that players in several browsers play together (Scene.match): its steps are made by a
 * Rollback. The page carries the packets, since only it can open connections (panels/match).
 * Imported when the first match begins.
 */
import type { Engine, Rollback, RollbackPeers, WelcomeReader, World } from "thud";
import { type Input, type KeyName, type KeyWords, noKeys, type Paint, type Scene, type SceneMatch, type SceneModule } from "../scene/scene";
import { USUAL } from "../page/url";
import type { Command } from "./commands";
import type { Match, Rerun, SceneRequest } from "./protocol";
import { Session } from "./session";
import { setUp } from "./stage";
import { SceneError } from "./trouble";

/** Steps that an input may arrive late. Chosen: a second and a half at 60 steps a second. */
const DEPTH = 90;
/**
 * Steps from a key press to the step in which it takes effect. Inputs that reach the others within
 * so many steps cause no rollback. Chosen.
 */
const INPUT_DELAY = 2;
/** Steps that a player who has joined late may run in one `makeStep`, to catch up. Chosen. */
const CATCH_UP = 30;
/** Milliseconds between two calls of `#beat`, which sends packets even if no step is made. */
const BEAT = 40;
/** Number of beats between two `MatchNews` to the page. Chosen. */
const TOLD_EVERY = 5;
/**
 * World units: a body that one correction moves further is not counted in `MatchNews.correction`,
 * since it was put elsewhere, as in a new round. Chosen.
 */
const FARTHEST = 50;

const ALONE = "All players make a match’s steps together: this works in a game of your own.";

/** What the page sends through the port of a match. */
export type ToMatch =
  | { from: number; bytes: ArrayBuffer }
  /**
   * The player `lost` is disconnected; `over`: it left on purpose and will not return. If it is the
   * host, the match ends.
   */
  | { lost: number; over: boolean }
  /** To the host: the player `joined` comes while the match is running. */
  | { joined: number }
  /** The host is gone, and this other player takes its place. */
  | { follow: number }
  /**
   * The host is gone, and this player takes its place, for the players that `follower` messages
   * have named.
   */
  | { takeOver: true };

/** What it gets. */
export type FromMatch =
  | { to: number; bytes: Uint8Array<ArrayBuffer>; sure: boolean }
  | { news: MatchNews }
  /** The player `follower` is ready to continue with this player as the host. */
  | { follower: number }
  /** This player is the host now; the players listed here cannot continue. */
  | { tookOver: number[] };

/** How a match goes. */
export interface MatchNews {
  /** Milliseconds that a packet takes to another player and back; null: not known yet. */
  roundTrip: number | null;
  /**
   * `rollbacks`: how many times steps had to be run again after a wrong prediction; `replayed`: the
   * number of these steps in all.
   */
  rollbacks: number;
  replayed: number;
  /**
   * The largest distance, in world units, by which running steps again has moved a body since the
   * last news.
   */
  correction: number;
  /** Steps by which this player is ahead of the others. */
  ahead: number;
  /** The next step cannot be made until inputs of other players arrive. */
  waits: boolean;
  /**
   * `equal`: how many hashes that other players sent were equal to the hashes of the same steps
   * here; `final`: the last step here whose inputs are all known, and its hash.
   */
  equal: number;
  final: { step: number; hash: string };
  refused: number;
  /**
   * A sentence that names the first step and body in which the state here differs from another
   * player's; null: none does.
   */
  difference: string | null;
  /** Numbers of the players who are connected. */
  present: number[];
}

/** Starts a match. The scene must have `match`, which says how several play it. */
export async function play(
  run: number,
  module: SceneModule,
  engine: Engine,
  request: SceneRequest,
  readText: (file: string) => Promise<string>,
): Promise<Session> {
  const thud = await import("thud");
  const { own, host, port } = request.match!;
  const reader = own === host ? null : await readWelcome(port, new thud.WelcomeReader());
  // The choices of this visitor are not used: all players must run the same game.
  const asked = { ...request, choices: USUAL };
  let bare: Uint8Array<ArrayBuffer> = new Uint8Array();
  const session = (await setUp(run, module, engine, asked, readText, {
    kind: MatchSession,
    // Handles differ from world to world. But if this empty world is first restored to the snapshot
    // of the host's world when that was empty, the same calls give the same handles, so that the
    // handles which the scene keeps are valid in the host's state.
    made(world: World) {
      if (reader && reader.more.length > 0) world.restore(reader.more);
      bare = world.snapshot();
    },
  })) as MatchSession;
  const { match } = session.scene;
  if (!match) {
    session.close();
    throw new SceneError({ message: "This scene does not say how several play it." });
  }
  session.connect(request.match!, match, thud, bare, reader);
  return session;
}

/**
 * Waits until the host has sent the whole state of the game. Messages that come after it are kept
 * in `waiting`.
 */
function readWelcome(port: MessagePort, reader: WelcomeReader): Promise<WelcomeReader> {
  return new Promise((resolve, reject) => {
    const fail = (message: string) => reject(new SceneError({ message }));
    const later: MessageEvent[] = [];
    port.onmessage = (event: MessageEvent<ToMatch>) => {
      if (reader.isWhole) later.push(event);
      else if ("lost" in event.data) fail("The match cannot be joined: the connection has ended.");
      else if ("bytes" in event.data && reader.hear(new Uint8Array(event.data.bytes)) && reader.isWhole) {
        waiting.set(port, later);
        resolve(reader);
      }
    };
  });
}

/** Messages that came through a port after the host's state and before the scene was built. */
const waiting = new WeakMap<MessagePort, MessageEvent[]>();

class MatchSession extends Session {
  #rollback!: Rollback<number, object>;
  #peers!: RollbackPeers;
  #match!: SceneMatch;
  #port!: MessagePort;
  #timer: ReturnType<typeof setInterval> | undefined;
  #held: Input["held"] = noKeys();
  #waits = false;
  #rollbacks = 0;
  #correction = 0;
  #over = false;
  /** Whether the match is over because the others left on purpose; false: the connection ended. */
  #isLeft = false;
  /** Number of beats so far, and the number of the last beat in which packets were sent. */
  #beats = 0;
  #told = 0;

  /** A snapshot of the world of this match before the scene built anything in it. */
  #bare: Uint8Array<ArrayBuffer> = new Uint8Array();
  #own = 0;
  #host = 0;
  #players = 0;
  /** Numbers of the players who have joined and have not been sent the state of the game yet. */
  readonly #joined = new Set<number>();

  connect(
    { port, own, host, players, present }: Match,
    match: SceneMatch,
    thud: typeof import("thud"),
    bare: Uint8Array<ArrayBuffer>,
    reader: WelcomeReader | null,
  ): void {
    const { scene } = this;
    this.#match = match;
    this.#port = port;
    this.#bare = bare;
    this.#own = own;
    this.#host = host;
    this.#players = players;
    scene.keys = own < players ? playerKeys(scene.keys) : {};
    match.begin?.(own < players ? own : null);
    // The input of an absent player: `inputs`, which is above all possible inputs.
    const absent = match.inputs;
    this.#rollback = new thud.Rollback<number, object>(this.world, {
      idle: Array.from({ length: players }, () => absent),
      depth: DEPTH,
      state: scene.state ?? {},
      step: (inputs, state) => {
        scene.state = state;
        match.step(inputs.map((input) => (input === absent ? null : input)));
      },
    });
    const about = {
      ...{ rollback: this.#rollback, inputs: match.inputs, delay: INPUT_DELAY },
      send: (to: number, bytes: Uint8Array<ArrayBuffer>, sure: boolean) => this.#post({ to, bytes, sure }),
    };
    this.#peers = reader
      ? thud.RollbackPeers.join(reader, { ...about, host })
      : new thud.RollbackPeers({ ...about, players, own, depth: DEPTH });
    scene.state = this.#rollback.state;
    this.step = this.#rollback.steps;
    if (own === host) {
      for (let player = 1; player < players; player++) if (!present.includes(player)) this.#peers.miss(player);
      for (const other of present)
        for (const bytes of this.#peers.start(other)) this.#post({ to: other, bytes, sure: true });
    }
    port.onmessage = ({ data }: MessageEvent<ToMatch>) => this.#hear(data);
    for (const { data } of waiting.get(port) ?? []) this.#hear(data as ToMatch);
    this.#timer = setInterval(() => this.#beat(), BEAT);
    this.paint = this.#painted();
  }

  override close(): void {
    clearInterval(this.#timer);
    this.#port?.close();
    super.close();
  }

  /**
   * Ignores all commands except keys: anything else would change the world of this player, and not
   * those of the others.
   */
  override do(command: Command): void {
    if (command.kind === "keys") this.#held = command.held;
  }

  /** While the next step waits for inputs of others, the present step is the last one. */
  override get end(): number {
    return this.#waits || this.#over ? this.step : Infinity;
  }

  override makeStep(): void {
    if (this.companion) {
      this.companion = null;
      this.box2dTrouble = "A match runs in thud alone.";
    }
    const start = performance.now();
    const rollback = this.#rollback;
    this.#peers.give(this.#match.input(this.#held));
    this.#settle();
    this.#waits = !this.#peers.advance();
    for (let i = 0; i < CATCH_UP && this.#peers.isBehind && this.#peers.advance(); i++);
    this.#tell();
    this.paint = this.#painted();
    if (this.#waits) return;
    this.step = rollback.steps;
    this.samples.push({
      step: this.step,
      milliseconds: performance.now() - start,
      penetration: this.world.stepError().penetrationMax,
      awake: this.world.stats().awakeBodies,
    });
  }

  override seek(): boolean {
    throw new SceneError({ message: ALONE });
  }

  override rerun(): Rerun {
    throw new SceneError({ message: ALONE });
  }

  override review<T>(): [before: T, after: T] {
    throw new SceneError({ message: ALONE });
  }

  override startIn(): void {
    throw new SceneError({ message: ALONE });
  }

  /** Runs wrongly predicted steps again, and notes how far that moved a body. */
  #settle(): void {
    const rollback = this.#rollback;
    if (rollback.settled === rollback.steps) return;
    const before = this.world.poses(1).slice();
    rollback.settle();
    this.#rollbacks++;
    const now = this.world.poses(1);
    for (let at = 0; at < Math.min(before.length, now.length); at += 4) {
      const way = Math.hypot(now[at] - before[at], now[at + 1] - before[at + 1]);
      if (way < FARTHEST) this.#correction = Math.max(this.#correction, way);
    }
  }

  #hear(data: ToMatch): void {
    if (this.#over) return;
    const peers = this.#peers;
    this.#waits = false;
    if ("joined" in data) this.#joined.add(data.joined);
    else if ("follow" in data) {
      this.#host = data.follow;
      peers.follow(data.follow);
    } else if ("takeOver" in data) {
      this.#host = this.#own;
      this.#post({ tookOver: peers.takeOver() });
    } else if ("lost" in data) {
      this.#joined.delete(data.lost);
      const isLast = peers.lose(data.lost);
      this.#over = this.#own !== this.#host || (isLast && data.over);
      this.#isLeft = data.over;
      this.paint = this.#painted();
    } else {
      const { from, bytes } = data;
      peers.hear(from, new Uint8Array(bytes));
      if (!peers.tells(from) && peers.followers.has(from)) this.#post({ follower: from });
    }
  }

  /** What the scene paints. If no step can be made at present, its message says why. */
  #painted(): Paint {
    const paint = this.scene.paint?.() ?? {};
    if (this.#over) {
      const why = this.#isLeft ? "the others have left" : "the connection has ended";
      return { ...paint, message: `The match is over: ${why}.` };
    }
    return this.#waits ? { ...paint, message: "Waiting for the others…" } : paint;
  }

  /**
   * Called every BEAT milliseconds, so that the other players get packets even while no picture is
   * drawn, as in a hidden tab.
   */
  #beat(): void {
    this.#beats++;
    if (this.#beats - this.#told > 1) this.#tell();
    if (this.#beats % TOLD_EVERY === 0) this.#news();
  }

  #tell(): void {
    this.#told = this.#beats;
    if (this.#over) return;
    for (const number of this.#joined) {
      const messages = this.#peers.invite(number, { more: this.#bare });
      if (!messages) continue;
      this.#joined.delete(number);
      for (const bytes of messages) this.#post({ to: number, bytes, sure: true });
    }
    this.#peers.tell();
  }

  #news(): void {
    const peers = this.#peers;
    const rollback = this.#rollback;
    const news: MatchNews = {
      roundTrip: peers.roundTrip,
      rollbacks: this.#rollbacks,
      replayed: rollback.replayed,
      correction: this.#correction,
      ahead: rollback.ahead,
      waits: this.#waits,
      equal: peers.equal,
      final: { ...peers.final, step: Math.max(0, peers.final.step) },
      refused: peers.refused,
      difference: differenceOf(peers),
      present: Array.from({ length: this.#players }, (_, i) => i).filter((player) => !peers.isAbsent(player)),
    };
    this.#correction = 0;
    this.#post({ news });
  }

  #post(message: FromMatch): void {
    this.#port.postMessage(message);
  }
}

/**
 * The keys of a game in a match: without those of a second player at the same keyboard, and without
 * "restart", since one player must not restart the match.
 */
function playerKeys(keys: Scene["keys"] = []): KeyName[] | KeyWords {
  const isUsed = (name: string) => !/^restart$|2$/.test(name);
  if (Array.isArray(keys)) return keys.filter(isUsed);
  return Object.fromEntries(Object.entries(keys).filter(([name]) => isUsed(name)));
}

/** A sentence on how the state here differs from another player's; null: it does not. */
function differenceOf({ differs, difference }: RollbackPeers): string | null {
  if (differs < 0) return null;
  if (!difference) return `Step ${differs} differs.`;
  const { step, bodySlot, player } = difference;
  const body = bodySlot < 0 ? "" : ` first in body ${bodySlot}`;
  const told = player < 0 ? "" : `; the inputs of player ${player + 1} were told differently`;
  return `Step ${step} differs,${body}${told}.`;
}
