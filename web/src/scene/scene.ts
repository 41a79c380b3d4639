/**
 * What a scene is: a plain JavaScript module in web/public/scenes, which the page shows beside the
 * canvas as it stands there and runs again as the visitor edits it. It builds a world on the `thud`
 * package and says how to look at it. Of all this only `Paint`, `View` and the plain data in
 * `state` cross the border of threads.
 */
import type { Engine, Mover, MoverOptions, Vec2, World, WorldOptions } from "thud";
import type * as geometry from "thud/geometry";
import type { Level, readLevel } from "thud/level";
import type { Control, Readings } from "./controls";
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
  /**
   * A world; units are yours, y is up. The visitor's choices (quality, …) are put over the options.
   * @example const world = createWorld({ gravity: [0, -10] })
   */
  createWorld(options?: WorldOptions): World;
  /**
   * How many: the number that the visitor chose, in the range that the module's `size` says.
   * @example for (let i = 0; i < size; i++)
   */
  size: number;
  /**
   * The visitor's random seed; 0 unless chosen. Scenes that use no chance ignore it.
   * @example random(seed)
   */
  seed: number;
  /**
   * Numbers in [low, high), on every machine the same (SplitMix64). Each call starts anew.
   * @example const chance = random(seed); chance(-1, 1)
   */
  random(seed: number): (low: number, high: number) => number;
  /**
   * The nearest multiple of 2^-16. Places on it stay exact when a world is moved by whole numbers
   * up to 10^7.
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
   * The world of a map that was read, with the visitor's choices likewise.
   * @example const world = buildLevel(level)
   */
  buildLevel(level: Level): World;
  /**
   * Moves a game's character over ground.
   * @example createMover(world, { shape: { kind: "circle", radius: 0.4 }, position: [0, 2] })
   */
  createMover(world: World, options: MoverOptions): Mover;
  /**
   * Brings the geometry of two shapes, which needs no world: closest points, times of impact,
   * Minkowski sums, bounding volumes.
   * @example const { closestPoints } = await loadGeometry(); closestPoints(thud, a, b)
   */
  loadGeometry(): Promise<typeof geometry>;
  /**
   * The engine itself, without the visitor's choices.
   * @example thud.createWorld()
   */
  thud: Engine;
}

export interface Scene {
  /**
   * What runs. All else may be left out.
   * @example return { world }
   */
  world: World;
  /**
   * What to look at first, in world units. Without it the page fits what there is.
   * @example view: { x: 0, y: 5, height: 12 }
   */
  view?: View;
  /**
   * Before each step. Must depend on the world, `state` and `input` alone: it is run again when the
   * visitor goes back in time.
   * @example update({ held, step }) { … }
   */
  update?(input: Input): void;
  /**
   * After each step, with its events; otherwise as `update`.
   * @example stepped() { for (const { a } of world.impulses()) … }
   */
  stepped?(): void;
  /**
   * After each step: what to draw besides the bodies.
   * @example paint: () => ({ marks, figures, message })
   */
  paint?(): Paint;
  /**
   * Plain data that `update` changes; snapshots keep it, so that time can go back.
   * @example state: { score: 0 }
   */
  state?: object;
  /**
   * Keys that the scene wants, best with what each does: they come as held.left…, a phone gets
   * buttons for them, and the page tells how to play.
   * @example keys: { left: "walk", fire: "shoot" }
   */
  keys?: KeyName[] | KeyWords;
  /**
   * The pointer is the scene's: it comes to `update`, and drags no bodies.
   * @example pointer: true
   */
  pointer?: boolean;
  /**
   * As soon as the pointer moves, also while the scene stands. May change `state` alone, and by the
   * newest place alone: of several in one step the last is kept.
   * @example pointed: ({ x, y, down }) => { … }
   */
  pointed?(pointer: NonNullable<Input["pointer"]>): void;
  /**
   * Slots of bodies that the page does not draw, because `paint` does.
   * @example hidden: [ball.index]
   */
  hidden?: number[];
  /**
   * Where a visitor's new bodies drop by keyboard.
   * @example spawn: [0, 8]
   */
  spawn?: Vec2;
  /**
   * Overlays that are on from the start: what the scene is about.
   * @example show: ["contacts"]
   */
  show?: OverlayName[];
  /**
   * What the visitor sets in a panel beside the scene: values of `state`, by their names.
   * @example controls: [{ kind: "check", name: "wind", label: "Wind", about: "…", group: "Look at" }]
   */
  controls?: Control[];
  /**
   * What the visitor should be told: what of a level was left out.
   * @example notes: ["…"]
   */
  notes?: string[];
  /**
   * So many times two bodies, from the first on, are shown with their Minkowski sum.
   * @example sums: 1
   */
  sums?: number;
  /**
   * After `state` went back: what else must follow it (a mover).
   * @example restored() { … }
   */
  restored?(): void;
  /**
   * Frees what the scene made besides the world (movers).
   * @example close() { … }
   */
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
  /**
   * Steps made since the scene began.
   * @example step % 60 === 0
   */
  step: number;
  /**
   * Which keys are down: left, right, up, down, fire, restart.
   * @example if (held.left) …
   */
  held: Readonly<Record<KeyName, boolean>>;
  /**
   * In the world; `down` while pressed. Null until there is one, and without `Scene.pointer`.
   * @example pointer?.down
   */
  pointer: { x: number; y: number; down: boolean } | null;
}

