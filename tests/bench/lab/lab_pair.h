/* lab_pair.h: two thud worlds that differ in one thing, stepped in turns, so that whatever else the
 * machine does hits both alike. */
#ifndef THUD_BENCH_LAB_PAIR_H
#define THUD_BENCH_LAB_PAIR_H

#include "lab/lab_world.h"

#include <thud/thud_listeners.h>

typedef struct lab_pair {
    const char *feature;
    const char *with, *without; /* what the two worlds are */
    /* Fills the scene and the settings of one of the two. */
    void (*fill)(bool with, scene *s, thud_world_def *def);
    const thud_listeners *listeners; /* of the world with; null: none */
} lab_pair;

/* Seconds of the median step. */
typedef struct lab_price {
    double with, without;
} lab_price;

/* False, and a line on stderr, when a world fails. */
bool lab_compare(const lab_pair *pair, bool quick, lab_price *out);

#endif
