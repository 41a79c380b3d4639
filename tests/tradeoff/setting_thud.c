/* setting_thud.c: thud at each of its qualities, everything else at its defaults; with the soft solver
 * alone at more substeps; and at the default quality with swept detection, which is what to choose where
 * all that matters is impacts. */
#include "build_thud.h"
#include "setting.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct own_world {
    thud_world *world;
    int body_count;
    thud_body_id bodies[];
} own_world;

static void print_log(thud_result result, const char *message, void *context) {
    (void)context;
    fprintf(stderr, "thud: %s (%s)\n", message, thud_result_text(result));
}

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
    def.log = print_log;
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
    for (int i = 0; i < own->body_count; i++) {
        thud_body_state body;
        if (thud_body_get(own->world, own->bodies[i], &body) != THUD_OK) {
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

static const setting_engine ENGINE = {"thud", create, destroy, step, read_bodies};

/* The soft solver alone, as it would be at more substeps: beside Box2D's, which is soft at all of its. */
static const thud_quality SOFT_4 = {.name = "soft 4",
                                    .substeps = 4,
                                    .contact_stiffness = 0.16f,
                                    .contact_damping = 10.0f,
                                    .detection = &thud_detection_continuous,
                                    .island_limit = 1};
static const thud_quality SOFT_8 = {.name = "soft 8",
                                    .substeps = 8,
                                    .contact_stiffness = 0.16f,
                                    .contact_damping = 10.0f,
                                    .detection = &thud_detection_continuous,
                                    .island_limit = 1};
static const thud_quality SOFT_16 = {.name = "soft 16",
                                     .substeps = 16,
                                     .contact_stiffness = 0.16f,
                                     .contact_damping = 10.0f,
                                     .detection = &thud_detection_continuous,
                                     .island_limit = 1};

const setting SETTINGS_THUD[] = {
    {.engine = &ENGINE, .name = "draft", .curve = "thud", .quality = &thud_quality_draft},
    {.engine = &ENGINE, .name = "default", .curve = "thud", .quality = &thud_quality_default},
    {.engine = &ENGINE, .name = "high", .curve = "thud", .quality = &thud_quality_high},
    {.engine = &ENGINE, .name = "exact", .curve = "thud", .quality = &thud_quality_exact},
    {.engine = &ENGINE, .name = "soft 4", .curve = "thud soft", .quality = &SOFT_4},
    {.engine = &ENGINE, .name = "soft 8", .curve = "thud soft", .quality = &SOFT_8},
    {.engine = &ENGINE, .name = "soft 16", .curve = "thud soft", .quality = &SOFT_16},
    {.engine = &ENGINE,
     .name = "default swept",
     .curve = "thud swept",
     .quality = &thud_quality_default,
     .detection = &thud_detection_swept},
};
const int SETTINGS_THUD_COUNT = sizeof SETTINGS_THUD / sizeof SETTINGS_THUD[0];
