/* hostile_memory.h: an allocator that refuses when a test tells it to, and knows what is still
 * held. Only memory asked for through it counts, so that a test's own is never refused. */
#ifndef HOSTILE_MEMORY_H
#define HOSTILE_MEMORY_H

#include <stdlib.h>

#include <thud/thud.h>

static long memory_allowed = -1; /* allocations until one fails; negative: no end */
static long memory_held;         /* blocks not given back */
static long memory_refused;      /* allocations that failed */

static inline void *hostile_allocate(size_t bytes, void *context) {
    (void)context;
    if (memory_allowed >= 0 && memory_allowed-- == 0) {
        memory_refused++;
        return NULL;
    }
    memory_held++;
    return aligned_alloc(64, bytes);
}

static inline void hostile_release(void *block, size_t bytes, void *context) {
    (void)bytes;
    (void)context;
    memory_held--;
    free(block);
}

static inline thud_allocator hostile_memory(void) {
    return (thud_allocator){hostile_allocate, hostile_release, NULL};
}

#endif
