/* options.h: the command line of thud-bench. */
#ifndef THUD_BENCH_OPTIONS_H
#define THUD_BENCH_OPTIONS_H

#include "engine.h"
#include "plan.h"
#include "race.h"

enum { OPTIONS_MAX_SCENES = 64 };

typedef struct chosen_scene {
    const scene_info *info;
    int size;
} chosen_scene;

/* The parts of a run, as bits. */
typedef enum bench_part {
    BENCH_SCENES = 1 << 0, /* the race between engines */
    BENCH_GROWTH = 1 << 1,
    BENCH_PAY = 1 << 2,
    BENCH_WORKERS = 1 << 3,
    BENCH_PROFILE = 1 << 4,
    BENCH_ALL = (1 << 5) - 1
} bench_part;

typedef enum options_outcome {
    OPTIONS_RUN,
    OPTIONS_HELP,
    OPTIONS_LIST,
    OPTIONS_WRONG
} options_outcome;

typedef struct options {
    chosen_scene scenes[OPTIONS_MAX_SCENES];
    int scene_count;
    const physics_engine *engines[RACE_MAX_ENGINES]; /* the first is thud */
    int engine_count;
    unsigned parts;
    const char *json; /* path; null: no JSON */
    int steps;        /* 0: those of the plan */
    int repetitions;
    bool quick;
} options;

/* Wrong options are reported on stderr. */
options_outcome options_read(options *o, int argc, char **argv);

void options_print_help(void);
void options_print_list(void);

#endif
