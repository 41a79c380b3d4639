/** What the page can run: the built-in scenes of the wasm module, and the levels of assets/levels. */
import { type Engine, World, type WorldOptions } from "thud";
import { buildLevel, type Problem, readLevel } from "thud/level";
import type { OverlayName } from "./render/overlay";

export interface Entry {
  /** As in the URL. */
  kind: "scene" | "level";
  name: string;
  title: string;
  about: string;
  group: string;
}

/** What the visitor has chosen for every world. */
export type Choices = Required<Pick<WorldOptions, "quality" | "detection" | "broadphase">>;

/** A scene or level that has been built. */
export interface Built {
  entry: Entry;
  world: World;
  camera: readonly [number, number];
  cameraHeight: number;
  spawn: readonly [number, number];
  /** Whether it is played with a character, which starts there. */
  character: boolean;
  gravity: readonly [number, number];
  lengthScale: number;
  /** The overlays that it is about. */
  show: readonly OverlayName[];
  /** So many times two bodies, from the first on, are shown with their Minkowski sum. */
  sumPairs: number;
  /** What a level does without. */
  problems: readonly Problem[];
}

const GROUPS: readonly [group: string, names: readonly string[]][] = [
  [
    "Piles and stacks",
    ["pyramid", "circle_pit", "mixed_terrain", "digging", "tall_stack", "heavy_on_light"],
  ],
  ["How it is done", ["detection", "minkowski", "broadphases"]],
  ["In motion", ["tumbler", "tumbler_half", "smash", "cradle", "slopes", "bullets", "gas"]],
  ["Crowds and extremes", ["platformer", "sizes", "one_spot", "asleep"]],
];

/** In the order of the bits of scene_show. */
const SHOWN: readonly OverlayName[] = ["cells", "axes", "motions"];

const levelUrls = import.meta.glob<string>("../../assets/levels/*.tmj", {
  query: "?url",
  import: "default",
  eager: true,
});

export class Catalogue {
  readonly entries: Entry[] = [];
  readonly #engine: Engine;

  constructor(engine: Engine) {
    this.#engine = engine;
    const { exports } = engine;
    const scenes: Entry[] = [];
    for (let i = 0; i < exports.api_scene_count(); i++) {
      engine.check(exports.api_scene_info(i));
      const [name, title, about] = Array.from(engine.slots.slice(0, 3), (at) => engine.text(at));
      const group = GROUPS.find(([, names]) => names.includes(name))?.[0] ?? "More scenes";
      scenes.push({ kind: "scene", name, title, about, group });
    }
    const levels = Object.keys(levelUrls).map((path): Entry => {
      const name = path.replace(/^.*\//, "").replace(/\.tmj$/, "");
      const words = name.replace(/[-_]/g, " ");
      const title = words[0].toUpperCase() + words.slice(1);
      return { kind: "level", name, title, about: "Drawn in Tiled", group: "Levels from Tiled" };
    });
    const order = ["Levels from Tiled", ...GROUPS.map(([group]) => group), "More scenes"];
    this.entries = [...levels, ...scenes].sort(
      (a, b) => order.indexOf(a.group) - order.indexOf(b.group),
    );
  }

  find(kind: string, name: string): Entry | undefined {
    return this.entries.find((entry) => entry.kind === kind && entry.name === name);
  }

  async build(entry: Entry, choices: Choices): Promise<Built> {
    if (entry.kind === "scene") return this.#buildScene(entry, choices);
    const path = Object.keys(levelUrls).find((key) => key.endsWith(`/${entry.name}.tmj`));
    const response = await fetch(levelUrls[path ?? ""]);
    if (!response.ok)
      throw new Error(`the level ${entry.name} cannot be loaded: ${response.statusText}`);
    return this.buildText(entry.name, await response.text(), choices, entry);
  }

  /** Builds a level from the text of a .tmj file; without `entry` it is the visitor's own. */
  buildText(name: string, text: string, choices: Choices, entry?: Entry): Built {
    const level = readLevel(name, text, { skip: true });
    const world = buildLevel(this.#engine, level, { ...choices, timed: true });
    return {
      entry: entry
        ? Object.assign(entry, { title: level.title, about: level.about || entry.about })
        : { kind: "level", name, title: level.title, about: level.about, group: "Your own" },
      world,
      camera: level.camera,
      cameraHeight: level.cameraHeight,
      spawn: level.spawn,
      character: level.character,
      gravity: level.gravity,
      lengthScale: level.lengthScale,
      show: [],
      sumPairs: 0,
      problems: level.problems,
    };
  }

  #buildScene(entry: Entry, choices: Choices): Built {
    const engine = this.#engine;
    const { exports } = engine;
    const index = this.#sceneIndex(entry.name);
    World.writeOptions(engine, { ...choices, timed: true });
    engine.check(exports.api_scene_create(index, 0));
    const [address, cameraX, cameraY, cameraHeight, spawnX, spawnY, lengthScale, show, sumPairs] =
      engine.slots;
    return {
      entry,
      world: new World(engine, { lengthScale }, address),
      camera: [cameraX, cameraY],
      cameraHeight,
      spawn: [spawnX, spawnY],
      character: false,
      gravity: [0, -10],
      lengthScale,
      show: SHOWN.filter((_, bit) => (show >> bit) & 1),
      sumPairs,
      problems: [],
    };
  }

  #sceneIndex(name: string): number {
    const engine = this.#engine;
    const count = engine.exports.api_scene_count();
    for (let i = 0; i < count; i++) {
      engine.check(engine.exports.api_scene_info(i));
      if (engine.text(engine.slots[0]) === name) return i;
    }
    throw new Error(`there is no scene ${name}`);
  }
}
