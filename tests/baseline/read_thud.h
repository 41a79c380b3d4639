/* read_thud.h: thud's bodies as every comparison reads them. */
#ifndef THUD_BASELINE_READ_THUD_H
#define THUD_BASELINE_READ_THUD_H

#include "contender.h"

#include <math.h>
#include <stdio.h>
#include <thud/thud.h>

/* A world's log hook. */
static inline void print_thud_log(thud_result result, const char *message, void *context) {
    (void)context;
    fprintf(stderr, "thud: %s (%s)\n", message, thud_result_text(result));
}

/* A body that is quarantined is lost, too. */
static inline void read_thud(const thud_world *world, const thud_body_id *ids, int count,
                             contender_body *bodies) {
    for (int i = 0; i < count; i++) {
        thud_body_state body;
        if (thud_body_get(world, ids[i], &body) != THUD_OK || body.quarantined) {
            bodies[i] = (contender_body){.x = NAN, .y = NAN};
            continue;
        }
        bodies[i] = (contender_body){
            .x = body.position.x,
            .y = body.position.y,
            .cosine = body.cosine,
            .sine = body.sine,
            .vx = body.velocity.x,
            .vy = body.velocity.y,
            .angular_velocity = body.angular_velocity,
            .mass = body.mass,
            .inertia = body.inertia,
            .awake = body.awake,
        };
    }
}

#endif
