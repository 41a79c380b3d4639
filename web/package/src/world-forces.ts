/**
 * The layer of World with further forces and impulses, the places and velocities of points of
 * bodies, and getters of single values. thud_forces.h and thud_reads.h describe them in full.
 * Getters change nothing, and are allowed inside callbacks.
 */
import {
  HandleAt,
  MotionAt,
  NumberAt,
  PlaceAt,
  QualityOptionsAt,
  RotationAt,
  StepSettingsAt,
} from "./generated/slots.js";
import { bodyAt, vecAt, xOf } from "./numbers.js";
import { type BodyId, type BodyRef, DETECTIONS, QUALITIES, type ShapeRef, type Vec2, type Into } from "./types.js";
import { Kind, kindOf } from "./plain/handles.js";
import type { StepSettings } from "./view-types.js";
import { WorldEdits } from "./world-edits.js";

/** The layer of World with forces, points and single values. */
export class WorldForces extends WorldEdits {
  // ---- forces and impulses ----

  /**
   * Applies a force, mass times length/s², to a dynamic body at a place in the world, through the
   * next step, or through the time of the next `advance`. Its torque is computed from the present
   * pose. A force that depends on the place, as a planet's or a spring's, is best that of the place in
   * the middle of the step, position + velocity × time step / 2: an orbit then keeps its energy, while
   * the force of the place before the step adds energy in each.
   * @throws {ThudError} "invalid", also for a body that is not dynamic; "stale".
   * @example world.applyForce(rocket, [0, 20], nozzle)
   */
  applyForce(body: BodyRef, force: Vec2, point: Vec2): void {
    this.on(Kind.body, "api_body_apply_force", body, xOf(force, "force"), force?.[1], xOf(point, "point"), point?.[1]);
  }

  /**
   * Applies an impulse, mass times length/s, to a dynamic body at its centre of mass, at once.
   * @throws {ThudError} "invalid", also for a body that is not dynamic; "stale".
   * @example world.applyCenterImpulse(ball, [0, 5])
   */
  applyCenterImpulse(body: BodyRef, impulse: Vec2): void {
    this.on(Kind.body, "api_body_apply_center_impulse", body, xOf(impulse, "impulse"), impulse?.[1]);
  }

  /**
   * Applies an angular impulse, mass times length²/s, to a dynamic body at once.
   * @throws {ThudError} "invalid", also for a body that is not dynamic; "stale".
   */
  applyAngularImpulse(body: BodyRef, impulse: number): void {
    this.on(Kind.body, "api_body_apply_angular_impulse", body, impulse);
  }

  /**
   * Sets the velocity by which a kinematic body reaches a pose at the end of the next step, turning
   * the shorter way; `angle` in radians. The body keeps the velocity, so call it before each step.
   * @throws {ThudError} "invalid", also for a body that is not kinematic, an AABB that would turn,
   * and a velocity above the world's maximumSpeed; "stale".
   * @example world.setTarget(lift, [0, 3 + Math.sin(time)])
   */
  setTarget(body: BodyRef, position: Vec2, angle = 0): void {
    this.on(Kind.body, "api_body_set_target", body, xOf(position, "position"), position?.[1], angle);
  }

  // ---- points; with `into` the result is written to that list, which is returned ----

  /**
   * The velocity, length/s, of the point of a body that is at this place in the world.
   * @throws {ThudError} "invalid", "stale".
   */
  velocityAt(body: BodyRef, point: Vec2, into?: Into): Vec2 {
    return this.#place("api_body_velocity_at", body, point, into);
  }

  /**
   * Transforms a point from the body's frame to the world.
   * @throws {ThudError} "invalid", "stale".
   * @example const muzzle = world.worldPoint(gun, [1, 0])
   */
  worldPoint(body: BodyRef, point: Vec2, into?: Into): Vec2 {
    return this.#place("api_body_world_point", body, point, into);
  }

  /**
   * Transforms a point from the world to the body's frame.
   * @throws {ThudError} "invalid", "stale".
   */
  localPoint(body: BodyRef, point: Vec2, into?: Into): Vec2 {
    return this.#place("api_body_local_point", body, point, into);
  }

  /**
   * Rotates a vector from the body's frame to the world.
   * @throws {ThudError} "invalid", "stale".
   */
  worldVector(body: BodyRef, vector: Vec2, into?: Into): Vec2 {
    return this.#place("api_body_world_vector", body, vector, into);
  }

