/* friction.h: Coulomb's law of friction, once for eight contacts in single precision (the soft
 * solver) and once for one contact in double precision (the direct solver).
 *
 * The tangent impulse acts against the sliding and is at most friction times the normal impulse; a
 * smaller impulse that stops the sliding is enough. `slip` is the speed at which body b slides over
 * body a along the tangent, with its sign, less the surface speed of a belt, before the impulse.
 * Coulomb's ratio does not depend on it; a law that does (Stribeck's, say) would replace
 * td_friction_ratio8 and td_friction_ratio, which must agree. docs/architecture.md names the other
 * places that such a law needs. */
#ifndef TD_FRICTION_H
#define TD_FRICTION_H

#include "base/simd.h"

/* The ratio of tangent to normal impulse while the contact slides. `friction` is the pair's
 * coefficient. */
TD_INLINE_SMALL f8 td_friction_ratio8(f8 friction, f8 slip) {
    (void)slip;
    return friction;
}

TD_INLINE_SMALL double td_friction_ratio(double friction, double slip) {
    (void)slip;
    return friction;
}

/* The bound of the tangent impulse; `normal` is the sum of the contact's normal impulses. */
TD_INLINE_SMALL f8 td_friction_bound8(f8 friction, f8 normal, f8 slip) {
    return td_friction_ratio8(friction, slip) * normal;
}

TD_INLINE_SMALL double td_friction_bound(double friction, double normal, double slip) {
    return td_friction_ratio(friction, slip) * normal;
}

#endif
