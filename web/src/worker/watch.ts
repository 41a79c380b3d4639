/**
 * Records which methods of a world a scene calls, and passes each call on to a follower, another
 * engine's copy of the world. It also remembers the options that a world and its bodies were made
 * with, which the engine does not tell afterwards. Each method of a watched world is wrapped, so
 * that every call is recorded; which calls the follower can copy is decided in box2d/follow.ts, and
 * the others are counted as missing.
 *
 * A character (Mover) pushes bodies inside the engine, without a call. So its `move` is wrapped as
 * well, and the bodies that it pushed are pushed in the follower by the same rule. The character's
 * own body is kinematic; the follower reads its pose.
 */
import {
  type BodyId,
  type BodyOptions,
  type Engine,
  handleOf,
  type Mover,
  type MoverOptions,
  type MoverReport,
  type Vec2,
  type World,
  type WorldOptions,
} from "thud";
import { type Hands, inFrame, push, type Push } from "./hands";
import { SceneError } from "./trouble";

/** What is recorded of a world because the engine does not tell it afterwards. */
export interface WorldRecord {
  /** The options that the world was made with, with later changes. */
  options: WorldOptions;
  /** The options that a body was made with, with later changes of damping, sleep and detection. */
  bodyOptions(body: BodyId): BodyOptions | undefined;
  /** The names of all methods that were called, except within `apart`. */
  readonly called: ReadonlySet<string>;
}

/** Another engine's copy of a world, which follows the calls. */
export interface Follower extends Hands {
  /** A method of the world was called, and returned `result`. */
  heed(method: string, result: unknown, args: readonly unknown[]): void;
}

export interface Watched extends WorldRecord {
  /** Whether createJoint was ever called. */
  readonly tied: boolean;
  /** From now on every call is passed to the follower; null: to none. */
  forwardTo(follower: Follower | null): void;
  /**
   * Runs `act` without recording its calls. The follower is told in another way (`explode`), or
   * copies the world anew.
   */
  apart(act: () => void): void;
  /** To be called when a character of this world is created. */
  watchMover(mover: Mover, options: MoverOptions): void;
}

/**
 * Largest size of the engine's memory in bytes. A scene that creates bodies without end would
 * otherwise crash the whole tab. Chosen.
 */
const MOST_BYTES = 2 ** 30;

function tooLarge(): SceneError {
  const message = `It holds more than ${MOST_BYTES / 2 ** 30} GB, so it was ended.`;
  return new SceneError({ message, tooLarge: true });
}

const worlds = new WeakMap<World, Watched>();

/** Watches all worlds that are created from now on. */
export function watchWorlds(engine: Engine): void {
  const { createWorld } = engine;
  engine.createWorld = (options = {}) => {
    const world = createWorld.call(engine, options);
    worlds.set(world, watch(world, options));
    return world;
  };
}

/** What was recorded of a world; undefined if it was created before `watchWorlds`. */
export function recordOf(world: World): Watched | undefined {
  return worlds.get(world);
}

/** Runs `act` without recording its calls; see `apart`. */
export function unseen(world: World, act: () => void): void {
  const record = recordOf(world);
  if (record) record.apart(act);
  else act();
}

