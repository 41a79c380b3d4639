/* waiting.h: tests which of the contacts that wait touch now. */
#ifndef TD_WAITING_H
#define TD_WAITING_H

#include "constraint/block.h"
#include "state/world.h"

/* The lists to which a thread appends its results. */
typedef struct td_waiting_found {
    td_array *begins, *ends; /* int: contacts that touch, and those whose bounds have parted, are
                                appended in their order; room for all that are tested */
    int thread;              /* number of the thread, which selects its scratch blocks */
} td_waiting_found;

/* Tests waiting contacts of a kind. Threads may test different ones at the same time. */
void td_waiting_test(thud_world *w, int kind, const int *contacts, int count,
                     const td_waiting_found *found);
/* Tests all waiting contacts, for scratch.begins and scratch.ends. */
typedef void td_waiting_fn(thud_world *w);
td_waiting_fn td_waiting_test_all;
/* Reserves the scratch blocks of so many threads. False when memory is short. */
bool td_waiting_reserve(thud_world *w, int threads);

/* Runs a kind's kernel on blocks. Returns whether one of them has offsets (td_block.has_offsets).
 * `separated` gets the blocks of which a lane does not touch; it needs room for one more than the
 * blocks, since td_set_touching always writes an entry, and only then decides whether it counts. */
int td_collide_blocks(thud_world *w, int kind, td_block *const *blocks, int count,
                      td_block **separated, int *separated_count);

#endif
