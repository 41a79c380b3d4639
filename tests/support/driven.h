/* driven.h: which directions each kind of joint can drive. Tests that draw joints at random use it:
 * a limit, spring or motor in any other direction is refused. */
#ifndef DRIVEN_H
#define DRIVEN_H

#include <thud/thud_joint.h>

static inline bool is_driven(thud_joint_kind kind, int direction) {
    enum {
        ALONG = 1 << THUD_DIRECTION_ALONG,
        ACROSS = 1 << THUD_DIRECTION_ACROSS,
        TURN = 1 << THUD_DIRECTION_TURN
    };
    static const unsigned driven[THUD_JOINT_KIND_COUNT] = {
        [THUD_JOINT_DISTANCE] = ALONG,     [THUD_JOINT_HINGE] = TURN,
        [THUD_JOINT_SLIDER] = ALONG,       [THUD_JOINT_WELD] = ALONG | ACROSS | TURN,
        [THUD_JOINT_WHEEL] = ALONG | TURN, [THUD_JOINT_TARGET] = ALONG | ACROSS | TURN,
    };
    return driven[kind] >> direction & 1u;
}

#endif
