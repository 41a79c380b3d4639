/** The messages between the page and the worker in which physics runs. Types only. */
import type { Broadphase, Detection, Quality, Vec2 } from "thud";
import type { Control } from "../scene/controls";
import type { Frame } from "../scene/frame";
import type { OverlayName } from "../scene/overlays";
import type { KeyWords, ScenePanel, SceneSize, View } from "../scene/scene";
import type { Command } from "./commands";
import type { BodyReport } from "./inspect";
import type { Series, SeriesProgress } from "./measure";
import type { HeavierProgress, Heaviest } from "./measure-heavier";
import type { PriceProgress, Prices } from "./measure-prices";
import type { Collision, ContactList, Pair } from "./microscope";

/** What the visitor has chosen for every world; see WorldOptions. */
export interface Choices {
  quality: Quality;
  /** 0: that of the quality. */
  substeps: number;
  /** "auto": that of the quality. */
  detection: Detection | "auto";
  broadphase: Broadphase;
  /**
   * Largest error that the engine may leave, in length scales (World.setMaxError); 0: no such
   * limit.
   */
  maxError: number;
  /** Steps per second; 0: the scene's. */
  stepRate: number;
  /** Greatest speed along x and along y (WorldOptions.maximumSpeed), in length scales per second; 0:
   * the scene's. */
  topSpeed: number;
}

/** A recording of a world (thud/recording) that is played. */
export interface Recording {
  /** The name of its file, without the ending. */
  name: string;
  bytes: Uint8Array<ArrayBuffer>;
  /** The address of thud-recorded.wasm, which plays it. */
  wasm: string;
  /**
   * The step at which the recording is forked, that is from which the visitor can change what
   * happens; null: the recording plays.
   */
  fork: number | null;
}

/** What "record" has made. */
export interface Recorded {
  bytes: Uint8Array<ArrayBuffer>;
  /** The number of its steps. */
  steps: number;
}

/** A match over a network that a scene is played in; see worker/match.ts. */
export interface Match {
  /**
   * The port through which the worker sends packets to the other players and gets theirs; it is
   * transferred.
   */
  port: MessagePort;
  /**
   * The number of the player in this browser, from 0; `players` or more: this browser only watches.
   */
  own: number;
  /**
   * The number of the host, the player who sends the state of the game to those who join: the one
   * who invited them, or who has taken over since.
   */
  host: number;
  /** The number of players; some of them may join later. */
  players: number;
  /** Set by the host: the numbers of the other players who are connected when the match begins. */
  present: number[];
}

/** A scene to run, with its settings. */
export interface SceneRequest {
  /** The name of the module's file in web/public/scenes, without ".js". */
  name: string;
  /** The visitor's text, in place of the file's. */
  code?: string;
  /**
   * Texts by file name, such as a level that the visitor dropped; `readText` looks here before it
   * fetches a file of the page.
   */
  files?: Readonly<Record<string, string>>;
  /** Played in place of a scene; all that is said of scenes here is then ignored. */
  recording?: Recording;
  /** Makes the scene's steps together with other browsers; `size` is the number of players. */
  match?: Match;
  /** Clamped to the scene's sizes; undefined: the scene's usual size. */
  size?: number;
  seed: number;
  choices: Choices;
}

/**
 * What the page is told of a scene that runs. The fields come from the module and from what its
 * function returned (scene/scene.ts).
 */
export interface RunningScene {
  /** The number of this run; messages of earlier runs are ignored. */
  run: number;
  /** The title in the module that runs, which a visitor's text may have changed. */
  title: string | null;
  size: number;
  sizes: SceneSize | null;
  view: View;
  spawn: Vec2;
  lengthScale: number;
  timeStep: number;
  show: readonly OverlayName[];
  /** The scene's keys, each with what it does; "" where the scene does not say. */
  keys: KeyWords;
  pointer: boolean;
  notes: readonly string[];
  controls: readonly Control[];
  panel: ScenePanel | null;
  /** Whether it can be played over a network. */
  shared: boolean;
}

/** What the page shows at present, and which overlays it needs. */
export interface Look {
  /**
   * Poses and debug drawing are relative to `origin`. `lower` and `upper` are the corners of the
   * visible part of the world.
   */
  origin: Vec2;
  lower: Vec2;
  upper: Vec2;
  overlays: readonly OverlayName[];
  /** The slot of the body that the visitor points at, or null. */
  focus: number | null;
}

/** How Box2D runs beside the scene. */
export interface Box2DRequest {
  substeps: number;
}

