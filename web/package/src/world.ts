/**
 * World: bodies, shapes and joints that advance in fixed steps. The class is built in layers, each
 * in a file of its own that extends the one before: world-base (creation, time, settings,
 * snapshots), world-queries, world-views (events, statistics, drawing), world-joints, world-edits,
 * world-forces, world-fields, rules/world-rules, world-lists, world-shapes, world-textures, and here the
 * bodies.
 *
 * Errors: the engine checks each handle and value. A call that fails throws a ThudError and has
 * changed nothing, unless its comment says otherwise. Besides the codes that a comment names, every
 * call throws "stale" after `close`, and "null" for a handle that is none.
 *
 * Callbacks are listeners, pair filters and cast listeners. Inside them the world may be read;
 * bodies and shapes that are created, destroyed, moved or pushed there change with the next step.
 */
import { shown, within } from "./checks/hook.js";
import { ThudError } from "./error.js";
import { BODY_OPTIONS, BodyStateAt, HandleAt } from "./generated/slots.js";
import { bodyId, flagOf, vecAt, writeOptions, xOf } from "./numbers.js";
import {
  BODY_KINDS,
  type BodyId, type BodyRef,
  type BodyOptions,
  type BodyState,
  type JointRef,
  type Locks,
  type ShapeId,
  type ShapeRef,
  type SolidOptions,
  type Vec2,
} from "./types.js";
import { generationOf, index1Of, Kind, kindOf, numberOfPair } from "./plain/handles.js";
import { WorldTextures } from "./world-textures.js";

/** Options of createBody that are no numbers of the module's body. */
const BODY_OTHERS = ["shapes", "locks"];
/** The module's functions by kind of handle. */
const DESTROY = ["", "api_body_destroy", "api_shape_destroy", "api_joint_destroy"];
const IS_VALID = ["", "api_body_is_valid", "api_shape_is_valid", "api_joint_is_valid"];

/** A world. Make it by `Engine.createWorld`, and free it by `close`. */
export class World extends WorldTextures {
  // ---- bodies ----

