/**
 * The layer of World with collision rules between kinds of shapes, listeners of contacts, and the
 * pair filter. thud_rules.h and thud_listeners.h describe them in full.
 */
import { ImpulseEventAt, ListAt, RULE_OPTIONS, RuleFoundAt, RuleOptionsAt } from "../generated/slots.js";
import { checkOptions } from "../checks/names.js";
import { fill, indexOf, numbersOf, rowsOf, shapeAt, vecAt } from "../numbers.js";
import { index1Of, Kind } from "../plain/handles.js";
import type { BodyRef } from "../types.js";
import { WorldFields } from "../world-fields.js";
import {
  type ContactResponse,
  type ImpulseEvent,
  type Listeners,
  type ObjectListener,
  type PairFilter,
  type Rule,
  RULE_KINDS,
  type RuleFound,
} from "./rule-types.js";

/**
 * The options of setListeners, and the parts of a row in the order of the bits of
 * thud_contact_part.
 */
const LISTENERS = ["prologue", "epilogue", "without"] as const;
const CONTACT_PARTS = ["bodies", "point"] as const;
/** The options of decide, and those of each side. */
const SIDES = ["a", "b"] as const;
const VELOCITIES = ["velocity", "angularVelocity"] as const;

/** See the head of this file. */
export class WorldRules extends WorldFields {
  /**
   * Sets the rule between each kind of `first` and each of `second` (category bits, at least one
   * each), from the next step on. It replaces the rules that these kinds had; null removes them.
   * @throws {ThudError} "invalid" for a value out of range, or a one-way rule of a kind with
   * itself; "memory"; "locked" inside a callback.
   * @example world.setRule(PLANK, PLAYER, { kind: "oneWay" })
   */
  setRule(first: number, second: number, rule: Rule | null): void {
    const { exports, slots, callbacks } = this.engine;
    const numbers = rule === null ? [] : numbersOf("setRule", rule, RULE_OPTIONS);
    exports.api_rule_defaults();
    fill(slots, numbers);
    const result = exports.api_world_set_rule(this.address, first, second, Number(rule !== null));
    if (result !== 0 || callbacks.hasThrown) this.refuse(result, "setRule", rule ?? {});
  }

  /**
   * The rule of two kinds, one category bit each; null where there is none.
   * @throws {ThudError} "invalid" for a number that is not one bit.
   */
  rule(first: number, second: number): RuleFound | null {
    const { exports, slots: s } = this.engine;
    this.engine.check(exports.api_world_rule(this.address, first, second));
    if (!s[RuleFoundAt.isSet]) return null;
    return {
      kind: RULE_KINDS[s[RuleOptionsAt.kind]],
      solidSide: vecAt(s, RuleOptionsAt.solidSide),
      friction: given(s[RuleOptionsAt.friction]),
      restitution: given(s[RuleOptionsAt.restitution]),
      surfaceSpeed: given(s[RuleOptionsAt.surfaceSpeed]),
      eventImpulse: given(s[RuleOptionsAt.eventImpulse]),
      reversed: s[RuleFoundAt.reversed] !== 0,
    };
  }

  /**
   * Prepares a world that never had a rule for `restore` from a snapshot with rules, which it would
   * refuse otherwise.
   * @throws {ThudError} "memory"; "locked" inside a callback.
   */
  useRules(): void {
    this.engine.check(this.engine.exports.api_world_use_rules(this.address));
  }

  /**
   * The contacts of the last step, or of all steps of the last `advance`, whose impulse was larger
   * than their rule's `eventImpulse`. A copy.
   * @example for (const { a } of world.impulseEvents()) world.destroy(a)
   */
  impulseEvents(): ImpulseEvent[] {
    this.onWorld("api_world_impulse_events");
    const { buffer, slots } = this.engine;
    return rowsOf(Float64Array, buffer, slots, ListAt.address, ImpulseEventAt.length, readImpulse);
  }

  /**
   * The same contacts as rows (IMPULSE_ROW): a view into wasm memory, valid until the next call of
   * the engine.
   */
  impulseEventView(): Float64Array {
    this.onWorld("api_world_impulse_events");
    const { buffer, slots: s } = this.engine;
    const count = s[ListAt.count] * ImpulseEventAt.length;
    return new Float64Array(buffer, count === 0 ? 0 : s[ListAt.address], count);
  }