/** Why a scene could not be run, or was stopped. */
export interface Trouble {
  message: string;
  /**
   * The file in which the error is, such as "scenes/artillery/tanks.js"; undefined: the scene's own
   * text.
   */
  file?: string;
  /** The place in that file, from 1. */
  line?: number;
  column?: number;
  details?: readonly string[];
  /** The scene holds so much memory that the page has to end its worker. */
  tooLarge?: boolean;
}

/** The world's hash after a step. */
export interface StateHash {
  step: number;
  hash: string;
}

/** The present state's hash, and the hash of the same step run again from a moment of the past. */
export interface Rerun extends StateHash {
  /** The step of that moment. */
  from: number;
  again: string;
}

/**
 * The questions that the page asks: for each, what is sent (`ask`) and what comes back (`answer`).
 * Each is answered once; some send progress messages before. See Client.ask.
 */
export interface Questions {
  /**
   * Loads the engine. `wasm` and `rest` are the addresses of its two files, `page` is the page's;
   * `threads` asks for the engine with threads. The answer is how many it has.
   */
  load: { ask: { wasm: string; rest?: string; threads?: number; page: string }; answer: number };
  /** Loads the part of the engine, and of the worker, that the first picture does not need. */
  complete: { ask: Record<string, never>; answer: void };
  /** Runs a scene in place of the present one. */
  run: { ask: SceneRequest; answer: RunningScene };
  choose: { ask: Pick<Choices, "quality" | "substeps" | "maxError">; answer: void };
  /**
   * Goes to a step that was made before. Steps after it stay reachable until a new step is made.
   */
  seek: { ask: { step: number; look: Look }; answer: Frame };
  /** Loads Box2D and runs it beside this scene and those that follow; null ends it. */
  box2d: { ask: Box2DRequest | null; answer: void };
  hash: { ask: Record<string, never>; answer: StateHash };
  /** Makes so many steps without drawing. */
  advance: { ask: { steps: number }; answer: StateHash };
  /** Goes back by so many steps, or as many as are kept, and runs to the present step again. */
  rerun: { ask: { steps: number }; answer: Rerun };
  /**
   * Records the running scene, from the oldest step that the history keeps to the present one.
   * `wasm` is the address of thud-recorded.wasm. The progress is the share that is done, 0 to 1.
   */
  record: { ask: { wasm: string }; answer: Recorded; progress: number };
  /** Lists and draws the calls of each step of a recording from now on, or ends that. */
  listCalls: { ask: { on: boolean }; answer: void };
  /** See World.bisectionLimit. */
  bisectionLimit: { ask: Record<string, never>; answer: number };
  /** The state of the body in a slot; null if there is none. */
  inspect: { ask: { slot: number }; answer: BodyReport | null };
  /** The contacts of the last step, of the body in a slot or (null) of all. */
  contacts: { ask: { slot: number | null }; answer: ContactList };
  /** One pair in the step that ended at `step`, taken apart. */
  examine: { ask: { pair: Pair; step: number }; answer: Collision };
  /** Makes steps until two shapes begin to touch or hit each other; false if none did. */
  runToContact: { ask: Record<string, never>; answer: boolean };
  /**
   * Measures a scene ("Measure"). The worker does nothing else meanwhile; to cancel, the page ends
   * it.
   */
  measure: { ask: SceneRequest; answer: Series; progress: SeriesProgress };
  /** Measures what each detection costs, and its error. */
  prices: { ask: Record<string, never>; answer: Prices; progress: PriceProgress };
  /** Measures the largest sizes of a scene ("Heavier"), likewise. */
  heavier: {
    ask: { scene: SceneRequest; sizes: SceneSize; hertz: number };
    answer: Heaviest & { withoutBox2D: string };
    progress: HeavierProgress;
  };
}
export type QuestionName = keyof Questions;
export type Progress<Name extends QuestionName> = Questions[Name] extends { progress: infer P }
  ? P
  : never;

export type ToWorker =
  | { kind: "ask"; id: number; name: QuestionName; value: unknown }
  | { kind: "command"; command: Command }
  /**
   * Asks for steps up to number `until`, as many as can be made in the time of a tick. The answer
   * is a frame.
   */
  | { kind: "tick"; run: number; until: number; look: Look };

export type ToPage =
  | { kind: "answer"; id: number; value?: unknown; trouble?: Trouble }
  | { kind: "progress"; id: number; value: unknown }
  | { kind: "frame"; frame: Frame }
  | { kind: "trouble"; run: number; trouble: Trouble };
