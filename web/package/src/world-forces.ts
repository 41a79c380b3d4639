/**
 * Bodies are pushed at points, and asked for single values: where their points are, how they move.
 * thud_forces.h and thud_reads.h have the details.
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
import { bodyAt, vecAt } from "./numbers.js";
import { type BodyId, DETECTIONS, QUALITIES, type ShapeId, type Vec2 } from "./types.js";
import type { StepSettings } from "./view-types.js";
import { WorldEdits } from "./world-edits.js";

export class WorldForces extends WorldEdits {
  // ---- pushes ----

  /**
   * Pushes through the next step only, at a place in the world, about which it also turns the body.
   * @example world.applyForceAt(rocket, [0, 20], nozzle)
   */
  applyForceAt(body: BodyId, force: Vec2, point: Vec2): void {
    this.onBody("api_body_apply_force_at", body, force[0], force[1], point[0], point[1]);
  }

  /**
   * Pushes at once at the centre of mass, mass times length/s, and turns nothing.
   * @example world.applyCenterImpulse(ball, [0, 5])
   */
  applyCenterImpulse(body: BodyId, impulse: Vec2): void {
    this.onBody("api_body_apply_center_impulse", body, impulse[0], impulse[1]);
  }

  /** Turns at once: mass times length²/s. */
  applyAngularImpulse(body: BodyId, impulse: number): void {
    this.onBody("api_body_apply_angular_impulse", body, impulse);
  }

  /**
   * Gives a kinematic body the velocity by which the next step brings it to a pose, the shorter way
   * round; it keeps that velocity, so ask before each step.
   * @example world.setTarget(lift, [0, 3 + Math.sin(time)])
   */
  setTarget(body: BodyId, position: Vec2, angle = 0): void {
    this.onBody("api_body_set_target", body, position[0], position[1], angle);
  }

  // ---- points ----

  /** The velocity of the point of the body that is at this place in the world, length/s. */
  velocityAt(body: BodyId, point: Vec2): Vec2 {
    return this.#place("api_body_velocity_at", body, point);
  }

  /**
   * From the body's frame to the world.
   * @example const muzzle = world.worldPoint(gun, [1, 0])
   */
  worldPoint(body: BodyId, point: Vec2): Vec2 {
    return this.#place("api_body_world_point", body, point);
  }

  /** From the world to the body's frame. */
  localPoint(body: BodyId, point: Vec2): Vec2 {
    return this.#place("api_body_local_point", body, point);
  }

  /** A direction, from the body's frame to the world. */
  worldVector(body: BodyId, vector: Vec2): Vec2 {
    return this.#place("api_body_world_vector", body, vector);
  }

  /** A direction, from the world to the body's frame. */
  localVector(body: BodyId, vector: Vec2): Vec2 {
    return this.#place("api_body_local_vector", body, vector);
  }

  // ---- single values, for who wants one and not a whole state ----

  /**
   * Where its origin is.
   * @example const [x, y] = world.positionOf(ball)
   */
  positionOf(body: BodyId): Vec2 {
    this.onBody("api_body_position", body);
    return vecAt(this.engine.slots, PlaceAt.at);
  }

  /** How far it is turned: radians in (-π, π], and their cosine and sine. */
  rotationOf(body: BodyId): { angle: number; cosine: number; sine: number } {
    this.onBody("api_body_rotation", body);
    const s = this.engine.slots;
    return { angle: s[RotationAt.angle], cosine: s[RotationAt.cosine], sine: s[RotationAt.sine] };
  }

  /** Of its centre of mass, length/s, and radians/s. */
  velocityOf(body: BodyId): { velocity: Vec2; angularVelocity: number } {
    this.onBody("api_body_velocity", body);
    const s = this.engine.slots;
    return { velocity: vecAt(s, MotionAt.velocity), angularVelocity: s[MotionAt.angularVelocity] };
  }

  /** What `setUserData` or the options gave. */
  userDataOf(id: BodyId | ShapeId): number {
    if (id.kind === "shape") this.onShape("api_shape_user_data", id);
    else this.onBody("api_body_user_data", id);
    return this.engine.slots[NumberAt.value];
  }

  /** The body that a shape is of. */
  bodyOf(shape: ShapeId): BodyId {
    this.onShape("api_shape_body", shape);
    return bodyAt(this.engine.slots, HandleAt.index1);
  }

  /** By which the next step is made. */
  settings(): StepSettings {
    this.engine.check(this.engine.exports.api_world_step_settings(this.address));
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

  #place(name: string, body: BodyId, point: Vec2): Vec2 {
    this.onBody(name, body, point[0], point[1]);
    return vecAt(this.engine.slots, PlaceAt.at);
  }
}
