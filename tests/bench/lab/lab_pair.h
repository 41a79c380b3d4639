/* lab_pair.h: times two thud worlds that differ in one feature. They are stepped in turns, so that
 * load of other processes affects both alike. */
#ifndef THUD_BENCH_LAB_PAIR_H
#define THUD_BENCH_LAB_PAIR_H

#include "lab/lab_world.h"

#include <thud/thud_listeners.h>

typedef struct lab_pair {
    const char *feature;
    const char *with, *without; /* names of the two worlds */
    /* Fills the scene and the def of the world with the feature or of the one without it. */
    void (*fill)(bool with, scene *s, thud_world_def *def);
    const thud_listeners *listeners; /* of the world with the feature; null: none */
} lab_pair;

/* Median time of a step, seconds. */
typedef struct lab_price {
    double with, without;
} lab_price;

/* False, with a line on stderr, if a world fails. */
bool lab_compare(const lab_pair *pair, bool quick, lab_price *out);

#endif
