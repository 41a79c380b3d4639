/** What a scene module is given: the same in the worker and in Node.js (tests, thumbnails). */
import type { Engine, Mover, WorldOptions } from "thud";
import type * as geometry from "thud/geometry";
import type * as level from "thud/level";
import { random } from "./random";
import type { SceneModule, SceneSetting } from "./scene";

export interface SettingOptions {
  thud: Engine;
  /** The visitor's: put over what the scene asks for. */
  choices?: WorldOptions;
  /** Brought between the module's least and most; without it the usual one. */
  size?: number;
  seed?: number;
  readText(file: string): Promise<string>;
  /** The reader of levels, which is loaded with the first one. */
  loadReader?(): Promise<typeof level>;
  /** Which the page's first scene goes without. */
  mover?: typeof Mover;
  /** Geometry, which is loaded with the first scene that is about it. */
  loadGeometry?(): Promise<typeof geometry>;
}

export function createSetting(
  module: SceneModule,
  {
    thud,
    choices = {},
    size,
    seed = 0,
    readText,
    mover,
    loadReader = () => import("thud/level"),
    loadGeometry = () => import("thud/geometry"),
  }: SettingOptions,
): SceneSetting {
  let reader: typeof level | undefined;
  return {
    thud,
    createWorld: (options = {}) => thud.createWorld({ ...options, ...choices }),
    buildLevel(level) {
      if (!reader) throw new Error("readLevel comes before buildLevel.");
      return reader.buildLevel(thud, level, choices);
    },
    async readLevel(...request) {
      reader ??= await loadReader();
      return reader.readLevel(...request);
    },
    createMover(world, options) {
      if (!mover) throw new Error("Movers could not be loaded.");
      return new mover(world, options);
    },
    readText,
    loadGeometry,
    size: sizeOf(module, size),
    seed,
    random,
    grid,
  };
}

/** The size that a module is run at when a visitor asks for `size`. */
export function sizeOf({ size }: SceneModule, wanted?: number): number {
  if (!size) return 0;
  const whole = Math.floor(wanted ?? size.usual);
  return Math.min(size.most, Math.max(size.least, whole));
}

/** See SceneSetting. Equal to scene_grid in demo/scene/scene.c. */
function grid(x: number): number {
  return Math.floor(x * 65536 + 0.5) / 65536;
}
