/* misuse.h: calls with an invalid argument that all engines have an equivalent of. */
#ifndef THUD_ADAPTERS_MISUSE_H
#define THUD_ADAPTERS_MISUSE_H

typedef enum misuse {
    MISUSE_POSITION = 0, /* sets a body's position to the value, both coordinates */
    MISUSE_ANGLE,
    MISUSE_VELOCITY,
    MISUSE_SPIN,
    MISUSE_FORCE,
    MISUSE_TORQUE,
    MISUSE_IMPULSE,
    MISUSE_IMPULSE_POINT,
    MISUSE_NEW_BODY, /* creates a body at that position */
    MISUSE_RADIUS,   /* creates a circle with this radius on a body */
    MISUSE_DENSITY,  /* creates a circle with this density */
    MISUSE_FRICTION, /* creates a circle with this friction */
    MISUSE_GRAVITY,
    MISUSE_TIME_STEP,
    MISUSE_RAY,    /* casts a ray from that position */
    MISUSE_GONE,   /* sets the velocity of a destroyed body; the value is not used */
    MISUSE_NOBODY, /* sets the velocity through the null handle */
} misuse;

#endif
