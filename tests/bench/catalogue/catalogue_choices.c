/* catalogue_choices.c: see catalogue_choices.h. */
#include "catalogue/catalogue_choices.h"

#include "build_thud.h"
#include "lab/lab_world.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

const thud_broadphase *broadphase_at(int index) {
    const thud_broadphase *all[BROADPHASE_COUNT] = {&thud_broadphase_grid, &thud_broadphase_sweep,
                                                    &thud_broadphase_all};
    return all[index];
}

const thud_detection *way_at(int index) {
    const thud_detection *all[WAY_COUNT] = {&thud_detection_overlap, &thud_detection_continuous,
                                            &thud_detection_bisect, &thud_detection_swept};
    return all[index];
}

static bool succeeds(thud_result result) {
    if (result != THUD_OK)
        fprintf(stderr, "thud-catalogue: %s\n", thud_result_text(result));
    return result == THUD_OK;
}

bool way_open(way_world *w, const scene *s, const thud_detection *detection, double time_step) {
    thud_world_def def = lab_settings();
    def.detection = detection;
    def.time_step = time_step;
    w->count = s->body_count;
    w->bodies = calloc((size_t)s->body_count, sizeof *w->bodies);
    return succeeds(w->bodies ? scene_build_thud(s, &def, &w->world, w->bodies, NULL)
                              : THUD_ERROR_MEMORY);
}

bool way_step(way_world *w) {
    return succeeds(thud_world_step(w->world));
}

void way_close(way_world *w) {
    thud_world_destroy(w->world);
    free(w->bodies);
    *w = (way_world){0};
}

double processor_seconds(void) {
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}
