/* thud_reads.h: single values of bodies and shapes, for who wants one and not all of thud_body_get
 * or thud_shape_get; and what a world's steps go by. Each costs a look at the handle and a copy.
 * They change nothing, and may be called inside callbacks: what waits for the next step is not
 * told.
 *
 * Outputs may be null. THUD_ERROR_NULL for a null world, THUD_ERROR_STALE; outputs are then as they
 * were. */
#ifndef THUD_READS_H
#define THUD_READS_H

#include "thud.h"

#ifdef __cplusplus
extern "C" {
#endif

THUD_API thud_result thud_body_position(const thud_world *world, thud_body_id body,
                                        thud_pos *position); /* of its origin */
THUD_API thud_result thud_body_rotation(const thud_world *world, thud_body_id body, double *angle,
                                        float *cosine, float *sine); /* angle in (-pi, pi] */
THUD_API thud_result thud_body_velocity(const thud_world *world, thud_body_id body,
                                        thud_vec2 *velocity, /* of the centre of mass */
                                        float *angular_velocity);
THUD_API thud_result thud_body_user_data(const thud_world *world, thud_body_id body,
                                         uint64_t *user_data);
THUD_API thud_result thud_shape_user_data(const thud_world *world, thud_shape_id shape,
                                          uint64_t *user_data);
THUD_API thud_result thud_shape_body(const thud_world *world, thud_shape_id shape,
                                     thud_body_id *body);

/* The same as values, for expressions: of the origin and of the centre of mass, (0, 0) where the
 * handle names nothing. */
static inline thud_pos thud_position_of(const thud_world *world, thud_body_id body) {
    thud_pos position = {0.0, 0.0};
    thud_body_position(world, body, &position);
    return position;
}

static inline thud_vec2 thud_velocity_of(const thud_world *world, thud_body_id body) {
    thud_vec2 velocity = {0.0f, 0.0f};
    thud_body_velocity(world, body, &velocity, NULL);
    return velocity;
}

/* By which the next step is made. */
typedef struct thud_step_settings {
    thud_vec2 gravity; /* length/s^2 */
    double time_step;  /* s */
    double max_error;  /* length; 0: none */
    int substeps;      /* fewer than the quality's where a time budget says so */
    bool sleeping;
    thud_quality quality; /* the world's copy, with what its def itself named */
} thud_step_settings;

THUD_API thud_result thud_world_step_settings(const thud_world *world, thud_step_settings *out);

#ifdef __cplusplus
}
#endif

#endif
