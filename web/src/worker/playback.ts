/**
 * Plays recordings of worlds (thud/recording) as if they were scenes. "Fork here" makes a world of
 * one of their steps that the visitor can change. Imported, with the engine that plays them, when
 * the first recording is opened.
 */
import type { Engine } from "thud";
import { load } from "thud/first";
import { Player } from "thud/recording";
import type { Calls } from "../scene/frame";
import type { Paint, Scene, View } from "../scene/scene";
import { messageOf } from "../shared/error";
import { checkScene } from "./check";
import type { Command } from "./commands";
import { History } from "./history";
import { listCalls, markCalls } from "./played-calls";
import type { Recording, Rerun } from "./protocol";
import { Session } from "./session";
import { describe } from "./stage";
import { SceneError } from "./trouble";

/** The commands by which visitors change bodies; they are refused while a recording plays. */
const BY_HAND: readonly Command["kind"][] = ["grab", "spawn", "explode", "dig"];
/** Number of steps for which the message REFUSAL is shown. Chosen. */
const TOLD = 180;
const REFUSAL = "A recording plays as it was made. Fork it to change what happens.";

/** The name of the chunk in which the page notes how a recording is shown; see `Shown`. */
export const SHOWN = "thud-page";

/** How the scene was shown that was recorded, as JSON in the chunk SHOWN. */
export interface Shown {
  view: View;
  lengthScale: number;
}

/** The engine of thud-recorded.wasm, loaded once. */
let engine: Promise<Engine> | null = null;

/** That engine. A failure to load it is forgotten. */
export function recordedEngine(wasm: string): Promise<Engine> {
  engine ??= load(wasm);
  engine.catch(() => (engine = null));
  return engine;
}

/** Opens a recording. Throws a SceneError if it is none, or damaged. */
export async function play(recording: Recording, run: number): Promise<Session> {
  if (run === 0)
    throw new SceneError({
      message: "Only what a scene builds can be measured: a recording cannot be built anew.",
    });
  const recorded = await recordedEngine(recording.wasm);
  const { name, fork } = recording;
  const shown = shownIn(recorded, recording);
  const player = openPlayer(recorded, recording);
  try {
    if (fork === null) return new Playback(run, player, name, shown);
    player.seek(fork);
    return new Fork(run, player, `${name}, from step ${fork} on`, shown, {});
  } catch (error) {
    player.close();
    throw error;
  }
}

function openPlayer(recorded: Engine, { name, bytes }: Recording): Player {
  try {
    return new Player(recorded, bytes, { calls: true });
  } catch (error) {
    // The engine says first which kind of error it is, and then what is wrong.
    const why = messageOf(error).replace(/^.*player: /, "");
    throw new SceneError({ message: `“${name}” cannot be played: ${why}` });
  }
}

/**
 * How the page showed the world when it recorded it; {} for a recording made elsewhere. The note is
 * a chunk that comes with the first step, so a second player is opened here to make that step.
 */
function shownIn(recorded: Engine, recording: Recording): Partial<Shown> {
  const player = openPlayer(recorded, recording);
  try {
    player.step();
    const chunk = player.chunks.find(({ name }) => name === SHOWN);
    if (!chunk) return {};
    const { view, lengthScale } = JSON.parse(new TextDecoder().decode(chunk.bytes)) as Shown;
    checkScene({ world: player.world, view });
    return lengthScale > 0 && Number.isFinite(lengthScale) ? { view, lengthScale } : { view };
  } catch {
    // If the first step differs from what was recorded, that is reported when it plays. A note that
    // cannot be read is ignored.
    return {};
  } finally {
    player.close();
  }
}

/** The history of a recording: the visitor can go to any of its steps. */
class Recorded extends History {
  constructor(private readonly player: Player) {
    super();
  }

  override get first(): number {
    return this.player.progress.first;
  }

  override get last(): number {
    return this.player.progress.end;
  }
}

/** A session whose world belongs to a player. */
export abstract class Played extends Session {
  constructor(
    run: number,
    protected readonly player: Player,
    title: string,
    { view, lengthScale = 1 }: Partial<Shown>,
    scene: Omit<Scene, "world">,
    history?: History,
  ) {
    const { world } = player;
    const { timeStep } = world.stepSettings();
    super(run, { world, view, ...scene }, 0, null, lengthScale, timeStep, title, [], history);
  }

  /** The calls that made the world are not known. */
  override get tied(): boolean {
    return true;
  }

  override close(): void {
    this.companion?.end();
    this.player.close();
  }
}

