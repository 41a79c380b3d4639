/* event_queue.c: the heap of event_queue.h. */
#include "base/event_queue.h"

#define ARRAY(name, element) TD_ARRAY_PLACE(td_event_queue, name, element)

static const td_array_place ARRAYS[] = {ARRAY(time, double), ARRAY(spot, int), ARRAY(heap, int)};
enum { ARRAY_COUNT = sizeof ARRAYS / sizeof *ARRAYS };

void td_event_queue_init(td_event_queue *a) {
    td_arrays_init(a, ARRAYS, ARRAY_COUNT);
}

bool td_event_queue_reserve(td_memory *memory, td_event_queue *a, int count) {
    return td_arrays_reserve(memory, a, ARRAYS, ARRAY_COUNT, count);
}

void td_event_queue_free(td_memory *memory, td_event_queue *a) {
    td_arrays_free(memory, a, ARRAYS, ARRAY_COUNT);
}

void td_event_queue_clear(td_event_queue *a, int count) {
    int *spot = a->spot.data;
    for (int i = 0; i < count; i++) {
        spot[i] = TD_NONE;
    }
    a->heap.count = 0;
}

/* Whether `number` comes before `other`: at an earlier time, or at the same time and with a smaller
 * number. */
static bool before(const td_event_queue *a, int number, int other) {
    const double *time = a->time.data;
    return time[number] < time[other] || (time[number] == time[other] && number < other);
}

/* Puts a number at an index of the heap. */
static void put(td_event_queue *a, int at, int number) {
    ((int *)a->heap.data)[at] = number;
    ((int *)a->spot.data)[number] = at;
}

/* Places a number at index `at`, or nearer to the front: parents that come after it move down. */
static void rise(td_event_queue *a, int at, int number) {
    const int *heap = a->heap.data;
    for (; at > 0 && before(a, number, heap[(at - 1) / 2]); at = (at - 1) / 2) {
        put(a, at, heap[(at - 1) / 2]);
    }
    put(a, at, number);
}

/* Places a number at index `at`, or further back: children that come before it move up; then nearer
 * to the front, for a number whose time has been brought forward. */
static void sink(td_event_queue *a, int at, int number) {
    const int *heap = a->heap.data;
    for (;;) {
        int child = 2 * at + 1;
        if (child + 1 < a->heap.count && before(a, heap[child + 1], heap[child])) {
            child++;
        }
        if (child >= a->heap.count || !before(a, heap[child], number)) {
            break;
        }
        put(a, at, heap[child]);
        at = child;
    }
    rise(a, at, number);
}

void td_event_queue_set(td_event_queue *a, int number, double time) {
    int at = td_int_at(&a->spot, number);
    *TD_AT(double, &a->time, number) = time;
    if (at == TD_NONE) {
        rise(a, a->heap.count++, number);
    } else {
        sink(a, at, number);
    }
}

void td_event_queue_strike(td_event_queue *a, int number) {
    int *spot = TD_AT(int, &a->spot, number), at = *spot;
    if (at == TD_NONE) {
        return;
    }
    *spot = TD_NONE;
    int last = td_int_at(&a->heap, --a->heap.count);
    if (last != number) {
        sink(a, at, last);
    }
}

int td_event_queue_next(td_event_queue *a, double *time) {
    if (a->heap.count == 0) {
        return TD_NONE;
    }
    int number = *(int *)a->heap.data;
    *time = *TD_AT(double, &a->time, number);
    td_event_queue_strike(a, number);
    return number;
}
