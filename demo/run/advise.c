/* advise.c: see advise.h. */
#define _POSIX_C_SOURCE 200809L

#include "advise.h"

#include "choices.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

void advise_name(const run_options *how, char *out) {
    int used = snprintf(out, ADVISE_NAME_MAX, "%s", QUALITIES[how->quality]->name);
    if (how->detection != DETECTION_DEFAULT)
        used += snprintf(out + used, (size_t)(ADVISE_NAME_MAX - used), ", %s",
                         DETECTIONS[how->detection].name);
    if (how->broadphase != BROADPHASE_DEFAULT)
        used += snprintf(out + used, (size_t)(ADVISE_NAME_MAX - used), ", %s",
                         BROADPHASES[how->broadphase].name);
    if (how->substeps > 0)
        snprintf(out + used, (size_t)(ADVISE_NAME_MAX - used), ", %d substeps", how->substeps);
}

/* Measures everything. False after a message. */
static bool measure(advice *a) {
    bool done = advise_measure(a->options, a->scene, &a->series) &&
                uses_count(a->options, a->scene, &a->used, &a->uses) &&
                advise_switch_off(&a->series, a->scene, &a->offs) &&
                advise_grow(&a->series.settings[a->offs.base].how, a->scene, &a->growth);
    if (isatty(STDERR_FILENO))
        fprintf(stderr, "\r%50s\r", "");
    return done;
}

bool advise(const run_options *options, const scene *s) {
    advice *a = calloc(1, sizeof *a);
    if (!a) {
        fprintf(stderr, "thud-run: out of memory\n");
        return false;
    }
    a->options = options;
    a->scene = s;
    bool done = measure(a);
    if (done && options->picture)
        done = advise_draw(a, options->picture);
    if (done && options->json)
        done = advise_print_json(a);
    else if (done)
        advise_print_text(a);
    advise_growth_free(&a->growth);
    advise_offs_free(&a->offs);
    advise_series_free(&a->series);
    free(a);
    return done;
}
