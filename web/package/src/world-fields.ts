/**
 * Forces on bodies from what is around them: explosions, wind, water, rolling, tyres.
 * Explosions and tyres push at once, the others through the next step: ask before each. thud_fields.h has the formulas.
 */
import {
  EXPLOSION_OPTIONS,
  ExplosionOptionsAt,
  NumberAt,
  TYRE_OPTIONS,
  WATER_OPTIONS,
} from "./generated/slots.js";
import { checkNames } from "./checks/names.js";
import { explained } from "./checks/hook.js";
import { fill, filterNumbers, numbersOf, writeOptions } from "./numbers.js";
import { Kind } from "./plain/handles.js";
import type { Explosion, Tyre, Water, Wind } from "./fields/field-types.js";
import type { BodyRef, Vec2 } from "./types.js";
import { WorldForces } from "./world-forces.js";

const WIND = ["density", "drag", "lift"] as const;
/** In the order of TYRE_OPTIONS: what has no default is refused. */
const TYRE = [NaN, NaN, 0, 0, 0, NaN] as const;
const NO_OTHERS: readonly string[] = [];

export class WorldFields extends WorldForces {
  /**
   * Pushes the dynamic bodies about a place away from it, at once, but for those that have cover.
   * Returns how many it pushed.
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
   * Pushes a body by the wind through the next step; it is left alone while it sleeps.
   * @example world.applyWind(flag, [8, 0], { drag: 1.2 })
   */
  applyWind(body: BodyRef, velocity: Vec2, wind: Wind = {}): void {
    checkNames("applyWind", wind, WIND);
    const { density = 1, drag = 1, lift = 1 } = wind;
    this.on(Kind.body, "api_body_apply_wind", body, velocity?.[0], velocity?.[1], density, drag, lift);
  }

  /**
   * Lifts and brakes what of a body is below a water line, through the next step.
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

  /** Brakes a ball that rolls as on a slope of `coefficient`, through the next step. */
  applyRollingResistance(body: BodyRef, coefficient: number): void {
    this.on(Kind.body, "api_body_apply_rolling", body, coefficient);
  }

  /**
   * Brings a point of the body to a speed along an axis, both in its frame, through the next step, by
   * a force of at most `most`: at speed 0 it holds or brakes, at another it drives.
   */
  applyGrip(body: BodyRef, point: Vec2, axis: Vec2, speed: number, most: number): void {
    const [x, y, alongX, alongY] = [point?.[0], point?.[1], axis?.[0], axis?.[1]];
    this.on(Kind.body, "api_body_apply_grip", body, x, y, alongX, alongY, speed, most);
  }

  /**
   * Has a tyre push the body at once, for a world that is seen from above: it drives, brakes, and
   * holds across its way, never so hard that the motion turns around. Thrust and brake have the first
   * claim to its grip. Returns how fast it slides across its way then, next to 0 while it holds.
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
