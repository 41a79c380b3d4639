/**
 * A world: bodies and shapes that advance in fixed steps. Handles are checked by the engine in
 * every call; a stale one throws, as does whatever is out of range, and nothing has changed then.
 * Built in layers, each in a file of its own: world-base (its life, time and settings),
 * world-queries, world-views (what is read of it), world-joints, world-edits, world-forces,
 * world-fields, world-lists, world-shapes, and here the bodies.
 */
import { within } from "./checks/parts.js";
import { blame, BODY_RANGES } from "./checks/ranges.js";
import { ThudError } from "./error.js";
import { BODY_OPTIONS, BodyStateAt, HandleAt } from "./generated/slots.js";
import { bodyAt, fill, numbersOf, vecAt } from "./numbers.js";
import {
  BODY_KINDS,
  type BodyId,
  type BodyOptions,
  type BodyState,
  type JointId,
  type ShapeId,
  type Vec2,
} from "./types.js";
import { WorldShapes } from "./world-shapes.js";

export class World extends WorldShapes {
  // ---- bodies ----

  /**
   * A body, with the shapes that are named. Without any it moves, and meets nothing, until it has
   * one. Where one of them is refused nothing is left of the body.
   * @example const ball = world.createBody({ kind: "dynamic", position: [0, 5] })
   */
  createBody(options: BodyOptions = {}): BodyId {
    const { engine } = this;
    const numbers = numbersOf("createBody", options, BODY_OPTIONS, ["shapes"]);
    const { shapes = [] } = options;
    if (typeof shapes?.length !== "number")
      throw new ThudError("invalid", `createBody: shapes must be a list: ${shapes}`);
    engine.exports.api_body_defaults();
    fill(engine.slots, numbers);
    try {
      engine.check(engine.exports.api_body_create(this.address));
    } catch (refused) {
      throw blame(refused, "createBody", options, BODY_RANGES, this.lengthScale);
    }
    this.shapesRevision++;
    const body = bodyAt(engine.slots, HandleAt.index1);
    let made = 0;
    try {
      for (; made < shapes.length; made++) this.createKind(body, shapes[made]);
    } catch (refused) {
      this.destroy(body);
      throw refused instanceof ThudError ? within(refused, `createBody: shapes[${made}]`) : refused;
    }
    return body;
  }

  /**
   * Removes a body with its shapes and joints, or one shape, or one joint.
   * @example world.destroy(ball)
   */
  destroy(id: BodyId | ShapeId | JointId): void {
    const destroy = this.engine.exports[`api_${id.kind}_destroy`];
    this.engine.check(destroy(this.address, id.index + 1, id.generation));
    if (id.kind !== "joint") this.shapesRevision++;
  }

  /** False once it was destroyed, or broke. */
  isValid(id: BodyId | ShapeId | JointId): boolean {
    const isValid = this.engine.exports[`api_${id.kind}_is_valid`];
    return isValid(this.address, id.index + 1, id.generation) !== 0;
  }

  /**
   * Where a body is, how fast, its mass.
   * @example world.bodyState(ball).position
   */
  bodyState(body: BodyId): BodyState {
    this.onBody("api_body_get", body);
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
  setTransform(body: BodyId, position: Vec2, angle = 0): void {
    this.onBody("api_body_set_transform", body, position[0], position[1], angle);
  }

  /**
   * Sets the velocity of the centre of mass, length/s, and the angular one, radians/s. Wakes it.
   * @example world.setVelocity(ball, [3, 0])
   */
  setVelocity(body: BodyId, velocity: Vec2, angularVelocity = 0): void {
    this.onBody("api_body_set_velocity", body, velocity[0], velocity[1], angularVelocity);
  }

  /**
   * Pushes at once: mass times length/s, at a place in the world. Wakes it.
   * @example world.applyImpulse(ball, [0, 5], point)
   */
  applyImpulse(body: BodyId, impulse: Vec2, point: Vec2): void {
    this.onBody("api_body_apply_impulse", body, impulse[0], impulse[1], point[0], point[1]);
  }

  /**
   * Pushes through the next step only, at the centre of mass.
   * @example world.applyForce(ball, [10, 0])
   */
  applyForce(body: BodyId, force: Vec2, torque = 0): void {
    this.onBody("api_body_apply_force", body, force[0], force[1], torque);
  }

  /** Wakes a body. False: it counts as at rest, and sleeps as soon as its whole island does. */
  setAwake(body: BodyId, awake: boolean): void {
    this.onBody("api_body_set_awake", body, Number(awake));
  }

  /**
   * False takes the body and its shapes out of the world: nothing moves, meets or finds them. True
   * brings it back, where it is and at the velocity it had.
   */
  setEnabled(body: BodyId, enabled: boolean): void {
    this.onBody("api_body_set_enabled", body, Number(enabled));
    this.shapesRevision++;
  }

  /** The shapes of a body. */
  shapesOf(body: BodyId): ShapeId[] {
    this.onBody("api_body_shapes", body);
    return this.shapeIds();
  }
}
