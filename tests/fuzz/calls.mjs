/**
 * Calls the whole JavaScript package at random, by a seed: with numbers out of range, options
 * without a meaning, and handles that are destroyed or closed. No call may make the engine trap,
 * throw an error that is not the package's own, or return a number that is not finite.
 *
 *     node tests/fuzz/calls.mjs --seconds 60 [--seed N] [--findings FOLDER]
 *     node tests/fuzz/calls.mjs --replay FILE     plays a finding, which is a file with a seed
 */
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { thud } from "../web/support/package.mjs";
import { EDIT_CALLS } from "./edit_calls.mjs";
import { GEOMETRY_CALLS } from "./geometry_calls.mjs";
import { JOINT_CALLS } from "./joint_calls.mjs";

// The number of calls per seed. Chosen.
const CALLS_OF_A_SEED = 300;
// Numbers that are extreme or invalid as arguments.
const HOSTILE = [NaN, Infinity, -Infinity, -0, 5e-324, 1e-30, 1e-4, 16384, 1e9, -1e12, 3e38, 1e308];
// Methods whose result may be infinite.
const MAY_BE_INFINITE = new Set(["bisectionLimit"]);

/** A world with its handles, and the random numbers and arguments of one seed. */
class Session {
  constructor(engine, seed) {
    this.engine = engine;
    this.state = (seed * 2654435761 + 88172645) >>> 0 || 1;
    this.hostile = seed % 2 === 1;
    this.world = engine.createWorld(this.worldOptions());
    this.bodies = [];
    this.shapes = [];
    this.joints = [];
    this.movers = [];
    this.snapshot = null;
  }

  below(count) {
    this.state ^= this.state << 13;
    this.state ^= this.state >>> 17;
    this.state ^= this.state << 5;
    return (this.state >>> 0) % count;
  }

  pick(list) {
    return list[this.below(list.length)];
  }

  number(low, high) {
    if (this.hostile && this.below(24) === 0) return this.pick(HOSTILE);
    return low + ((high - low) * this.below(4096)) / 4096;
  }

  place() {
    return [this.number(-12, 12), this.number(-2, 14)];
  }

  vector() {
    return [this.number(-20, 20), this.number(-20, 20)];
  }

  body() {
    return this.bodies.length ? this.pick(this.bodies) : { kind: "body", index: 0, generation: 0 };
  }

  shape() {
    if (this.shapes.length && this.below(12)) return this.pick(this.shapes);
    return { kind: "shape", index: this.below(5), generation: this.below(3) };
  }

  joint() {
    if (this.joints.length && this.below(12)) return this.pick(this.joints);
    return { kind: "joint", index: this.below(5), generation: this.below(3) };
  }

  solid() {
    const [halfWidth, halfHeight] = [this.number(0.1, 2), this.number(0.1, 2)];
    return this.pick([
      { kind: "circle", radius: halfWidth },
      { kind: "aabb", halfWidth, halfHeight },
      { kind: "obb", halfWidth, halfHeight, angle: this.number(-4, 4) },
    ]);
  }

  filter() {
    const some = [{ sensors: true }, { mask: 1, category: this.below(9) }, { group: this.below(5) - 2 }];
    return this.pick([{}, ...some, { ignore: this.body() }]);
  }

  /** The options, to which a hostile seed adds an unknown one in one of 30 calls. */
  options(given) {
    return this.hostile && this.below(30) === 0 ? { ...given, [this.pick(["x", "Kind"])]: 1 } : given;
  }

  worldOptions() {
    return {
      quality: this.pick(["draft", "default", "high", "exact", { base: "draft", substeps: 3 }]),
      broadphase: this.pick(["grid", "sweep", "all", "sweep_y", "sweep_widest", "sweep_both"]),
      sleeping: this.below(2) === 0,
      ...this.pick([{}, { detection: this.pick(["overlap", "continuous", "bisect", "swept"]) }]),
      ...this.pick([{}, { contactEvents: false }, { timed: true }]),
      ...this.pick([{}, { cellSize: 0.5 }]),
    };
  }

  shapeOptions() {
    return this.options({
      density: this.number(0.1, 4),
      friction: this.number(0, 1),
      restitution: this.number(0, 1),
      sensor: this.below(6) === 0,
      events: this.below(8) > 0,
      category: 1 << this.below(4),
      surfaceSpeed: this.number(-2, 2),
    });
  }

