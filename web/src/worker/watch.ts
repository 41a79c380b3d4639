/**
 * Watches the worlds of an engine from their first body on, for what a world does not tell
 * afterwards: what it and its bodies were made with, whether bodies, shapes or ground have changed,
 * and what a scene's own code does to bodies, which goes to its follower too.
 *
 * A character (Mover) pushes bodies inside the engine. It is watched too, and pushes the
 * follower's by the same rule; its own body is kinematic, and the follower reads its pose.
 */
import {
  type BodyId,
  type BodyOptions,
  type BodyRef,
  type Engine,
  handleOf,
  type JointId,
  type JointRef,
  type Mover,
  type MoverOptions,
  type MoverReport,
  type ShapeId,
  type ShapeRef,
  type Vec2,
  type World,
  type WorldOptions,
} from "thud";
import { type Hands, inFrame, push, type Push } from "./hands";

/** What a thud world does not tell of itself. */
export interface Known {
  /** What it was made with, or has been set to since. */
  options: WorldOptions;
  /** What its bodies were made with: their damping, sleep and detection count. */
  bodyOptions(body: BodyId): BodyOptions | undefined;
  /** Whether there ever was a joint. */
  readonly tied: boolean;
  /** What has acted on bodies that another engine has no like of, in a word or two each. */
  readonly fields: ReadonlySet<string>;
  /** Another number whenever bodies, shapes or ground changed. */
  changes(): number;
}

/** Another engine's copy of a world, with the same methods. */
export type Follower = Hands &
  Pick<
    World,
    "setTransform" | "applyForce" | "setAwake" | "setGravity" | "setTimeStep" | "setSleeping"
  > & {
    /** A joint was made, set or destroyed. */
    touchJoint(joint: JointId): void;
  };

export interface Watched extends Known {
  /** What is done to the thud world's bodies from now on is done to the follower's. Null ends it. */
  forwardTo(follower: Follower | null): void;
  /** Runs `act` without forwarding: the follower gets a command of its own (`pull`, `explode`). */
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
  let tied = false;
  const fields = new Set<string>();
  let follower: Follower | null = null;
  /** A refused call throws before `then`, and changes nothing. */
  const after = <Name extends Watchable>(name: Name, then: Then<Name>) => {
    const own = world[name].bind(world) as (...args: unknown[]) => unknown;
    const watched = (...args: unknown[]) => {
      const result = own(...args);
      const [first, ...rest] = args;
      const id = typeof first === "number" ? byNumber(name, first, rest[0]) : first;
      (then as (...all: unknown[]) => void)(result, ...(args.length > 0 ? [id, ...rest] : []));
      return result;
    };
    world[name] = watched as World[Name];
  };
  /** A body that is not there yet is brought over by the next sync, with what was done to it. */
  const onBody = (body: BodyId, act: (follower: Follower) => void) => {
    if (follower?.isValid(body)) act(follower);
  };

