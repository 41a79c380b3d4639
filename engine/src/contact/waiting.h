/* waiting.h: tests which of the contacts that wait touch now. */
#ifndef TD_WAITING_H
#define TD_WAITING_H

#include "constraint/block.h"
#include "state/world.h"

/* Waiting contacts of one kind that one thread tests. */
typedef struct td_waiting_part {
    int kind;
    const int *contacts;
    int count;
    td_array *begins, *ends; /* int: those that touch, and those whose bounds have parted, are
                                appended in their order; room for all of the contacts */
    int thread;              /* which of the scratch blocks are used: those of this thread */
} td_waiting_part;

/* Tests the contacts of a part. Threads may test different parts at the same time. */
void td_waiting_test(thud_world *w, const td_waiting_part *part);
/* Tests parts with the same lists, one after the other. */
typedef void td_waiting_fn(thud_world *w, const td_waiting_part *parts, int count);
td_waiting_fn td_waiting_test_all;
/* Reserves the scratch blocks of so many threads. False when memory is short. */
bool td_waiting_reserve(thud_world *w, int threads);

/* Runs a kind's kernel on blocks. Returns whether one of them has offsets
 * (td_block.has_offsets). `separated` gets the blocks of which a lane does not touch; it needs room
 * for one more than the blocks, since the kernel writes before it knows. */
int td_collide_blocks(thud_world *w, int kind, td_block *const *blocks, int count,
                      td_block **separated, int *separated_count);

#endif
