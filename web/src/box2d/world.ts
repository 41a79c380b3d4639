/**
 * A copy of a thud world in Box2D. It is made from the state of the thud world, makes the same
 * steps, and follows the thud world: bodies that come and go, terrain that changes, kinematic
 * bodies that move. All arguments and results are in the thud world's units, and bodies are named
 * by their thud handles.
 *
 * One step of both: the scene's own code, the same commands to both, `box2dWorld.sync()`,
 * `world.step()`, `box2dWorld.step()`.
 */
import type {
  BodyId,
  BodyState,
  JointId,
  ShapeId,
  ShapeState,
  Terrain,
  Vec2,
  World,
} from "thud";
import type {
  b2BodyId,
  b2ShapeId,
  b2Vec2,
  b2WorldId,
} from "../../node_modules/box2d3-wasm/build/dist/es/deluxe/Box2D.deluxe";
import { type Held, inFrame } from "../worker/hands";
import type { Follower, WorldRecord } from "../worker/watch";
import { type Entry, weigh } from "./entry";
import { follow, missesOf } from "./follow";
import type { Gap } from "./joint-gap";
import { Joints } from "./joints";
import type { Box2D } from "./load";
import { type Common, createWorld, makeBody, makeChain, makeShape, setBody, setMass, setShape } from "./make";
import { Mirror, type Twin } from "./mirror";
import { Moves } from "./moves";
import { originFor, Places } from "./places";
import { Ruler } from "./ruler";

/**
 * If the pose of a kinematic body differs from that in thud by more than this (metres, plus the
 * length of the difference of the direction vectors), thud's body was moved by setTransform, and so
 * is Box2D's. Chosen.
 */
const STRAY = 0.002;

/**
 * Largest difference between Box2D's mass properties and thud's that is left: a share of mass and
 * inertia, and length scales for the centre. Chosen.
 */
const ROUNDING = 1e-4;

/** Settings of a copy. What is not given has its default value. */
export interface Box2DOptions extends Partial<WorldRecord> {
  /** Substeps per step. Default 4, as Box2D's manual recommends. */
  substeps?: number;
  /**
   * Contact frequency in Hz. Default 30, that of Box2D, which uses at most an eighth of its substep
   * rate.
   */
  contactHertz?: number;
}

export class Box2DWorld implements Follower, Twin {
  readonly #source: World;
  readonly #settings: Box2DOptions;
  readonly #common: Common;
  readonly #world: b2WorldId;
  readonly #mirror: Mirror;
  readonly #joints: Joints;
  /** Bodies without shapes. They are copied only if a joint needs them. */
  readonly #bare = new Map<number, BodyId>();
  /** Whether a body was added since the last call of `#follow`: joints may need it. */
  #cameBody = false;
  /**
   * Bodies that lost a shape. thud computes their mass in its next step, so it is copied after
   * that.
   */
  readonly #lighter = new Set<Entry>();
  readonly #moves: Moves;
  /** By slot of the thud body. */
  readonly #entries = new Map<number, Entry>();
  /** The slot of the thud body, by the index of Box2D's body. */
  readonly #slots: number[] = [];
  readonly #places: Places;
  /** Substeps of the steps from now on. */
  substeps: number;
  #gravity: Vec2;
  #timeStep: number;
  /**
   * Whether `heed` is called for each method of the thud world. If not, `sync` has to compare both
   * worlds every time.
   */
  #heeds = false;
  /** Whether a call since the last `sync` requires that both worlds are compared. */
  #stale = false;
  /** What is done at the end of the next `sync`. */
  #waiting: (() => void)[] = [];
  #ruler: Ruler | null = null;

