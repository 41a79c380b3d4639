/**
 * The interface of scenes. A scene is a plain JavaScript module in web/public/scenes. It builds a
 * world with the package `thud`, and says how to show it. The page shows its text beside the
 * canvas, and runs it again when the visitor has edited it. Scenes run in the worker; of all this
 * only `Paint`, `View` and the plain data in `state` are sent to the page.
 *
 * The comments of SceneSetting, Scene, Input, Paint and the marks are shown to visitors who edit a
 * scene (tools/code-names.mjs).
 */
import type { Engine, Mover, MoverOptions, Rollback, Vec2, World, WorldOptions } from "thud";
import type * as geometry from "thud/geometry";
import type { Level, readLevel } from "thud/level";
import type { Control, Readings } from "./controls";
import type { OverlayName } from "./overlays";

/** A module of web/public/scenes. */
export interface SceneModule {
  /** Its title in the menu. The page reads `title`, `about` and `menu` when it is built. */
  title?: string;
  /** What to look at, in one sentence. */
  about?: string;
  /**
   * Its group and place in the menu. Scenes are in the order of `place`; a group begins with its
   * first scene. Null for a module that is not in the menu.
   */
  menu?: { group: string; place: number } | null;
  /**
   * The number of things in the scene, which a visitor can choose ("heavier"). A scene without it
   * has one size.
   */
  size?: SceneSize;
  /** Builds the scene. May be asynchronous, to read a level from a file. */
  default(setting: SceneSetting): Scene | Promise<Scene>;
}

/**
 * `means` says what the number counts; `usual` is the default, and `least` and `most` are the
 * bounds.
 */
export interface SceneSize {
  means: string;
  usual: number;
  least: number;
  most: number;
}

/** What a scene's function is given. */
export interface SceneSetting {
  /**
   * Creates a world. The units are yours; y is up. The visitor's choices (quality, …) replace the
   * same options here.
   * @example const world = createWorld({ gravity: [0, -10] })
   */
  createWorld(options?: WorldOptions): World;
  /**
   * The number of things that the visitor chose, in the range of the module's `size`.
   * @example for (let i = 0; i < size; i++)
   */
  size: number;
  /**
   * The visitor's random seed; 0 unless chosen. Scenes without random numbers ignore it.
   * @example random(seed)
   */
  seed: number;
  /**
   * A generator of random numbers in [low, high), the same on every machine (SplitMix64). Each call
   * of `random` begins anew.
   * @example const chance = random(seed); chance(-1, 1)
   */
  random(seed: number): (low: number, high: number) => number;
  /**
   * The nearest multiple of 2^-16. Such places stay exact when a world is moved by whole numbers up
   * to 10^7.
   */
  grid(x: number): number;
  /**
   * The text of a file of this page.
   * @example await readText("terrain/jacksboro_100.csv")
   */
  readText(file: string): Promise<string>;
  /**
   * Reads a map of the Tiled editor.
   * @example const level = await readLevel("quarry", await readText("levels/quarry.tmj"))
   */
  readLevel: typeof readLevel;
  /**
   * Creates the world of a map. The visitor's choices replace its options.
   * @example const world = buildLevel(level)
   */
  buildLevel(level: Level): World;
  /**
   * Creates a mover, which moves a game's character over ground.
   * @example createMover(world, { shape: { kind: "circle", radius: 0.4 }, position: [0, 2] })
   */
  createMover(world: World, options: MoverOptions): Mover;
  /**
   * Loads the functions for two shapes without a world: closest points, times of impact, Minkowski
   * sums, bounding volumes.
   * @example const { closest } = await loadGeometry(); closest(thud, a, b)
   */
  loadGeometry(): Promise<typeof geometry>;
  /**
   * Loads the class Rollback, by which peers of a networked game run steps again as inputs arrive.
   * @example const Rollback = await loadRollback(); new Rollback(world, { idle: [0, 0], step })
   */
  loadRollback(): Promise<typeof Rollback>;
  /**
   * The engine itself. Worlds that it creates do not have the visitor's choices.
   * @example thud.createWorld()
   */
  thud: Engine;
}

