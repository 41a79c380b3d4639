/* awake_arrays.h: the list of the arrays that have an element for each awake body (structure of
 * arrays).
 *
 * A line of this list is all that declares an array: its field in thud_world, its stride, growth,
 * copying from slot to slot, freeing and its part of snapshots follow from it. The first value of
 * an element is set in td_awake_add, or in td_awake_refresh where it follows from the body; until
 * then a slot has the values of the body that had it before. A value that must survive while the
 * body sleeps also needs a field in td_body that td_awake_remove sets, as `direct_steps` has. */
#ifndef TD_AWAKE_ARRAYS_H
#define TD_AWAKE_ARRAYS_H

#include "base/indices.h"

/* The third column of the list. */
enum {
    TD_REBUILT = 0, /* each step writes it before it reads it: not in snapshots */
    TD_STATE = 1    /* later steps depend on it: in snapshots */
};

/* Name, element, and whether it is state. */
#define TD_AWAKE_ARRAYS(X)                                                                        \
    X(velocity, float[4], TD_STATE) /* x, y, turn; inverse mass */                                \
    X(delta, float[4], TD_STATE)    /* motion of the last step: x, y, angle; 0 between steps */   \
    X(start, float[4], TD_REBUILT)  /* velocity at the start of a substep, damped */              \
    X(substep_gain, float[4], TD_STATE) /* velocity that forces add in a substep */               \
    X(damping, float[2], TD_STATE)      /* linear, angular */                                     \
    X(idle, float, TD_STATE)            /* time at rest, s */                                     \
    X(direct_steps, uint8_t,                                                                      \
      TD_STATE) /* number of further steps for which the direct solver solves its island          \
                   (TD_DIRECT_STEPS), or of its cooldown */                                       \
    X(slow_steps, uint16_t, TD_STATE) /* two counts of slow steps of its island: TD_SLOW_STEPS */ \
    X(reach, float[2], TD_STATE)      /* td_body.min_extent and .max_extent */                    \
    X(mass, float, TD_STATE)                                                                      \
    X(inertia, float, TD_STATE)                                                                   \
    X(gravity_mass, float, TD_STATE)    /* mass times gravity scale */                            \
    X(body_of, td_body_index, TD_STATE) /* its count is the number of slots in use */             \
    X(lone, int, TD_STATE) /* the body's only shape, if it is centred; else TD_NONE */            \
    X(colours, td_colours, TD_STATE)

/* Numbers of the arrays in thud_world.awake: TD_AWAKE_velocity and so on. */
#define TD_AWAKE_NUMBER(name, element, is_state) TD_AWAKE_##name,
enum { TD_AWAKE_ARRAYS(TD_AWAKE_NUMBER) TD_AWAKE_ARRAY_COUNT };

/* The arrays by name, in the order of their numbers. */
#define TD_AWAKE_FIELD(name, element, is_state) td_array name;

#endif
