/* event_queue.h: which of many things comes next: a binary heap of numbers with a time each, that
 * may be brought forward, deferred or struck out. Equal times come in the order of the numbers. */
#ifndef TD_EVENT_QUEUE_H
#define TD_EVENT_QUEUE_H

#include "base/memory.h"

typedef struct td_event_queue {
    td_array time; /* double, by number */
    td_array spot; /* int, by number: where it stands in the heap, or TD_NONE */
    td_array heap; /* int: numbers */
} td_event_queue;

void td_event_queue_init(td_event_queue *queue);
/* Room for the numbers below `count`. False when memory is short. */
bool td_event_queue_reserve(td_memory *memory, td_event_queue *queue, int count);
void td_event_queue_free(td_memory *memory, td_event_queue *queue);

/* Empty, for numbers below `count`, for which there is room. */
void td_event_queue_clear(td_event_queue *queue, int count);
void td_event_queue_set(td_event_queue *queue, int number, double time);
void td_event_queue_strike(td_event_queue *queue, int number); /* fine if it is not there */
/* The number that comes first, taken out, or TD_NONE. */
int td_event_queue_next(td_event_queue *queue, double *time);

#endif
