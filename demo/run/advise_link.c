/* advise_link.c: see advise_link.h. The bounds are read from the test when the build is configured
 * (link_sizes.h: LINK_SIZES); what each program has is in its source, tests/web/link. */
#include "advise_link.h"

#include "choices.h"
#include "link_sizes.h"
#include "without.h"

#include <string.h>

enum {
    AABBS = 1,
    OBBS = 2,
    TERRAINS = 4,
    DIRECT = 8,
    JOINTS = 16,
    SENSORS = 32,
    RESTITUTION = 64,
    UNMEASURED = 128
};

static const struct {
    const char *program;
    double kilobytes;
} SIZES[] = {LINK_SIZES};

static const struct {
    const char *program;
    unsigned has;
} PROGRAMS[] = {
    {"circles", 0},
    {"boxes", AABBS},
    {"islands", DIRECT},
    {"joints", JOINTS | DIRECT},
    {"everything", AABBS | OBBS | TERRAINS | DIRECT | SENSORS | RESTITUTION},
};

static unsigned needs_of(const run_options *how, const scene *s) {
    unsigned needs = s->joint_count > 0 ? JOINTS : 0;
    for (int i = 0; i < s->shape_count; i++) {
        needs |= s->shapes[i].sensor ? SENSORS : 0;
        needs |= s->shapes[i].material.restitution > 0 ? RESTITUTION : 0;
        switch (s->shapes[i].kind) {
        case SCENE_CIRCLE:
            break;
        case SCENE_AABB:
            needs |= AABBS;
            break;
        case SCENE_OBB:
            needs |= OBBS;
            break;
        case SCENE_TERRAIN_FLAT:
        case SCENE_TERRAIN_UNIFORM:
        case SCENE_TERRAIN_IRREGULAR:
            needs |= TERRAINS;
            break;
        }
    }
    if (QUALITIES[how->quality]->islands && !(how->without & WITHOUT_DIRECT))
        needs |= DIRECT;
    const thud_detection *detection = DETECTIONS[how->detection].detection;
    if (!detection)
        detection = QUALITIES[how->quality]->detection;
    bool other = detection != &thud_detection_overlap && detection != &thud_detection_continuous;
    /* The small programs test all pairs, which gives the bits of the grid. */
    const thud_broadphase *broadphase = BROADPHASES[how->broadphase].broadphase;
    bool acts = scene_has_fields(s) ||
                (broadphase != &thud_broadphase_grid && broadphase != &thud_broadphase_all);
    for (int i = 0; i < s->body_count; i++)
        other |= s->bodies[i].detection != SCENE_AS_WORLD;
    return needs | (other || acts ? UNMEASURED : 0);
}

advise_link advise_link_of(const run_options *how, const scene *s) {
    unsigned needs = needs_of(how, s);
    advise_link least = {0};
    for (size_t i = 0; i < sizeof PROGRAMS / sizeof PROGRAMS[0]; i++)
        for (size_t k = 0; k < sizeof SIZES / sizeof SIZES[0]; k++)
            if ((needs & ~PROGRAMS[i].has) == 0 &&
                strcmp(PROGRAMS[i].program, SIZES[k].program) == 0 &&
                (!least.program || SIZES[k].kilobytes < least.kilobytes))
                least = (advise_link){SIZES[k].program, SIZES[k].kilobytes};
    return least;
}