  /** A texture for one of few numbers of vertices, which fits some lines. */
  texture() {
    const table = Array.from({ length: 1 + this.below(4) }, () => this.number(0, 1));
    const vertices = Array.from({ length: 2 + this.below(9) }, () => this.number(0, 1));
    return this.pick([{ vertices }, { vertices, table }, { vertices, table, repeats: true }]);
  }

  line() {
    const heights = Array.from({ length: 2 + this.below(9) }, () => this.number(-1, 1));
    return this.pick([
      { kind: "flat", slope: this.number(-1, 1) },
      { kind: "uniform", x0: this.number(-12, 0), spacing: this.number(0.5, 3), heights },
      { kind: "irregular", points: heights.map((y, i) => [2 * i - 8 + y / 4, y]) },
    ]);
  }

  keep(list, made) {
    list.push(made);
    if (list.length > 40) list.shift();
    return made;
  }
}

/**
 * The calls by name. Each makes the call that its name says, and returns what the call returned. */
export const CALLS = {
  ...GEOMETRY_CALLS,
  ...JOINT_CALLS,
  ...EDIT_CALLS,
  createBody: (s) =>
    s.keep(
      s.bodies,
      s.world.createBody(
        s.options({
          kind: s.pick(["static", "kinematic", "dynamic", "dynamic", "dynamic"]),
          position: s.place(),
          angle: s.below(2) ? 0 : s.number(-3, 3),
          gravityScale: s.number(-1, 2),
          userData: s.below(99),
        }),
      ),
    ),
  createBodies: (s) => {
    const rest = { restitution: s.number(0, 1), offset: s.place() };
    const shapes = s.pick([
      [thud.circle(s.number(0.1, 1), rest), thud.aabb(s.number(0.1, 1), 0.5)],
      [thud.obb(1, s.number(0.1, 1), rest)],
      thud.walls(s.number(1, 9), 9, s.number(0.1, 1), rest),
    ]);
    const made = s.world.createBodies(s.options({ kind: "dynamic", shapes }), [s.place(), s.place()]);
    for (const body of made) s.keep(s.bodies, body);
    return made;
  },
  createCircle: (s) => {
    const options = { ...s.shapeOptions(), radius: s.number(0.1, 1) };
    return s.keep(s.shapes, s.world.createCircle(s.body(), options));
  },
  createAabb: (s) => {
    const box = { halfWidth: s.number(0.1, 1), halfHeight: s.number(0.1, 1) };
    return s.keep(s.shapes, s.world.createAabb(s.body(), { ...s.shapeOptions(), ...box }));
  },
  createObb: (s) => {
    const box = { halfWidth: s.number(0.1, 1), halfHeight: s.number(0.1, 1), offset: s.vector() };
    return s.keep(s.shapes, s.world.createObb(s.body(), { ...s.shapeOptions(), ...box }));
  },
  createTerrain: (s) => s.keep(s.shapes, s.world.createTerrain(s.body(), s.line())),
  destroy: (s) => s.world.destroy(s.pick([s.body(), s.shape(), s.joint()])),
  isValid: (s) => s.world.isValid(s.pick([s.body(), s.shape(), s.joint()])),
  bodyStateOf: (s) => s.world.bodyStateOf(s.body()),
  shapeStateOf: (s) => s.world.shapeStateOf(s.shape()),
  shapesOf: (s) => s.world.shapesOf(s.body()),
  contactsOf: (s) => s.world.contactsOf(s.body()),
  setTransform: (s) => s.world.setTransform(s.body(), s.place(), s.below(2) ? 0 : s.number(-9, 9)),
  setVelocity: (s) => s.world.setVelocity(s.body(), s.vector(), s.number(-9, 9)),
  applyImpulse: (s) => s.world.applyImpulse(s.body(), s.vector(), s.place()),
  applyCenterForce: (s) => s.world.applyCenterForce(s.body(), s.vector()),
  applyTorque: (s) => s.world.applyTorque(s.body(), s.number(-9, 9)),
  setAwake: (s) => s.world.setAwake(s.body(), s.below(2) === 0),
  setEnabled: (s) => s.world.setEnabled(s.body(), s.below(2) === 0),
  terrainOf: (s) => s.world.terrainOf(s.shape()),
  setHeights: (s) => s.world.setHeights(s.shape(), s.below(9) - 1, [s.number(-1, 1)]),
  dig: (s) => s.world.dig(s.shape(), s.place(), s.number(0.1, 2)),
  raise: (s) => s.world.raise(s.shape(), s.number(-9, 9), s.number(0.1, 2), s.number(-1, 1)),
  replaceRange: (s) => s.world.replaceRange(s.shape(), -1, 1, [[s.number(-1, 1), s.number(-1, 1)]]),
  groundAt: (s) => s.world.groundAt(s.shape(), s.number(-9, 9)),
  setTexture: (s) => s.world.setTexture(s.shape(), s.below(4) === 0 ? null : s.texture()),
  textureOf: (s) => s.world.textureOf(s.shape()),
  frictionAt: (s) => s.world.frictionAt(s.shape(), s.number(-9, 9)),
  placeFoot: (s) => s.world.placeFoot(s.shape(), s.number(-9, 9), s.number(0, 2)),
  castRay: (s) => s.world.castRay(s.place(), s.vector(), s.options(s.filter())),
  castRayAll: (s) => s.world.castRayAll(s.place(), s.vector(), s.filter()),
  castShape: (s) => s.world.castShape(s.solid(), s.place(), s.vector(), s.filter()),
  castShapeAll: (s) => s.world.castShapeAll(s.solid(), s.place(), s.vector(), s.filter()),
  closest: (s) => s.world.closest(s.place(), s.number(0, 20), s.filter()),
  overlap: (s) =>
    s.world.overlap(
      s.below(2)
        ? { kind: "bounds", lower: s.place(), upper: s.place() }
        : { ...s.solid(), center: s.place() },
      s.filter(),
    ),
  step: (s) => s.world.step(),
  advance: (s) => s.world.advance(s.number(0, 0.05), s.below(5)),
  events: (s) => s.world.events(),
  poses: (s) => {
    s.world.poses(s.number(0, 1), ...s.place()); // not checked: poses are NaN where there is no body
  },
  stats: (s) => s.world.stats(),
  bisectionLimit: (s) => s.world.bisectionLimit(),
  broadphaseCounts: (s) => s.world.broadphaseCounts(),
  stepError: (s) => s.world.stepError(),
  measure: (s) => s.world.measure(),
  hash: (s) => s.world.hash(),
  shapeTable: (s) => {
    s.world.shapeTable();
  },
  shapeTableAwake: (s) => {
    s.world.shapeTableAwake();
  },
  draw: (s) => s.world.draw({ lower: s.place(), upper: s.place(), contacts: true }),
  setGravity: (s) => s.world.setGravity(s.vector()),
  setTimeStep: (s) => s.world.setTimeStep(s.number(0.001, 0.05)),
  setQuality: (s) => s.world.setQuality(s.pick(["draft", "default", "high", { substeps: 2 }])),
  setMaxError: (s) => s.world.setMaxError(s.number(0, 0.1)),
  setSleeping: (s) => s.world.setSleeping(s.below(2) === 0),
  snapshot: (s) => {
    s.snapshot = s.world.snapshot();
    s.after = null;
  },
  pack: (s) => {
    const now = s.world.snapshot();
    const base = s.snapshot && s.below(2) ? s.snapshot : undefined;
    const back = s.world.unpack(s.world.pack(now, base), base);
    if (back.length !== now.length || back.some((byte, i) => byte !== now[i]))
      throw new Error("other bytes are unpacked than were packed");
  },
  unpack: (s) => {
    const packed = s.world.pack(s.world.snapshot());
    packed[s.below(packed.length)] ^= 1 + s.below(255);
    let refused = false;
    try {
      s.world.unpack(packed);
    } catch (error) {
      refused = error instanceof thud.ThudError;
    }
    if (!refused) throw new Error("a damaged packed snapshot is taken, or refused in another way");
  },
  restore: (s) => {
    if (!s.snapshot) return;
    s.world.restore(s.snapshot);
    s.world.step();
    const hash = s.world.hash();
    if (s.after && s.after !== hash) throw new Error("a restored world goes another way");
    s.after = hash;
  },
  restoreDamaged: (s) => {
    if (!s.snapshot) return;
    const damaged = s.snapshot.slice(0, s.snapshot.length - s.below(2));
    damaged[s.below(damaged.length)] ^= 1 + s.below(255);
    let refused = false;
    try {
      s.world.restore(damaged);
    } catch (error) {
      refused = error instanceof thud.ThudError;
    }
    if (!refused) throw new Error("a damaged snapshot is taken, or refused in another way");
  },
  Mover: (s) => {
    const body = s.below(3) ? {} : { body: s.body() };
    const given = { shape: s.solid(), position: s.place(), maxSlope: s.number(0, 1.5), ...body };
    const mover = new thud.Mover(s.world, s.options(given));
    const gone = s.keep(s.movers, mover) && s.movers.length > 6 ? s.movers.shift() : null;
    if (gone) gone.close();
  },
  move: (s) => {
    if (s.movers.length) return s.pick(s.movers).move(s.vector(), s.number(0.001, 0.05));
  },
  walk: (s) => {
    if (!s.movers.length) return;
    const walk = { speed: s.number(-9, 9), jump: s.number(0, 9), drop: s.below(4) === 0 };
    return s.pick(s.movers).walk(s.options(walk));
  },
  closeMover: (s) => {
    if (s.movers.length) s.pick(s.movers).close();
  },
  minkowskiSum: (s) => thud.minkowskiSum(s.engine, s.solid(), s.solid(), s.vector()),
  createWorld: (s) => {
    const options = { ...s.worldOptions(), timeStep: s.number(0.001, 0.1), gravity: s.vector() };
    const other = s.engine.createWorld(s.options({ ...options, lengthScale: s.number(0.1, 9) }));
    const body = other.createBody({ kind: "dynamic" });
    other.createCircle(body, { radius: 0.5 });
    other.step();
    s.keep(s.bodies, body);
    other.close();
    other.step(); // the world is closed: the call must be refused with a named error
  },
};