  /**
   * Creates a body with the shapes of its options. A body without shapes moves, but collides with
   * nothing. If one of the shapes is refused the body is not created.
   * @throws {ThudError} "invalid" for an unknown option or a value out of range; "memory".
   * @example const ball = world.createBody({ kind: "dynamic", position: [0, 5] })
   */
  createBody(options: BodyOptions = {}): BodyId {
    const index1 = this.#make(options);
    return bodyId(index1, this.#generation);
  }

  /**
   * As `createBody`, but returns the body's number, and allocates no object in JavaScript. To
   * allocate none at all keep the options, and change them for the next body.
   * @throws {ThudError} "invalid", also for a body that has no number, see `numberOf`; "memory".
   * @example const ball = world.spawn(ballOptions)
   */
  spawn(options: BodyOptions): number {
    const index1 = this.#make(options);
    try {
      return numberOfPair(index1, this.#generation, Kind.body);
    } catch (refused) {
      this.destroy(bodyId(index1, this.#generation));
      throw refused;
    }
  }

  /**
   * Creates a body at each of the positions, with the same options otherwise. If one is refused
   * none is created.
   * @throws {ThudError} "invalid"; "memory".
   * @example world.createBodies({ shapes: [{ kind: "circle", radius: 0.5 }] }, [[-2, 0], [2, 0]])
   */
  createBodies(options: Omit<BodyOptions, "position">, positions: readonly Vec2[]): BodyId[] {
    const made: BodyId[] = [];
    try {
      for (const position of positions) made.push(this.createBody({ ...options, position }));
    } catch (refused) {
      for (const body of made) this.destroy(body);
      throw refused instanceof ThudError
        ? within(refused, `createBodies: positions[${made.length}]`)
        : refused;
    }
    return made;
  }

  /** The generation of the body that #make made last. */
  #generation = 0;

  /** Creates a body. Returns index1 of its handle, and sets #generation. */
  #make(options: BodyOptions): number {
    const { engine } = this;
    const shapes = options?.shapes;
    if (shapes !== undefined && typeof shapes?.length !== "number")
      throw new ThudError("invalid", `createBody: shapes must be a list: ${shown(shapes)}`);
    engine.exports.api_body_defaults();
    writeOptions("createBody", engine.slots, options, BODY_OPTIONS, BODY_OTHERS);
    const result = engine.exports.api_body_create(this.address);
    if (result !== 0) this.refuse(result, "createBody", options);
    this.shapesRevision++;
    const index1 = engine.slots[HandleAt.index1];
    const generation = engine.slots[HandleAt.index1 + 1];
    if (shapes !== undefined) this.#makeShapes(index1, generation, shapes);
    if (options.locks !== undefined) this.#lock(bodyId(index1, generation), options.locks);
    this.#generation = generation;
    return index1;
  }

  /** Adds shapes to a new body; destroys the body and throws where one is refused. */
  #makeShapes(index1: number, generation: number, shapes: readonly SolidOptions[]): void {
    let made = 0;
    try {
      for (; made < shapes.length; made++) this.makeSolid(index1, generation, shapes[made]);
    } catch (refused) {
      this.destroy(bodyId(index1, generation));
      throw refused instanceof ThudError ? within(refused, `createBody: shapes[${made}]`) : refused;
    }
  }

  /** Locks axes of a new body; destroys the body and throws where that is refused. */
  #lock(body: BodyId, locks: Locks): void {
    try {
      this.setLocks(body, locks);
    } catch (refused) {
      this.destroy(body);
      throw refused instanceof ThudError ? within(refused, "createBody") : refused;
    }
  }

  /**
   * Destroys a body with its shapes and joints, or one shape, or one joint. `kind`: a handle of
   * another kind is refused.
   * @throws {ThudError} "invalid", "stale"; "locked" for a joint inside a callback.
   * @example world.destroy(ball)
   */
  destroy(id: BodyRef | ShapeRef | JointRef, kind?: "body" | "shape" | "joint"): void {
    const its = kindOf(id, kind);
    this.on(its, DESTROY[its], id);
    if (its !== Kind.joint) this.shapesRevision++;
  }

  /**
   * Whether the handle names a body, shape or joint of this world: false once it was destroyed.
   * `kind`: a handle of another kind is refused.
   * @throws {ThudError} "invalid".
   */
  isValid(id: BodyRef | ShapeRef | JointRef, kind?: "body" | "shape" | "joint"): boolean {
    const its = kindOf(id, kind);
    const isValid = this.engine.exports[IS_VALID[its]];
    return isValid(this.address, index1Of(id, its), generationOf(id)) !== 0;
  }

  /**
   * All values of a body: its pose, velocity, mass and flags.
   * @throws {ThudError} "stale".
   * @example world.bodyStateOf(ball).position
   */
  bodyStateOf(body: BodyRef): BodyState {
    this.on(Kind.body, "api_body_state", body);
    const s = this.engine.slots;
    return {
      kind: BODY_KINDS[s[BodyStateAt.kind]],
      position: vecAt(s, BodyStateAt.position),
      center: vecAt(s, BodyStateAt.center),
      angle: s[BodyStateAt.angle],
      velocity: vecAt(s, BodyStateAt.velocity),
      angularVelocity: s[BodyStateAt.angularVelocity],
      mass: s[BodyStateAt.mass],
      inertia: s[BodyStateAt.inertia],
      gravityScale: s[BodyStateAt.gravityScale],
      awake: s[BodyStateAt.awake] !== 0,
      enabled: s[BodyStateAt.enabled] !== 0,
      quarantined: s[BodyStateAt.quarantined] !== 0,
      userData: s[BodyStateAt.userData],
      shapeCount: s[BodyStateAt.shapeCount],
    };
  }

  /**
   * Puts a body's origin at a place and turns the body to an angle, radians (0 for a body with an
   * AABB or terrain). It has no path in between.
   * @throws {ThudError} "invalid", "stale"; "memory" inside a callback.
   * @example world.setTransform(ball, [0, 5], 0)
   */
  setTransform(body: BodyRef, position: Vec2, angle = 0): void {
    this.on(Kind.body, "api_body_set_transform", body, xOf(position, "position"), position?.[1], angle);
  }

  /**
   * Sets the velocity of the centre of mass, length/s, and the angular velocity, radians/s, default
   * 0. Wakes the body.
   * @throws {ThudError} "invalid", also for a static body; "stale"; "memory" inside a callback.
   * @example world.setVelocity(ball, [3, 0])
   */
  setVelocity(body: BodyRef, velocity: Vec2, angularVelocity = 0): void {
    this.on(Kind.body, "api_body_set_velocity", body, xOf(velocity, "velocity"), velocity?.[1], angularVelocity);
  }

  /**
   * Applies an impulse, mass times length/s, to a dynamic body at a place in the world, at once.
   * Wakes the body.
   * @throws {ThudError} "invalid", also for a body that is not dynamic; "stale"; "memory" inside a
   * callback.
   * @example world.applyImpulse(ball, [0, 5], point)
   */
  applyImpulse(body: BodyRef, impulse: Vec2, point: Vec2): void {
    this.on(Kind.body, "api_body_apply_impulse", body, xOf(impulse, "impulse"), impulse?.[1], xOf(point, "point"), point?.[1]);
  }

  /**
   * Applies a force, mass times length/s², to a dynamic body at its centre of mass, through the
   * next step, or through the time of the next `advance`. Forces add up.
   * @throws {ThudError} "invalid", also for a body that is not dynamic; "stale"; "memory" inside a
   * callback.
   * @example world.applyCenterForce(ball, [10, 0])
   */
  applyCenterForce(body: BodyRef, force: Vec2): void {
    this.on(Kind.body, "api_body_apply_center_force", body, xOf(force, "force"), force?.[1]);
  }

  /**
   * Applies a torque, mass times length²/s², to a dynamic body, through the next step, or through
   * the time of the next `advance`. Torques add up.
   * @throws {ThudError} "invalid", also for a body that is not dynamic; "stale"; "memory" inside a
   * callback.
   * @example world.applyTorque(ball, -3)
   */
  applyTorque(body: BodyRef, torque: number): void {
    this.on(Kind.body, "api_body_apply_torque", body, torque);
  }

  /**
   * Wakes a dynamic body; false: it counts as at rest, and falls asleep as soon as its whole island
   * does.
   * @throws {ThudError} "invalid", "stale"; "memory" inside a callback.
   */
  setAwake(body: BodyRef, awake: boolean): void {
    this.on(Kind.body, "api_body_set_awake", body, flagOf(awake, "awake"));
  }

  /**
   * Enables or disables a body. False removes the body and its shapes from the simulation: its
   * contacts end, and no body, query or joint acts on it. True brings it back at its place, with
   * its velocity.
   * @throws {ThudError} "invalid", "stale"; "memory" inside a callback.
   */
  setEnabled(body: BodyRef, enabled: boolean): void {
    this.on(Kind.body, "api_body_set_enabled", body, flagOf(enabled, "enabled"));
    this.shapesRevision++;
  }

  /**
   * The shapes of a body, in reverse order of their creation.
   * @throws {ThudError} "stale".
   */
  shapesOf(body: BodyRef): ShapeId[] {
    this.on(Kind.body, "api_body_shapes", body);
    return this.shapeIds();
  }
}
