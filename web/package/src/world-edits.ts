/**
 * Bodies and shapes are changed after they were made. A change holds from the next step on, wakes
 * the body and what touches it, and is in snapshots that are taken after it. What is out of range
 * throws, and nothing has changed then; thud_edits.h has the details.
 */
import { checkNames } from "./checks/names.js";
import { blame, MASS_RANGES } from "./checks/ranges.js";
import { indexOf, numbersOf, userData } from "./numbers.js";
import {
  BODY_KINDS,
  type BodyId,
  type BodyKind,
  type Detection,
  DETECTIONS,
  type Filter,
  type Mass,
  type ShapeId,
} from "./types.js";
import { ShapeStateAt } from "./generated/slots.js";
import { WorldJoints } from "./world-joints.js";

const FILTER = ["category", "mask", "group"] as const;
const MASS = ["mass", "inertia", "center", "."] as const;

export class WorldEdits extends WorldJoints {
  // ---- shapes ----

  /**
   * What a shape is and meets; what is not named stays as it is. Contacts with what it meets no more
   * end, with an event.
   * @example world.setFilter(ghost, { mask: 0 })
   */
  setFilter(shape: ShapeId, filter: Filter): void {
    const [category, mask, group] = numbersOf("setFilter", filter, FILTER);
    this.onShape("api_shape_get", shape);
    const s = this.engine.slots;
    this.onShape(
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
  setFriction(shape: ShapeId, friction: number): void {
    this.onShape("api_shape_set_friction", shape, friction);
  }

  /** How much it bounces, [0, 1]. */
  setRestitution(shape: ShapeId, restitution: number): void {
    this.onShape("api_shape_set_restitution", shape, restitution);
  }

  /**
   * The speed of a conveyor belt, length/s.
   * @example world.setSurfaceSpeed(belt, -2)
   */
  setSurfaceSpeed(shape: ShapeId, speed: number): void {
    this.onShape("api_shape_set_surface_speed", shape, speed);
  }

  /** Mass per area, 0 or more. Its body is weighed anew at once, and its centre of mass moves. */
  setDensity(shape: ShapeId, density: number): void {
    this.onShape("api_shape_set_density", shape, density);
  }

  /** Whether it notes what is there and stops nothing. Its contacts end, and begin anew. */
  setSensor(shape: ShapeId, sensor: boolean): void {
    this.onShape("api_shape_set_sensor", shape, Number(sensor));
    this.shapesRevision++;
  }

  /**
   * Of a circle. Its body is weighed anew; what it then overlaps is pushed apart.
   * @example world.setRadius(balloon, 0.8)
   */
  setRadius(shape: ShapeId, radius: number): void {
    this.onShape("api_shape_set_radius", shape, radius);
    this.shapesRevision++;
  }

  /** Of a box, about the same centre; as `setRadius`. */
  setHalfExtents(shape: ShapeId, halfWidth: number, halfHeight: number): void {
    this.onShape("api_shape_set_half_extents", shape, halfWidth, halfHeight);
    this.shapesRevision++;
  }

  // ---- bodies ----

  /** Keeps a number for your own use with a body or a shape: whole, from 0 to 2⁵³ - 1. */
  setUserData(id: BodyId | ShapeId, data: number): void {
    const number = userData(data) ?? 0;
    if (id.kind === "shape") this.onShape("api_shape_set_user_data", id, number);
    else this.onBody("api_body_set_user_data", id, number);
  }

  /**
   * What moves it. What becomes static stands still, what becomes dynamic is weighed by its shapes;
   * its contacts end, and those that still touch begin with the next step.
   * @example world.setKind(platform, "dynamic")
   */
  setKind(body: BodyId, kind: BodyKind): void {
    this.onBody("api_body_set_kind", body, indexOf(BODY_KINDS, kind, "kind"));
  }

  /** What slows its motion and its turning, 1/s, 0 or more. */
  setDamping(body: BodyId, linear: number, angular: number): void {
    this.onBody("api_body_set_damping", body, linear, angular);
  }

  /** What it feels of the world's gravity: 0 floats. */
  setGravityScale(body: BodyId, scale: number): void {
    this.onBody("api_body_set_gravity_scale", body, scale);
  }

  /** True stops its turning at once. */
  setFixedRotation(body: BodyId, fixed: boolean): void {
    this.onBody("api_body_set_fixed_rotation", body, Number(fixed));
  }

  /** How its motion is tested; null: as the world's. */
  setDetection(body: BodyId, detection: Detection | null): void {
    const number = detection === null ? -1 : indexOf(DETECTIONS, detection, "detection");
    this.onBody("api_body_set_detection", body, number);
  }

  /** Whether it may sleep once it is at rest. */
  setMaySleep(body: BodyId, maySleep: boolean): void {
    this.onBody("api_body_set_may_sleep", body, Number(maySleep));
  }

  /**
   * Gives a dynamic body a mass of its own, whatever its shapes weigh, until that is set again or
   * the body changes its kind; null: as its shapes weigh.
   * @example world.setMass(boat, { mass: 900, inertia: 400, center: [0, -0.4] })
   */
  setMass(body: BodyId, mass: Mass | null): void {
    if (mass === null) {
      this.onBody("api_body_weigh", body);
      return;
    }
    checkNames("setMass", mass, MASS);
    const { center = [0, 0] } = mass;
    try {
      this.onBody("api_body_set_mass", body, mass.mass, mass.inertia, center?.[0], center?.[1]);
    } catch (refused) {
      throw blame(refused, "setMass", mass, MASS_RANGES, this.lengthScale);
    }
  }
}
