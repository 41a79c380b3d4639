/* motion.h: the passes over all awake bodies, eight at a time: integration of velocities and
 * positions in each substep, and the end of the step. A body that a constraint acts on moves by
 * semi-implicit Euler. A dynamic body that no constraint acts on (here called free, which is not
 * the same as td_trajectory.free) moves on the exact path of its acceleration and damping
 * (damping.h). Arrays are by awake slot; slot 0 is a dummy that stands for all static bodies. */
#ifndef TD_MOTION_H
#define TD_MOTION_H

#include "base/memory.h"
#include "constraint/block.h"

/* Bound of the kinetic energy of one body, and of the work of gravity on it in a step, so that sums
 * over a few such bodies stay finite: 1/34 of the largest float. Chosen; not tuned. */
#define TD_ENERGY_MAX 1e37f

typedef struct td_motion_context {
    float (*velocity)[4];           /* x, y, turn, and the inverse mass */
    float (*delta)[4];              /* motion since the start of the step: x, y, turn. The fourth
                                       value is 1 for a body that a bounce pass has marked
                                       (td_end_flights_fn), else 0 */
    float (*start)[4];              /* velocity at the start of the substep */
    const float (*substep_gain)[4]; /* velocity that gravity and forces add in a substep */
    const float (*damping)[2];      /* null where no body is damped */
    const uint64_t (*colours)[2];   /* the body's td_colours: none where it is free */
    int count;                      /* awake slots, with the dummy */
    int substeps;
    float h;         /* length of a substep, s */
    float max_speed; /* length/s */
    bool bouncy;     /* a pair has restitution, so that delta may have marks */
} td_motion_context;

/* The velocities of the first substep: the damped velocity plus what gravity and forces add. A free
 * body (see the head of this file) gets its velocity at the end of the whole step at once, and no
 * later pass changes it. Each substep adds this velocity times h to the body's delta, which would
 * be too far. So delta begins with the difference between the body's exact motion in the step and
 * the sum of these products. */
typedef void td_begin_motion_fn(const td_motion_context *context);
/* The velocities of a later substep: adds to each velocity its whole change in the substep before,
 * by forces and by constraints. The change by constraints is what their impulses of that substep
 * would give again, since contact points and anchors are fixed within a step: so this starts all
 * constraints from these impulses (warm start), by two vector operations a body instead of a pass
 * over the constraints. */
typedef void td_integrate_velocity_fn(const td_motion_context *context);
/* delta += h v. */
typedef void td_integrate_position_fn(const td_motion_context *context);
/* After the positions of the last substep: moves a marked body to its exact path if its constraints
 * applied no impulse in this step. The bounce passes mark the bodies of contacts that may bounce.
 * Without this pass, a body that flies up from a bounce would lose energy by semi-implicit Euler
 * for as long as it is near enough to the other shape to have a contact. */
typedef void td_end_flights_fn(const td_motion_context *context);
struct thud_world;

/* Four sums of each kind, which td_total_of adds up. */
typedef struct td_energy_sums {
    d4 kinetic; /* kinetic energy */
    d4 gained;  /* work of gravity in the step */
} td_energy_sums;

/* The arguments and the results of td_finalize_bodies for a part of the awake bodies. */
typedef struct td_finalize_part {
    int first, end; /* awake slots; `first` is a multiple of TD_LANES */
    td_array *odd,
        *fast;       /* td_awake_slot: as in td_scratch; with room for all bodies of the part */
    td_array *moved; /* int: gets the shapes that have left their fat bounds; with room for all
                        shapes of the part */
    td_energy_sums *sums; /* the first eight bodies of the part add their energies here */
    int sums_step;        /* the n-th eight bodies, from 0, add to sums[n * sums_step]; 0: all add
                             to the same */
    bool has_moved;       /* a shape has left its fat bounds */
    int idle, drowsy;     /* bodies of the part: see thud_world.idle_bodies, drowsy_bodies */
} td_finalize_part;

/* wide_finalize.c: adds motions to poses, and updates shapes and bounds. Parts of one world write
 * no common data. */
typedef void td_finalize_bodies_fn(struct thud_world *world, td_finalize_part *part);

/* Kinetic energy of all awake bodies, the same to the bit as td_finalize_bodies sums it up. */
typedef double td_kinetic_energy_fn(const struct thud_world *world);

#endif
