/* setting_thud.c: thud at each of its qualities, everything else at its defaults; with the soft
 * solver alone at more substeps; and at the default quality with swept detection, which is what to
 * choose where all that matters is impacts. */
#include "build_thud.h"
#include "read_thud.h"
#include "setting.h"

#include <stdio.h>
#include <stdlib.h>

typedef struct own_world {
    thud_world *world;
    int body_count;
    thud_body_id bodies[];
} own_world;

static void *create(const scene *s, const setting *how) {
    own_world *own = calloc(1, sizeof *own + (size_t)s->body_count * sizeof own->bodies[0]);
    if (!own) {
        fprintf(stderr, "thud: out of memory\n");
        return NULL;
    }
    thud_world_def def = thud_default_world_def();
    def.time_step = CONTENDER_TIME_STEP;
    def.sleeping = false;
    def.quality = how->quality;
    def.detection = how->detection;
    def.log = print_thud_log;
    thud_result result = scene_build_thud(s, &def, &own->world, own->bodies, NULL);
    if (result != THUD_OK) {
        fprintf(stderr, "thud: scene %s could not be built: %s\n", s->name,
                thud_result_text(result));
        free(own);
        return NULL;
    }
    own->body_count = s->body_count;
    return own;
}

static void destroy(void *state) {
    own_world *own = state;
    if (own)
        thud_world_destroy(own->world);
    free(own);
}

static bool step(void *state) {
    own_world *own = state;
    return thud_world_step(own->world) == THUD_OK;
}

static void read_bodies(void *state, contender_body *bodies) {
    own_world *own = state;
    read_thud(own->world, own->bodies, own->body_count, bodies);
}

static const setting_engine ENGINE = {"thud", create, destroy, step, read_bodies};

/* The soft solver alone, as it would be at more substeps: beside Box2D's, which is soft at all of
 * its. */
#define SOFT(n)                                                                                  \
    {                                                                                            \
        .engine = &ENGINE, .name = "soft " #n, .curve = "thud soft",                             \
        .quality = &(const thud_quality) {                                                       \
            .name = "soft " #n, .substeps = n, .contact_stiffness = 0.16f,                       \
            .contact_damping = 10.0f, .detection = &thud_detection_continuous, .island_limit = 1 \
        }                                                                                        \
    }

const setting SETTINGS_THUD[] = {
    {.engine = &ENGINE, .name = "draft", .curve = "thud", .quality = &thud_quality_draft},
    {.engine = &ENGINE, .name = "default", .curve = "thud", .quality = &thud_quality_default},
    {.engine = &ENGINE, .name = "high", .curve = "thud", .quality = &thud_quality_high},
    {.engine = &ENGINE, .name = "exact", .curve = "thud", .quality = &thud_quality_exact},
    SOFT(4),
    SOFT(8),
    SOFT(16),
    {.engine = &ENGINE,
     .name = "default swept",
     .curve = "thud swept",
     .quality = &thud_quality_default,
     .detection = &thud_detection_swept},
};
const int SETTINGS_THUD_COUNT = sizeof SETTINGS_THUD / sizeof SETTINGS_THUD[0];
