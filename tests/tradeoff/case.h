/* case.h: a case of the trade-off: a scene together with the error that is measured in it.
 *
 * To add a case, define a `const tradeoff_case` in a file cases_*.c and add a line in cases.c. */
#ifndef THUD_TRADEOFF_CASE_H
#define THUD_TRADEOFF_CASE_H

#include "engine.h"
#include "oracle.h"
#include "scenes.h"

/* The state of a world after a step, measured independently of the engine. No body is lost. */
typedef struct sighting {
    const scene *scene;        /* at the start */
    const engine_body *bodies; /* at present, in the scene's order */
    double time;               /* s since the start */
    oracle_score score;        /* score of the present state */
    const oracle_score *start; /* ... and of the scene at the start */
    const engine_body
        *expected; /* the bodies of the oracle's linkage at present; null without one */
} sighting;

/* How the error of a run follows from the errors of its steps. */
typedef enum case_fold { CASE_WORST = 0, CASE_MEAN, CASE_LAST } case_fold;

typedef struct tradeoff_case {
    const char *name, *title;
    const char *about;      /* one sentence about the scene */
    const char *error;      /* what is measured; the label of an axis */
    const char *unit;       /* "m", or "" where the error is a ratio */
    int size, quick_size;   /* passed to fill */
    int steps, quick_steps; /* number of steps of 1/60 s */
    /* Errors up to this count as none: the result of rounding, of a documented tolerance, or of the
     * reference's own error in a perfect run. */
    double floor;
    /* The factor by which a finer quality may have a larger error and count as equal; 1 where the
     * motion is not chaotic. */
    double chance;
    case_fold fold;
    const scene_info *built_in;       /* the scene; null: made by fill */
    bool (*fill)(scene *s, int size); /* fills an empty scene; false, with a line on stderr, if
                                         something is missing */
    double (*error_of)(const sighting *now);
    bool has_linkage; /* the oracle's linkage is run as the reference */
} tradeoff_case;

/* An error function of several cases: the deepest overlap of the present state. */
double case_deepest_overlap(const sighting *now);

/* Creates the case's scene. False, with *s empty and a line on stderr, if it cannot. */
bool case_fill(const tradeoff_case *c, bool quick, scene *s);

int cases_count(void);
const tradeoff_case *cases_at(int index);
const tradeoff_case *cases_find(const char *name); /* null if there is none */

extern const tradeoff_case case_column_30, case_column_100, case_pyramid, case_heavy_on_light,
    case_rubble, case_slope, case_rolling, case_gas, case_cradle, case_bullets, case_pit,
    case_chain, case_bridge, case_ragdolls, case_cars;

#endif
