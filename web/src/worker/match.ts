/**
 * A scene that players in several browsers play together (Scene.match): its steps are made by a
 * Rollback. The page carries the packets, since only it can open connections (page/match). Imported
 * when the first match begins.
 */
import type { Engine, Rollback } from "thud";
import { type Input, noKeys, type Paint, type SceneMatch, type SceneModule } from "../scene/scene";
import { USUAL } from "../page/url";
import type { Command } from "./commands";
import { Peers } from "./match-peers";
import type { Match, Rerun, SceneRequest } from "./protocol";
import { Session } from "./session";
import { setUp } from "./stage";
import { SceneError } from "./trouble";

/** Steps that an input may arrive late. Chosen: a second and a half at 60 steps a second. */
const DEPTH = 90;
/** Milliseconds between two looks at whether something has to be told although no step was made. */
const BEAT = 40;
/** Beats between two messages to the page of how the match goes. Chosen. */
const TOLD_EVERY = 5;
/** The most that a body may move in one correction to count; far more is a new round. Chosen. */
const FARTHEST = 50;

const ALONE = "All players make a match’s steps together: this works in a game of your own.";

/** What the page sends through the port of a match. */
export type ToMatch = { from: number; bytes: ArrayBuffer } | { lost: number };

/** What it gets. */
export type FromMatch =
  | { to: number; bytes: Uint8Array<ArrayBuffer>; sure: boolean }
  | { news: MatchNews };

/** How a match goes. */
export interface MatchNews {
  /** Milliseconds there and back; null: not known yet. */
  roundTrip: number | null;
  /** How often steps were run again, and how many in all. */
  rollbacks: number;
  replayed: number;
  /** The largest way by which a body was corrected since the last news, in world units. */
  correction: number;
  /** Steps by which this player is ahead of the others. */
  ahead: number;
  /** The next step waits for inputs of others. */
  waits: boolean;
  /** Hashes of others that were compared and equal; the last final one, and its step. */
  equal: number;
  final: { step: number; hash: string };
  refused: number;
  /** What is wrong: the first step and body that differ; null: nothing. */
  difference: string | null;
}

/** Starts a match of a scene that says how it is played. */
export async function play(
  run: number,
  module: SceneModule,
  engine: Engine,
  request: SceneRequest,
  readText: (file: string) => Promise<string>,
): Promise<Session> {
  const { Rollback } = await import("thud");
  // What a visitor has chosen for other scenes would make another game of it.
  const asked = { ...request, choices: USUAL };
  const session = (await setUp(run, module, engine, asked, readText, {
    kind: MatchSession,
  })) as MatchSession;
  const { match } = session.scene;
  if (!match) {
    session.close();
    throw new SceneError({ message: "This scene does not say how several play it." });
  }
  session.connect(request.match!, match, Rollback);
  return session;
}

class MatchSession extends Session {
  #rollback!: Rollback<number, object>;
  #peers!: Peers;
  #match!: SceneMatch;
  #port!: MessagePort;
  #timer: ReturnType<typeof setInterval> | undefined;
  #held: Input["held"] = noKeys();
  #waits = false;
  #rollbacks = 0;
  #correction = 0;
  #over = false;
  /** Beats in all, and the last in which a packet was sent. */
  #beats = 0;
  #told = 0;

  connect({ port, own }: Match, match: SceneMatch, kind: typeof Rollback): void {
    const { scene, size: players } = this;
    this.#match = match;
    this.#port = port;
    match.begin?.(own);
    this.#rollback = new kind<number, object>(this.world, {
      idle: Array.from({ length: players }, () => 0),
      depth: DEPTH,
      state: scene.state ?? {},
      step: (inputs, state) => {
        scene.state = state;
        match.step(inputs);
      },
    });
    scene.state = this.#rollback.state;
    this.#peers = new Peers({
      ...{ rollback: this.#rollback, players, own, inputs: match.inputs, depth: DEPTH },
      send: (to, bytes, sure) => this.#post({ to, bytes, sure }),
    });
    port.onmessage = ({ data }: MessageEvent<ToMatch>) => this.#hear(data);
    this.#timer = setInterval(() => this.#beat(), BEAT);
    this.paint = this.#painted();
  }

  override close(): void {
    clearInterval(this.#timer);
    this.#port?.close();
    super.close();
  }

  /** Only keys: anything else would change this player’s world alone. */
  override do(command: Command): void {
    if (command.kind === "keys") this.#held = command.held;
  }

  /** While the next step waits for others there is none. */
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
    this.#waits = !rollback.advance();
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
    this.#waits = false;
    if ("lost" in data) {
      this.#over = this.#peers.lose(data.lost);
      this.paint = this.#painted();
    } else this.#peers.hear(data.from, new Uint8Array(data.bytes));
  }

  /** What the scene draws; where no step can be made, why. */
  #painted(): Paint {
    const paint = this.scene.paint?.() ?? {};
    if (this.#over) return { ...paint, message: "The match is over: the others have left." };
    return this.#waits ? { ...paint, message: "Waiting for the others…" } : paint;
  }

  /** Also while no picture is due, as in a hidden tab, the others get what they wait for. */
  #beat(): void {
    this.#beats++;
    if (this.#beats - this.#told > 1) this.#tell();
    if (this.#beats % TOLD_EVERY === 0) this.#news();
  }

  #tell(): void {
    this.#told = this.#beats;
    if (!this.#over) this.#peers.tell();
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
      final: peers.final,
      refused: peers.refused,
      difference: differenceOf(peers),
    };
    this.#correction = 0;
    this.#post({ news });
  }

  #post(message: FromMatch): void {
    this.#port.postMessage(message);
  }
}

/** In words, what differs from another player; null: nothing. */
function differenceOf({ differs, difference }: Peers): string | null {
  if (differs < 0) return null;
  if (!difference) return `Step ${differs} differs.`;
  const { step, bodySlot, player } = difference;
  const body = bodySlot < 0 ? "" : ` first in body ${bodySlot}`;
  const told = player < 0 ? "" : `; the inputs of player ${player + 1} were told differently`;
  return `Step ${step} differs,${body}${told}.`;
}
