/* outcome.h: what a run measured, and printing it as text or JSON. */
#ifndef THUD_RUN_OUTCOME_H
#define THUD_RUN_OUTCOME_H

#include "options.h"
#include "scene.h"

typedef struct run_outcome {
    thud_stats stats;     /* after the last step */
    thud_measure measure; /* of the state after the last step */
    long steps;
    double seconds, worst_seconds; /* step time summed over all steps; of the slowest step */
    double stage_seconds[THUD_STAGE_COUNT];
    double penetration_max; /* a length; over all steps, contacts of sleeping bodies included */
    thud_step_error worst;  /* the largest of each value over all steps */
    long quarantined;
    long passed; /* bodies that went through what stands, a body once for each step: passing.h */
    uint64_t hash;
} run_outcome;

/* The error of a run, in the scene's length scales: the deepest overlap of all steps, or the widest
 * gap of a joint where that is more; infinite where a body passed through what stands or became
 * non-finite. */
double run_error_of(const run_outcome *o, const scene *s);

void run_print_text(const run_outcome *o, const scene *s, const run_options *options);
/* Prints one JSON object. False if memory runs out. */
bool run_print_json(const run_outcome *o, const scene *s, const run_options *options);

struct cJSON;
/* Prints the JSON and deletes it. False, after a message, if it is null or memory runs out. */
bool run_print_and_free(struct cJSON *json);

#endif
