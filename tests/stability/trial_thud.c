/* trial_thud.c: thud at each of its qualities. */
#include "build_thud.h"
#include "read_thud.h"
#include "trial_engine.h"

#include <math.h>
#include <stdlib.h>

static const thud_quality *const QUALITIES[] = {
    [ENTRANT_DRAFT] = &thud_quality_draft,
    [ENTRANT_DEFAULT] = &thud_quality_default,
    [ENTRANT_HIGH] = &thud_quality_high,
    [ENTRANT_EXACT] = &thud_quality_exact,
};

typedef struct thud_trial {
    thud_world *world;
    int body_count;
    thud_body_id bodies[];
} thud_trial;

static void *create(const ledger *l, entrant e, const scene *s, const trial_settings *settings) {
    thud_trial *own = calloc(1, sizeof *own + (size_t)s->body_count * sizeof own->bodies[0]);
    if (!own)
        return NULL;
    thud_world_def def = thud_default_world_def();
    def.quality = QUALITIES[e];
    def.time_step = settings->time_step;
    def.sleeping = false;
    def.baseline_simd = l->baseline_simd;
    if (settings->every_bounce)
        def.restitution_threshold = 0;
    def.log = print_thud_log;
    if (scene_build_thud(s, &def, &own->world, own->bodies, NULL) != THUD_OK) {
        free(own);
        return NULL;
    }
    own->body_count = s->body_count;
    return own;
}

static void destroy(void *state) {
    thud_trial *own = state;
    thud_world_destroy(own->world);
    free(own);
}

static bool step(void *state) {
    thud_trial *own = state;
    return thud_world_step(own->world) == THUD_OK;
}

static bool set_time_step(void *state, double seconds) {
    thud_trial *own = state;
    return thud_world_set_time_step(own->world, seconds) == THUD_OK;
}

static void read_bodies(void *state, contender_body *bodies) {
    thud_trial *own = state;
    read_thud(own->world, own->bodies, own->body_count, bodies);
}

static void read_pose(void *state, int body, thud_pos origin, thud_pose *out) {
    thud_trial *own = state;
    int count;
    const thud_pose *poses = thud_world_poses(own->world, origin, 1, &count);
    uint32_t slot = own->bodies[body].index1 - 1;
    *out = poses && slot < (uint32_t)count ? poses[slot] : (thud_pose){NAN, NAN, NAN, NAN};
}

static bool renew(void *state, const scene *s, int body) {
    thud_trial *own = state;
    const scene_body *from = &s->bodies[body];
    const scene_shape *circle = &s->shapes[from->first_shape];
    thud_body_def def = thud_default_body_def();
    thud_shape_def shape = thud_default_shape_def();
    def.kind = THUD_DYNAMIC;
    def.position = (thud_pos){from->x, from->y};
    return thud_body_destroy(own->world, own->bodies[body]) == THUD_OK &&
           thud_body_create(own->world, &def, &own->bodies[body]) == THUD_OK &&
           thud_shape_create_circle(own->world, own->bodies[body], &shape, (thud_vec2){0, 0},
                                    (float)circle->hx, NULL) == THUD_OK;
}

static bool misuse_body(void *state, int body, misuse call, double value) {
    thud_trial *own = state;
    return misuse_thud(own->world, own->bodies[body], call, value);
}

static uint64_t bytes(void *state) {
    thud_trial *own = state;
    return thud_world_stats(own->world).bytes;
}

static uint64_t allocations(void *state) {
    thud_trial *own = state;
    return thud_world_stats(own->world).step_allocations;
}

const trial_engine TRIAL_THUD = {
    .create = create,
    .destroy = destroy,
    .step = step,
    .set_time_step = set_time_step,
    .read = read_bodies,
    .pose = read_pose,
    .renew = renew,
    .misuse = misuse_body,
    .bytes = bytes,
    .allocations = allocations,
};
