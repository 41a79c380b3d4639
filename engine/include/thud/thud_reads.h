/* thud_reads.h: getters of single values of bodies and shapes (thud_body_get_state and
 * thud_shape_get_state get all values), of the settings of steps, and of counts of the broadphase.
 * The getters change nothing, and are allowed inside callbacks; edits made inside a callback are
 * not visible before the next step.
 *
 * Outputs may be null. THUD_ERROR_NULL for a null world, THUD_ERROR_STALE; outputs are then not
 * written. */
#ifndef THUD_READS_H
#define THUD_READS_H

#include "thud.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The position of the body's origin. */
THUD_API thud_result thud_body_get_position(const thud_world *world, thud_body_id body,
                                            thud_pos *out_position);
/* The body's angle, rad, in (-pi, pi], and its cosine and sine. */
THUD_API thud_result thud_body_get_rotation(const thud_world *world, thud_body_id body,
                                            double *out_angle, float *out_cosine, float *out_sine);
/* The velocity of the centre of mass, length/s, and the angular velocity, rad/s. */
THUD_API thud_result thud_body_get_velocity(const thud_world *world, thud_body_id body,
                                            thud_vec2 *out_velocity, float *out_angular_velocity);
/* The caller's own data of a body (thud_body_def.user_data). */
THUD_API thud_result thud_body_get_user_data(const thud_world *world, thud_body_id body,
                                             uint64_t *out_user_data);
/* The caller's own data of a shape (thud_shape_def.user_data). */
THUD_API thud_result thud_shape_get_user_data(const thud_world *world, thud_shape_id shape,
                                              uint64_t *out_user_data);
/* The body to which a shape belongs. */
THUD_API thud_result thud_shape_get_body(const thud_world *world, thud_shape_id shape,
                                         thud_body_id *out_body);

/* The position of the origin as a return value, for use in expressions; (0, 0) if the handle is
 * not valid. */
static inline thud_pos thud_position_of(const thud_world *world, thud_body_id body) {
    thud_pos position = {0.0, 0.0};
    thud_body_get_position(world, body, &position);
    return position;
}

/* The velocity of the centre of mass, length/s, likewise. */
static inline thud_vec2 thud_velocity_of(const thud_world *world, thud_body_id body) {
    thud_vec2 velocity = {0.0f, 0.0f};
    thud_body_get_velocity(world, body, &velocity, NULL);
    return velocity;
}

/* The settings of the next step. */
typedef struct thud_step_settings {
    thud_vec2 gravity; /* length/s^2 */
    double time_step;  /* s */
    double max_error;  /* length; 0: none */
    int substeps;      /* fewer than the quality's if a time budget has reduced them */
    bool sleeping;
    thud_quality quality; /* the world's copy, with the values that its def overrides */
} thud_step_settings;

/* The settings with which the next step will run. THUD_ERROR_NULL. */
THUD_API thud_result thud_world_get_step_settings(const thud_world *world, thud_step_settings *out);

/* Counts of the broadphase's work in the last step. They do not depend on the machine, the clock or
 * the number of workers. Each shape whose bounds moved is tested against others; of n shapes there
 * are n (n - 1) / 2 pairs, all of which thud_broadphase_all tests if more than half of the shapes
 * have moved. After thud_world_restore all counts are 0 until the next step, and those of this step
 * may differ from the saved world's if a query ran between two steps. */
typedef struct thud_broadphase_counts {
    int moved;           /* shapes that are new or whose bounds moved: those that are tested against
                            others */
    int64_t tested;      /* pairs of bounds that were compared */
    int64_t found;       /* pairs of bounds that overlap */
    int64_t sort_moves;  /* plane sweeps: keys that insertion sort moved past another key since the
                            broadphase of the step before; for a nearly sorted list, the number of
                            its inversions (pairs in the wrong order) */
    int cells;           /* grid: cells with shapes of awake bodies, as the grid was last built */
    int cell_shapes;     /* grid: the shapes in these cells; divided by `cells`, the mean of a
                            cell */
    int cell_shapes_max; /* grid: the maximum in a cell */
} thud_broadphase_counts;

/* The call counts the cells, in time proportional to their number. THUD_ERROR_NULL; *out is then
 * not written. */
THUD_API thud_result thud_world_get_broadphase_counts(const thud_world *world,
                                                      thud_broadphase_counts *out);

#ifdef __cplusplus
}
#endif

#endif
