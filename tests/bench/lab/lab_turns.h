/* lab_turns.h: times any number of thud worlds of one scene. They are stepped in turns, so that
 * load of other processes affects all alike. A world that is too slow is left out. */
#ifndef THUD_BENCH_LAB_TURNS_H
#define THUD_BENCH_LAB_TURNS_H

#include "lab/lab_world.h"

enum { LAB_TURNS_STEPS = 200 };

typedef struct lab_turns_plan {
    int warm_up;     /* untimed steps, at least 2 */
    int steps;       /* timed steps, at most LAB_TURNS_STEPS */
    double seconds;  /* no turn begins later than this, except the first five */
    double too_dear; /* seconds: a world whose second step takes longer is left out (the first step
                        allocates) */
} lab_turns_plan;

/* Seconds. Each is the minimum over the repetitions so far; worlds are deterministic. */
typedef struct lab_turns_times {
    bool dropped;
    double first;                                              /* broadphase of the first step */
    double second_step;                                        /* whole second step */
    double step[LAB_TURNS_STEPS], broadphase[LAB_TURNS_STEPS]; /* of each step after the warm-up */
    int count;                                                 /* number of timed steps */
    thud_stats stats;                                          /* after the last step */
} lab_turns_times;

/* Takes new worlds whose clock is lab_now. Repetition 0 initialises the times, and later ones make
 * as many steps. False, with a line on stderr, if a step fails. */
bool lab_take_turns(const char *label, lab_world *labs, int count, const lab_turns_plan *plan,
                    int repetition, lab_turns_times *times);

/* The mean of `count` >= 1 values. */
double lab_turns_mean(const double *values, int count);

#endif
