/* shared_stages.h: the stages of a step that a world shares among the workers of its job system
 * only where the program asks for it (thud_job_system.stages), so that others do not link them. */
#ifndef TD_SHARED_STAGES_H
#define TD_SHARED_STAGES_H

#include "broadphase/pairs.h"
#include "contact/waiting.h"
#include "solver/motion.h"
#include "state/world.h"

#include <string.h>

typedef void td_sift_fast_fn(thud_world *w);

struct thud_shared_stages {
    /* As td_finalize_bodies for `all` bodies, with the same results to the bit. */
    td_finalize_bodies_fn *finalize;
    /* As the world's sweep of all shapes, with the same pairs, for a td_pair_search as context. */
    td_sweep_fn *sweep;
    /* As td_waiting_test_all, with the same lists in the same order. */
    td_waiting_fn *waiting;
    /* Removes from scratch.fast the bodies that collide with nothing on their way, which
     * td_stage_continuous would leave as they are. */
    td_sift_fast_fn *sift_fast;
};

/* Bodies that a worker takes at once: a multiple of TD_LANES. Chosen. */
enum { TD_SHARE_BODIES = 256 };

/* The results of td_finalize_bodies for one part of the bodies, with memory for their lists. */
typedef struct td_finalize_share {
    td_energy_sums sums[TD_SHARE_BODIES / TD_LANES];
    td_finalize_part part;
    td_array odd, fast, moved;
    int room[3][TD_SHARE_BODIES]; /* memory of odd, fast and moved */
} td_finalize_share;

/* TD_SHARE_SHAPES: the number of shapes whose pairs a worker searches before it takes more;
 * TD_SHARE_PAIRS: room for their pairs. In a heap of equal circles a shape has about 6 neighbours,
 * which are 3 pairs a shape, since each pair is found once; so there is room for 4. Chosen. */
enum { TD_SHARE_SHAPES = 256, TD_SHARE_PAIRS = 4 * TD_SHARE_SHAPES };

/* The pairs that the shapes of one part have. */
typedef struct td_sweep_share {
    bool done;            /* false: the calling thread has to search the part */
    int count, new_count; /* count: elements of `pairs`. The first new_count of them have been
                             tested and have no contact yet */
    int64_t overlaps, tested;
    td_new_pair pairs[TD_SHARE_PAIRS];
} td_sweep_share;

/* Waiting contacts that a worker tests at once. Chosen. */
enum { TD_SHARE_WAITING = 256 };

/* The contacts of one part of the waiting ones that begin, and those that end. */
typedef struct td_waiting_share {
    td_array begins, ends;
    int room[2][TD_SHARE_WAITING]; /* memory of begins and ends */
} td_waiting_share;

/* Fast bodies that a worker looks at at once. Chosen. */
enum { TD_SHARE_FAST = 256 };

/* The bodies of one part of scratch.fast that may collide within the step. */
typedef struct td_fast_share {
    td_array meeting; /* td_awake_slot */
    int room[TD_SHARE_FAST];
} td_fast_share;

/* An element of td_scratch.shares. */
typedef union td_share {
    td_finalize_share finalize;
    td_sweep_share sweep;
    td_waiting_share waiting;
    td_fast_share fast;
} td_share;

/* An empty list in the room that a share has for it. */
static inline td_array td_share_list(int *room, int capacity) {
    return (td_array){.data = room, .capacity = capacity, .stride = sizeof(int)};
}

/* Appends what a share has found to a list of all that has room for it. */
static inline void td_share_append(td_array *all, const td_array *found) {
    if (found->count) {
        memcpy((int *)all->data + all->count, found->data, (size_t)found->count * sizeof(int));
        all->count += found->count;
    }
}

/* In shared_finalize.c, shared_sweep.c, shared_waiting.c and shared_fast.c: the functions of
 * thud_shared_stages. */
td_finalize_bodies_fn td_shared_finalize;
td_sweep_fn td_shared_sweep;
td_waiting_fn td_shared_waiting;
td_sift_fast_fn td_shared_sift_fast;

#endif
