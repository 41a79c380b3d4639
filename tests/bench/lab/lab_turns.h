/* lab_turns.h: any number of thud worlds of one scene, stepped in turns, so that whatever else the
 * machine does hits all alike; one that is too dear drops out. */
#ifndef THUD_BENCH_LAB_TURNS_H
#define THUD_BENCH_LAB_TURNS_H

#include "lab/lab_world.h"

enum { LAB_TURNS_STEPS = 200 };

typedef struct lab_turns_plan {
    int warm_up;     /* steps, at least 2 */
    int steps;       /* timed, at most LAB_TURNS_STEPS */
    double seconds;  /* no turn begins later than this, but the first five do */
    double too_dear; /* seconds: a world whose second step takes longer drops out; the first one
                        makes everything */
} lab_turns_plan;

/* Seconds: the least of the repetitions so far, as worlds are deterministic. */
typedef struct lab_turns_times {
    bool dropped;
    double first;                                              /* of the first step's broadphase */
    double second_step;                                        /* of all of it */
    double step[LAB_TURNS_STEPS], broadphase[LAB_TURNS_STEPS]; /* after the warm-up */
    int count;                                                 /* of the timed steps */
    thud_stats stats;                                          /* of the last step */
} lab_turns_times;

/* The worlds are new, and have lab_now for their clock. Repetition 0 fills in the times, and later
 * ones go as far as that did. False, and a line on stderr, when a step fails. */
bool lab_take_turns(const char *label, lab_world *labs, int count, const lab_turns_plan *plan,
                    int repetition, lab_turns_times *times);

/* Of `count` >= 1 values. */
double lab_turns_mean(const double *values, int count);

#endif
