/* draws.c: see draws.h. A greedy algorithm: of CANDIDATES random settings it takes the one that
 * covers the largest number of pairs of values that are not covered yet. */
#include "draws.h"

#include <string.h>

enum { CANDIDATES = 48, TRIES = 4096 };

typedef struct covered {
    bool pair[DIMENSIONS][VALUES_MAX][DIMENSIONS][VALUES_MAX]; /* a dimension with itself: single
                                                                  values */
} covered;

/* How many uncovered pairs the settings cover. Single values weigh 100 times as much, so that all
 * values are drawn first. */
static int gain_of(const covered *c, const settings *s) {
    int gain = 0;
    for (int d = 0; d < DIMENSIONS; d++) {
        for (int e = 0; e <= d; e++) {
            if (!c->pair[d][s->value[d]][e][s->value[e]]) {
                gain += d == e ? 100 : 1;
            }
        }
    }
    return gain;
}

/* Marks all pairs of values in `s` as covered. */
static void cover(covered *c, const settings *s) {
    for (int d = 0; d < DIMENSIONS; d++) {
        for (int e = 0; e <= d; e++) {
            c->pair[d][s->value[d]][e][s->value[e]] = true;
        }
    }
}

/* A seed that is different for each guarantee, and never 0. */
static uint64_t seed_of(const char *name, uint64_t seed) {
    seed = (seed + 1) * 0x9e3779b97f4a7c15u;
    for (; *name; name++) {
        seed = (seed ^ (unsigned char)*name) * 0x100000001b3u;
    }
    return seed ? seed : 1;
}

/* Random settings for which the guarantee holds. */
static settings draw_settings(const guarantee *g, source *random) {
    settings s = {{0}};
    do {
        s = settings_at(draw_below(random, settings_count()));
    } while (!guarantee_covers(g, &s));
    return s;
}

/* The best of `tries` random settings. draws_of repeats the search with TRIES where CANDIDATES find
 * nothing new. */
static settings draw_best(const guarantee *g, const covered *c, source *random, int tries) {
    settings best = draw_settings(g, random);
    for (int i = 1; i < tries; i++) {
        settings s = draw_settings(g, random);
        if (gain_of(c, &s) > gain_of(c, &best)) {
            best = s;
        }
    }
    return best;
}

int draws_of(const guarantee *g, uint64_t seed, settings out[DRAWS_MAX]) {
    covered *c = calloc(1, sizeof *c);
    source random = {seed_of(g->name, seed)};
    int count = 0;
    while (c && count < DRAWS_MAX) {
        settings s = draw_best(g, c, &random, CANDIDATES);
        if (gain_of(c, &s) == 0) {
            s = draw_best(g, c, &random, TRIES);
        }
        if (gain_of(c, &s) == 0) {
            break;
        }
        cover(c, &s);
        out[count++] = s;
    }
    free(c);
    return count;
}
