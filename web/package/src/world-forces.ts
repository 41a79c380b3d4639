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
import { type BodyId, type BodyRef, DETECTIONS, QUALITIES, type ShapeRef, type Vec2, type Into } from "./types.js";
import { Kind, kindOf } from "./plain/handles.js";
import type { StepSettings } from "./view-types.js";
import { WorldEdits } from "./world-edits.js";

export class WorldForces extends WorldEdits {
  // ---- pushes ----

  /**
   * Pushes through the next step only, at a place in the world, about which it also turns the body.
   * @example world.applyForceAt(rocket, [0, 20], nozzle)
   */
  applyForceAt(body: BodyRef, force: Vec2, point: Vec2): void {
    this.on(Kind.body, "api_body_apply_force_at", body, force?.[0], force?.[1], point?.[0], point?.[1]);
  }

  /**
   * Pushes at once at the centre of mass, mass times length/s, and turns nothing.
   * @example world.applyCenterImpulse(ball, [0, 5])
   */
  applyCenterImpulse(body: BodyRef, impulse: Vec2): void {
    this.on(Kind.body, "api_body_apply_center_impulse", body, impulse?.[0], impulse?.[1]);
  }

  /** Turns at once: mass times length²/s. */
  applyAngularImpulse(body: BodyRef, impulse: number): void {
    this.on(Kind.body, "api_body_apply_angular_impulse", body, impulse);
  }

  /**
   * Gives a kinematic body the velocity by which the next step brings it to a pose, the shorter way
   * round; it keeps that velocity, so ask before each step.
   * @example world.setTarget(lift, [0, 3 + Math.sin(time)])
   */
  setTarget(body: BodyRef, position: Vec2, angle = 0): void {
    this.on(Kind.body, "api_body_set_target", body, position?.[0], position?.[1], angle);
  }

  // ---- points; all write into a list of yours where one is given, and return it ----

  /** The velocity of the point of the body that is at this place in the world, length/s. */
  velocityAt(body: BodyRef, point: Vec2, into?: Into): Vec2 {
    return this.#place("api_body_velocity_at", body, point, into);
  }

  /**
   * From the body's frame to the world.
   * @example const muzzle = world.worldPoint(gun, [1, 0])
   */
  worldPoint(body: BodyRef, point: Vec2, into?: Into): Vec2 {
    return this.#place("api_body_world_point", body, point, into);
  }

  /** From the world to the body's frame. */
  localPoint(body: BodyRef, point: Vec2, into?: Into): Vec2 {
    return this.#place("api_body_local_point", body, point, into);
  }

  /** A direction, from the body's frame to the world. */
  worldVector(body: BodyRef, vector: Vec2, into?: Into): Vec2 {
    return this.#place("api_body_world_vector", body, vector, into);
  }

  /** A direction, from the world to the body's frame. */
  localVector(body: BodyRef, vector: Vec2, into?: Into): Vec2 {
    return this.#place("api_body_local_vector", body, vector, into);
  }

  // ---- single values, for who wants one and not a whole state ----

  /**
   * Where its origin is.
   * @example const [x, y] = world.positionOf(ball)
   */
  positionOf(body: BodyRef, into?: Into): Vec2 {
    this.on(Kind.body, "api_body_position", body);
    return this.#pair(PlaceAt.at, into);
  }

  /** How far it is turned: radians in (-π, π], and their cosine and sine. */
  rotationOf(body: BodyRef): { angle: number; cosine: number; sine: number } {
    this.on(Kind.body, "api_body_rotation", body);
    const s = this.engine.slots;
    return { angle: s[RotationAt.angle], cosine: s[RotationAt.cosine], sine: s[RotationAt.sine] };
  }

  /** Of its centre of mass, length/s, and radians/s. */
  velocityOf(body: BodyRef): { velocity: Vec2; angularVelocity: number } {
    this.on(Kind.body, "api_body_velocity", body);
    const s = this.engine.slots;
    return { velocity: vecAt(s, MotionAt.velocity), angularVelocity: s[MotionAt.angularVelocity] };
  }

  /**
   * The pose and the motion of a body in a list of yours: x, y, angle; velocity x, y and angular.
   * @example world.readMotion(ball, numbers)
   */
  readMotion(body: BodyRef, into: Into): void {
    this.positionOf(body, into);
    this.on(Kind.body, "api_body_rotation", body);
    const s = this.engine.slots;
    into[2] = s[RotationAt.angle];
    this.on(Kind.body, "api_body_velocity", body);
    into[3] = s[MotionAt.velocity];
    into[4] = s[MotionAt.velocity + 1];
    into[5] = s[MotionAt.angularVelocity];
  }

  /** What `setUserData` or the options gave. Where a kind is told another is refused. */
  userDataOf(id: BodyRef | ShapeRef, kind?: "body" | "shape"): number {
    if (kindOf(id, kind) === Kind.shape) this.on(Kind.shape, "api_shape_user_data", id);
    else this.on(Kind.body, "api_body_user_data", id);
    return this.engine.slots[NumberAt.value];
  }

  /** The body that a shape is of. */
  bodyOf(shape: ShapeRef): BodyId {
    this.on(Kind.shape, "api_shape_body", shape);
    return bodyAt(this.engine.slots, HandleAt.index1);
  }

  /** By which the next step is made. */
  settings(): StepSettings {
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

  #place(name: string, body: BodyRef, point: Vec2, into?: Into): Vec2 {
    this.on(Kind.body, name, body, point?.[0], point?.[1]);
    return this.#pair(PlaceAt.at, into);
  }

  #pair(at: number, into: Into | undefined): Vec2 {
    const s = this.engine.slots;
    if (into === undefined) return vecAt(s, at);
    into[0] = s[at];
    into[1] = s[at + 1];
    return into as unknown as Vec2;
  }
}
