/* contender_thud.c: thud at its defaults. */
#include "build_thud.h"
#include "contender.h"
#include "read_thud.h"

#include <stdio.h>
#include <stdlib.h>

typedef struct thud_contender {
    thud_world *world;
    int body_count;
    thud_body_id bodies[];
} thud_contender;

static void *create(const scene *s, contender_settings settings) {
    thud_contender *own = calloc(1, sizeof *own + (size_t)s->body_count * sizeof own->bodies[0]);
    if (!own) {
        fprintf(stderr, "thud: out of memory\n");
        return NULL;
    }
    thud_world_def def = thud_default_world_def();
    def.time_step = CONTENDER_TIME_STEP;
    def.sleeping = settings.sleeping;
    def.contact_events = def.contact_events || settings.events;
    def.log = print_thud_log;
    int refused = -1;
    thud_result result = scene_build_thud(s, &def, &own->world, own->bodies, &refused);
    if (result != THUD_OK) {
        fprintf(stderr, "thud: scene %s could not be built, body %d: %s\n", s->name, refused,
                thud_result_text(result));
        free(own);
        return NULL;
    }
    own->body_count = s->body_count;
    return own;
}

static void destroy(void *state) {
    thud_contender *own = state;
    if (own)
        thud_world_destroy(own->world);
    free(own);
}

static bool step(void *state) {
    thud_contender *own = state;
    return thud_world_step(own->world) == THUD_OK;
}

static void read_bodies(void *state, contender_body *bodies) {
    thud_contender *own = state;
    read_thud(own->world, own->bodies, own->body_count, bodies);
}

static contender_events events(void *state) {
    thud_contender *own = state;
    thud_events e = thud_world_events(own->world);
    return (contender_events){e.begin_count, e.end_count, e.hit_count, e.sensor_begin_count,
                              e.sensor_end_count};
}

static uint64_t bytes(void *state) {
    thud_contender *own = state;
    return thud_world_stats(own->world).bytes;
}

const contender contender_thud = {
    .name = "thud",
    .create = create,
    .destroy = destroy,
    .step = step,
    .read = read_bodies,
    .events = events,
    .bytes = bytes,
};
