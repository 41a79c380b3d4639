/**
 * Watches the worlds of an engine from their first body on: which of its methods a scene calls, what
 * it and its bodies were made with, which a world does not tell afterwards, and what its follower,
 * another engine's copy, is to do as well. Every call is seen, whatever it is: what becomes of it is
 * the follower's to say, and what no follower knows of is missing there (box2d/follow.ts).
 *
 * A character (Mover) pushes bodies inside the engine. It is watched too, and pushes the
 * follower's by the same rule; its own body is kinematic, and the follower reads its pose.
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

/** What a thud world does not tell of itself. */
export interface Known {
  /** What it was made with, or has been set to since. */
  options: WorldOptions;
  /** What its bodies were made with, or set to since: their damping, sleep and detection count. */
  bodyOptions(body: BodyId): BodyOptions | undefined;
  /** The names of all methods that were called, but for what was done apart. */
  readonly called: ReadonlySet<string>;
}

/** Another engine's copy of a world. */
export interface Follower extends Hands {
  /** A method of the world was called and did not throw. */
  heed(method: string, result: unknown, args: readonly unknown[]): void;
}

export interface Watched extends Known {
  /** Whether there ever was a joint. */
  readonly tied: boolean;
  /** It hears of every call from now on. Null ends it. */
  forwardTo(follower: Follower | null): void;
  /** Runs `act` unseen: the follower gets a command of its own (`explode`), or begins anew. */
  apart(act: () => void): void;
  /** A character of this world, as it is made. */
  watchMover(mover: Mover, options: MoverOptions): void;
}

const worlds = new WeakMap<World, Watched>();

/** Of worlds that are made from now on. */
export function watchWorlds(engine: Engine): void {
  const { createWorld } = engine;
  engine.createWorld = (options = {}) => {
    const world = createWorld.call(engine, options);
    worlds.set(world, watch(world, options));
    return world;
  };
}

/** What is known of a world, if it was watched from its making on. */
export function knownOf(world: World): Watched | undefined {
  return worlds.get(world);
}

/** Does to a world what no scene does, and what its follower learns of in another way. */
export function unseen(world: World, act: () => void): void {
  const known = knownOf(world);
  if (known) known.apart(act);
  else act();
}

/** Of a new world. */
export function watch(world: World, made: WorldOptions): Watched {
  const options = { ...made };
  const bodies = new Map<number, { body: BodyId; options: BodyOptions }>();
  const called = new Set<string>();
  let follower: Follower | null = null;
  /** How many calls deep in what is done apart. */
  let hidden = 0;
  const apart = <T>(act: () => T): T => {
    hidden++;
    try {
      return act();
    } finally {
      hidden--;
    }
  };
  const heed = (method: string, result: unknown, args: readonly unknown[]) => {
    called.add(method);
    keep(method, result, args);
    follower?.heed(method, result, args);
  };
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
      // What is tried there is undone.
      const result = method === "whatIf" ? apart(act) : act();
      // A refused call has thrown, and changed nothing.
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

/** What the other methods are made of. */
const INTERNAL = new Set(
  ["constructor", "on", "onWorld", "refuse", "freeRoom", "shapeIds", "makeSolid"],
);

/** Of all classes that the world is of. */
function methodsOf(world: World): Set<string> {
  const names = new Set<string>();
  let of = Object.getPrototypeOf(world) as object;
  for (; of !== Object.prototype; of = Object.getPrototypeOf(of) as object)
    for (const [name, { value }] of Object.entries(Object.getOwnPropertyDescriptors(of)))
      if (typeof value === "function" && !INTERNAL.has(name)) names.add(name);
  return names;
}

/** By its handle or its number. */
function bodyOf(ref: unknown): BodyId {
  return typeof ref === "number" ? handleOf(ref, "body") : (ref as BodyId);
}

/** The options that are set again by these. */
const WORLD_SETTERS: Readonly<Record<string, keyof WorldOptions>> = {
  setGravity: "gravity",
  setTimeStep: "timeStep",
  setSleeping: "sleeping",
};
/** By their second argument, and their third; a body's state does not tell them. */
const BODY_SETTERS: Readonly<Record<string, [keyof BodyOptions, (keyof BodyOptions)?]>> = {
  setDamping: ["linearDamping", "angularDamping"],
  setDetection: ["detection"],
  setMaySleep: ["maySleep"],
};

/** thud's own, in radians. */
const MAX_SLOPE = 0.9;

/** Of the bodies that a move met: each once, and none that can be stood on. */
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
    const state = world.bodyState(body);
    const rise = normal[0] * up[0] + normal[1] * up[1];
    if (state.kind !== "dynamic" || rise >= Math.cos(maxSlope)) continue;
    const anchor = inFrame(state, point);
    const most = pushForce * dt;
    pushes.set(body.index, { body, anchor, met: point, normal, velocity, most, reach });
  }
  return [...pushes.values()];
}
