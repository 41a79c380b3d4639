/* misuse.h: wrong calls that every engine's API has a place for. */
#ifndef THUD_ADAPTERS_MISUSE_H
#define THUD_ADAPTERS_MISUSE_H

typedef enum misuse {
    MISUSE_POSITION = 0, /* a body is put there, both coordinates */
    MISUSE_ANGLE,
    MISUSE_VELOCITY,
    MISUSE_SPIN,
    MISUSE_FORCE,
    MISUSE_TORQUE,
    MISUSE_IMPULSE,
    MISUSE_IMPULSE_POINT,
    MISUSE_NEW_BODY, /* at that place */
    MISUSE_RADIUS,   /* of a circle given to a body */
    MISUSE_DENSITY,  /* of another one */
    MISUSE_FRICTION, /* likewise */
    MISUSE_GRAVITY,
    MISUSE_TIME_STEP,
    MISUSE_RAY,    /* from that place */
    MISUSE_GONE,   /* a velocity for a body that was destroyed; the value does not matter */
    MISUSE_NOBODY, /* ... for the null handle */
} misuse;

#endif