export interface View {
  x: number;
  y: number;
  /** World units from top to bottom. */
  height: number;
  /** World units that must fit from left to right. */
  width?: number;
  /** In a window that is taller than that, the view stands low: what is thrown goes up. */
  low?: boolean;
  /** The view in a window that is taller than wide, as of a phone that is held upright. */
  tall?: Omit<View, "tall">;
}

/** Names of colours, which the page's light and dark themes define. */
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

export interface Paint {
  /**
   * The view goes after this place, gently.
   * @example follow: [x, y]
   */
  follow?: Vec2;
  /**
   * What is drawn over the bodies.
   * @example marks: [{ kind: "circle", x, y, radius, ink: "gold" }]
   */
  marks?: Mark[];
  /**
   * Figures of the game, at the top: score, wind, lives.
   * @example figures: [{ label: "Score", value: "3" }]
   */
  figures?: { label: string; value: string }[];
  /**
   * A line that tells what happened or what to do; said to screen readers when it changes.
   * @example message: "You won."
   */
  message?: string;
  /**
   * Rows to be read in the panel, by the name of the control under which they stand.
   * @example readings: { wind: [["Speed", "3 m/s"]] }
   */
  readings?: Readings;
  /**
   * Words on the keys' buttons in place of arrows. Such buttons are there beside a keyboard too, and
   * those without a word are not.
   * @example buttons: { left: "Undo", fire: "Drive" }
   */
  buttons?: KeyWords;
}

/**
 * In world units unless said otherwise; drawn in order, over the bodies. Places are smoothed
 * between two steps if both have as many marks of the same kinds.
 */
export type Mark = LineMark | CircleMark | BoxMark | FigureMark | TextMark;

/**
 * A line from point to point; filled, the area that it goes around, without an outline.
 * @example { kind: "line", points: [[0, 0], [1, 2]], ink: "soft" }
 */
export interface LineMark {
  kind: "line";
  points: Vec2[];
  ink: Ink;
  /** CSS pixels. Default 2. */
  width?: number;
  dashed?: boolean;
  /** 0 to 1. */
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
  /** 0 to 1. */
  opacity?: number;
  filled?: boolean;
}

/**
 * A box, turned by its angle.
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
  /** 0 to 1. */
  opacity?: number;
  filled?: boolean;
}

/**
 * A rounded box with eyes.
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
 * Words in their place.
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