  for (const name of CHANGES) after(name, () => void changes++);
  for (const name of FIELDS) after(name, () => void fields.add(NAMES_OF_FIELDS[name]));
  const keep = (body: BodyId, given: BodyOptions) => {
    bodies.set(body.index, { body, options: given });
    changes++;
  };
  after("createBody", (body, given = {}) => keep(body, given));
  after("spawn", (number, given) => keep(handleOf(number, "body"), { ...given }));
  after("createJoint", (joint) => {
    tied = true;
    follower?.touchJoint(joint);
  });
  for (const name of OF_JOINTS) after(name, (_, ...args) => follower?.touchJoint(args[0]));
  after("destroy", (_, id) => id.kind === "joint" && follower?.touchJoint(id));
  after("setTransform", (_, id, ...pose) => onBody(id, (f) => f.setTransform(id, ...pose)));
  after("setVelocity", (_, id, ...speed) => onBody(id, (f) => f.setVelocity(id, ...speed)));
  after("applyImpulse", (_, id, ...impulse) => onBody(id, (f) => f.applyImpulse(id, ...impulse)));
  after("applyForce", (_, id, ...force) => onBody(id, (f) => f.applyForce(id, ...force)));
  after("applyForceAt", (_, id, [x, y], point) =>
    onBody(id, (f) => {
      const { center } = f.bodyState(id);
      f.applyForce(id, [x, y], (point[0] - center[0]) * y - (point[1] - center[1]) * x);
    }),
  );
  after("applyCenterImpulse", (_, id, impulse) =>
    onBody(id, (f) => f.applyImpulse(id, impulse, f.bodyState(id).center)),
  );
  after("applyAngularImpulse", (_, id, impulse) =>
    onBody(id, (f) => {
      const { velocity, angularVelocity, inertia } = f.bodyState(id);
      if (inertia > 0) f.setVelocity(id, velocity, angularVelocity + impulse / inertia);
    }),
  );
  after("setAwake", (_, id, awake) => onBody(id, (f) => f.setAwake(id, awake)));
  after("setGravity", (_, gravity) => {
    options.gravity = gravity;
    follower?.setGravity(gravity);
  });
  after("setTimeStep", (_, seconds) => {
    options.timeStep = seconds;
    follower?.setTimeStep(seconds);
  });
  after("setSleeping", (_, sleeping) => {
    options.sleeping = sleeping;
    follower?.setSleeping(sleeping);
  });

  return {
    options,
    bodyOptions(id) {
      const found = bodies.get(id.index);
      return found?.body.generation === id.generation ? found.options : undefined;
    },
    get tied() {
      return tied;
    },
    fields,
    changes: () => changes,
    forwardTo(other) {
      follower = other;
    },
    apart(act) {
      const other = follower;
      follower = null;
      try {
        act();
      } finally {
        follower = other;
      }
    },
    watchMover(mover, options) {
      const move = mover.move.bind(mover);
      mover.move = (velocity, dt, how) => {
        const report = move(velocity, dt, how);
        if (follower)
          for (const one of pushesOf(world, options, velocity, dt, report)) push(follower, one);
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

const OF_JOINTS = [
  "setDrive",
  "setJointLength",
  "setJointFrame",
  "setJointBreaking",
  "setJointEnabled",
] as const;

/** By the methods that make them act. */
const NAMES_OF_FIELDS = {
  applyBuoyancy: "water",
  applyWind: "wind",
  explode: "explosions with cover",
  applyGrip: "tyres",
  applyTyre: "tyres",
  setRule: "rules between kinds",
} as const;
const FIELDS = Object.keys(NAMES_OF_FIELDS) as (keyof typeof NAMES_OF_FIELDS)[];

const CHANGES = [
  ...OF_JOINTS,
  "createJoint",
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
  | keyof typeof NAMES_OF_FIELDS
  | "createBody"
  | "spawn"
  | "setTransform"
  | "setVelocity"
  | "applyImpulse"
  | "applyForce"
  | "applyForceAt"
  | "applyCenterImpulse"
  | "applyAngularImpulse"
  | "setAwake"
  | "setGravity"
  | "setTimeStep"
  | "setSleeping";

/** Where numbers may stand for handles, handles. */
type Ids<T> = {
  [I in keyof T]: BodyRef | ShapeRef | JointRef extends T[I]
    ? BodyId | ShapeId | JointId
    : BodyRef extends T[I]
      ? BodyId
      : JointRef extends T[I]
        ? JointId
        : T[I];
};

type Then<Name extends Watchable> = (
  result: ReturnType<World[Name]>,
  ...args: Ids<Parameters<World[Name]>>
) => void;

/** The handle that a scene gave by its number; other numbers stay what they are. */
function byNumber(name: Watchable, number: number, kind: unknown): unknown {
  if (name === "setTimeStep") return number;
  if (name === "destroy") return handleOf(number, kind as "body" | "shape" | "joint");
  return handleOf(number, OF_JOINTS.some((one) => one === name) ? "joint" : "body");
}
