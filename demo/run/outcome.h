/* outcome.h: what a run found, and how it is printed. */
#ifndef THUD_RUN_OUTCOME_H
#define THUD_RUN_OUTCOME_H

#include "options.h"
#include "scene.h"

typedef struct run_outcome {
    thud_stats stats;     /* of the last step */
    thud_measure measure; /* of the last state */
    long steps;
    double seconds, worst_seconds; /* all steps; the slowest one */
    double stage_seconds[THUD_STAGE_COUNT];
    double penetration_max; /* of all steps, sleepers too */
    thud_step_error worst;  /* the largest of each over all steps */
    long quarantined;
    uint64_t hash;
} run_outcome;

void run_print_text(const run_outcome *o, const scene *s, const run_options *options);
/* False when memory is short. */
bool run_print_json(const run_outcome *o, const scene *s, const run_options *options);

#endif
