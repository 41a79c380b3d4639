/* engines.c: the list of the engines of this build, and engine_create. */
#include "engine.h"

#include <stdio.h>
#include <string.h>

const physics_engine *const BUILT_ENGINES[] = {
    &engine_thud,
#ifdef THUD_BOX2D_BUILD
    &engine_box2d,
#endif
#ifdef THUD_RAPIER_BUILD
    &engine_rapier,
#endif
#ifdef THUD_CHIPMUNK_BUILD
    &engine_chipmunk,
#endif
};
const int BUILT_ENGINE_COUNT = sizeof BUILT_ENGINES / sizeof BUILT_ENGINES[0];

const physics_engine *engine_find(const char *name) {
    for (int i = 0; i < BUILT_ENGINE_COUNT; i++)
        if (strcmp(BUILT_ENGINES[i]->name, name) == 0)
            return BUILT_ENGINES[i];
    return NULL;
}

/* Whether the processor has the instructions that the library was built for; otherwise false, with
 * a line on stderr. */
static bool can_run(const physics_engine *engine) {
    bool lacking = false;
#if defined(__x86_64__)
    lacking = engine->needs_avx2 && !__builtin_cpu_supports("avx2");
#endif
    if (lacking)
        fprintf(stderr, "%s: this processor has no AVX2, which the library was built for\n",
                engine->name);
    return !lacking;
}

bool engine_can_build(const physics_engine *engine, const scene *s) {
    bool lacks_fields = engine != &engine_thud && scene_has_fields(s);
    return !lacks_fields && (!engine->can_build || engine->can_build(s));
}

void *engine_create(const physics_engine *engine, const scene *s, engine_settings settings) {
    if (settings.time_step == 0)
        settings.time_step = ENGINE_TIME_STEP;
    if (settings.substeps == 0)
        settings.substeps = 4;
    void *world = !s->failed && engine_can_build(engine, s) && can_run(engine)
                      ? engine->create(s, &settings)
                      : NULL;
    if (!world)
        fprintf(stderr, "%s: scene %s could not be built\n", engine->name, s->name);
    return world;
}
