/** The messages between the page and the worker in which physics runs. Types only. */
import type { Broadphase, Detection, Quality, Vec2 } from "thud";
import type { Control } from "../scene/controls";
import type { Frame } from "../scene/frame";
import type { OverlayName } from "../scene/overlays";
import type { KeyWords, SceneSize, View } from "../scene/scene";
import type { Command } from "./commands";
import type { BodyReport } from "./inspect";
import type { Series, SeriesProgress } from "./measure";
import type { HeavierProgress, Heaviest } from "./measure-heavier";

/** What the visitor has chosen for every world. */
export interface Choices {
  quality: Quality;
  /** 0: the quality's. */
  substeps: number;
  /** "auto": the quality's. */
  detection: Detection | "auto";
  broadphase: Broadphase;
  /** In length scales; 0: none. */
  maxError: number;
}

/** What to run. */
export interface SceneRequest {
  /** Of web/public/scenes, without its ending. */
  name: string;
  /** The visitor's own text in place of the file's. */
  code?: string;
  /** Files that `readText` finds before those of the page: a level that was dropped. */
  files?: Readonly<Record<string, string>>;
  /** Clamped to the scene's; without it the usual one. */
  size?: number;
  seed: number;
  choices: Choices;
}

/** What the page knows of a scene that runs. */
export interface RunningScene {
  run: number;
  /** As its module says: a visitor's text may say another than the file's. */
  title: string | null;
  size: number;
  sizes: SceneSize | null;
  view: View;
  spawn: Vec2;
  lengthScale: number;
  timeStep: number;
  show: readonly OverlayName[];
  /** With what each does, or "". */
  keys: KeyWords;
  pointer: boolean;
  notes: readonly string[];
  controls: readonly Control[];
}

/** What the page sees, and what it wants drawn there by the engine. */
export interface Look {
  origin: Vec2;
  lower: Vec2;
  upper: Vec2;
  overlays: readonly OverlayName[];
  /** The slot of a body that is looked at. */
  focus: number | null;
}

/** How Box2D goes along. */
export interface Box2DRequest {
  substeps: number;
}

/** Why a scene could not be run or stopped; `line` and `column` (from 1) are of its own text. */
export interface Trouble {
  message: string;
  /** Of a file that the scene imports, as "scenes/artillery/tanks.js"; without it the scene's. */
  file?: string;
  line?: number;
  column?: number;
  details?: readonly string[];
}

export interface StateHash {
  step: number;
  hash: string;
}

/** The present state's hash, as it is and as it came out again from a moment of the past. */
export interface Rerun extends StateHash {
  from: number;
  again: string;
}

/** Requests that are answered once each, some with news on the way; see Client.ask. */
export interface Questions {
  load: { ask: { wasm: string; rest?: string; page: string }; answer: void };
  /** Brings the part of the engine that a first picture does not need. */
  complete: { ask: Record<string, never>; answer: void };
  run: { ask: SceneRequest; answer: RunningScene };
  choose: { ask: Pick<Choices, "quality" | "substeps" | "maxError">; answer: void };
  /** Goes to a step of the past, or on from there; the future stays until a step is made. */
  seek: { ask: { step: number; look: Look }; answer: Frame };
  /** Loads Box2D and runs it beside this scene and all that follow; null ends that. */
  box2d: { ask: Box2DRequest | null; answer: void };
  hash: { ask: Record<string, never>; answer: StateHash };
  /** Makes steps without a display, and tells the state's hash after them. */
  advance: { ask: { steps: number }; answer: StateHash };
  /** Goes back by so many steps, or as many as are kept, and runs to the present again. */
  rerun: { ask: { steps: number }; answer: Rerun };
  /** See World.bisectionLimit. */
  bisectionLimit: { ask: Record<string, never>; answer: number };
  /** A body's state; null if none has the slot. */
  inspect: { ask: { slot: number }; answer: BodyReport | null };
  /** Takes a worker to itself; ending the worker ends it. */
  measure: { ask: SceneRequest; answer: Series; progress: SeriesProgress };
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
  /** Steps are made until `until`, or for as long as the page can wait; a frame answers. */
  | { kind: "tick"; run: number; until: number; look: Look };

export type ToPage =
  | { kind: "answer"; id: number; value?: unknown; trouble?: Trouble }
  | { kind: "progress"; id: number; value: unknown }
  | { kind: "frame"; frame: Frame }
  | { kind: "trouble"; run: number; trouble: Trouble };
