/**
 * Creates what a scene's function is given. It is the same in the worker and in Node.js (tests,
 * thumbnails).
 */
import type { Engine, Mover, Rollback, WorldOptions } from "thud";
import type * as geometry from "thud/geometry";
import type * as level from "thud/level";
import { random } from "./random";
import type { SceneModule, SceneSetting } from "./scene";

/** What `createSetting` needs. */
export interface SettingOptions {
  thud: Engine;
  /** The visitor's choices, which replace the scene's options. */
  choices?: WorldOptions;
  /** The size that the visitor asks for; see `sizeOf`. */
  size?: number;
  seed?: number;
  readText(file: string): Promise<string>;
  /** Loads the reader of levels, when a scene first reads one. */
  loadReader?(): Promise<typeof level>;
  /** The class Mover; undefined where it is not loaded, as for the page's first scene. */
  mover?: typeof Mover;
  /** Loads the functions for two shapes, when a scene first needs them. */
  loadGeometry?(): Promise<typeof geometry>;
  /** Loads the class Rollback, when a scene first needs it. */
  loadRollback?(): Promise<typeof Rollback>;
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
    loadRollback = () => import("thud").then(({ Rollback }) => Rollback),
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
    async readLevel(name, content, options) {
      reader ??= await loadReader();
      return reader.readLevel(name, content, { engine: thud, ...options });
    },
    createMover(world, options) {
      if (!mover) throw new Error("Movers could not be loaded.");
      return new mover(world, options);
    },
    readText,
    loadGeometry,
    loadRollback,
    size: sizeOf(module, size),
    seed,
    random,
    grid,
  };
}

/**
 * The size at which a module runs if the visitor asks for `wanted`: that, within the module's
 * bounds, or the usual size; 0 for a module without sizes.
 */
export function sizeOf({ size }: SceneModule, wanted?: number): number {
  if (!size) return 0;
  const whole = Math.floor(wanted ?? size.usual);
  return Math.min(size.most, Math.max(size.least, whole));
}

/** See SceneSetting. The same as scene_grid in demo/scene/scene.c. */
function grid(x: number): number {
  return Math.floor(x * 65536 + 0.5) / 65536;
}
