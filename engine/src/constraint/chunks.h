/* chunks.h: divides the blocks and bodies of a step among workers.
 *
 * Each worker has a range of the awake slots, and of every run the blocks of those slots. So the
 * bodies that it reads and writes in one pass are mostly those of its last pass, and their cache
 * lines stay with its processor: to take a line from another processor costs 20 to 40 ns, about as
 * much as a block of contacts (measured with two processors). */
#ifndef TD_CHUNKS_H
#define TD_CHUNKS_H

#include "constraint/lanes.h"
#include "state/jobs.h"

/* A piece of a run for one worker, and the result of its narrowphase. */
typedef struct td_chunk {
    int32_t run, first, count; /* index of the run; blocks, in scratch.blocks */
    int32_t worker;            /* whose share it belongs to */
    int32_t has_offsets;       /* 1: one of its blocks has offsets */
    int32_t separated;         /* number of blocks with a lane that no longer touches */
} td_chunk;

/* What workers do between two barriers, at which they wait for each other: `parts` parts, each some
 * chunks that one worker claims at once, whose beginnings are td_part_first(w, first) and the
 * following ones. Chunks of one bin (graph colour) have no moving body in common, so that workers
 * share them. Small colours, and runs whose blocks may share bodies (td_run_is_single), are for one
 * worker. Where such follow each other they are one part, since waiting for another worker between
 * them would take longer than they do. */
typedef struct td_phase {
    int first, parts;
    int shares[THUD_WORKERS_MAX + 1]; /* of the parts, for td_worker_take */
} td_phase;

/* The element of scratch.chunk_order with which a part begins, by its number among the parts of all
 * phases. The part ends where the next one begins; one more number than there are parts is valid.
 */
static inline int *td_part_first(const thud_world *w, int part) {
    return TD_AT(int, &w->scratch.chunk_order, w->scratch.chunks.count + part);
}

/* Divides the runs into chunks; a single worker has one for each run. For several workers, also
 * lists the phases, in the order of solving. False when memory is short. */
bool td_chunks_cut(thud_world *w);

/* Runs one part of a phase: calls run(work, chunk) for each of its chunks, by their indices in
 * scratch.chunks. */
void td_phase_run(const thud_world *w, const td_phase *phase, int part, td_chunk_fn *run,
                  void *work);

/* Awake slots that one of several workers takes at once in a pass over bodies. */
int td_body_chunk(const thud_world *w, int workers);
/* Sets the shares (td_worker_take) of the passes over bodies, in chunks of td_body_chunk. */
void td_share_bodies(const thud_world *w, int workers, int shares[THUD_WORKERS_MAX + 1]);

#endif
