/* lab_world.c: see lab_world.h. */
#include "lab/lab_world.h"

#include "build_thud.h"

#include <stdio.h>
#include <time.h>

double lab_now(void *context) {
    (void)context;
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

thud_world_def lab_settings(void) {
    thud_world_def def = thud_default_world_def();
    def.sleeping = false;
    return def;
}

bool lab_open(lab_world *lab, const thud_world_def *def) {
    int refused = -1;
    thud_result result = scene_build_thud(&lab->scene, def, &lab->world, NULL, &refused);
    if (result != THUD_OK)
        fprintf(stderr, "thud-bench: scene %s could not be built, body %d: %s\n",
                lab->scene.name ? lab->scene.name : "", refused, thud_result_text(result));
    return result == THUD_OK;
}

bool lab_open_scene(lab_world *lab, const scene_info *info, int size, const thud_world_def *def) {
    *lab = (lab_world){0};
    if (!scenes_fill(info, size, &lab->scene)) {
        fprintf(stderr, "thud-bench: out of memory for scene %s\n", info->name);
        return false;
    }
    return lab_open(lab, def);
}

void lab_close(lab_world *lab) {
    thud_world_destroy(lab->world);
    scene_free(&lab->scene);
    *lab = (lab_world){0};
}

bool lab_run(lab_world *lab, int count, double *seconds) {
    for (int i = 0; i < count; i++) {
        double start = lab_now(NULL);
        thud_result result = thud_world_step(lab->world);
        if (seconds)
            seconds[i] = lab_now(NULL) - start;
        if (result != THUD_OK) {
            fprintf(stderr, "thud-bench: step: %s\n", thud_result_text(result));
            return false;
        }
    }
    return true;
}
