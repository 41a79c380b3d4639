/**
 * The layer of World with forces that depend on a body's shapes, place or motion: explosions, wind,
 * water, rolling resistance, grip and tyres. Explosions and tyres change velocities at once; the
 * others act through the next step, so call them before each step (with `advance`, in
 * `calls.before`). thud_fields.h has the formulas.
 */
import {
  EXPLOSION_OPTIONS,
  ExplosionOptionsAt,
  NumberAt,
  TYRE_OPTIONS,
  WATER_OPTIONS,
} from "./generated/slots.js";
import { checkOptions } from "./checks/names.js";
import { explained } from "./checks/hook.js";
import { fill, filterNumbers, numbersOf, writeOptions, xOf } from "./numbers.js";
import { Kind } from "./plain/handles.js";
import type { Explosion, Tyre, Water, Wind } from "./fields/field-types.js";
import type { BodyRef, Vec2 } from "./types.js";
import { WorldForces } from "./world-forces.js";

const WIND = ["density", "drag", "lift"] as const;
/** Defaults in the order of TYRE_OPTIONS. Options without a default have NaN, which is refused. */
const TYRE = [NaN, NaN, 0, 0, 0, NaN] as const;
const NO_OTHERS: readonly string[] = [];

/** The layer of World with explosions, wind, water, rolling resistance, grip and tyres. */
export class WorldFields extends WorldForces {
  /**
   * Applies impulses to the dynamic bodies around a place, away from it, at once; shapes that
   * others shield get none. Sleeping bodies wake. Returns the number of bodies that got an impulse.
   * @throws {ThudError} "invalid"; "memory".
   * @example world.explode({ center: [0, 1], radius: 2, falloff: 4, impulse: 20 })
   */
  explode(explosion: Explosion): number {
    const { exports, slots } = this.engine;
    const numbers = numbersOf("explode", explosion, EXPLOSION_OPTIONS, ["filter"]);
    const filter = filterNumbers(explosion.filter ?? {});
    exports.api_explosion_defaults();
    fill(slots, numbers);
    fill(slots, filter, ExplosionOptionsAt.filter);
    const result = exports.api_world_explode(this.address);
    if (result !== 0 || this.engine.callbacks.hasThrown) this.refuse(result, "explode", explosion);
    return this.engine.slots[NumberAt.value];
  }

  /**
   * Applies drag and lift of wind at this velocity (length/s) to a dynamic body through the next
   * step. A sleeping body is left alone.
   * @throws {ThudError} "invalid", "stale"; "locked" inside a callback.
   * @example world.applyWind(flag, [8, 0], { drag: 1.2 })
   */
  applyWind(body: BodyRef, velocity: Vec2, wind: Wind = {}): void {
    checkOptions("applyWind", wind, WIND);
    const { density = 1, drag = 1, lift = 1 } = wind;
    this.on(Kind.body, "api_body_apply_wind", body, xOf(velocity, "velocity"), velocity?.[1], density, drag, lift);
  }

  /**
   * Applies buoyancy and drag to the part of a dynamic body below a water line, through the next
   * step. A sleeping body is left alone.
   * @throws {ThudError} "invalid", "stale"; "locked" inside a callback.
   * @example world.applyBuoyancy(boat, { point: [0, 2], density: 3 })
   */
  applyBuoyancy(body: BodyRef, water: Water): void {
    const { exports, slots } = this.engine;
    const numbers = numbersOf("applyBuoyancy", water, WATER_OPTIONS);
    exports.api_water_defaults();
    fill(slots, numbers);
    try {
      this.on(Kind.body, "api_body_apply_buoyancy", body);
    } catch (refused) {
      throw explained(refused, "applyBuoyancy", water, this.lengthScale);
    }
  }

  /**
   * Applies rolling resistance to the circles of a dynamic body, as of a ball on grass, through the
   * next step: a torque of `coefficient` (0 to 10⁶) times radius times normal force. A sleeping
   * body is left alone.
   * @throws {ThudError} "invalid", "stale"; "locked" inside a callback; "memory".
   */
  applyRollingResistance(body: BodyRef, coefficient: number): void {
    this.on(Kind.body, "api_body_apply_rolling_resistance", body, coefficient);
  }

  /**
   * Drives a point of a dynamic body to a speed (length/s) along an axis, through the next step, by
   * a force of at most `maxForce` (mass times length/s², 0 to 10³⁰). Point and axis are in the body's
   * frame; the axis has any length but 0. At speed 0 the force brakes, at another speed it drives.
   * @throws {ThudError} "invalid", "stale"; "locked" inside a callback.
   */
  applyGrip(body: BodyRef, point: Vec2, axis: Vec2, speed: number, maxForce: number): void {
    const [x, y, alongX, alongY] = [xOf(point, "point"), point?.[1], xOf(axis, "axis"), axis?.[1]];
    this.on(Kind.body, "api_body_apply_grip", body, x, y, alongX, alongY, speed, maxForce);
  }

  /**
   * Applies the impulse of a tyre in one step to a dynamic body, at once, for a world that is seen
   * from above: the tyre drives, brakes, and resists motion across its rolling direction, but never
   * reverses a motion. Thrust and brake take their part of its grip first. Returns the speed at
   * which it then slides across its rolling direction, length/s: close to 0 while it grips.
   * @throws {ThudError} "invalid", also where impulses have made the body's velocity infinite;
   * "stale".
   * @example world.applyTyre(car, { at: [1, 0.5], steer: 0.3, thrust: 20, grip: 40 })
   */
  applyTyre(body: BodyRef, tyre: Tyre): number {
    const { slots } = this.engine;
    slots.set(TYRE);
    writeOptions("applyTyre", slots, tyre, TYRE_OPTIONS, NO_OTHERS);
    try {
      this.on(Kind.body, "api_body_apply_tyre", body);
    } catch (refused) {
      throw explained(refused, "applyTyre", tyre);
    }
    return this.engine.slots[NumberAt.value];
  }
}