/** Wraps the methods of a new world, which was created with the options `made`. */
export function watch(world: World, made: WorldOptions): Watched {
  const options = { ...made };
  const bodies = new Map<number, { body: BodyId; options: BodyOptions }>();
  const called = new Set<string>();
  let follower: Follower | null = null;
  /** Depth of nested `apart` calls. */
  let hidden = 0;
  const apart = <T>(act: () => T): T => {
    hidden++;
    try {
      return act();
    } finally {
      hidden--;
    }
  };
  /** Called after each recorded call. Throws if the engine holds too much memory. */
  const heed = (method: string, result: unknown, args: readonly unknown[]) => {
    if (world.engine.buffer.byteLength > MOST_BYTES) throw tooLarge();
    called.add(method);
    keep(method, result, args);
    follower?.heed(method, result, args);
  };
  /** Keeps the options that a call gave to the world or to a body. */
  const keep = (method: string, result: unknown, [first, second, third]: readonly unknown[]) => {
    if (method === "createBody" || method === "spawn") {
      const body = bodyOf(result);
      bodies.set(body.index, { body, options: { ...(first as BodyOptions) } });
    } else if (method in WORLD_SETTERS) {
      Object.assign(options, { [WORLD_SETTERS[method]]: first });
    } else if (method in BODY_SETTERS) {
      const [one, other] = BODY_SETTERS[method];
      const known = bodies.get(bodyOf(first).index);
      if (known) Object.assign(known.options, { [one]: second ?? undefined });
      if (known && other) Object.assign(known.options, { [other]: third });
    }
  };
  const methods = world as unknown as Record<string, (...args: unknown[]) => unknown>;
  for (const method of methodsOf(world)) {
    const own = methods[method];
    methods[method] = (...args) => {
      const act = () => own.apply(world, args);
      // What `whatIf` tries is undone afterwards, so it is not recorded.
      const result = method === "whatIf" ? apart(act) : act();
      // A call that the engine refuses has thrown before this line, and changed nothing.
      if (hidden === 0) heed(method, result, args);
      return result;
    };
  }

  return {
    options,
    bodyOptions(id) {
      const found = bodies.get(id.index);
      return found?.body.generation === id.generation ? found.options : undefined;
    },
    called,
    get tied() {
      return called.has("createJoint");
    },
    forwardTo(other) {
      follower = other;
    },
    apart,
    watchMover(mover, options) {
      const move = mover.move.bind(mover);
      mover.move = (velocity, dt, how) => {
        const report = move(velocity, dt, how);
        if (follower && hidden === 0)
          for (const one of pushesOf(world, options, velocity, dt, report)) push(follower, one);
        return report;
      };
    },
  };
}

/** Methods that other methods call, and scenes do not. */
const INTERNAL = new Set(
  ["constructor", "on", "onWorld", "refuse", "freeRoom", "shapeIds", "makeSolid"],
);

/** The names of the methods of all classes that the world inherits from. */
function methodsOf(world: World): Set<string> {
  const names = new Set<string>();
  let of = Object.getPrototypeOf(world) as object;
  for (; of !== Object.prototype; of = Object.getPrototypeOf(of) as object)
    for (const [name, { value }] of Object.entries(Object.getOwnPropertyDescriptors(of)))
      if (typeof value === "function" && !INTERNAL.has(name)) names.add(name);
  return names;
}

/** A body given by its handle, or by its handle as a number (handleOf). */
function bodyOf(ref: unknown): BodyId {
  return typeof ref === "number" ? handleOf(ref, "body") : (ref as BodyId);
}

/** The world's options that these methods set. */
const WORLD_SETTERS: Readonly<Record<string, keyof WorldOptions>> = {
  setGravity: "gravity",
  setTimeStep: "timeStep",
  setSleeping: "sleeping",
};
/**
 * The options that these methods set by their second and third argument. World.bodyStateOf does not
 * tell them.
 */
const BODY_SETTERS: Readonly<Record<string, [keyof BodyOptions, (keyof BodyOptions)?]>> = {
  setDamping: ["linearDamping", "angularDamping"],
  setDetection: ["detection"],
  setMaySleep: ["maySleep"],
};

/** Default of MoverOptions.maxSlope in the engine, in radians. */
const MAX_SLOPE = 0.9;

/**
 * The pushes of one move: one for each dynamic body that the character touched and cannot stand on.
 */
function pushesOf(
  world: World,
  { shape, up = [0, 1], maxSlope = MAX_SLOPE, pushForce = 0 }: MoverOptions,
  velocity: Vec2,
  dt: number,
  { hits }: MoverReport,
): Push[] {
  const reach =
    shape.kind === "circle" ? shape.radius : Math.hypot(shape.halfWidth, shape.halfHeight);
  const pushes = new Map<number, Push>();
  for (const { body, point, normal } of hits) {
    if (pushes.has(body.index) || !world.isValid(body)) continue;
    const state = world.bodyStateOf(body);
    const rise = normal[0] * up[0] + normal[1] * up[1];
    if (state.kind !== "dynamic" || rise >= Math.cos(maxSlope)) continue;
    const anchor = inFrame(state, point);
    const most = pushForce * dt;
    pushes.set(body.index, { body, anchor, met: point, normal, velocity, most, reach });
  }
  return [...pushes.values()];
}