/**
 * A recording that plays. Its steps have the recording's numbers; one made with `ringSteps` has
 * lost its first steps and begins at `progress.first`.
 */
export class Playback extends Played {
  /** The step up to which the message REFUSAL is shown. */
  #told = -1;
  /** Whether calls are listed and drawn, and the height of the view, by which they are. */
  #lists = false;
  #height = 0;

  constructor(run: number, player: Player, title: string, shown: Partial<Shown>) {
    super(run, player, title, shown, { paint: () => paintOf(player) }, new Recorded(player));
    this.step = player.progress.first;
  }

  override get end(): number {
    const { end, difference } = this.player.progress;
    return difference ? this.step : end;
  }

  override get calls(): Calls | undefined {
    return this.#lists ? listCalls(this.player.calls) : undefined;
  }

  override listCalls(on: boolean): void {
    this.#lists = on;
    this.#height ||= describe(this).view.height;
    this.#show();
  }

  override do({ kind }: Command): void {
    if (!BY_HAND.includes(kind)) return;
    this.#told = this.step + TOLD;
    this.#show();
  }

  override makeStep(): void {
    const start = performance.now();
    this.#play(() => this.player.step());
    this.samples.push({
      step: this.step,
      milliseconds: performance.now() - start,
      penetration: this.world.stepError().penetrationMax,
      awake: this.world.stats().awakeBodies,
    });
  }

  override seek(step: number): boolean {
    const { first, last } = this.history;
    if (step < first || step > last) return false;
    this.#told = -1;
    this.#play(() => this.#goTo(step));
    return true;
  }

  override rerun(steps: number): Rerun {
    const { step, hash } = this.hash;
    const from = Math.max(this.history.first, step - steps);
    this.player.seek(from);
    this.#goTo(step);
    return { from, step, hash, again: this.world.hash() };
  }

  override review<T>(step: number, read: () => T): [before: T, after: T] {
    if (step <= this.history.first) throw new Error(`Step ${step} is not in the recording.`);
    const present = this.step;
    try {
      this.player.seek(step - 1);
      const before = read();
      this.player.seek(step);
      return [before, read()];
    } finally {
      this.#goTo(present);
    }
  }

  /**
   * Goes to a step, by seeking to the step before it and playing the step itself, since the player
   * reports the calls only of steps that it plays.
   */
  #goTo(step: number): void {
    const { first } = this.history;
    this.player.seek(Math.max(first, step - 1));
    if (step > first) this.player.step();
  }

  /**
   * Plays or seeks (`act`). If what happens differs from what was recorded, nothing is thrown:
   * `paintOf` shows it.
   */
  #play(act: () => unknown): void {
    try {
      act();
    } catch (error) {
      if (!this.player.progress.difference) throw error;
    }
    this.step = this.player.progress.steps;
    this.#show();
  }

  #show(): void {
    const paint = paintOf(this.player);
    if (this.step < this.#told) paint.message ??= REFUSAL;
    if (this.#lists) {
      const { calls, world } = this.player;
      paint.marks = [...markCalls(calls, world, this.#height), ...(paint.marks ?? [])];
    }
    this.paint = paint;
  }
}

/**
 * A session that begins with the world of one step of a recording. The player makes no more of its
 * steps: the world goes on by ordinary steps, and the visitor can change it.
 */
class Fork extends Played {
  /** The engine does not time this world: its clock was not recorded. */
  override makeStep(): void {
    const start = performance.now();
    super.makeStep();
    this.samples.at(-1)!.milliseconds = performance.now() - start;
  }
}

/** How far a recording has been played, and where what happens differs from it. */
function paintOf({ progress, world }: Player): Paint {
  const { end, steps, hashes, difference } = progress;
  const figures = [
    { label: "Step", value: `${steps} of ${end}` },
    { label: "Hashes equal", value: String(hashes) },
  ];
  if (!difference) return { figures };
  const { after, at, body } = difference;
  const which = after + 1 < at ? `One of the steps ${after + 1} to ${at}` : `Step ${at}`;
  const first = body ? ` The first body that differs is number ${body.index}, marked here.` : "";
  const message = `${which} is not what was recorded.${first}`;
  if (!body || !world.isValid(body)) return { figures, message };
  const [x, y] = world.bodyStateOf(body).position;
  return {
    figures,
    message,
    marks: [
      { kind: "circle", x, y, radius: 1, ink: "bad" },
      { kind: "text", x, y, text: "differs", ink: "bad" },
    ],
  };
}
