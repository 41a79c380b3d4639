/**
 * Watches the worlds of an engine from their first body on, for what a world does not tell
 * afterwards: what it and its bodies were made with, whether bodies, shapes or ground have changed,
 * and what a scene's own code does to bodies, which goes to the rival too.
 *
 * A character (Mover) pushes bodies inside the engine. It is watched too, and pushes the rival's by
 * the same rule; its own body is kinematic and followed by `Rival.sync`.
 */
import type {
  BodyId,
  BodyOptions,
  Engine,
  Mover,
  MoverOptions,
  MoverReport,
  Vec2,
  World,
  WorldOptions,
} from "thud";
import { inFrame, push, type Push } from "./hands";
import type { Known } from "./known";
import type { Rival } from "./rival";

export interface Watched extends Known {
  /** From now on, what is done to the thud world's bodies is done to the rival's. Null ends it. */
  forwardTo(rival: Rival | null): void;
  /** Runs `act` without forwarding: the rival gets a deed of its own (`pull`, `explode`). */
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
    watchMover(mover, options) {
      const move = mover.move.bind(mover);
      mover.move = (velocity, dt, how) => {
        const report = move(velocity, dt, how);
        if (rival)
          for (const one of pushesOf(world, options, velocity, dt, report)) push(rival, one);
        return report;
      };
    },
  };
}

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
