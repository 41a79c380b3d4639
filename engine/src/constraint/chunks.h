/* chunks.h: divides the blocks and bodies of a step among workers.
 *
 * Each worker has a range of the awake slots, and the same share of the blocks of a place
 * (constraint/lanes.h) as of its slots; other runs are divided evenly. So the bodies that it reads
 * and writes in one pass are mostly those of its last pass, and their cache lines stay with its
 * processor: to take a line from another processor costs 20 to 40 ns, about as much as a block of
 * contacts (measured with two processors). */
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

/* The work between two barriers, at which workers wait for each other: `parts` parts, of which a
 * worker claims one at a time. A part is a sequence of chunks; part i of the phase begins at
 * td_part_first(w, first + i). Chunks of one graph colour have no moving body in common, so that
 * workers share them. A colour that is a single chunk, and a run whose blocks may share bodies
 * (td_run_is_single), are for one worker. Where several of these follow each other, they form one
 * part, since waiting for another worker between them would take longer than solving them. */
typedef struct td_phase {
    int first, parts;
    int shares[THUD_WORKERS_MAX + 1]; /* of the parts, for td_worker_take */
} td_phase;

/* Where in scratch.chunk_order a part begins: an index, to read or to set. `part` is the number of
 * the part among those of all phases. It ends where the next one begins; so there is one entry more
 * than parts, the end of the last one. */
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
