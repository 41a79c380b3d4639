/**
 * What two kinds of shapes are to each other, and who is asked and told of contacts. thud_rules.h
 * and thud_listeners.h say all of it.
 */
import { ImpulseEventAt, ListAt, RULE_OPTIONS, RuleFoundAt, RuleOptionsAt } from "../generated/slots.js";
import { checkNames } from "../checks/names.js";
import { fill, indexOf, numbersOf, rowsOf, shapeAt, vecAt } from "../numbers.js";
import { WorldFields } from "../world-fields.js";
import {
  type ImpulseEvent,
  type Listeners,
  MEETINGS,
  type PairFilter,
  type Rule,
  type RuleFound,
} from "./rule-types.js";

const LISTENERS = ["prologue", "epilogue", "without"] as const;
const CONTACT_PARTS = ["bodies", "point"] as const;

export class WorldRules extends WorldFields {
  /**
   * The rule between kinds of shapes, bits of `category`, from the next step on; null takes it away.
   * @example world.setRule(PLANK, PLAYER, { meeting: "oneWay" })
   */
  setRule(first: number, second: number, rule: Rule | null): void {
    const { exports, slots, callbacks } = this.engine;
    const numbers = rule === null ? [] : numbersOf("setRule", rule, RULE_OPTIONS);
    exports.api_rule_defaults();
    fill(slots, numbers);
    const result = exports.api_world_set_rule(this.address, first, second, Number(rule !== null));
    if (result !== 0 || callbacks.hasThrown) this.refuse(result, "setRule", rule ?? {});
  }

  /** The rule of two kinds, one bit each; null where there is none. */
  rule(first: number, second: number): RuleFound | null {
    const { exports, slots: s } = this.engine;
    this.engine.check(exports.api_world_rule(this.address, first, second));
    if (!s[RuleFoundAt.isSet]) return null;
    return {
      meeting: MEETINGS[s[RuleOptionsAt.meeting]],
      solidSide: vecAt(s, RuleOptionsAt.solidSide),
      friction: given(s[RuleOptionsAt.friction]),
      restitution: given(s[RuleOptionsAt.restitution]),
      surfaceSpeed: given(s[RuleOptionsAt.surfaceSpeed]),
      mostImpulse: given(s[RuleOptionsAt.mostImpulse]),
      reversed: s[RuleFoundAt.reversed] !== 0,
    };
  }

  /** Makes a world that never had a rule ready to be restored from a snapshot that has some. */
  useRules(): void {
    this.engine.check(this.engine.exports.api_world_use_rules(this.address));
  }

  /**
   * The contacts that gave more in the last step than their rule's `mostImpulse`; copied.
   * @example for (const { a } of world.impulses()) world.destroy(a)
   */
  impulses(): ImpulseEvent[] {
    this.onWorld("api_world_impulses");
    const { buffer, slots } = this.engine;
    return rowsOf(Float64Array, buffer, slots, ListAt.address, ImpulseEventAt.length, readImpulse);
  }

  /** The same without copies: rows as IMPULSE_ROW has them, valid until the next call. */
  impulseView(): Float64Array {
    this.onWorld("api_world_impulses");
    const { buffer, slots: s } = this.engine;
    const count = s[ListAt.count] * ImpulseEventAt.length;
    return new Float64Array(buffer, count === 0 ? 0 : s[ListAt.address], count);
  }

  /**
   * Asked before contacts are solved, and told after: once a step for all of them, as rows. What
   * most prologues are for, `setRule` does without a call. Null: nobody listens.
   * @example world.setListeners({ prologue: (rows, count) => veto(rows, count) })
   */
  setListeners(listeners: Listeners | null): void {
    const { prologue, epilogue, without = [] } = listeners ?? {};
    checkNames("listeners", listeners ?? {}, LISTENERS);
    const { exports, callbacks } = this.engine;
    const [asks, tells] = [prologue, epilogue].map((listener) => Number(listener !== undefined));
    const parts = without.reduce((bits, part) => bits | (1 << indexOf(CONTACT_PARTS, part, "part")), 0);
    this.engine.check(exports.api_world_set_listeners(this.address, asks, tells, parts));
    callbacks.set(this.address, { prologue, epilogue });
  }

  /**
   * Asked of two shapes whose bounds come to overlap: false keeps them apart, as their filters
   * might. To have all asked anew, set it again. Null: none.
   */
  setPairFilter(filter: PairFilter | null): void {
    const { exports, callbacks } = this.engine;
    const before = callbacks.of(this.address).filter;
    callbacks.set(this.address, { filter: filter ?? undefined }); // what touches is asked at once
    const result = exports.api_world_set_filter(this.address, Number(filter !== null));
    if (result !== 0) callbacks.set(this.address, { filter: before });
    this.engine.check(result);
  }
}

/** Not-a-number, and for an impulse infinite, is what was not given. */
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