/** What a scene's function returns: the world, and how it is shown, controlled and drawn. */
export interface Scene {
  /**
   * The world that runs. Everything else may be left out.
   * @example return { world }
   */
  world: World;
  /**
   * The part of the world that is shown first, in world units. Without it the page fits the bodies.
   * @example view: { x: 0, y: 5, height: 12 }
   */
  view?: View;
  /**
   * Called before each step. Must depend on the world, `state` and `input` alone, because it is
   * called again for the same steps when the visitor goes back in time.
   * @example update({ held, step }) { … }
   */
  update?(input: Input): void;
  /**
   * Called after each step, when the world has the step's events. The same rule applies as to
   * `update`.
   * @example stepped() { for (const { a } of world.impulseEvents()) … }
   */
  stepped?(): void;
  /**
   * Returns what to draw besides the bodies. Called after each step, at the start, and whenever the
   * visitor changes something or goes to another time; it must change nothing.
   * @example paint: () => ({ marks, figures, message })
   */
  paint?(): Paint;
  /**
   * Plain data that `update` changes. Snapshots contain it, so that the visitor can go back in
   * time.
   * @example state: { score: 0 }
   */
  state?: object;
  /**
   * The keys that the scene uses, best with what each does. They arrive as held.left and so on; a
   * phone gets buttons for them, and the page shows what they do.
   * @example keys: { left: "walk", fire: "shoot" }
   */
  keys?: KeyName[] | KeyWords;
  /**
   * Whether the scene uses the pointer: `update` gets its place, and the visitor cannot drag
   * bodies.
   * @example pointer: true
   */
  pointer?: boolean;
  /**
   * Called as soon as the pointer moves, also while the scene is paused. May change `state` alone,
   * and must depend on the last place alone: of several moves in one step only the last is kept.
   * @example pointed: ({ x, y, down }) => { … }
   */
  pointed?(pointer: NonNullable<Input["pointer"]>): void;
  /**
   * Slots of bodies that the page does not draw, because `paint` draws them.
   * @example hidden: [ball.index]
   */
  hidden?: number[];
  /**
   * Not used by this page: bodies that the visitor creates by keyboard appear at the crosshair, in
   * the middle of the view.
   * @example spawn: [0, 8]
   */
  spawn?: Vec2;
  /**
   * Overlays that are on when the scene begins.
   * @example show: ["contacts"]
   */
  show?: OverlayName[];
  /**
   * Controls in a panel beside the scene, which set values of `state` by their names.
   * @example controls: [{ kind: "check", name: "wind", label: "Wind", about: "…", group: "Look at" }]
   */
  controls?: Control[];
  /**
   * The panel that opens with the scene in place of Values: Trade, or the part Contacts of Inside.
   * @example panel: "contacts"
   */
  panel?: ScenePanel;
  /**
   * What a match over a network needs of a game; the page then has the panel Match.
   * @example match: { inputs: 8, input: ({ left }) => Number(left), step(inputs) { … } }
   */
  match?: SceneMatch;
  /**
   * Messages for the visitor, for example what of a level was left out.
   * @example notes: ["…"]
   */
  notes?: string[];
  /**
   * Number of pairs of bodies, from the first body on, that are shown with their Minkowski sum.
   * @example sums: 1
   */
  sums?: number;
  /**
   * Called after `state` was restored: restore here what depends on it (a mover).
   * @example restored() { … }
   */
  restored?(): void;
  /**
   * Frees what the scene made besides the world (movers).
   * @example close() { … }
   */
  close?(): void;
}

/** The panels that may open with a scene. */
export const SCENE_PANELS = ["trade", "contacts"] as const;
export type ScenePanel = (typeof SCENE_PANELS)[number];

/** The keys with a 2 are a second player's at the same keyboard: A, D and W. */
export const KEY_NAMES = [
  ...["left", "right", "up", "down", "fire", "restart"],
  ...["left2", "right2", "up2"],
] as ("left" | "right" | "up" | "down" | "fire" | "restart" | "left2" | "right2" | "up2")[];
export type KeyName = (typeof KEY_NAMES)[number];

/** What each key does, in a word or two: { left: "walk", right: "walk", up: "jump" }. */
export type KeyWords = Partial<Record<KeyName, string>>;

export function noKeys(): Record<KeyName, boolean> {
  return Object.fromEntries(KEY_NAMES.map((name) => [name, false])) as Record<KeyName, boolean>;
}

/**
 * A game that players in several browsers play together, as many as the scene's size says. Each
 * browser runs every step at once, and again where it did not know an input yet (class Rollback), so
 * that all that changes has to be in the world and in the scene's `state`, and `step` may depend on
 * these and on the inputs alone. `state` is a new object after steps were run again: read it from the
 * scene each time.
 */
export interface SceneMatch {
  /** The number of different inputs, 2 to 255: an input is a whole number below it; 0: no key. */
  inputs: number;
  /** The input of the keys that are held in this browser. */
  input(held: Input["held"]): number;
  /**
   * A match begins; `player` is the one of this browser, from 0; null: it only watches. Called before
   * the first step.
   */
  begin?(player: number | null): void;
  /**
   * One step of the game with the input of each player, the world's step included. Who has left, or has
   * not come yet, has no input: null.
   */
  step(inputs: readonly (number | null)[]): void;
}

