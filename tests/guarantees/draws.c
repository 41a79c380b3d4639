/* draws.c: see draws.h. Greedy: of some random settings the one with most pairs that none had. */
#include "draws.h"

#include <string.h>

enum { CANDIDATES = 48, TRIES = 4096 };

typedef struct covered {
    bool pair[DIMENSIONS][VALUES_MAX][DIMENSIONS][VALUES_MAX]; /* a dimension with itself: values */
} covered;

/* How many pairs the settings add; values of their own count more, so that they come first. */
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

static void cover(covered *c, const settings *s) {
    for (int d = 0; d < DIMENSIONS; d++) {
        for (int e = 0; e <= d; e++) {
            c->pair[d][s->value[d]][e][s->value[e]] = true;
        }
    }
}

static uint64_t seed_of(const char *name, uint64_t seed) {
    seed = (seed + 1) * 0x9e3779b97f4a7c15u;
    for (; *name; name++) {
        seed = (seed ^ (unsigned char)*name) * 0x100000001b3u;
    }
    return seed ? seed : 1;
}

static settings draw_settings(const guarantee *g, source *random) {
    settings s = {{0}};
    do {
        s = settings_at(draw_below(random, settings_count()));
    } while (!guarantee_covers(g, &s));
    return s;
}

/* What no candidate of a round adds is looked for once more in all settings. */
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
