/* friction.h: Coulomb's law, for eight contacts of the wide passes and for one in double precision.
 *
 * What slides gets an impulse along the tangent against its sliding, of at most the ratio of
 * friction times the impulse along the normal; what less would stop, stops. `slip` is the speed at
 * which b slides over a along the tangent, with its sign, beyond that of a belt, before the
 * impulse: Coulomb's ratio is the same at any, and a rule that goes by the speed would stand here
 * in its place. Both versions say the same. What such a rule touches besides: docs/architecture.md.
 */
#ifndef TD_FRICTION_H
#define TD_FRICTION_H

#include "base/simd.h"

/* The ratio of both impulses while it slides. `friction` is the pair's coefficient. */
TD_INLINE_SMALL f8 td_friction_ratio8(f8 friction, f8 slip) {
    (void)slip;
    return friction;
}

TD_INLINE_SMALL double td_friction_ratio(double friction, double slip) {
    (void)slip;
    return friction;
}

/* The greatest impulse along the tangent beside `normal`, the sum of those along the normal. */
TD_INLINE_SMALL f8 td_friction_bound8(f8 friction, f8 normal, f8 slip) {
    return td_friction_ratio8(friction, slip) * normal;
}

TD_INLINE_SMALL double td_friction_bound(double friction, double normal, double slip) {
    return td_friction_ratio(friction, slip) * normal;
}

#endif