/** What a player does during one step. */
export interface Input {
  /**
   * Number of steps made since the scene began.
   * @example step % 60 === 0
   */
  step: number;
  /**
   * Which keys are down: left, right, up, down, fire, restart.
   * @example if (held.left) …
   */
  held: Readonly<Record<KeyName, boolean>>;
  /**
   * The pointer's place in the world; `down` while it is pressed. Null before it has moved over the
   * page, and without `Scene.pointer`.
   * @example pointer?.down
   */
  pointer: { x: number; y: number; down: boolean } | null;
}

/** A view of the world about the place x, y. */
export interface View {
  x: number;
  y: number;
  /** Height of the view in world units. */
  height: number;
  /** Width in world units that must be visible as well. */
  width?: number;
  /**
   * In a window that is taller than the view, the view stands in the lower part, for scenes in
   * which things fly up.
   */
  low?: boolean;
  /** The view in a window that is taller than wide, such as a phone's. */
  tall?: Omit<View, "tall">;
}

/** Names of colours. The page's light and dark themes define them. */
export type Ink =
  | "ink" // text and outlines
  | "soft" // quiet lines
  | "accent"
  | "good"
  | "bad"
  | "gold"
  | "water"
  | "player" // the first player, the character
  | "rival"; // the second player

/** What a scene draws and shows besides the bodies. */
export interface Paint {
  /**
   * The place that the view follows smoothly.
   * @example follow: [x, y]
   */
  follow?: Vec2;
  /**
   * What is drawn over the bodies.
   * @example marks: [{ kind: "circle", x, y, radius, ink: "gold" }]
   */
  marks?: Mark[];
  /**
   * Figures of a game, shown at the top: score, wind, lives.
   * @example figures: [{ label: "Score", value: "3" }]
   */
  figures?: { label: string; value: string }[];
  /**
   * A line that says what happened or what to do. Screen readers say it when it changes.
   * @example message: "You won."
   */
  message?: string;
  /**
   * Rows of text in the panel, by the name of the control below which they are shown.
   * @example readings: { wind: [["Speed", "3 m/s"]] }
   */
  readings?: Readings;
  /**
   * Words on the buttons of keys, in place of arrows. Buttons with a word are shown beside a
   * keyboard, too; keys without a word then get no button.
   * @example buttons: { left: "Undo", fire: "Drive" }
   */
  buttons?: KeyWords;
}

/**
 * A mark is drawn over the bodies, in the order of the list. Sizes are in world units unless said
 * otherwise. Marks are interpolated between two steps if both have as many marks of the same kinds.
 */
export type Mark = LineMark | CircleMark | BoxMark | FigureMark | TextMark;

/**
 * A line from point to point; if filled, the area that it encloses, without an outline.
 * @example { kind: "line", points: [[0, 0], [1, 2]], ink: "soft" }
 */
export interface LineMark {
  kind: "line";
  points: Vec2[];
  ink: Ink;
  /** CSS pixels. Default 2. */
  width?: number;
  dashed?: boolean;
  /** Opacity from 0 to 1. */
  opacity?: number;
  filled?: boolean;
}

/**
 * A circle.
 * @example { kind: "circle", x, y, radius: 1, ink: "good" }
 */
export interface CircleMark {
  kind: "circle";
  x: number;
  y: number;
  radius: number;
  ink: Ink;
  /** Opacity from 0 to 1. */
  opacity?: number;
  filled?: boolean;
}

/**
 * A box, rotated by its angle.
 * @example { kind: "box", x, y, halfWidth: 1, halfHeight: 2, ink: "bad" }
 */
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
  /** Opacity from 0 to 1. */
  opacity?: number;
  filled?: boolean;
}

/**
 * A rounded box with eyes, which look to the left (-1) or right (1).
 * @example { kind: "figure", x, y, halfWidth: 1, halfHeight: 2, facing: 1, ink: "player" }
 */
export interface FigureMark {
  kind: "figure";
  x: number;
  y: number;
  halfWidth: number;
  halfHeight: number;
  facing: -1 | 1;
  ink: Ink;
}

/**
 * Text, centred at its place.
 * @example { kind: "text", x, y, text: "Hello", ink: "ink" }
 */
export interface TextMark {
  kind: "text";
  x: number;
  y: number;
  text: string;
  ink: Ink;
  /** CSS pixels. Default 14. */
  size?: number;
}
