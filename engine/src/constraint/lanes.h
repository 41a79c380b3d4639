/* lanes.h: where constraints that act live: lanes of blocks, blocks in bins.
 *
 * Bins stay dense: a lane that leaves is filled by the bin's last one. Which lane a constraint has
 * follows from the history of the world alone, never from addresses. */
#ifndef TD_LANES_H
#define TD_LANES_H

#include "state/world.h"

/* A run of blocks of one bin, in the order of solving. */
typedef struct td_run {
    int32_t kind, fixed; /* kind of the constraints; `fixed` 1: side a is static */
    int32_t bin;         /* runs of the same bin have no moving body in common, but in overflow */
    int32_t first, count;
    int32_t armed;  /* one of its blocks is */
    int32_t shared; /* one of its blocks is: no two workers at once */
} td_run;

/* Whether blocks of a run may name the same body: those of the overflow, and those with kinematic
 * bodies, which take no colours. */
static inline bool td_run_is_single(const td_run *run) {
    return run->shared || run->bin % TD_COLOURS == TD_OVERFLOW;
}

/* A piece of a run, and what the narrowphase found of it. */
typedef struct td_chunk {
    int32_t run, first, count; /* blocks */
    int32_t armed, parted;     /* whether one is armed; how many have a lane that touches no more */
} td_chunk;

static inline td_block *td_block_at(const thud_world *w, int kind, int index) {
    return td_slot_at(&w->pool[w->kinds[kind]->form], index);
}

/* The lane operations of contacts, defined in contact/contact_lanes.c. */
extern const td_lane_ops td_contact_lanes;

static inline const td_lane_ops *td_lane_ops_of(const thud_world *w, int kind) {
    const td_lane_ops *own = w->kinds[kind]->lanes;
    return own ? own : &td_contact_lanes;
}

/* Where a constraint lives that acts. A type of its own, so that nobody takes td_constraint.slot,
 * which is a place in a list while the constraint waits, for the one or the other half of it. */
typedef struct td_lane {
    td_block *block;
    int lane;
} td_lane;

static inline td_lane td_lane_of(const thud_world *w, const td_constraint *constraint) {
    assert(constraint->state == TD_TOUCHING);
    return (td_lane){td_block_at(w, constraint->kind, constraint->slot / TD_LANES),
                     constraint->slot % TD_LANES};
}

/* Gives each of the constraints a lane by its graph colour. What has a lane already takes its
 * impulses along. False when memory is short, and nothing has changed. */
bool td_lanes_place(thud_world *w, const int *constraints, int count);
/* Moves lanes to their kinds' bins of sleepers, impulses and all, after td_lanes_reserve_sleeping,
 * which makes room for any of them. */
void td_lanes_put_to_sleep(thud_world *w, const int *constraints, int count);
bool td_lanes_reserve_sleeping(thud_world *w);
void td_lane_remove(thud_world *w, int constraint);

/* Lists the blocks in the order of solving: colours with moving bodies first and static ones last,
 * so that the ground has the last word. */
bool td_lanes_sequence(thud_world *w);

/* The awake slot of one of its bodies changed. */
void td_lane_refresh(thud_world *w, int constraint);
/* Does what td_lane_refresh does, and has the manifold and the masses worked out anew in the next
 * narrowphase. */
void td_lane_renew(thud_world *w, int constraint);

#endif
