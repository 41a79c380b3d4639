/* event_queue.h: a priority queue of events, as an indexed binary heap: each number 0 .. count - 1
 * may be in the queue once, with a time that can be changed (J. W. J. Williams, "Algorithm 232:
 * Heapsort", 1964). Equal times come in the order of the numbers, so that the order is the same
 * everywhere. All operations but clearing take O(log n). */
#ifndef TD_EVENT_QUEUE_H
#define TD_EVENT_QUEUE_H

#include "base/memory.h"

typedef struct td_event_queue {
    td_array time; /* double, by number */
    td_array spot; /* int, by number: its index in `heap`, or TD_NONE: not in the queue */
    td_array heap; /* int: numbers; heap[i] comes no later than heap[2 i + 1] and heap[2 i + 2] */
} td_event_queue;

void td_event_queue_init(td_event_queue *queue);
/* Makes room for the numbers below `count`. False when memory is short. */
bool td_event_queue_reserve(td_memory *memory, td_event_queue *queue, int count);
void td_event_queue_free(td_memory *memory, td_event_queue *queue);

/* Empties the queue, for numbers below `count`; there must be room for them. */
void td_event_queue_clear(td_event_queue *queue, int count);
/* Puts a number into the queue, or changes its time. */
void td_event_queue_set(td_event_queue *queue, int number, double time);
/* Takes a number out of the queue, if it is there. */
void td_event_queue_strike(td_event_queue *queue, int number);
/* Takes the number with the earliest time out, and returns it; TD_NONE where the queue is empty. */
int td_event_queue_next(td_event_queue *queue, double *time);

#endif
