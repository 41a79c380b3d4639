/* motion.h: the wide passes over awake bodies: velocities, positions, and the end of the step. */
#ifndef TD_MOTION_H
#define TD_MOTION_H

#include "constraint/block.h"

typedef struct td_motion_context {
    float (*velocity)[4], (*delta)[4], (*start)[4];
    const float (*push)[4];    /* velocity that gravity and forces give in a substep */
    const float (*damping)[2]; /* null where no body is damped */
    int count;                 /* awake slots, the dummy included */
    float h;                   /* of a substep */
    float max_speed;           /* length/s */
} td_motion_context;

/* First substep: v += push. Later ones also add what the contacts gave in the substep before: with
 * anchors fixed over the step that is exactly a warm start, at the price of two vector operations a
 * body instead of a pass over the contacts. */
typedef void td_integrate_velocity_fn(const td_motion_context *context, bool first);
typedef void td_integrate_position_fn(const td_motion_context *context);
struct thud_world;

/* wide_finalize.c: the end of the step; fills scratch.odd, scratch.fast and the moved list, and
 * sums up energies. */
typedef void td_finalize_bodies_fn(struct thud_world *world);

/* Kinetic energy of all awake bodies, to the bit as td_finalize_bodies sums it up. */
typedef double td_kinetic_energy_fn(const struct thud_world *world);

#endif
