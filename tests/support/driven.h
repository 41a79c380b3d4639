/* driven.h: which directions each kind of joint can drive. Tests that draw joints at random use it:
 * a limit, spring or motor in any other direction is refused. */
#ifndef DRIVEN_H
#define DRIVEN_H

#include <thud/thud_joint.h>

static inline bool is_driven(thud_joint_kind kind, int direction) {
    enum { ALONG = 1 << THUD_ALONG, ACROSS = 1 << THUD_ACROSS, TURN = 1 << THUD_TURN };
    static const unsigned driven[THUD_JOINT_KIND_COUNT] = {
        [THUD_DISTANCE] = ALONG,     [THUD_HINGE] = TURN,
        [THUD_SLIDER] = ALONG,       [THUD_WELD] = ALONG | ACROSS | TURN,
        [THUD_WHEEL] = ALONG | TURN, [THUD_TARGET] = ALONG | ACROSS | TURN,
    };
    return driven[kind] >> direction & 1u;
}

#endif
