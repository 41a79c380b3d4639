/* duel.h: runs the same scene in thud and in Box2D, for tests of results that must agree. Include
 * it after cmocka.h. */
#ifndef THUD_BASELINE_DUEL_H
#define THUD_BASELINE_DUEL_H

#include "engine.h"

#include <math.h>
#include <stdlib.h>

enum { THUD = 0, BOX2D = 1, ENGINES = 2 };

typedef struct duel {
    scene scene;
    const physics_engine *engine[ENGINES];
    void *world[ENGINES];
    engine_body *bodies[ENGINES];  /* states after the last step, in the scene's order */
    engine_events events[ENGINES]; /* sums over all steps so far */
} duel;

/* Call it first, then fill d->scene, then call duel_begin. */
static inline void duel_init(duel *d) {
    *d = (duel){.engine = {&engine_thud, &engine_box2d}};
    scene_init(&d->scene);
}

static inline void duel_begin(duel *d) {
    for (int e = 0; e < ENGINES; e++) {
        d->world[e] = engine_create(d->engine[e], &d->scene, (engine_settings){.events = true});
        assert_non_null(d->world[e]);
        d->bodies[e] = calloc((size_t)d->scene.body_count, sizeof *d->bodies[e]);
        assert_non_null(d->bodies[e]);
        d->engine[e]->read(d->world[e], d->bodies[e]);
    }
}

static inline void duel_step(duel *d, int steps) {
    for (int e = 0; e < ENGINES; e++) {
        for (int i = 0; i < steps; i++) {
            assert_true(d->engine[e]->step(d->world[e]));
            engine_events now = d->engine[e]->events(d->world[e]);
            d->events[e].begin += now.begin;
            d->events[e].end += now.end;
            d->events[e].hit += now.hit;
            d->events[e].sensor_begin += now.sensor_begin;
            d->events[e].sensor_end += now.sensor_end;
        }
        d->engine[e]->read(d->world[e], d->bodies[e]);
    }
}

static inline void duel_end(duel *d) {
    for (int e = 0; e < ENGINES; e++) {
        d->engine[e]->destroy(d->world[e]);
        free(d->bodies[e]);
    }
    scene_free(&d->scene);
}

/* Fails also for NaN. */
#define assert_near(actual, expected, tolerance)                                          \
    do {                                                                                  \
        double actual_ = (actual), expected_ = (expected), tolerance_ = (tolerance);      \
        if (!(fabs(actual_ - expected_) <= tolerance_))                                   \
            fail_msg("%s is %.6g, not within %.3g of %.6g", #actual, actual_, tolerance_, \
                     expected_);                                                          \
    } while (0)

#endif
