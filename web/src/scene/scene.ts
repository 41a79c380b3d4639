/**
 * What a scene is: a plain JavaScript module in web/public/scenes, which the page shows beside the
 * canvas as it stands there and runs again as the visitor edits it. It builds a world on the `thud`
 * package and says how to look at it. Of all this only `Paint`, `View` and the plain data in
 * `state` cross the border of threads.
 */
import type { Engine, Mover, MoverOptions, Vec2, World, WorldOptions } from "thud";
import type { Level, readLevel } from "thud/level";
import type { OverlayName } from "./overlays";

/** A module of web/public/scenes. */
export interface SceneModule {
  /** What it is called in the menu. The page reads this and the next two when it is built. */
  title?: string;
  /** What to look at, in one sentence. */
  about?: string;
  /**
   * Where it stands in the menu, which goes by `place` upwards; a group begins with its first scene.
   * Null for a module that is in no menu.
   */
  menu?: { group: string; place: number } | null;
  /** The number that a visitor may turn up ("heavier"); a scene without has one size. */
  size?: SceneSize;
  /** May be asynchronous: a level is read from a file first. */
  default(setting: SceneSetting): Scene | Promise<Scene>;
}

export interface SceneSize {
  means: string;
  usual: number;
  least: number;
  most: number;
}

/** What a scene is given. */
export interface SceneSetting {
  thud: Engine;
  /** As `thud.createWorld`, with the visitor's choices (quality, …) put over the options. */
  createWorld(options?: WorldOptions): World;
  /** As the package's, with the visitor's choices likewise; after `readLevel`. */
  buildLevel(level: Level): World;
  readLevel: typeof readLevel;
  createMover(world: World, options: MoverOptions): Mover;
  /** The text of a file of the page: "levels/quarry.tmj", "terrain/jacksboro_100.csv". */
  readText(file: string): Promise<string>;
  /** Between `size.least` and `size.most`. */
  size: number;
  /** The visitor's; 0 unless chosen. Scenes that use no chance ignore it. */
  seed: number;
  /** Uniform in [low, high), on every machine the same (SplitMix64). Each call starts anew. */
  random(seed: number): (low: number, high: number) => number;
  /**
   * The nearest multiple of 2^-16. Places on it stay exact when a world is moved by whole numbers
   * up to 10^7.
   */
  grid(x: number): number;
}

export interface Scene {
  world: World;
  /** What to look at first, in world units. Without it the page fits what there is. */
  view?: View;
  /** Where a visitor's new bodies drop by keyboard. */
  spawn?: Vec2;
  /** What the visitor should be told: what of a level was left out. */
  notes?: string[];
  /** What the scene is about is shown from the start. */
  show?: OverlayName[];
  /** So many times two bodies, from the first on, are shown with their Minkowski sum. */
  sums?: number;
  /**
   * Keys that the scene wants, best with what each does: they come as `Input.held`, a phone gets
   * buttons for them, and the page tells how to play.
   */
  keys?: KeyName[] | KeyWords;
  /** The hand is the scene's (it comes as `Input.pointer`) and not the page's to drag bodies. */
  pointer?: boolean;
  /** Slots of bodies that the page does not draw, because `paint` does. */
  hidden?: number[];
  /** Plain data that `update` changes; snapshots keep it, so that time can go back. */
  state?: object;
  /** After `state` went back: what else must follow it (a mover). */
  restored?(): void;
  /**
   * Before each step. Must depend on the world, `state` and `input` alone: it is run again when
   * the visitor goes back in time.
   */
  update?(input: Input): void;
  /** After each step: what to draw besides the bodies. */
  paint?(): Paint;
  /** Frees what the scene made besides the world (movers). */
  close?(): void;
}

export const KEY_NAMES = ["left", "right", "up", "down", "fire", "restart"] as const;
export type KeyName = (typeof KEY_NAMES)[number];

/** What keys are for, in a word or two: { left: "walk", right: "walk", up: "jump" }. */
export type KeyWords = Partial<Record<KeyName, string>>;

export function noKeys(): Record<KeyName, boolean> {
  return { left: false, right: false, up: false, down: false, fire: false, restart: false };
}

/** What a player does during one step. */
export interface Input {
  /** Steps made since the scene began. */
  step: number;
  held: Readonly<Record<KeyName, boolean>>;
  /** In the world; `down` while pressed. Null until there is one, and without `Scene.pointer`. */
  pointer: { x: number; y: number; down: boolean } | null;
}

export interface View {
  x: number;
  y: number;
  /** World units from top to bottom. */
  height: number;
  /** World units that must fit from left to right. */
  width?: number;
}

/** Names of colours, which the page's light and dark themes define. */
export type Ink =
  | "ink" // text and outlines
  | "soft" // quiet lines
  | "accent"
  | "good"
  | "bad"
  | "gold"
  | "player" // the first player, the character
  | "rival"; // the second player

export interface Paint {
  /** The view goes after this place, gently. */
  follow?: Vec2;
  marks?: Mark[];
  /** Figures of the game, at the top: score, wind, lives. */
  figures?: { label: string; value: string }[];
  /** A line that tells what happened or what to do; said to screen readers when it changes. */
  message?: string;
}

/**
 * In world units unless said otherwise; drawn in order, over the bodies. Places are smoothed
 * between two steps if both have as many marks of the same kinds.
 */
export type Mark = LineMark | CircleMark | BoxMark | FigureMark | TextMark;

export interface LineMark {
  kind: "line";
  points: Vec2[];
  ink: Ink;
  /** CSS pixels. Default 2. */
  width?: number;
  dashed?: boolean;
}

export interface CircleMark {
  kind: "circle";
  x: number;
  y: number;
  radius: number;
  ink: Ink;
  /** 0 to 1. */
  opacity?: number;
  filled?: boolean;
}

export interface BoxMark {
  kind: "box";
  x: number;
  y: number;
  halfWidth: number;
  halfHeight: number;
  angle?: number;
  /** Radius of the corners. */
  round?: number;
  ink: Ink;
  /** 0 to 1. */
  opacity?: number;
  filled?: boolean;
}

/** A rounded box with eyes. */
export interface FigureMark {
  kind: "figure";
  x: number;
  y: number;
  halfWidth: number;
  halfHeight: number;
  facing: -1 | 1;
  ink: Ink;
}

export interface TextMark {
  kind: "text";
  x: number;
  y: number;
  text: string;
  ink: Ink;
  /** CSS pixels. Default 14. */
  size?: number;
}
