/* thud_quality.h: qualities: sets of solver settings, from fast to accurate. A world def names one.
 * A program does not link code that only other qualities use. Included by thud.h.
 *
 * docs/tradeoff.md shows the cost and the errors of each, as `./run tradeoff` measures them. */
#ifndef THUD_QUALITY_H
#define THUD_QUALITY_H

#include "thud_detection.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A solver for islands in which the contacts of the soft solver would overlap too much. (The soft
 * solver is the iterative one for all islands: it treats contacts as stiff springs and dampers, in
 * substeps.) thud_islands_direct solves all constraints of such an island at once, by sparse
 * factorisation. */
typedef struct thud_island_solver thud_island_solver;
/* The direct solver of islands. All qualities but thud_quality_draft name it. */
extern THUD_API const thud_island_solver thud_islands_direct;

/* A caller may copy one of the four below, change the copy and use it. Worlds keep their own
 * copy. */
typedef struct thud_quality {
    const char *name; /* for the caller's use */
    int substeps; /* number of substeps in a step, 1 .. THUD_SUBSTEPS_MAX. Contact stiffness rises
                     with the substep rate, so that with more substeps contacts also overlap less.
                     Fewer substeps in a world def, or by a time budget, reduce island_work in
                     proportion, and do not make more islands direct */
    float contact_stiffness;           /* frequency of the contact springs divided by the substep
                                          rate, [THUD_CONTACT_STIFFNESS_MIN,
                                          THUD_CONTACT_STIFFNESS_MAX] */
    float contact_damping;             /* damping ratio of the contact springs, [0,
                                          THUD_CONTACT_DAMPING_MAX] */
    const thud_detection *detection;   /* not null */
    const thud_island_solver *islands; /* null: only the soft solver (for an exception see
                                          thud_detection_swept) */
    float overlap_limit; /* >= 0: an island is solved by `islands` if a contact in it would overlap
                        under its load by more than this share of the smaller body's thinnest
                        shape, in two checks (in large worlds eight steps apart), while both bodies
                        are nearly at rest against each other; 0: every island is. An island in
                        which a contact bounces is left to the soft solver in that step. In a world
                        that chooses bisect or swept every island without joints is
                        (thud_detection_swept) */
    int island_limit;    /* bodies, 1 .. THUD_ISLAND_LIMIT_MAX: larger islands are left to the soft
                            solver */
    int64_t
        island_work; /* budget of all direct islands in a step, >= 0: operations on 3 x 3 blocks in
                        factorisations, plus, for each factorisation, one for each body and two for
                        each contact. A tree of hinges and welds needs no matrix: one operation a
                        body and iteration. Islands beyond the budget are left to the soft solver.
                        At rest
                        a step needs one factorisation, of 6 operations a body in a column and 140
                        in a pyramid of 500 bodies; in motion it needs many, of the same size. Whole
                        steps at quality high (docs/tradeoff.md): at rest a column of boxes takes
                        1.1 µs a body, a pyramid 4.0 µs. An island without contacts may use eight
                        times the rest of the budget. Whatever the budget is, islands with joints
                        together use at most 4,000 operations a step for each awake body of the
                        world, or those of 1,000 bodies if there are fewer, and each island may use
                        at least 4,000 for each of its bodies. An island that uses up its share is
                        left to the soft solver for some steps, and for twice as many each time that
                        this happens again */
    int island_slow_steps; /* number of successive slow steps after which an island is left to the
                            soft solver for a pause of 120 steps, 0 .. THUD_ISLAND_SLOW_STEPS_MAX. A
                            step is slow if the island needs more than eight factorisations; while
                            its bodies hardly move against each other, four times as many slow steps
                            are allowed. If overlap_limit is above 0, an island of contacts whose
                            bodies do move against each other gets no more than eight
                            factorisations, and a pause of 30 steps where they do not suffice (under
                            overlap and continuous; bisect and swept let nothing overlap, and have
                            no such limit). The pause of 120 steps also follows a direct result that
                            is not valid. A pause doubles each time that it follows again before the
                            island had a step that is not slow, up to sixteen times its length; if
                            eight factorisations exceed island_work, the pause of 120 steps is one
                            of 1920 at once. 0: no limit, the direct solver is tried in every step;
                            but an island with joints that could not be solved in eight successive
                            steps is left to the soft solver for 8 steps, and for twice as many each
                            time that it happens again, up to 128 */
} thud_quality;

/* The fastest: two substeps, and no island solver. */
extern THUD_API const thud_quality thud_quality_draft;
/* The default: four substeps; islands whose contacts would overlap by more than its overlap_limit
 * are solved directly. */
extern THUD_API const thud_quality thud_quality_default;
/* Eight substeps; every island of up to 2048 bodies is solved directly, within a budget. */
extern THUD_API const thud_quality thud_quality_high;
/* The most accurate: sixteen substeps, thud_detection_swept, and every island of up to 4096 bodies
 * is solved directly. */
extern THUD_API const thud_quality thud_quality_exact;

#ifdef __cplusplus
}
#endif

#endif
