/**
 * Starts a scene: gives the scene's function what it needs, and makes a Session of the world that
 * it returns.
 */
import type { Engine, Mover, World, WorldOptions } from "thud";
import type { KeyWords, Scene, SceneModule, View } from "../scene/scene";
import { FIRST_SCENE } from "../scene/first";
import { createSetting, type SettingOptions } from "../scene/setting";
import { BODY, DYNAMIC, HALF, ROW, SLOT, STATIC } from "../scene/shape-table";
import { checkScene } from "./check";
import { readShapes } from "./frames";
import type { Choices, RunningScene, SceneRequest } from "./protocol";
import { closeAll, maxErrorOf, Session } from "./session";
import { SceneError } from "./trouble";
import { recordOf } from "./watch";

/** The visitor's choices as options of a world. */
export function optionsOf(choices: Choices): WorldOptions {
  const { quality, substeps, detection, broadphase, stepRate, topSpeed } = choices;
  return {
    quality,
    substeps,
    detection: detection === "auto" ? undefined : detection,
    broadphase,
    timed: true,
    // What is not chosen must be missing here: an option that is undefined would hide the scene's.
    ...(stepRate > 0 ? { timeStep: 1 / stepRate } : {}),
    ...(topSpeed > 0 ? { maximumSpeed: topSpeed } : {}),
  };
}

/** Imports that tests replace; by default those of createSetting, and bringMover. */
interface Loaders extends Pick<SettingOptions, "loadReader" | "loadGeometry" | "loadRollback"> {
  loadMover?(): Promise<typeof Mover | undefined>;
  /** The class of the session that is returned. */
  kind?: typeof Session;
  /**
   * Is told of each world of `createWorld` before the scene builds anything in it; not of worlds of
   * `buildLevel`.
   */
  made?(world: World): void;
}

/** Loads the class Mover. If that fails, scenes without movers still run. */
async function bringMover(): Promise<typeof Mover | undefined> {
  return import("thud").then(({ Mover }) => Mover).catch(() => undefined);
}

/**
 * Runs the scene's function. Throws what it throws, or a SceneError if what it returns is wrong;
 * what it created is then closed.
 */
export async function setUp(
  run: number,
  module: SceneModule,
  engine: Engine,
  request: SceneRequest,
  readText: (file: string) => Promise<string>,
  { loadMover = bringMover, kind = Session, made, ...loaders }: Loaders = {},
): Promise<Session> {
  const first = request.name === FIRST_SCENE && request.code === undefined;
  const choices = optionsOf(request.choices);
  const setting = createSetting(module, {
    thud: engine,
    choices,
    size: request.size,
    seed: request.seed,
    readText,
    mover: first ? undefined : await loadMover(),
    ...loaders,
  });
  // All worlds and movers that the scene makes. Those that it does not return are closed with the
  // session.
  const worlds = new Map<World, Pick<WorldOptions, "lengthScale" | "timeStep">>();
  const movers: Mover[] = [];
  const { createWorld, buildLevel, createMover } = setting;
  setting.createWorld = (options = {}) => {
    const world = createWorld(options);
    made?.(world);
    worlds.set(world, options);
    return world;
  };
  setting.buildLevel = (level) => {
    const world = buildLevel(level);
    worlds.set(world, level);
    return world;
  };
  setting.createMover = (world, options) => {
    const mover = createMover(world, options);
    recordOf(world)?.watchMover(mover, options);
    movers.push(mover);
    return mover;
  };
  try {
    const scene: Scene | undefined = await module.default(setting);
    const options = scene?.world && worlds.get(scene.world);
    if (!options)
      throw new SceneError({
        message: "A scene returns the world that createWorld gave it: return { world }",
      });
    checkScene(scene);
    const { lengthScale = 1, timeStep = 1 / 60 } = { ...options, ...choices };
    // The error limit is chosen in length scales; the length scale is an option of the scene's
    // world.
    scene.world.setMaxError(maxErrorOf(request.choices) * lengthScale);
    const others = [...movers, ...worlds.keys()].filter((other) => other !== scene.world);
    const sizes = module.size ?? null;
    const title = typeof module.title === "string" ? module.title : null;
    return new kind(run, scene, setting.size, sizes, lengthScale, timeStep, title, others);
  } catch (error) {
    closeAll([...movers, ...worlds.keys()]);
    throw error;
  }
}

/**
 * What the page is told of the scene. A view that the scene does not give is computed from its
 * bodies.
 */
export function describe(session: Session): RunningScene {
  const { run, title, size, sizes, scene, lengthScale, timeStep } = session;
  const view = scene.view ?? fit(session);
  return {
    run,
    title,
    size,
    sizes,
    view: view.width === undefined ? { ...view, width: widthOf(session, view) } : view,
    spawn: scene.spawn ?? [view.x, view.y + 0.4 * view.height],
    lengthScale,
    timeStep,
    show: [...(scene.show ?? []), ...(scene.sums ? (["sums"] as const) : [])],
    keys: keyWords(scene.keys ?? []),
    pointer: scene.pointer ?? false,
    notes: scene.notes ?? [],
    controls: scene.controls ?? [],
    panel: scene.panel ?? null,
    shared: Boolean(scene.match),
  };
}

/** The keys with what each does; "" for a scene that gives only a list of keys. */
function keyWords(keys: NonNullable<Scene["keys"]>): KeyWords {
  return Array.isArray(keys) ? Object.fromEntries(keys.map((name) => [name, ""])) : keys;
}

/**
 * Width of a view that has none: 2.2 times the largest horizontal distance from its middle to a
 * dynamic body, of those whose distance is at most its height; at most twice the height.
 */
function widthOf({ world }: Session, { x, y, height }: View): number {
  const { shapes } = readShapes(world);
  const poses = world.poses(1, x, y);
  let reach = 0;
  for (let i = 0; i < shapes.count; i++) {
    const row = shapes.rows.subarray(i * ROW, (i + 1) * ROW);
    const distance = Math.abs(poses[4 * row[SLOT]]);
    if (row[BODY] === DYNAMIC && distance <= height) reach = Math.max(reach, distance);
  }
  return Math.min(2.2 * reach, 2 * height);
}

/** A view of all dynamic bodies, or of all bodies if none is dynamic. */
function fit({ world }: Session): View {
  const { shapes } = readShapes(world);
  const poses = world.poses(1, 0, 0);
  let [x0, y0, x1, y1] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const least of [DYNAMIC, STATIC]) {
    for (let i = 0; i < shapes.count; i++) {
      const row = shapes.rows.subarray(i * ROW, (i + 1) * ROW);
      if (row[BODY] < least) continue;
      const [x, y] = poses.subarray(4 * row[SLOT]);
      const reach = Math.hypot(row[HALF], row[HALF + 1]);
      [x0, x1] = [Math.min(x0, x - reach), Math.max(x1, x + reach)];
      [y0, y1] = [Math.min(y0, y - reach), Math.max(y1, y + reach)];
    }
    if (x0 < x1) break;
  }
  if (!(x0 < x1)) return { x: 0, y: 5, height: 20 };
  const height = 1.4 * Math.max(y1 - y0, 1);
  return { x: (x0 + x1) / 2, y: (y0 + y1) / 2, height, width: 1.2 * (x1 - x0) };
}
