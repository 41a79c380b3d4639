/* thud_quality.h: the knob between speed and accuracy, for a world def to choose from. A program
 * that never names a quality does not link what only that one uses.
 *
 * What each costs and gets wrong is measured by `./run tradeoff` and stands in docs/tradeoff.md. */
#ifndef THUD_QUALITY_H
#define THUD_QUALITY_H

#include "thud_detection.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How islands that the soft solver cannot hold are solved instead: all their contacts at once. */
typedef struct thud_island_solver thud_island_solver;
extern THUD_API const thud_island_solver thud_islands_direct;

/* Four stand below; a caller may take one, change it and use that instead. Worlds keep a copy. */
typedef struct thud_quality {
    const char *name;
    int substeps; /* a step is cut into so many, 1 .. THUD_SUBSTEPS_MAX. Contact stiffness rises
                     with the substep rate, so that more of them also sink less. A world def that
                     names fewer, or a time budget that does, gets no more islands solved
                     directly for it, and island_work in proportion */
    float contact_stiffness; /* contact frequency over substep rate, [THUD_CONTACT_STIFFNESS_MIN,
                                THUD_CONTACT_STIFFNESS_MAX] */
    float contact_damping;   /* damping ratio of overlap that is pushed apart, [0,
                                THUD_CONTACT_DAMPING_MAX] */
    const thud_detection *detection;   /* not null */
    const thud_island_solver *islands; /* null: the soft solver does all */
    float sag_limit;     /* >= 0: an island in which a contact gives way under its load by more than
                            this share of the smaller body's size goes to `islands`; 0: each does */
    int island_limit;    /* 1 .. THUD_ISLAND_LIMIT_MAX: islands of more bodies stay with the soft
                            solver */
    int64_t island_work; /* >= 0: operations on 3 x 3 blocks that all islands together may take a
                            step: those of each matrix, one more a body and two a contact. Those
                            for which there is no more stay with the soft solver. A column takes 6
                            a body at rest, a pyramid of 500 bodies 140 a body; in motion a step
                            takes many matrices, each as dear as the one at rest. Whole steps at
                            quality high (docs/tradeoff.md): at rest a column of boxes takes 0.6 µs
                            a body, a pyramid 1.9 µs. An island of joints alone may take eight
                            times what is left. Whatever this allows, islands with joints take a
                            bounded part of a frame together, more in worlds of over a thousand
                            bodies, and each at least the share of its own bodies of that; one that
                            spends what it may take is left to the soft solver for some steps, and
                            for twice as many each time that it happens again */
    int island_patience; /* 0 .. THUD_ISLAND_PATIENCE_MAX: steps in succession in which an island
                            may need more than eight matrices, or twenty times as many while it
                            hardly moves, before it is left to the soft solver for 120 steps, as it
                            is where the direct result is no good. Each time that happens again
                            before it was easy the pause doubles, up to 1920 steps, and where eight
                            matrices are more than island_work it is that at once. 0: any number,
                            each step tried anew; but an island with joints that could not be
                            solved in eight steps in succession is left to the soft solver for 8,
                            and for twice as many each time that it happens again, up to 128 */
} thud_quality;

extern THUD_API const thud_quality thud_quality_draft;
extern THUD_API const thud_quality thud_quality_default;
extern THUD_API const thud_quality thud_quality_high;
extern THUD_API const thud_quality thud_quality_exact;

#ifdef __cplusplus
}
#endif

#endif
