/**
 * Bodies and shapes are changed after they were made. A change holds from the next step on, wakes
 * the body and what touches it, and is in snapshots that are taken after it. What is out of range
 * throws, and nothing has changed then; thud_edits.h has the details.
 */
import { checkNames } from "./checks/names.js";
import { Kind, kindOf } from "./plain/handles.js";
import { indexOf, numbersOf, userData } from "./numbers.js";
import {
  BODY_KINDS,
  type BodyRef,
  type BodyKind,
  type Detection,
  DETECTIONS,
  type Filter,
  type Locks,
  type Mass,
  type ShapeRef,
} from "./types.js";
import { NumberAt, ShapeStateAt } from "./generated/slots.js";
import { WorldJoints } from "./world-joints.js";

const FILTER = ["category", "mask", "group"] as const;
const LOCKS = ["x", "y"] as const;
const MASS = ["mass", "inertia", "center", "."] as const;

export class WorldEdits extends WorldJoints {
  // ---- shapes ----

  /**
   * What a shape is and meets; what is not named stays as it is. Contacts with what it meets no more
   * end, with an event.
   * @example world.setFilter(ghost, { mask: 0 })
   */
  setFilter(shape: ShapeRef, filter: Filter): void {
    const [category, mask, group] = numbersOf("setFilter", filter, FILTER);
    this.on(Kind.shape, "api_shape_get", shape);
    const s = this.engine.slots;
    this.on(
      Kind.shape,
      "api_shape_set_filter",
      shape,
      category ?? s[ShapeStateAt.category],
      mask ?? s[ShapeStateAt.mask],
      group ?? s[ShapeStateAt.group],
    );
  }

  /**
   * Coefficient of friction, 0 or more.
   * @example world.setFriction(ice, 0)
   */
  setFriction(shape: ShapeRef, friction: number): void {
    this.on(Kind.shape, "api_shape_set_friction", shape, friction);
  }

  /** How much it bounces, [0, 1]. */
  setRestitution(shape: ShapeRef, restitution: number): void {
    this.on(Kind.shape, "api_shape_set_restitution", shape, restitution);
  }

  /**
   * The speed of a conveyor belt, length/s.
   * @example world.setSurfaceSpeed(belt, -2)
   */
  setSurfaceSpeed(shape: ShapeRef, speed: number): void {
    this.on(Kind.shape, "api_shape_set_surface_speed", shape, speed);
  }

  /** Mass per area, 0 or more. Its body is weighed anew at once, and its centre of mass moves. */
  setDensity(shape: ShapeRef, density: number): void {
    this.on(Kind.shape, "api_shape_set_density", shape, density);
  }

  /** Whether it notes what is there and stops nothing. Its contacts end, and begin anew. */
  setSensor(shape: ShapeRef, sensor: boolean): void {
    this.on(Kind.shape, "api_shape_set_sensor", shape, Number(sensor));
    this.shapesRevision++;
  }

  /**
   * Whether its pairs have events; a pair has them where both shapes make them. An end is told
   * exactly where its begin was.
   * @example world.setEvents(debris, false)
   */
  setEvents(shape: ShapeRef, events: boolean): void {
    this.on(Kind.shape, "api_shape_set_events", shape, Number(events));
  }

  /**
   * Of a circle. Its body is weighed anew; what it then overlaps is pushed apart.
   * @example world.setRadius(balloon, 0.8)
   */
  setRadius(shape: ShapeRef, radius: number): void {
    this.on(Kind.shape, "api_shape_set_radius", shape, radius);
    this.shapesRevision++;
  }

  /** Of a box, about the same centre; as `setRadius`. */
  setHalfExtents(shape: ShapeRef, halfWidth: number, halfHeight: number): void {
    this.on(Kind.shape, "api_shape_set_half_extents", shape, halfWidth, halfHeight);
    this.shapesRevision++;
  }

  // ---- bodies ----

  /**
   * Keeps a number for your own use with a body or a shape: whole, from 0 to 2⁵³ - 1. Where a kind is
   * told another is refused.
   */
  setUserData(id: BodyRef | ShapeRef, data: number, kind?: "body" | "shape"): void {
    const number = userData(data) ?? 0;
    if (kindOf(id, kind) === Kind.shape) this.on(Kind.shape, "api_shape_set_user_data", id, number);
    else this.on(Kind.body, "api_body_set_user_data", id, number);
  }

  /**
   * What moves it. What becomes static stands still, what becomes dynamic is weighed by its shapes;
   * its contacts end, and those that still touch begin with the next step.
   * @example world.setKind(platform, "dynamic")
   */
  setKind(body: BodyRef, kind: BodyKind): void {
    this.on(Kind.body, "api_body_set_kind", body, indexOf(BODY_KINDS, kind, "kind"));
  }

  /** What slows its motion and its turning, 1/s, 0 or more. */
  setDamping(body: BodyRef, linear: number, angular: number): void {
    this.on(Kind.body, "api_body_set_damping", body, linear, angular);
  }

  /** What it feels of the world's gravity: 0 floats. */
  setGravityScale(body: BodyRef, scale: number): void {
    this.on(Kind.body, "api_body_set_gravity_scale", body, scale);
  }

  /** True stops its turning at once. */
  setFixedRotation(body: BodyRef, fixed: boolean): void {
    this.on(Kind.body, "api_body_set_fixed_rotation", body, Number(fixed));
  }

  /**
   * Which axes of the world a dynamic body does not move along, from where its centre of mass is, or
   * is put by `setTransform`. A lock is a joint, which `jointsOf` lists.
   * @example world.setLocks(paddle, { x: true })
   */
  setLocks(body: BodyRef, locks: Locks): void {
    const [x, y] = numbersOf("setLocks", locks, LOCKS);
    this.on(Kind.body, "api_body_set_locks", body, x ?? 0, y ?? 0);
  }

  /** The axes that it does not move along. */
  locksOf(body: BodyRef): { x: boolean; y: boolean } {
    this.on(Kind.body, "api_body_locks", body);
    const locked = this.engine.slots[NumberAt.value];
    return { x: (locked & 1) !== 0, y: locked > 1 };
  }

  /** How its motion is tested; null: as the world's. */
  setDetection(body: BodyRef, detection: Detection | null): void {
    const number = detection === null ? -1 : indexOf(DETECTIONS, detection, "detection");
    this.on(Kind.body, "api_body_set_detection", body, number);
  }

  /** Whether it may sleep once it is at rest. */
  setMaySleep(body: BodyRef, maySleep: boolean): void {
    this.on(Kind.body, "api_body_set_may_sleep", body, Number(maySleep));
  }

  /**
   * Gives a dynamic body a mass of its own, whatever its shapes weigh, until that is set again or
   * the body changes its kind; null: as its shapes weigh.
   * @example world.setMass(boat, { mass: 900, inertia: 400, center: [0, -0.4] })
   */
  setMass(body: BodyRef, mass: Mass | null): void {
    if (mass === null) {
      this.on(Kind.body, "api_body_weigh", body);
      return;
    }
    checkNames("setMass", mass, MASS);
    const { center = [0, 0] } = mass;
    this.on(Kind.body, "api_body_set_mass", body, mass.mass, mass.inertia, center?.[0], center?.[1]);
  }
}
