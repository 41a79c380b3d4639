/* lab_turns.h: any number of thud worlds of one scene, stepped in turns, so that whatever else the
 * machine does hits all alike; one that is too dear drops out. */
#ifndef THUD_BENCH_LAB_TURNS_H
#define THUD_BENCH_LAB_TURNS_H

#include "lab_world.h"

enum { LAB_TURNS_STEPS = 200 };

typedef struct lab_turns_plan {
    int warm_up;
    int steps;      /* timed, at most LAB_TURNS_STEPS */
    double seconds; /* no turn begins later than this, but the first five do */
    double too_dear; /* seconds: a world with a first step longer than this drops out */
} lab_turns_plan;

/* Seconds. */
typedef struct lab_turns_times {
    bool dropped;
    double first;            /* of the first step's broadphase */
    double first_step;       /* of all of it */
    double broadphase, step; /* medians after the warm-up */
    thud_stats stats;        /* of the last step */
} lab_turns_times;

/* The worlds must have lab_now for their clock. False, and a line on stderr, when a step fails. */
bool lab_take_turns(const char *label, lab_world *labs, int count, const lab_turns_plan *plan,
                    lab_turns_times *times);

#endif