const NAMES = Object.keys(CALLS);

/** Throws if a number in the value is not finite, however deeply nested. */
function checkFinite(value, name) {
  if (typeof value === "number" && !Number.isFinite(value) && !MAY_BE_INFINITE.has(name))
    throw new Error(`${name} tells ${value}`);
  if (value && typeof value === "object")
    for (const inner of Object.values(value)) checkFinite(inner, name);
}

/** Calls that tell a body's velocity as it is. */
const TELL_VELOCITY = new Set(["bodyStateOf", "velocityAt"]);

/** Plays one seed and throws at a finding. Returns the number of calls. */
export function play(engine, seed) {
  const s = new Session(engine, seed);
  const ground = s.keep(s.bodies, s.world.createBody());
  s.keep(s.shapes, s.world.createTerrain(ground, { kind: "irregular", points: [[-9, 0], [9, 1]] }));
  let unseen = false;
  for (let i = 0; i < CALLS_OF_A_SEED; i++) {
    const name = s.below(4) === 0 ? "step" : s.pick(NAMES);
    try {
      const told = CALLS[name](s);
      // Until the next step a velocity need not be finite: impulses may add up to infinity.
      unseen = name === "applyImpulse" || (unseen && name !== "step");
      if (!unseen || !TELL_VELOCITY.has(name)) checkFinite(told, name);
    } catch (error) {
      if (!(error instanceof thud.ThudError) || !error.message)
        throw new Error(`seed ${seed}, call ${i}, ${name}: ${error}`, { cause: error });
    }
  }
  for (const mover of s.movers) {
    try {
      mover.close();
    } catch (error) {
      if (!(error instanceof thud.ThudError)) throw error; // otherwise it was closed before
    }
  }
  s.world.close();
  return CALLS_OF_A_SEED;
}

/** The value of `--name` on the command line. */
function option(name, fallback) {
  const at = process.argv.indexOf(`--${name}`);
  return at < 0 ? fallback : process.argv[at + 1];
}

async function main() {
  const replayed = option("replay", null);
  if (replayed) {
    play(await thud.load(), Number(readFileSync(replayed, "utf8")));
    return;
  }
  const end = Date.now() + 1000 * Number(option("seconds", 60));
  const folder = option("findings", "build/fuzz/findings");
  let seed = Number(option("seed", 1)) * 1000;
  let calls = 0;
  while (Date.now() < end) {
    const engine = await thud.load();
    for (let i = 0; i < 200 && Date.now() < end; i++, seed++) {
      try {
        calls += play(engine, seed);
      } catch (error) {
        console.error(error);
        mkdirSync(folder, { recursive: true });
        writeFileSync(join(folder, `js-${seed}`), `${seed}\n`);
        process.exitCode = 1;
        return;
      }
      const progress = process.env.FUZZ_PROGRESS;
      if (progress) writeFileSync(`${progress}.${process.pid}`, `${calls}\n`);
    }
  }
  console.log(`${calls} calls`);
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) await main();