  constructor(box2d: Box2D, source: World, settings: Box2DOptions = {}) {
    const { options = {} } = settings;
    this.#source = source;
    this.#settings = settings;
    this.substeps = settings.substeps ?? 4;
    this.#gravity = options.gravity ?? [0, -10];
    this.#timeStep = options.timeStep ?? 1 / 60;
    const unit = options.lengthScale ?? 1;
    this.#common = {
      box2d,
      unit,
      origin: originFor(source, unit),
      events: options.contactEvents ?? true,
    };
    this.#places = new Places(this.#common);
    this.#world = createWorld(this.#common, options, settings.contactHertz);
    this.#moves = new Moves(box2d);
    this.#mirror = new Mirror(source, this);
    this.#joints = new Joints(this.#common, source, this.#world, (id) => this.#bodyOf(id));
    this.#follow();
  }

  /** Frees everything. */
  close(): void {
    this.#ruler?.close();
    this.#box2d.b2DestroyWorld(this.#world);
    this.#entries.clear();
  }

  /** What the ruler may know of the calls. */
  get #known(): Pick<WorldRecord, "called"> | undefined {
    const { called } = this.#settings;
    return called && { called };
  }

  get #box2d(): Box2D {
    return this.#common.box2d;
  }

  /**
   * The place of Box2D's origin in the thud world. It is that of the world unless all bodies are
   * too far away.
   */
  get origin(): Vec2 {
    return this.#common.origin;
  }

  // ---- time ----

  /**
   * Brings the copy up to date: bodies, shapes, terrain, joints, and the motion of kinematic
   * bodies. To be called just before the steps of both engines. A body that is disabled in thud
   * does not exist in Box2D.
   */
  sync(): void {
    for (const entry of this.#lighter) this.#balance(entry);
    this.#lighter.clear();
    if (this.#stale || !this.#heeds) this.#follow();
    this.#stale = false;
    for (const entry of this.#entries.values()) if (entry.kind === "kinematic") this.#steer(entry);
    for (const apply of this.#waiting.splice(0)) apply();
  }

  /** Calls `apply` once the next `sync` has copied the bodies that came. */
  afterCopy(apply: () => void): void {
    this.#waiting.push(apply);
  }

  /** Compares both worlds, and copies what changed. */
  #follow(): void {
    this.#cameBody = false;
    this.#mirror.sync();
    for (const id of this.#bare.values()) if (!this.#source.isValid(id)) this.removeBody(id);
    for (const entry of this.#entries.values())
      if (!entry.weight && !this.#lighter.has(entry)) this.#balance(entry);
    if (this.#cameBody) this.#joints.touchAll();
    this.#joints.follow();
  }

  /**
   * Gives Box2D's body the mass, inertia and centre of thud's, if they differ from those that Box2D
   * computed from the shapes.
   */
  #balance(entry: Entry): void {
    entry.weight = weigh(this.#common, entry);
    if (entry.kind !== "dynamic") return;
    const state = this.#source.bodyStateOf(entry.id);
    const { mass, inertia, center } = entry.weight;
    const [x, y] = inFrame(state, state.center);
    const far = Math.hypot(x - center[0], y - center[1]) / this.#common.unit;
    const apart = (a: number, b: number) => Math.abs(a - b) > ROUNDING * a;
    if (!apart(state.mass, mass) && !apart(state.inertia, inertia) && far < ROUNDING) return;
    setMass(this.#common, entry.body, { mass: state.mass, inertia: state.inertia, center: [x, y] });
    entry.weight = weigh(this.#common, entry);
  }

  /** Box2D's body; null if the thud body is disabled. Creates a body that has no shapes. */
  #bodyOf(id: BodyId): b2BodyId | null {
    if (!this.isValid(id)) {
      const state = this.#source.bodyStateOf(id);
      if (!state.enabled) return null;
      this.addBody(id, state);
      this.finishBody(id, state);
      this.#bare.set(id.index, id);
    }
    return this.#entry(id).body;
  }

  /** Gives a kinematic body the pose (see STRAY) and the velocity that it has in thud. */
  #steer({ id }: Entry): void {
    const { position, angle, velocity, angularVelocity } = this.#source.bodyStateOf(id);
    const { unit } = this.#common;
    const [x, y, cosine, sine] = this.#places.pose(id.index);
    const strayed =
      Math.hypot(position[0] - x, position[1] - y) / unit +
      Math.hypot(Math.cos(angle) - cosine, Math.sin(angle) - sine);
    if (!(strayed < STRAY)) this.setTransform(id, position, angle);
    this.setVelocity(id, velocity, angularVelocity);
  }

  /** Makes a step. Returns the milliseconds that Box2D's step took. */
  step(): number {
    const { b2World_Step } = this.#box2d;
    const start = performance.now();
    b2World_Step(this.#world, this.#timeStep, this.substeps);
    const milliseconds = performance.now() - start;
    this.#places.beginStep();
    this.#moves.read(this.#world);
    for (let i = 0; i < this.#moves.count; i++)
      this.#moves.copyPose(i, this.#places.now, 4 * this.#slots[this.#moves.index1(i)]);
    this.#joints.breakThem();
    return milliseconds;
  }

  // ---- reading ----

  /**
   * Poses laid out like World.poses: four numbers per slot, x and y relative to the origin, cosine,
   * sine; NaN in empty slots. For alpha 1 after the last step, for alpha 0 before it. A copy.
   */
  poses(alpha: 0 | 1 = 1, originX = 0, originY = 0): Float32Array<ArrayBuffer> {
    return this.#places.copy(alpha, originX, originY);
  }

  /** The deepest overlap at present. Takes about as long as a step of thud at draft. */
  penetration(): number {
    this.#ruler ??= new Ruler(this.#source, this.#common.unit, this.#known);
    this.#ruler.sync();
    const [x, y] = this.origin;
    return this.#ruler.penetration(this.poses(1, x, y), x, y);
  }

  /** Kinetic and potential energy, as in World.measure. Takes some microseconds per body. */
  energy(): [kinetic: number, potential: number] {
    let [kinetic, potential] = [0, 0];
    for (const entry of this.#entries.values()) {
      if (entry.kind !== "dynamic") continue;
      const { center, velocity, angularVelocity, mass, inertia } = this.#held(entry);
      const [vx, vy] = velocity;
      kinetic += 0.5 * mass * (vx * vx + vy * vy) + 0.5 * inertia * angularVelocity ** 2;
      const [gx, gy] = this.#gravity;
      potential -= entry.gravityScale * mass * (gx * center[0] + gy * center[1]);
    }
    return [kinetic, potential];
  }

  /**
   * The gap of the joint that is open the most, in thud's poses and in Box2D's; empty without
   * joints.
   */
  jointGaps(): Gap[] {
    const [x, y] = this.origin;
    return this.#joints.gaps([this.#source.poses(1, x, y).slice(), this.poses(1, x, y)]);
  }

  /** What the thud world has and Box2D is not given, in a few words each. */
  get misses(): string[] {
    return [...this.#joints.misses, ...missesOf(this.#settings.called ?? new Set())];
  }

  /** Number of bodies with shapes. */
  get bodies(): number {
    return this.#entries.size - this.#bare.size;
  }

  get awakeBodies(): number {
    return this.#box2d.b2World_GetAwakeBodyCount(this.#world);
  }

  /** Bodies whose centre of mass is in a circle. */
  within(x: number, y: number, radius: number): BodyId[] {
    const found: BodyId[] = [];
    for (const entry of this.#entries.values()) {
      const [cx, cy] = this.#centerOf(entry);
      if (Math.hypot(cx - x, cy - y) <= radius) found.push(entry.id);
    }
    return found;
  }

  /** Bytes that all of Box2D's worlds hold. */
  get bytes(): number {
    const counters = this.#box2d.b2World_GetCounters(this.#world);
    const { byteCount } = counters;
    counters.delete();
    return byteCount;
  }

  // ---- Hands, and other methods as in World ----

  /** Whether the body exists. False, too, for a body that `sync` has not copied yet. */
  isValid(body: BodyId): boolean {
    return this.#entries.get(body.index)?.id.generation === body.generation;
  }

  bodyStateOf(body: BodyId): Held {
    return this.#held(this.#entry(body));
  }

  setTransform(body: BodyId, position: Vec2, angle = 0): void {
    const { b2Rot, b2Body_SetTransform } = this.#box2d;
    const entry = this.#entry(body);
    const turn = new b2Rot();
    turn.c = Math.cos(angle);
    turn.s = Math.sin(angle);
    this.#withPlace(position, (place) => b2Body_SetTransform(entry.body, place, turn));
    turn.delete();
    this.#places.put(body.index, position, angle);
  }

  setVelocity(body: BodyId, velocity: Vec2, angularVelocity = 0): void {
    const { b2Body_SetLinearVelocity, b2Body_SetAngularVelocity } = this.#box2d;
    const entry = this.#entry(body);
    this.#withMetres(velocity, (v) => b2Body_SetLinearVelocity(entry.body, v));
    b2Body_SetAngularVelocity(entry.body, angularVelocity);
  }

  applyImpulse(body: BodyId, impulse: Vec2, point: Vec2): void {
    const { b2Body_ApplyLinearImpulse } = this.#box2d;
    const entry = this.#entry(body);
    this.#withMetres(impulse, (j) =>
      this.#withPlace(point, (at) => b2Body_ApplyLinearImpulse(entry.body, j, at, true)),
    );
  }

  applyForce(body: BodyId, force: Vec2, point: Vec2): void {
    const { b2Body_ApplyForce } = this.#box2d;
    const entry = this.#entry(body);
    this.#withMetres(force, (f) =>
      this.#withPlace(point, (at) => b2Body_ApplyForce(entry.body, f, at, true)),
    );
  }

  applyCenterForce(body: BodyId, force: Vec2): void {
    const { b2Body_ApplyForceToCenter } = this.#box2d;
    const entry = this.#entry(body);
    this.#withMetres(force, (f) => b2Body_ApplyForceToCenter(entry.body, f, true));
  }

  applyTorque(body: BodyId, torque: number): void {
    this.#box2d.b2Body_ApplyTorque(this.#entry(body).body, torque / this.#common.unit ** 2, true);
  }

  setAwake(body: BodyId, awake: boolean): void {
    this.#box2d.b2Body_SetAwake(this.#entry(body).body, awake);
  }

  setGravity(gravity: Vec2): void {
    this.#gravity = gravity;
    this.#withMetres(gravity, (g) => this.#box2d.b2World_SetGravity(this.#world, g));
  }

  setTimeStep(seconds: number): void {
    this.#timeStep = seconds;
  }

  setSleeping(sleeping: boolean): void {
    this.#box2d.b2World_EnableSleeping(this.#world, sleeping);
  }

  // ---- Follower ----

  heed(method: string, result: unknown, args: readonly unknown[]): void {
    this.#heeds = true;
    follow(this, method, result, args);
  }

  /**
   * To be called when bodies, shapes or terrain may have changed: the next `sync` compares both
   * worlds.
   */
  lookAgain(): void {
    this.#stale = true;
  }

  /** To be called when a joint was created, changed or destroyed in the thud world. */
  touchJoint(joint: JointId): void {
    this.#joints.touch(joint);
  }

  /** Gives Box2D's body the properties that the thud body has now. */
  changeBody(body: BodyId): void {
    const entry = this.#entry(body);
    const state = this.#source.bodyStateOf(body);
    entry.kind = state.kind;
    entry.turns = turns(state);
    entry.gravityScale = state.gravityScale;
    setBody(this.#common, entry.body, state, this.#settings.bodyOptions?.(body) ?? {});
    this.#balance(entry);
    // Locks of a body (setLocks) are joints, which may have come or gone.
    this.#joints.touchAll();
    this.lookAgain();
  }

  /** Gives Box2D's shape the properties that the thud shape has now. */
  changeShape(shape: ShapeId): void {
    const state = this.#source.shapeStateOf(shape);
    const entry = this.#entries.get(state.body.index);
    const made = entry?.made.get(shape.index);
    // A shape that is not copied yet will be made from its state at that time.
    if (!entry || !made) return;
    if (state.kind !== "terrain" && "shape" in made && this.#isSensor(made.shape) === state.sensor) {
      setShape(this.#common, made.shape, state);
    } else {
      const terrain = state.kind === "terrain" ? this.#source.terrainOf(shape) : null;
      this.removeShape(state.body, shape);
      this.addShape(state.body, shape, state, terrain);
    }
    this.#balance(entry);
  }

  #isSensor(shape: b2ShapeId): boolean {
    return this.#box2d.b2Shape_IsSensor(shape);
  }

  /** Calls `use` with a vector of thud lengths, scaled to metres. */
  #withMetres([x, y]: Vec2, use: (vector: b2Vec2) => void): void {
    const { unit } = this.#common;
    this.#withVector([x / unit, y / unit], use);
  }

  /** Calls `use` with a place of the thud world, in Box2D's coordinates. */
  #withPlace(place: Vec2, use: (vector: b2Vec2) => void): void {
    this.#withVector(this.#places.toMetres(place), use);
  }

  #withVector([x, y]: Vec2, use: (vector: b2Vec2) => void): void {
    const vector = new this.#box2d.b2Vec2(x, y);
    use(vector);
    vector.delete();
  }

  /** Throws if the body is not copied. */
  #entry(body: BodyId): Entry {
    const entry = this.#entries.get(body.index);
    if (!entry || entry.id.generation !== body.generation)
      throw new Error(`Box2D has no body in slot ${body.index} yet`);
    return entry;
  }

  /** The state of a body in the thud world's units. */
  #held(entry: Entry): Held {
    const { unit } = this.#common;
    const [x, y, c, s] = this.#places.pose(entry.id.index);
    const { mass, inertia } = (entry.weight ??= weigh(this.#common, entry));
    const velocity = this.#box2d.b2Body_GetLinearVelocity(entry.body);
    const [vx, vy] = [velocity.x * unit, velocity.y * unit];
    velocity.delete();
    return {
      kind: entry.kind,
      position: [x, y],
      center: this.#centerOf(entry),
      angle: Math.atan2(s, c),
      velocity: [vx, vy],
      angularVelocity: this.#box2d.b2Body_GetAngularVelocity(entry.body),
      mass,
      inertia,
    };
  }

  /** The centre of mass in the thud world. */
  #centerOf(entry: Entry): Vec2 {
    const [x, y, c, s] = this.#places.pose(entry.id.index);
    const { center } = (entry.weight ??= weigh(this.#common, entry));
    return [x + c * center[0] - s * center[1], y + s * center[0] + c * center[1]];
  }

  // ---- Twin ----

  addBody(id: BodyId, state: BodyState): void {
    // The body had no shapes until now, and was created for a joint.
    if (this.isValid(id)) return void this.#bare.delete(id.index);
    this.#cameBody = true;
    const options = this.#settings.bodyOptions?.(id) ?? {};
    const body = makeBody(this.#common, this.#world, state, options);
    this.#entries.set(id.index, {
      id,
      body,
      kind: state.kind,
      turns: turns(state),
      gravityScale: state.gravityScale,
      made: new Map(),
      weight: null,
    });
    this.#slots[body.index1] = id.index;
    this.#places.add(id.index, state.position, state.angle);
  }

  addShape(body: BodyId, id: ShapeId, state: ShapeState, terrain: Terrain | null): void {
    const entry = this.#entry(body);
    const made =
      state.kind === "terrain"
        ? { chain: makeChain(this.#common, entry.body, state, terrain!) }
        : { shape: makeShape(this.#common, entry.body, state) };
    entry.made.set(id.index, made);
    entry.weight = null;
  }

  /**
   * Sets the velocity after the shapes were added: it is that of the centre of mass, which they
   * determine.
   */
  finishBody(id: BodyId, state: BodyState): void {
    this.setVelocity(id, state.velocity, state.angularVelocity);
  }

  removeShape(body: BodyId, { index }: ShapeId): void {
    const entry = this.#entry(body);
    const made = entry.made.get(index);
    if (!made) return;
    if ("chain" in made) this.#box2d.b2DestroyChain(made.chain);
    else this.#box2d.b2DestroyShape(made.shape, true);
    entry.made.delete(index);
    entry.weight = null;
    this.#lighter.add(entry);
  }

  removeBody(body: BodyId): void {
    this.#joints.forget(body);
    this.#bare.delete(body.index);
    this.#lighter.delete(this.#entry(body));
    this.#box2d.b2DestroyBody(this.#entry(body).body);
    this.#entries.delete(body.index);
    this.#places.remove(body.index);
  }
}

/** Whether a body can rotate. */
function turns({ kind, inertia }: BodyState): boolean {
  return kind !== "dynamic" || inertia > 0;
}
