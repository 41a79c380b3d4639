/**
 * A world: bodies and shapes that advance in fixed steps. Handles are checked by the engine in
 * every call; a stale one throws, as does whatever is out of range, and nothing has changed then.
 * Built in layers, each in a file of its own: world-base (its life, time and settings),
 * world-queries, world-views (what is read of it), world-joints, world-edits, world-forces,
 * world-fields, world-lists, world-shapes, and here the bodies.
 */
import { within } from "./checks/hook.js";
import { ThudError } from "./error.js";
import { BODY_OPTIONS, BodyStateAt, HandleAt } from "./generated/slots.js";
import { bodyId, vecAt, writeOptions } from "./numbers.js";
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
import { WorldShapes } from "./world-shapes.js";

const BODY_OTHERS = ["shapes", "locks"];
/** By kind. */
const DESTROY = ["", "api_body_destroy", "api_shape_destroy", "api_joint_destroy"];
const IS_VALID = ["", "api_body_is_valid", "api_shape_is_valid", "api_joint_is_valid"];

export class World extends WorldShapes {
  // ---- bodies ----

  /**
   * A body, with the shapes that are named. Without any it moves, and meets nothing, until it has
   * one. Where one of them is refused nothing is left of the body.
   * @example const ball = world.createBody({ kind: "dynamic", position: [0, 5] })
   */
  createBody(options: BodyOptions = {}): BodyId {
    const index1 = this.#make(options);
    return bodyId(index1, this.#generation);
  }

  /**
   * As `createBody`, but returns the body's number: nothing is made in JavaScript. Keep the options
   * and what is in them, and set them anew for the next.
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
   * As many as there are positions, alike in all else. Where one is refused nothing is left of the
   * others.
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

  #generation = 0;

  /** Returns the first half of the handle, and leaves the other. */
  #make(options: BodyOptions): number {
    const { engine } = this;
    const shapes = options?.shapes;
    if (shapes !== undefined && typeof shapes?.length !== "number")
      throw new ThudError("invalid", `createBody: shapes must be a list: ${shapes}`);
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

  #makeShapes(index1: number, generation: number, shapes: readonly SolidOptions[]): void {
    let made = 0;
    try {
      for (; made < shapes.length; made++) this.makeSolid(index1, generation, shapes[made]);
    } catch (refused) {
      this.destroy(bodyId(index1, generation));
      throw refused instanceof ThudError ? within(refused, `createBody: shapes[${made}]`) : refused;
    }
  }

  #lock(body: BodyId, locks: Locks): void {
    try {
      this.setLocks(body, locks);
    } catch (refused) {
      this.destroy(body);
      throw refused instanceof ThudError ? within(refused, "createBody") : refused;
    }
  }

  /**
   * Removes a body with its shapes and joints, or one shape, or one joint. Where a kind is told
   * another is refused.
   * @example world.destroy(ball)
   */
  destroy(id: BodyRef | ShapeRef | JointRef, kind?: "body" | "shape" | "joint"): void {
    const its = kindOf(id, kind);
    this.on(its, DESTROY[its], id);
    if (its !== Kind.joint) this.shapesRevision++;
  }

  /** False once it was destroyed, or broke. Where a kind is told another is refused. */
  isValid(id: BodyRef | ShapeRef | JointRef, kind?: "body" | "shape" | "joint"): boolean {
    const its = kindOf(id, kind);
    const isValid = this.engine.exports[IS_VALID[its]];
    return isValid(this.address, index1Of(id, its), generationOf(id)) !== 0;
  }

  /**
   * Where a body is, how fast, its mass.
   * @example world.bodyState(ball).position
   */
  bodyState(body: BodyRef): BodyState {
    this.on(Kind.body, "api_body_get", body);
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
   * Puts a body elsewhere at once, without a motion in between; radians.
   * @example world.setTransform(ball, [0, 5], 0)
   */
  setTransform(body: BodyRef, position: Vec2, angle = 0): void {
    this.on(Kind.body, "api_body_set_transform", body, position?.[0], position?.[1], angle);
  }

  /**
   * Sets the velocity of the centre of mass, length/s, and the angular one, radians/s. Wakes it.
   * @example world.setVelocity(ball, [3, 0])
   */
  setVelocity(body: BodyRef, velocity: Vec2, angularVelocity = 0): void {
    this.on(Kind.body, "api_body_set_velocity", body, velocity?.[0], velocity?.[1], angularVelocity);
  }

  /**
   * Pushes at once: mass times length/s, at a place in the world. Wakes it.
   * @example world.applyImpulse(ball, [0, 5], point)
   */
  applyImpulse(body: BodyRef, impulse: Vec2, point: Vec2): void {
    this.on(Kind.body, "api_body_apply_impulse", body, impulse?.[0], impulse?.[1], point?.[0], point?.[1]);
  }

  /**
   * Pushes through the next step only, at the centre of mass.
   * @example world.applyForce(ball, [10, 0])
   */
  applyForce(body: BodyRef, force: Vec2, torque = 0): void {
    this.on(Kind.body, "api_body_apply_force", body, force?.[0], force?.[1], torque);
  }

  /** Wakes a body. False: it counts as at rest, and sleeps as soon as its whole island does. */
  setAwake(body: BodyRef, awake: boolean): void {
    this.on(Kind.body, "api_body_set_awake", body, Number(awake));
  }

  /**
   * False takes the body and its shapes out of the world: nothing moves, meets or finds them. True
   * brings it back, where it is and at the velocity it had.
   */
  setEnabled(body: BodyRef, enabled: boolean): void {
    this.on(Kind.body, "api_body_set_enabled", body, Number(enabled));
    this.shapesRevision++;
  }

  /** The shapes of a body, the last made first. */
  shapesOf(body: BodyRef): ShapeId[] {
    this.on(Kind.body, "api_body_shapes", body);
    return this.shapeIds();
  }
}