  /**
   * Rotates a vector from the world to the body's frame.
   * @throws {ThudError} "invalid", "stale".
   */
  localVector(body: BodyRef, vector: Vec2, into?: Into): Vec2 {
    return this.#place("api_body_local_vector", body, vector, into);
  }

  // ---- single values, in place of a whole state ----

  /**
   * The place of a body's origin; with `into` it is written to that list.
   * @throws {ThudError} "stale".
   * @example const [x, y] = world.positionOf(ball)
   */
  positionOf(body: BodyRef, into?: Into): Vec2 {
    this.on(Kind.body, "api_body_position", body);
    return this.#pair(PlaceAt.at, into);
  }

  /**
   * The angle of a body, radians in (-π, π], with its cosine and sine.
   * @throws {ThudError} "stale".
   */
  rotationOf(body: BodyRef): { angle: number; cosine: number; sine: number } {
    this.on(Kind.body, "api_body_rotation", body);
    const s = this.engine.slots;
    return { angle: s[RotationAt.angle], cosine: s[RotationAt.cosine], sine: s[RotationAt.sine] };
  }

  /**
   * The velocity of a body's centre of mass, length/s, and its angular velocity, radians/s.
   * @throws {ThudError} "stale".
   */
  velocityOf(body: BodyRef): { velocity: Vec2; angularVelocity: number } {
    this.on(Kind.body, "api_body_velocity", body);
    const s = this.engine.slots;
    return { velocity: vecAt(s, MotionAt.velocity), angularVelocity: s[MotionAt.angularVelocity] };
  }

  /**
   * Pose and velocity of a body, written to a list, which is returned: x, y, angle; velocity x, y,
   * angular velocity.
   * @throws {ThudError} "stale".
   * @example world.motionOf(ball, numbers)
   */
  motionOf(body: BodyRef, into: Into): Into {
    this.positionOf(body, into);
    this.on(Kind.body, "api_body_rotation", body);
    const s = this.engine.slots;
    into[2] = s[RotationAt.angle];
    this.on(Kind.body, "api_body_velocity", body);
    into[3] = s[MotionAt.velocity];
    into[4] = s[MotionAt.velocity + 1];
    into[5] = s[MotionAt.angularVelocity];
    return into;
  }

  /**
   * The user data of a body or shape. `kind`: a handle of another kind is refused.
   * @throws {ThudError} "invalid", "stale".
   */
  userDataOf(id: BodyRef | ShapeRef, kind?: "body" | "shape"): number {
    if (kindOf(id, kind) === Kind.shape) this.on(Kind.shape, "api_shape_user_data", id);
    else this.on(Kind.body, "api_body_user_data", id);
    return this.engine.slots[NumberAt.value];
  }

  /**
   * The body of a shape.
   * @throws {ThudError} "stale".
   */
  bodyOf(shape: ShapeRef): BodyId {
    this.on(Kind.shape, "api_shape_body", shape);
    return bodyAt(this.engine.slots, HandleAt.index1);
  }

  /** The settings of the next step. */
  stepSettings(): StepSettings {
    this.onWorld("api_world_step_settings");
    const s = this.engine.slots;
    const quality = s.subarray(StepSettingsAt.quality);
    return {
      gravity: vecAt(s, StepSettingsAt.gravity),
      timeStep: s[StepSettingsAt.timeStep],
      maxError: s[StepSettingsAt.maxError],
      substeps: s[StepSettingsAt.substeps],
      sleeping: s[StepSettingsAt.sleeping] !== 0,
      quality: {
        base: QUALITIES[s[StepSettingsAt.base]],
        substeps: quality[QualityOptionsAt.substeps],
        contactStiffness: quality[QualityOptionsAt.contactStiffness],
        contactDamping: quality[QualityOptionsAt.contactDamping],
        detection: DETECTIONS[quality[QualityOptionsAt.detection]],
        islands: quality[QualityOptionsAt.islands] !== 0,
      },
    };
  }

  /** Calls the module's function `name` for a body and a point; it returns a pair. */
  #place(name: string, body: BodyRef, point: Vec2, into?: Into): Vec2 {
    this.on(Kind.body, name, body, xOf(point, "point"), point?.[1]);
    return this.#pair(PlaceAt.at, into);
  }

  /** The two numbers at `at` in the slots, written to `into` where that is given. */
  #pair(at: number, into: Into | undefined): Vec2 {
    const s = this.engine.slots;
    if (into === undefined) return vecAt(s, at);
    into[0] = s[at];
    into[1] = s[at + 1];
    return into as unknown as Vec2;
  }
}
