/* shared_stages.h: the stages of a step that a world shares among the workers of its job system
 * only where the program asks for it (thud_job_system.stages), so that others do not link them. */
#ifndef TD_SHARED_STAGES_H
#define TD_SHARED_STAGES_H

#include "solver/motion.h"
#include "state/world.h"

struct thud_shared_stages {
    /* Makes room for `finalize`. False when memory is short. */
    bool (*finalize_reserve)(thud_world *w);
    /* As td_finalize_bodies for `all` bodies, with the same results to the bit. */
    td_finalize_bodies_fn *finalize;
};

/* Bodies that a worker takes at once: a multiple of TD_LANES. Chosen. */
enum { TD_SHARE_BODIES = 256 };

/* A part of the bodies with memory for what is found of them. */
typedef struct td_finalize_share {
    td_energy_sums sums[TD_SHARE_BODIES / TD_LANES];
    td_finalize_part part;
    td_array odd, fast, moved;
    int room[3][TD_SHARE_BODIES]; /* data of these three */
} td_finalize_share;

/* shared_finalize.c: see above. */
bool td_shared_finalize_reserve(thud_world *w);
td_finalize_bodies_fn td_shared_finalize;

#endif