  /**
   * Sets the callbacks before and after contacts are solved, each called once a step for all
   * contacts, as rows. For fixed behaviour of kinds of shapes `setRule` needs no calls. Null
   * removes them.
   *
   * Inside the callbacks edits wait for the next step, or throw "locked".
   * @throws {ThudError} "invalid" for an unknown option or part; "memory"; "locked" inside a
   * callback.
   * @example world.setListeners({ prologue: (rows, count) => veto(rows, count) })
   */
  setListeners(listeners: Listeners | null): void {
    const { prologue, epilogue, without = [] } = listeners ?? {};
    checkOptions("listeners", listeners ?? {}, LISTENERS);
    const { exports, callbacks } = this.engine;
    const [asks, tells] = [prologue, epilogue].map((listener) => Number(listener !== undefined));
    const parts = without.reduce((bits, part) => bits | (1 << indexOf(CONTACT_PARTS, part, "part")), 0);
    this.engine.check(exports.api_world_set_listeners(this.address, asks, tells, parts));
    callbacks.set(this.address, { prologue, epilogue });
  }

  /**
   * Sets the epilogue of a body of any kind, called for each of its contacts that the epilogue of
   * the world is told of, after it. It replaces the one that the body had; null removes it. It goes
   * with the body when that is destroyed, and is not part of a snapshot. A sensor has no contacts:
   * `events` tells of it.
   * @throws {ThudError} "stale"; "memory"; "locked" inside a callback.
   * @example world.setBodyEpilogue(ball, (row) => play(row[LISTENED_ROW.normalImpulse]))
   */
  setBodyEpilogue(body: BodyRef, epilogue: ObjectListener | null): void {
    this.on(Kind.body, "api_body_set_epilogue", body, Number(epilogue !== null));
    const index1 = index1Of(body, Kind.body);
    this.engine.callbacks.setObject(this.address, "bodies", index1, epilogue);
  }

  /**
   * Sets the epilogue of all shapes of one of these categories (bits, at least one), called for each
   * of their contacts, after that of the world and of the body. It replaces the one of exactly these
   * categories; null removes it. Not part of a snapshot.
   * @throws {ThudError} "invalid" for no category; "memory"; "locked" inside a callback.
   */
  setCategoryEpilogue(categories: number, epilogue: ObjectListener | null): void {
    this.onWorld("api_world_set_category_epilogue", categories, Number(epilogue !== null));
    this.engine.callbacks.setObject(this.address, "categories", categories >>> 0, epilogue);
  }

  /**
   * Inside a prologue: decides the velocities after the collision of the contact in this row (0 is
   * the first), in place of friction and restitution: a kicker, a bat, a portal that turns the
   * velocity. The pair has no other effect in the step, as if it were vetoed, and the epilogues are
   * told of it; gravity and other contacts act as on any velocity. A collision that "continuous"
   * finds stops the body first, and the next step asks again. thud_listeners.h has the details;
   * `stepError().energyDecided` has the energy.
   * @throws {ThudError} "invalid" where no prologue is asked about this row, for a body that is not
   * dynamic, and for numbers that are not finite; "null" for neither a nor b; "memory".
   * @example world.setListeners({ prologue: () => world.decide(0, { b: { velocity: [0, 12] } }) })
   */
  decide(row: number, response: ContactResponse): void {
    checkOptions("decide", response, SIDES);
    const numbers: number[] = [];
    let sides = 0;
    SIDES.forEach((name, i) => {
      const side = response[name];
      if (side !== undefined) checkOptions("decide", side, VELOCITIES);
      if (side !== undefined) sides |= 1 << i;
      numbers.push(side?.velocity?.[0] ?? NaN, side?.velocity?.[1] ?? NaN, side?.angularVelocity ?? 0);
    });
    const at = Number.isInteger(row) ? row : -1;
    this.engine.check(this.engine.exports.api_contact_decide(this.address, at, sides, ...numbers));
  }

  /**
   * Sets the function that decides whether two shapes may make a pair. It is called when the bounds
   * of two shapes begin to overlap, and for all pairs when it is set. Null removes it.
   * @throws {ThudError} "memory"; "locked" inside a callback.
   */
  setPairFilter(filter: PairFilter | null): void {
    const { exports, callbacks } = this.engine;
    const before = callbacks.of(this.address).filter;
    callbacks.set(this.address, { filter: filter ?? undefined }); // api_world_set_filter calls it
    const result = exports.api_world_set_filter(this.address, Number(filter !== null));
    if (result !== 0) callbacks.set(this.address, { filter: before });
    this.engine.check(result);
  }
}

/** A value of a rule; undefined where it was not given: the module has NaN, or Infinity, there. */
function given(value: number): number | undefined {
  return Number.isFinite(value) ? value : undefined;
}

function readImpulse(rows: Float64Array, at: number): ImpulseEvent {
  return {
    a: shapeAt(rows, at + ImpulseEventAt.shapeA),
    b: shapeAt(rows, at + ImpulseEventAt.shapeB),
    point: vecAt(rows, at + ImpulseEventAt.point),
    normal: vecAt(rows, at + ImpulseEventAt.normal),
    impulse: rows[at + ImpulseEventAt.impulse],
  };
}
