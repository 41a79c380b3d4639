/* case.h: a scene together with the error that matters in it.
 *
 * A new case is one `const tradeoff_case` in a file cases_*.c and a line in cases.c. */
#ifndef THUD_TRADEOFF_CASE_H
#define THUD_TRADEOFF_CASE_H

#include "engine.h"
#include "oracle.h"
#include "scenes.h"

/* What can be seen of a world after a step, by no engine's own measure. Nothing is lost. */
typedef struct sighting {
    const scene *scene;          /* as it began */
    const engine_body *bodies;   /* as of now, in the scene's order */
    double time;                 /* s since the start */
    oracle_score score;          /* of this step */
    const oracle_score *start;   /* ... and of the scene as it began */
    const engine_body *expected; /* as the oracle's linkage has them now; null without one */
} sighting;

/* How the errors of the single steps make the one of the whole run. */
typedef enum case_fold { CASE_WORST = 0, CASE_MEAN, CASE_LAST } case_fold;

typedef struct tradeoff_case {
    const char *name, *title;
    const char *about;      /* a sentence: what happens */
    const char *error;      /* what is measured, in words that fit an axis */
    const char *unit;       /* "m", or "" where the error is a ratio */
    int size, quick_size;   /* handed to fill */
    int steps, quick_steps; /* of 1/60 s */
    /* Errors up to here are as good as none: what rounding, a tolerance that is documented, or the
     * yardstick itself makes of a perfect run. */
    double floor;
    /* How much worse a finer quality may seem and count as no worse: 1 where nothing is chaotic. */
    double chance;
    case_fold fold;
    const scene_info *built_in;       /* the scene; null: it is made by ... */
    bool (*fill)(scene *s, int size); /* ... which has an empty one, and gives false, and a line on
                                         stderr, when something is missing */
    double (*error_of)(const sighting *now);
    bool has_linkage; /* the oracle's linkage runs beside it */
} tradeoff_case;

/* An error that more than one case has: of what overlaps now, the deepest. */
double case_deepest_overlap(const sighting *now);

/* Makes the case's scene. False, *s is empty, and a line on stderr says why, when it cannot. */
bool case_fill(const tradeoff_case *c, bool quick, scene *s);

int cases_count(void);
const tradeoff_case *cases_at(int index);
const tradeoff_case *cases_find(const char *name); /* null if there is none */

extern const tradeoff_case case_column_30, case_column_100, case_pyramid, case_heavy_on_light,
    case_rubble, case_slope, case_rolling, case_gas, case_cradle, case_bullets, case_pit,
    case_chain, case_bridge, case_ragdolls, case_cars;

#endif
