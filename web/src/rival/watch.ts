/**
 * Watches the worlds of an engine from their first body on, for what a world does not tell
 * afterwards: what it and its bodies were made with, whether bodies, shapes or ground have changed,
 * and what a scene's own code does to bodies, which goes to the rival too.
 *
 * A character (Mover) pushes bodies inside the engine, which is not seen here; its own body is
 * kinematic and followed by `Rival.sync`.
 */
import type { BodyId, BodyOptions, Engine, World, WorldOptions } from "thud";
import type { Known } from "./known";
import type { Rival } from "./rival";

export interface Watched extends Known {
  /** From now on, what is done to the thud world's bodies is done to the rival's. Null ends it. */
  forwardTo(rival: Rival | null): void;
  /** Runs `act` without forwarding: the rival gets a deed of its own (`pull`, `explode`). */
  apart(act: () => void): void;
}

/** Returns a function that finds what is known of a world that was made since. */
export function watchWorlds(engine: Engine): (world: World) => Watched | undefined {
  const worlds = new WeakMap<World, Watched>();
  const { createWorld } = engine;
  engine.createWorld = (options = {}) => {
    const world = createWorld.call(engine, options);
    worlds.set(world, watch(world, options));
    return world;
  };
  return (world) => worlds.get(world);
}

/** Of a new world. */
export function watch(world: World, made: WorldOptions): Watched {
  const options = { ...made };
  const bodies = new Map<number, { body: BodyId; options: BodyOptions }>();
  let changes = 0;
  let rival: Rival | null = null;
  /** A refused call throws before `then`, and changes nothing. */
  const after = <Name extends Watchable>(name: Name, then: Then<Name>) => {
    const own = world[name].bind(world) as (...args: unknown[]) => unknown;
    const watched = (...args: unknown[]) => {
      const result = own(...args);
      (then as (...all: unknown[]) => void)(result, ...args);
      return result;
    };
    world[name] = watched as World[Name];
  };
  /** A body that is not there yet is brought over by the next sync, with what was done to it. */
  const onBody = (body: BodyId, act: (rival: Rival) => void) => {
    if (rival?.isValid(body)) act(rival);
  };

  for (const name of CHANGES) after(name, () => void changes++);
  after("createBody", (body, given = {}) => bodies.set(body.index, { body, options: given }));
  after("setTransform", (_, id, ...pose) => onBody(id, (r) => r.setTransform(id, ...pose)));
  after("setVelocity", (_, id, ...speed) => onBody(id, (r) => r.setVelocity(id, ...speed)));
  after("applyImpulse", (_, id, ...impulse) => onBody(id, (r) => r.applyImpulse(id, ...impulse)));
  after("applyForce", (_, id, ...force) => onBody(id, (r) => r.applyForce(id, ...force)));
  after("setAwake", (_, id, awake) => onBody(id, (r) => r.setAwake(id, awake)));
  after("setGravity", (_, gravity) => {
    options.gravity = gravity;
    rival?.setGravity(gravity);
  });
  after("setTimeStep", (_, seconds) => {
    options.timeStep = seconds;
    rival?.setTimeStep(seconds);
  });
  after("setSleeping", (_, sleeping) => {
    options.sleeping = sleeping;
    rival?.setSleeping(sleeping);
  });

  return {
    options,
    bodyOptions(id) {
      const found = bodies.get(id.index);
      return found?.body.generation === id.generation ? found.options : undefined;
    },
    changes: () => changes,
    forwardTo(other) {
      rival = other;
    },
    apart(act) {
      const other = rival;
      rival = null;
      try {
        act();
      } finally {
        rival = other;
      }
    },
  };
}

const CHANGES = [
  "createCircle",
  "createAabb",
  "createObb",
  "createTerrain",
  "destroy",
  "setEnabled",
  "setHeights",
  "dig",
  "raise",
  "replaceRange",
] as const;

type Watchable =
  | (typeof CHANGES)[number]
  | "createBody"
  | "setTransform"
  | "setVelocity"
  | "applyImpulse"
  | "applyForce"
  | "setAwake"
  | "setGravity"
  | "setTimeStep"
  | "setSleeping";
type Then<Name extends Watchable> = (
  result: ReturnType<World[Name]>,
  ...args: Parameters<World[Name]>
) => void;
