/* motion.h: the passes over all awake bodies, eight at a time: integration of velocities and
 * positions in each substep (semi-implicit Euler), and the end of the step. Arrays are by awake
 * slot; slot 0 is a dummy that stands for all static bodies. */
#ifndef TD_MOTION_H
#define TD_MOTION_H

#include "constraint/block.h"

/* Bound of the kinetic energy of one body, and of the work of gravity on it in a step, so that sums
 * over a few such bodies stay finite: 1/34 of the largest float. Chosen; not tuned. */
#define TD_ENERGY_MAX 1e37f

typedef struct td_motion_context {
    float (*velocity)[4];           /* x, y, turn, and the inverse mass */
    float (*delta)[4];              /* motion since the start of the step: x, y, turn */
    float (*start)[4];              /* velocity at the start of the substep */
    const float (*substep_gain)[4]; /* velocity that gravity and forces add in a substep */
    const float (*damping)[2];      /* null where no body is damped */
    int count;                      /* awake slots, with the dummy */
    float h;                        /* length of a substep, s */
    float max_speed;                /* length/s */
} td_motion_context;

/* v = v / (1 + h damping) + gain, where the gain is `substep_gain` in the first substep. In later
 * substeps it is the whole change of velocity in the substep before, forces and constraints
 * together: as anchors are fixed within a step, that is the warm start of all constraints, at the
 * price of two vector operations a body instead of a pass over the constraints. */
typedef void td_integrate_velocity_fn(const td_motion_context *context, bool first);
/* delta += h v */
typedef void td_integrate_position_fn(const td_motion_context *context);
struct thud_world;

/* wide_finalize.c: adds motions to poses, and updates shapes and bounds. Fills scratch.odd,
 * scratch.fast and the list of moved shapes, and sums up energies. */
typedef void td_finalize_bodies_fn(struct thud_world *world);

/* Kinetic energy of all awake bodies, the same to the bit as td_finalize_bodies sums it up. */
typedef double td_kinetic_energy_fn(const struct thud_world *world);

#endif
