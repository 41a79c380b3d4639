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

/* A piece of a run, which one worker claims, and the result of its narrowphase. */
typedef struct td_chunk {
    int32_t run, first, count; /* index of the run; blocks, in scratch.blocks */
    int32_t worker;            /* whose share it belongs to */
    int32_t has_offsets;       /* 1: one of its blocks has offsets */
    int32_t separated;         /* number of blocks with a lane that no longer touches */
} td_chunk;

/* The chunks between two barriers, at which workers wait for each other: elements of
 * scratch.chunk_order from `first` on. Chunks of one bin (graph colour) have no moving body in
 * common: workers share them, each chunk a part. Small colours, and runs whose blocks may share
 * bodies (td_run_is_single), are one chunk. Such chunks that follow each other are one part, since
 * waiting for another worker between them would take longer than they do. */
typedef struct td_phase {
    int first, chunks, parts;
    int shares[THUD_WORKERS_MAX + 1]; /* of the parts, for td_worker_take */
} td_phase;

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
